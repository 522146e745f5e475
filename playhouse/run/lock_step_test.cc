#include "playhouse/run/lock_step.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "playhouse/run/testing/still_engine.h"
#include "playhouse/world/population/population.h"

namespace playhouse::run {
namespace {

constexpr const char* kRobot = "interval_sim 100\nposition( name \"r0\" )\n";

/// A member, told from others by its address.
struct Who {
  std::string name;
};

/// Two members by the names of "b" and "a", and what they were told.
class TwoMembers : public ::testing::Test {
 protected:
  LockStep lock_step{{.members = 2, .names = {"a", "b"}}};
  Who a{"first"}, b{"second"};
  std::string told;

  void step(const Who& who, std::uint64_t ticks = 1) {
    lock_step.step(&who, who.name, ticks, [this, name = who.name](const std::optional<std::string>& why) {
      told += name + (why ? ": " + *why : " done") + "; ";
    });
  }
  void tick() {
    ASSERT_TRUE(lock_step.is_due());
    for (const LockStep::Done& done : lock_step.ticked()) done({});
  }
  void join() {
    EXPECT_EQ(lock_step.join(&b, "b", b.name), "");
    EXPECT_EQ(lock_step.join(&a, "a", a.name), "");
  }
};

TEST_F(TwoMembers, the_first_tick_waits_until_all_have_joined_and_asked) {
  EXPECT_EQ(lock_step.join(&b, "b", b.name), "");
  step(b);
  EXPECT_FALSE(lock_step.is_due());
  EXPECT_EQ(lock_step.join(&a, "a", a.name), "");
  EXPECT_FALSE(lock_step.is_due());
  step(a);
  tick();
  EXPECT_EQ(told, "first done; second done; ");
}

TEST_F(TwoMembers, who_asked_for_more_ticks_waits_for_all_of_them) {
  join();
  step(a, 3);
  for (int k = 0; k < 3; ++k) {
    EXPECT_FALSE(lock_step.is_due());
    step(b);
    tick();
  }
  EXPECT_EQ(told, "second done; second done; first done; second done; ");
}

TEST_F(TwoMembers, act_in_the_order_of_their_names_between_two_ticks) {
  join();
  EXPECT_TRUE(lock_step.may_act(&a));
  EXPECT_FALSE(lock_step.may_act(&b)) << "a has not finished";
  step(a);
  EXPECT_FALSE(lock_step.may_act(&a)) << "what it says now is for the next tick";
  EXPECT_TRUE(lock_step.may_act(&b));
  step(b);
  tick();
  EXPECT_TRUE(lock_step.may_act(&a));
  EXPECT_FALSE(lock_step.may_act(&b));
}

TEST_F(TwoMembers, a_client_that_is_no_member_may_act_at_any_time) {
  const Who viewer{"viewer"};
  EXPECT_TRUE(lock_step.may_act(&viewer));
}

TEST_F(TwoMembers, refuses_names_that_are_not_awaited_or_taken_and_steps_without_one) {
  const Who other{"other"};
  EXPECT_NE(lock_step.join(&other, "c", "other"), "");
  join();
  EXPECT_NE(lock_step.join(&other, "a", "other"), "");
  EXPECT_NE(lock_step.join(&a, "b", "first"), "") << "it has another name";
  EXPECT_EQ(lock_step.join(&a, "a", "first"), "") << "again";
  step(other);
  EXPECT_EQ(told, "other: clients of this world join by name first; ");
}

TEST_F(TwoMembers, a_second_step_before_the_first_is_done_is_refused) {
  join();
  step(a);
  step(a);
  EXPECT_EQ(told, "first: its last step is not done yet; ");
}

TEST_F(TwoMembers, the_other_goes_on_when_one_leaves_and_both_are_awaited_again_when_none_is_left) {
  join();
  step(a);
  lock_step.leave(&b);
  tick();
  lock_step.leave(&a);
  EXPECT_EQ(lock_step.join(&a, "a", a.name), "");
  step(a);
  EXPECT_FALSE(lock_step.is_due());
}

TEST_F(TwoMembers, steps_are_refused_once_the_run_is_over) {
  join();
  step(a);
  lock_step.close("it is over");
  step(b);
  EXPECT_EQ(told, "first: it is over; second: it is over; ");
  EXPECT_TRUE(lock_step.may_act(&b)) << "so that nothing waits for ever";
}

TEST(LockStep, drops_who_is_silent_for_too_long_but_not_while_the_world_is_paused) {
  LockStep lock_step({.members = 2, .names = {}, .timeout = 10});
  Who a{"first"}, b{"second"};
  ASSERT_EQ(lock_step.join(&a, "a", a.name), "");
  ASSERT_EQ(lock_step.join(&b, "b", b.name), "");
  lock_step.step(&b, b.name, 1, [](const auto&) {});
  for (const double now : {0.0, 9.0}) lock_step.look_for_silence(now, false);
  EXPECT_TRUE(lock_step.has(&a));
  lock_step.look_for_silence(100, true);
  lock_step.look_for_silence(101, false);
  EXPECT_TRUE(lock_step.has(&a));
  lock_step.look_for_silence(110, false);
  EXPECT_FALSE(lock_step.has(&a));
  EXPECT_TRUE(lock_step.is_due());
}

TEST(LockStep, clients_without_names_join_with_their_first_step) {
  LockStep lock_step({.members = 2, .names = {}});
  const Who clients[3]{{"0"}, {"1"}, {"2"}};
  std::string told;
  for (const Who& client : clients)
    lock_step.step(&client, client.name, 1,
                   [&](const std::optional<std::string>& why) { told += client.name + why.value_or(""); });
  EXPECT_EQ(told, "2all that this world waits for have joined");
  EXPECT_TRUE(lock_step.is_due());
}

TEST(Simulation, in_lock_step_ticks_only_as_far_as_it_was_asked_to_and_tells_when_the_data_are_out) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  Simulation simulation(std::make_unique<testing::StillEngine>(scene),
                        {.speed = 0, .duration = 0.5, .lock_step = LockStep::LockStepOptions{}});
  std::atomic<int> shown = 0;
  simulation.follow(on_show([&](const world::World& world, const world::Pace&) {
    if (world.tick() == 3) ++shown;
  }));
  std::thread ticks([&] { simulation.run(); });
  std::atomic<bool> done = false;
  simulation.lock_step()->step(&done, "test", 3, [&](const std::optional<std::string>& why) {
    EXPECT_FALSE(why);
    EXPECT_EQ(simulation.world().tick(), 3u);
    EXPECT_EQ(shown, 1);
    done = true;
  });
  while (!done) std::this_thread::yield();
  simulation.requests().stop();
  ticks.join();
  EXPECT_EQ(simulation.world().tick(), 3u);
}

TEST(Simulation, what_was_posted_before_a_step_is_carried_out_before_its_tick) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  Simulation simulation(std::make_unique<testing::StillEngine>(scene),
                        {.speed = 0, .duration = 20, .lock_step = LockStep::LockStepOptions{}});
  std::thread ticks([&] { simulation.run(); });
  const auto step = [&] {
    std::atomic<bool> done = false;
    simulation.lock_step()->step(&ticks, "test", 1, [&](const auto&) { done = true; });
    while (!done) std::this_thread::yield();
  };
  std::vector<std::uint64_t> seen;
  for (std::uint64_t k = 0; k < 200; ++k) {
    simulation.requests().post(
        [&](const world::Journal& journal) { seen.push_back(journal.world().tick()); });
    step();
  }
  ticks.join();
  for (std::uint64_t k = 0; k < 200; ++k) EXPECT_EQ(seen[k], k);
}

