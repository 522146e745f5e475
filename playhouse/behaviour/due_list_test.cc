#include "playhouse/behaviour/due_list.h"

#include <gtest/gtest.h>

namespace playhouse::behaviour {
namespace {

TEST(DueList, has_those_that_are_subscribed_and_whose_period_is_over) {
  scene::SceneDesc scene;
  for (const double interval : {0.1, 0.25, 0.1}) {
    scene::ModelDesc& ranger = scene.models.emplace_back();
    ranger.kind = scene::ModelKind::kRanger;
    ranger.alwayson = true;
    ranger.update_interval = interval;
  }
  scene.models[2].alwayson = false;
  world::World world(scene, 1);
  DueList list;
  list.populate(world, world.rangers.model);
  std::vector<std::vector<std::uint32_t>> due;
  for (std::uint64_t tick = 1; tick <= 6; ++tick) {
    const auto rows = list.take(world, {world.rangers.model, world.rangers.measured_tick}, tick);
    std::vector<std::uint32_t>& numbers = due.emplace_back();
    for (const world::KindRow row : rows) numbers.push_back(row.index);
  }
  EXPECT_EQ(due, (std::vector<std::vector<std::uint32_t>>{{0}, {0}, {0, 1}, {0}, {0}, {0, 1}}));
  EXPECT_EQ(world.rangers.measured_tick, (std::vector<std::uint64_t>{6, 6, 0}));
}

}  // namespace
}  // namespace playhouse::behaviour
