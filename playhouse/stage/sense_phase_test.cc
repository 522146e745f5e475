// Phases follow a population that changes: populated for one world and then for another, they measure there
// as phases that knew no other.

#include "playhouse/stage/sense_phase.h"

#include <gtest/gtest.h>

#include "playhouse/stage/sense_fiducial.h"
#include "playhouse/stage/sense_ranger.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::stage {
namespace {

Senses all_senses() {
  Senses senses;
  add_senses(senses, 1);
  return senses;
}

/// What is measured in the first tick of a scene: the hash of it, and the rays.
std::pair<std::uint64_t, std::uint64_t> measure(Senses& senses, const scene::SceneDesc& scene) {
  world::World world(scene, 1);
  Trees trees = make_trees(world);
  const Solids solids = testing::make_solids(world, trees);
  const Walls walls(solids);
  world::Workers workers(1);
  DiscIndex index;
  index.populate(solids.moving(), 0.3);
  index.rebuild(
      solids.moving(), [&](std::size_t i) { return disc_of(solids, solids.fixed + i); }, workers);
  const Space space{solids, index, walls};
  senses.populate(world, space);
  const std::uint64_t rays = senses.sense(world, space, 1, workers);
  return {world.sensed_hash(), rays};
}

void add_finder(scene::SceneDesc& scene) {
  scene::ModelDesc& model = scene.models.emplace_back();
  model.name = model.alias = "finder";
  model.kind = scene::ModelKind::kFiducial;
  model.alwayson = true;
  model.fiducial = scene::FiducialDesc{};
  for (scene::ModelDesc& other : scene.models) other.fiducial_return = 3;
}

TEST(Senses, measure_in_another_population_as_if_they_had_known_no_other) {
  std::vector<scene::SceneDesc> scenes = {testing::crowd(5, testing::Sensing::kSonar),
                                          testing::crowd(40, testing::Sensing::kLaser),
                                          testing::crowd(60, testing::Sensing::kSonar)};
  scenes.push_back(scenes[0]);
  add_finder(scenes[1]);
  scenes.push_back(testing::crowd(20, testing::Sensing::kSonar));  // a body for which tables are too small
  scenes.back().models.push_back(testing::robot("large", {9, 9, 0, 0.4}, {3, 2, 1}));
  add_finder(scenes.back());
  scenes.push_back(scenes[2]);
  Senses used = all_senses();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    Senses fresh = all_senses();
    const auto expected = measure(fresh, scenes[i]), got = measure(used, scenes[i]);
    EXPECT_EQ(got, expected) << "scene " << i;
    EXPECT_GT(got.second, 0u);
  }
}

TEST(RangerKinds, keep_what_rangers_that_are_alike_share) {
  const scene::SceneDesc few = testing::crowd(3, testing::Sensing::kSonar),
                         lasers = testing::crowd(2, testing::Sensing::kLaser),
                         many = testing::crowd(9, testing::Sensing::kSonar);
  RangerKinds kinds;
  kinds.populate(world::World(few, 1), 0.3);
  const std::uint16_t* const table = kinds.kinds.at(0).bundles.at(0).meets.data();
  kinds.populate(world::World(lasers, 1), 0.2);
  EXPECT_EQ(kinds.of_ranger, (std::vector<std::uint32_t>{1, 1}));
  kinds.populate(world::World(many, 1), 0.3);
  EXPECT_EQ(kinds.kinds.size(), 2u);
  EXPECT_EQ(kinds.of_ranger, std::vector<std::uint32_t>(9, 0));
  EXPECT_EQ(kinds.kinds[0].bundles[0].meets.data(), table);
  const double half = kinds.kinds[0].bundles[0].half;
  kinds.populate(world::World(many, 1), 0.5);
  EXPECT_GE(kinds.kinds[0].bundles[0].half, half + 0.2) << "tables are good for larger bodies";
}

}  // namespace
}  // namespace playhouse::stage