TEST(Simulation, in_lock_step_what_is_said_behind_the_last_tick_never_counts) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  for (int repeat = 0; repeat < 50; ++repeat) {
    Simulation simulation(std::make_unique<testing::StillEngine>(scene),
                          {.speed = 0, .duration = 0.2, .lock_step = LockStep::LockStepOptions{}});
    bool is_carried_out = false;
    simulation.lock_step()->step(&simulation, "test", 2, [&](const auto&) {
      simulation.requests().post([&](const world::Journal&) { is_carried_out = true; });
    });
    simulation.run();
    EXPECT_EQ(simulation.world().tick(), 2u);
    EXPECT_FALSE(is_carried_out);
  }
}

TEST(Simulation, starts_again_with_the_models_and_ids_of_the_start_and_another_seed) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  Simulation simulation(std::make_unique<testing::StillEngine>(scene),
                        {.speed = 0, .lock_step = LockStep::LockStepOptions{}});
  world::World& world = simulation.engine().world();
  const std::uint64_t hash = world.hash(), seed = world.seed();
  ASSERT_TRUE(world::spawn(world, 0, {1, 2, 0, 0}));
  simulation.engine().step();
  ASSERT_TRUE(simulation.restart(seed).ok());
  EXPECT_EQ(world.tick(), 0u);
  EXPECT_EQ(world.hash(), hash);
  ASSERT_TRUE(simulation.restart(7).ok());
  EXPECT_EQ(world.seed(), 7u);
  EXPECT_EQ(world.models.size(), 1u);
  EXPECT_EQ(world.hash(), world::World(scene, 7).hash());
}

