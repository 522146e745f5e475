// Runs that are taken back: what comes after an instant is the same to the bit as the first time, whoever
// came and went, and however many workers there are. Out of scope here: which instants there are
// (run/history_test.cc) and what happens to devices (bridge/simulated/auto_devices_test.cc).

#include <gtest/gtest.h>

#include <map>

#include "playhouse/app/world_opener.h"
#include "playhouse/run/testing/still_engine.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/population/population.h"

namespace playhouse::app {
namespace {

using Hashes = std::map<std::uint64_t, std::uint64_t>;  // by tick

Hashes part(const Hashes& all, std::uint64_t first, std::uint64_t last) {
  return {all.lower_bound(first), all.upper_bound(last)};
}

/// Robots with controllers that remember and sense.
class Rewound {
 public:
  explicit Rewound(unsigned workers)
      : scene_(*scene::load_world(std::string(PLAYHOUSE_SOURCE_DIR) + "/worlds/cave.world")),
        simulation_(*make_engine(scene_, {.workers = workers}, controllers::Libraries::LibraryUse::kLoad,
                                 [](const std::string&) {}),
                    {.speed = 0, .duration = 0, .clock = run::testing::no_time_passes}) {
    simulation_.requests().record(true);
    simulation_.follow(run::on_show([this](const world::World& world, const world::Pace&) {
      hash_of_tick[world.tick()] = world.hash();
    }));
  }
  void run_to(std::uint64_t tick) {
    simulation_.extend(tick - world().tick());
    simulation_.run();
  }
  void change(const std::function<void(world::Journal&)>& change) {
    ASSERT_TRUE(simulation_.requests().post(change));
    run_to(world().tick());
  }
  /// Hashes of the ticks from an instant to another tick, as they are once more.
  Hashes again(std::uint64_t instant, std::uint64_t tick) {
    hash_of_tick.clear();
    simulation_.requests().rewind(instant);
    run_to(tick);
    // The world that was left is shown once more, with its new pace.
    return part(std::exchange(hash_of_tick, {}), instant, tick);
  }
  world::World& world() { return simulation_.engine().world(); }

  Hashes hash_of_tick;

 private:
  scene::SceneDesc scene_;
  run::Simulation simulation_;
};

TEST(Rewind, goes_on_as_the_first_time_with_any_number_of_workers) {
  Hashes of_one_worker;
  for (const unsigned workers : {1u, 2u, 4u}) {
    Rewound run(workers);
    run.run_to(120);
    const auto first = run.hash_of_tick;
    EXPECT_EQ(run.again(50, 120), part(first, 50, 120)) << workers;
    EXPECT_EQ(run.again(100, 120), part(first, 100, 120)) << workers;
    EXPECT_EQ(run.again(10, 120), part(first, 10, 120)) << workers;
    if (workers == 1) of_one_worker = first;
    EXPECT_EQ(first, of_one_worker) << workers;
  }
}

TEST(Rewind, brings_back_who_went_and_does_without_who_came) {
  Rewound run(2);
  const std::uint32_t robot = run.world().models.desc[run.world().positions.model[{0}]];
  const world::ModelId of_start = run.world().id(run.world().positions.model[{0}]);
  world::ModelId late;
  run.run_to(25);
  run.change([&](world::Journal& journal) { late = *journal.spawn(robot, {1, 1, 0, 0.5}); });
  run.run_to(35);
  const auto go = [&](world::Journal& journal) { EXPECT_TRUE(journal.despawn(of_start)); };
  run.change(go);
  run.run_to(80);
  const auto first = run.hash_of_tick;

  EXPECT_EQ(run.again(20, 20), part(first, 20, 20));
  EXPECT_TRUE(run.world().row(of_start));
  EXPECT_FALSE(run.world().row(late));
  EXPECT_EQ(run.again(50, 50), part(first, 50, 50)) << "later again, while nothing else happened";
  EXPECT_FALSE(run.world().row(of_start));
  EXPECT_EQ(run.again(30, 34), part(first, 30, 34)) << "tick 35 was changed after it was done";
  EXPECT_TRUE(run.world().row(of_start));
  EXPECT_TRUE(run.world().row(late));
  run.run_to(35);
  run.change(go);
  run.run_to(80);
  EXPECT_EQ(part(run.hash_of_tick, 36, 80), part(first, 36, 80)) << "who does the same again gets the same";
}

/// Between two keyframes, with changes and clients that come and go: the truth is the first time.
TEST(Rewind, goes_to_any_tick_with_what_was_done_until_then) {
  Rewound run(2);
  run.run_to(42);
  const std::uint32_t prototype = run.world().models.desc[run.world().positions.model[{0}]];
  const world::ModelId robot = run.world().id(run.world().positions.model[{0}]);
  const world::ModelId laser = run.world().id(run.world().rangers.model[{0}]);
  run.change([&](world::Journal& journal) {
    ASSERT_TRUE(journal.spawn(prototype, {1, 1, 0, 0.5}, "late"));
    ASSERT_TRUE(journal.apply(world::changes::Subscribe{laser}));
  });
  run.run_to(45);
  run.change([&](world::Journal& journal) {
    ASSERT_TRUE(journal.apply(world::changes::Place{robot, {-1, 1, 0, 2}}));
    ASSERT_TRUE(journal.apply(world::changes::Unsubscribe{laser}));
  });
  run.run_to(47);
  run.change([&](world::Journal& journal) { ASSERT_TRUE(journal.despawn(robot)); });
  run.run_to(83);
  run.change([&](world::Journal& journal) {
    ASSERT_TRUE(journal.apply(
        world::changes::Say{journal.world().id(journal.world().find("late")), "left at this moment"}));
  });
  const auto first = run.hash_of_tick;
  for (const std::uint64_t tick : {44, 41, 46, 43, 79, 48, 83, 44, 83})
    EXPECT_EQ(run.again(tick, tick).at(tick), first.at(tick)) << tick;
  EXPECT_EQ(run.world().models.say[run.world().find("late")], "left at this moment");
  run.run_to(90);
  const auto on = run.hash_of_tick;
  EXPECT_EQ(run.again(86, 90), part(on, 86, 90)) << "the moment that was left is a part of the run";
  EXPECT_NE(run.again(44, 46).at(46), first.at(46)) << "from there nobody did anything";
}

TEST(Rewind, goes_another_way_where_somebody_does_something_else) {
  Rewound run(1);
  run.run_to(60);
  const auto first = run.hash_of_tick;
  run.again(30, 30);
  run.change([](world::Journal& journal) {
    const world::ModelRow robot = journal.world().positions.model[{0}];
    journal.apply(world::changes::Place{journal.world().id(robot), {0.5, 0.5, 0, 1}});
  });
  run.run_to(60);
  EXPECT_NE(run.hash_of_tick.at(60), first.at(60));
}

}  // namespace
}  // namespace playhouse::app