TEST(Simulation, gives_no_id_a_second_time_after_it_started_again) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  Simulation simulation(std::make_unique<testing::StillEngine>(scene),
                        {.speed = 0, .duration = 0, .lock_step = LockStep::LockStepOptions{}});
  const auto come = [&] {
    world::ModelId id;
    simulation.requests().post([&](world::Journal& journal) { id = *journal.spawn(0, {1, 2, 0, 0}); });
    simulation.run();
    return id;
  };
  const auto restart = [&] {
    simulation.requests().post_to_all([&](const world::Journal&) { EXPECT_TRUE(simulation.restart(7)); });
    simulation.requests().post([](const world::Journal&) {});
    simulation.run();
    EXPECT_EQ(simulation.world().hash(), world::World(scene, 7).hash()) << "nobody came yet";
  };
  std::vector<world::ModelId> came;
  for (int run = 0; run < 3; ++run) {
    came.push_back(come());
    restart();
  }
  EXPECT_LT(came[0], came[1]);
  EXPECT_LT(came[1], came[2]);
}

TEST(Simulation, is_after_a_new_start_the_run_of_a_fresh_one_also_where_models_come) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  world::World fresh(scene, 7);
  ASSERT_TRUE(world::spawn(fresh, 0, {1, 2, 0, 0}));
  Simulation simulation(std::make_unique<testing::StillEngine>(scene),
                        {.speed = 0, .duration = 0, .lock_step = LockStep::LockStepOptions{}});
  for (int run = 0; run < 3; ++run) {
    simulation.requests().post_to_all([&](const world::Journal&) { EXPECT_TRUE(simulation.restart(7)); });
    simulation.requests().post([](world::Journal& journal) { EXPECT_TRUE(journal.spawn(0, {1, 2, 0, 0})); });
    simulation.run();
    const world::World& world = simulation.world();
    EXPECT_EQ(world.hash(), fresh.hash());
    EXPECT_EQ(world.positions.odom_error.back(), fresh.positions.odom_error.back());
  }
}

TEST(Simulation, without_lock_step_keeps_no_start) {
  testing::StillSimulation still(kRobot);
  EXPECT_FALSE(still.simulation.restart(1).ok());
}

/// Work of many parts after each tick.
struct ManyParts final : Follower {
  void ticked(const world::World&) override { is_due = true; }
  std::optional<Work> work(const world::World&, const world::Pace&) override {
    if (!std::exchange(is_due, false)) return {};
    return Work{kParts, [this](std::size_t) { ++done; }};
  }
  static constexpr std::size_t kParts = 200;
  bool is_due = false;
  std::atomic<std::size_t> done = 0;
};

TEST(Simulation, in_lock_step_tells_when_the_works_of_followers_are_done) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  ManyParts parts;
  Simulation simulation(std::make_unique<testing::StillEngine>(scene),
                        {.speed = 0, .duration = 0.5, .lock_step = LockStep::LockStepOptions{}});
  simulation.follow(parts);
  std::thread ticks([&] { simulation.run(); });
  std::atomic<bool> done = false;
  simulation.lock_step()->step(&done, "test", 3, [&](const std::optional<std::string>& why) {
    EXPECT_FALSE(why);
    EXPECT_EQ(parts.done, 3 * ManyParts::kParts);
    done = true;
  });
  while (!done) std::this_thread::yield();
  simulation.requests().stop();
  ticks.join();
}

}  // namespace
}  // namespace playhouse::run
