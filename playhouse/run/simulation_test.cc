#include "playhouse/run/simulation.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "playhouse/base/limits.h"
#include "playhouse/run/testing/still_engine.h"
#include "playhouse/world/changes/packed_change.h"
#include "playhouse/world/population/population.h"

namespace playhouse::run {
namespace {

using testing::StillEngine;
using testing::StillSimulation;

constexpr const char* kRobot = "interval_sim 100\nposition( name \"r0\" )\n";

TEST(Simulation, ends_at_the_first_tick_at_or_after_the_duration) {
  for (const auto& [duration, ticks] : {std::pair{0.0, 0u}, {0.1, 1u}, {0.25, 3u}, {1.0, 10u}}) {
    const scene::SceneDesc scene = testing::scene_of(kRobot);
    Simulation simulation(std::make_unique<StillEngine>(scene), {.speed = 0, .duration = duration});
    simulation.run();
    EXPECT_EQ(simulation.world().tick(), ticks) << duration;
  }
}

TEST(Simulation, carries_out_what_was_posted_before_the_next_tick) {
  StillSimulation still(kRobot);
  std::uint64_t seen_at = 99;
  ASSERT_TRUE(still.simulation.requests().post(
      [&](const world::Journal& journal) { seen_at = journal.world().tick(); }));
  still.run(3);
  EXPECT_EQ(seen_at, 0u);
}

TEST(Simulation, a_command_reaches_its_robot) {
  StillSimulation still(kRobot);
  still.simulation.requests().drive({0}, {0.3, 0, 0, 0.2});
  still.run(1);
  EXPECT_EQ(still.world().positions.command[{0}], (geom::Twist{0.3, 0, 0, 0.2}));
}

TEST(Simulation, a_viewer_who_drives_is_one_more_who_commands) {
  StillSimulation still(kRobot);
  still.simulation.requests().command(world::changes::Drive{{0}, {0.3, 0, 0, 0.2}});
  still.simulation.requests().drive({0}, {0.5, 0.1, 0, -1});
  still.run(1);
  EXPECT_EQ(still.world().positions.command[{0}], (geom::Twist{0.5, 0.1, 0, -1}));
}

TEST(Simulation, shows_every_tick_to_its_listeners_with_the_time) {
  StillSimulation still(kRobot);
  std::vector<std::uint64_t> seen;
  still.simulation.follow(
      on_show([&](const world::World& world, const world::Pace&) { seen.push_back(world.tick()); }));
  still.run(2);
  EXPECT_EQ(seen, (std::vector<std::uint64_t>{0, 1, 2}));
  EXPECT_DOUBLE_EQ(still.simulation.time(), 0.2);
}

TEST(Simulation, shows_every_tick_to_works_while_the_world_stands) {
  struct Watcher final : Follower {
    std::optional<Work> work(const world::World& world, const world::Pace&) override {
      if (world.tick() % 2 == 0) return {};
      return Work{.run = [&world, this](std::size_t) {
        const std::uint64_t tick = world.tick();
        std::this_thread::yield();
        EXPECT_EQ(world.tick(), tick);
        seen.push_back(tick);
      }};
    }
    std::vector<std::uint64_t> seen;
  } watcher;
  StillSimulation still(kRobot);
  still.simulation.follow(watcher);
  still.run(6);
  EXPECT_EQ(watcher.seen, (std::vector<std::uint64_t>{1, 3, 5}));
}

/// So many that the publisher thread is woken for them.
constexpr std::size_t kManyParts = 200;

/// Work of many parts after each tick, after which it asks for something, as drivers do that read others.
struct Asking final : Follower {
  explicit Asking(Simulation& simulation) : simulation(simulation) {}
  void ticked(const world::World&) override { is_due = true; }
  std::optional<Work> work(const world::World&, const world::Pace&) override {
    if (!std::exchange(is_due, false)) return {};
    return Work{kManyParts, [this](std::size_t) { ++parts; },
                [this] {
                  times.push_back(parts == kManyParts * (times.size() + 1) ? simulation.world().time() : -1);
                  simulation.requests().post_always(
                      [this](const world::Journal& journal) { answered.push_back(journal.world().time()); },
                      {});
                }};
  }
  Simulation& simulation;
  bool is_due = false;
  std::atomic<std::size_t> parts = 0;
  std::vector<double> times, answered;
};

TEST(Simulation, what_works_ask_for_in_the_end_happens_before_the_next_tick) {
  for (const unsigned workers : {1u, 3u}) {
    StillSimulation still(kRobot, workers);
    Asking asking(still.simulation);
    still.simulation.follow(asking);
    std::vector<double> ticks;
    for (int tick = 1; tick <= 50; ++tick) ticks.push_back(tick * 0.1);
    still.run(50);
    ASSERT_EQ(asking.times.size(), 50u);
    EXPECT_EQ(asking.answered, asking.times);
    for (std::size_t k = 0; k < 50; ++k) EXPECT_DOUBLE_EQ(asking.times[k], ticks[k]);
  }
}

TEST(Simulation, is_shown_when_the_works_of_all_are_done) {
  StillSimulation still(kRobot);
  std::vector<std::size_t> done;
  Asking asking(still.simulation);
  still.simulation.follow(
      on_show([&](const world::World&, const world::Pace&) { done.push_back(asking.parts); }));
  still.simulation.follow(asking);
  still.run(1);
  ASSERT_GE(done.size(), 2u);
  EXPECT_EQ(done[0], 0u);
  EXPECT_EQ(done[1], kManyParts);
}

TEST(Simulation, tells_its_followers_of_each_change_before_the_next_and_before_its_listeners) {
  StillSimulation still(kRobot);
  std::string told;
  still.simulation.follow(on_event([&](const world::World& world, const world::Event& event) {
    told += event.kind == world::Event::EventKind::kSpawn ? "came " : "went ";
    told += std::to_string(world.models.size()) + ", ";
  }));
  still.simulation.follow(on_show([&](const world::World&, const world::Pace&) { told += "shown, "; }));
  world::ModelId robot;
  still.simulation.requests().post([&](world::Journal& journal) { robot = *journal.spawn(0, {}); });
  still.simulation.requests().post([&](world::Journal& journal) { EXPECT_TRUE(journal.despawn(robot)); });
  still.run(0);
  EXPECT_EQ(told, "shown, came 2, went 1, shown, ") << "the pace is shown first";
}

TEST(Simulation, shows_a_run_listener_the_world_before_and_after_what_was_posted_and_each_tick) {
  struct Notes final : run::Follower {
    void changed(const world::World& world, std::span<const world::Change> changes) override {
      for (const world::Change& change : changes) text += std::string(world::name_of(change)) + ", ";
      note("changed", world);
    }
    void ticked(const world::World& world) override { note("tick", world); }
    void note(const char* what, const world::World& world) {
      text += std::string(what) + " " + std::to_string(world.models.size()) + ", ";
    }
    std::string text;
  } notes;
  StillSimulation still(kRobot);
  still.simulation.follow(notes);
  still.simulation.requests().post([&](world::Journal& journal) { EXPECT_TRUE(journal.spawn(0, {})); });
  still.simulation.requests().post([&](world::Journal& journal) { EXPECT_TRUE(journal.spawn(0, {})); });
  still.run(2);
  EXPECT_EQ(notes.text, "spawn, spawn, changed 3, tick 3, tick 3, ");
}

TEST(Simulation, has_controllers_know_who_came_before_anybody_saves_the_state) {
  struct Counter final : world::Decider {
    std::string_view name() const override { return "counter"; }
    std::size_t size() const override { return known; }
    void follow(world::World& world) override { known = world.models.size(); }
    void decide(world::World&, std::size_t, std::size_t) override {}
    void hash(const world::World&, Hash&) const override {}
    Result<void> save(Packer&) const override { return {}; }
    bool load(world::World&, Unpacker&) override { return true; }
    std::size_t known = 0;
  };
  StillSimulation still(kRobot);
  auto owned = std::make_unique<Counter>();
  const Counter& counter = *owned;
  std::size_t known = 0;
  still.world().deciders.push_back(std::move(owned));
  still.simulation.requests().post([&](world::Journal& journal) { EXPECT_TRUE(journal.spawn(0, {})); });
  still.simulation.follow(on_show([&](const world::World&, const world::Pace&) { known = counter.known; }));
  still.run(0);
  EXPECT_EQ(known, 2u);
}

TEST(Simulation, a_paused_world_does_what_is_posted_and_single_steps_only) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  Simulation simulation(std::make_unique<StillEngine>(scene), {.speed = 1, .paused = true});
  std::uint64_t at_first = 99, at_second = 99;
  std::thread ticks([&] { simulation.run(); });
  simulation.requests().post([&](const world::Journal& journal) {
    at_first = journal.world().tick();
    simulation.requests().step_once();
    simulation.requests().step_once();
  });
  // Each listener call after a tick asks again, so the thread ends when both steps are done.
  while (simulation.time() < 0.15) std::this_thread::yield();
  simulation.requests().post([&](const world::Journal& journal) {
    at_second = journal.world().tick();
    simulation.requests().stop();
  });
  ticks.join();
  EXPECT_EQ(at_first, 0u);
  EXPECT_EQ(at_second, 2u);
  EXPECT_TRUE(simulation.requests().pace().paused);
}

TEST(Simulation, shows_the_world_again_while_the_next_tick_is_far) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  Simulation simulation(std::make_unique<StillEngine>(scene), {.speed = 1e-6});
  int shown = 0;
  simulation.follow(on_show([&](const world::World& world, const world::Pace& pace) {
    EXPECT_FALSE(pace.paused);
    if (world.tick() <= 1 && ++shown == 4) simulation.requests().stop();
  }));
  simulation.run();
  EXPECT_GE(shown, 4);
}

TEST(Simulation, refuses_speeds_that_make_no_sense) {
  StillSimulation still(kRobot);
  still.simulation.requests().set_speed(-1);
  still.simulation.requests().set_speed(std::nan(""));
  EXPECT_EQ(still.simulation.requests().pace().speed, 0);
  still.simulation.requests().set_speed(2);
  EXPECT_EQ(still.simulation.requests().pace().speed, 2);
}

TEST(Simulation, a_tiny_speed_is_slow_and_not_fast) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  Simulation simulation(std::make_unique<StillEngine>(scene), {.speed = 1e-300, .duration = 10});
  std::atomic<bool> ended = false;
  std::thread ticks([&] {
    simulation.run();
    ended = true;
  });
  // A clock that overflows has ticked on, or has ended the run, long before these are through.
  std::atomic<int> looks = 0;
  while (looks < 100 && !ended) {
    const int before = looks;
    simulation.requests().post([&](const world::Journal&) { ++looks; });
    while (looks == before && !ended) std::this_thread::yield();
  }
  simulation.requests().stop();
  ticks.join();
  EXPECT_EQ(looks, 100);
  EXPECT_LE(simulation.world().tick(), 1u) << "the first is due at once";
}

TEST(Simulation, a_flood_of_pauses_and_speeds_runs_no_tick_ahead_of_its_time) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  std::atomic<double> now = 0;
  Simulation simulation(std::make_unique<StillEngine>(scene),
                        {.speed = 1, .clock = [&] { return now.load(); }});
  std::thread ticks([&] { simulation.run(); });
  const auto carry_out = [&] {
    // What is posted may overtake a pause or a resume that was said before, but not twice.
    for (int time = 0; time < 2; ++time) {
      std::atomic<bool> done = false;
      simulation.requests().post([&](const world::Journal&) { done = true; });
      while (!done) std::this_thread::yield();
    }
  };
  for (int step = 0; step <= 20; ++step) {
    now = step * 0.0505;
    for (int i = 0; i < 5; ++i) {
      simulation.requests().pause();
      carry_out();
      simulation.requests().set_speed(2);
      carry_out();
      simulation.requests().set_speed(1);
      simulation.requests().resume();
      carry_out();
    }
  }
  simulation.requests().stop();
  ticks.join();
  EXPECT_EQ(simulation.world().tick(), 11u) << "one at once and then ten in 1.01 s";
}

TEST(Simulation, single_steps_that_wait_are_forgotten_when_the_world_resumes) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  Simulation simulation(std::make_unique<StillEngine>(scene), {.speed = 1, .clock = [] { return 0.0; }});
  simulation.requests().pause();
  std::thread ticks([&] { simulation.run(); });
  simulation.requests().post([&](const world::Journal&) {
    for (int i = 0; i < 60; ++i) simulation.requests().step_once();
    simulation.requests().resume();
  });
  std::atomic<int> looks = 0;
  while (looks < 10) {
    const int before = looks;
    simulation.requests().post([&](const world::Journal&) { ++looks; });
    while (looks == before) std::this_thread::yield();
  }
  simulation.requests().stop();
  ticks.join();
  EXPECT_LE(simulation.world().tick(), 1u) << "the first is due at once";
}

/// A paused world whose ticks wait for the test.
class SingleSteps : public ::testing::Test {
 protected:
  SingleSteps() {
    simulation_.follow(on_show([this](const world::World& world, const world::Pace&) {
      while (world.tick() > allowed_) std::this_thread::yield();
    }));
    ticks_ = std::thread([this] { simulation_.run(); });
  }
  ~SingleSteps() override {
    allowed_ = kAll;
    simulation_.requests().stop();
    ticks_.join();
  }
  /// Of a client; once answered, by the tick or why not.
  struct Asked {
    std::atomic<std::uint64_t> done_at = kAll;
    std::string why_not;
  };
  void step(std::uint64_t ticks, Asked& asked) {
    simulation_.requests().step(ticks, [this, &asked](const std::optional<std::string>& why_not) {
      asked.why_not = why_not.value_or("");
      asked.done_at = why_not ? 0 : simulation_.world().tick();
    });
  }
  /// The first tick of what was asked for is done, the rest is not.
  void wait_for_first_tick() {
    while (simulation_.time() == 0) std::this_thread::yield();
  }
  static constexpr std::uint64_t kAll = 1u << 30;

  const scene::SceneDesc scene_ = testing::scene_of(kRobot);
  Simulation simulation_{std::make_unique<StillEngine>(scene_), {.speed = 1, .paused = true}};
  std::atomic<std::uint64_t> allowed_ = 0;
  std::thread ticks_;
};

TEST_F(SingleSteps, that_are_acknowledged_are_done) {
  Asked first, second, third;
  step(limits::kSingleSteps, first);
  wait_for_first_tick();
  step(limits::kSingleSteps, second);
  EXPECT_EQ(second.done_at, 0u);
  EXPECT_EQ(second.why_not, "too many steps are waiting: 1000 at most");
  step(1, third);
  allowed_ = kAll;
  while (first.done_at == kAll || third.done_at == kAll) std::this_thread::yield();
  EXPECT_EQ(third.done_at, limits::kSingleSteps + 1);
  EXPECT_EQ(first.why_not + third.why_not, "");
}

TEST_F(SingleSteps, of_a_running_world_are_refused_without_effect) {
  allowed_ = kAll;
  simulation_.requests().resume();
  Asked asked;
  step(1, asked);
  EXPECT_EQ(asked.done_at, 0u);
  EXPECT_EQ(asked.why_not, "the world is running: pause it first, or start it with --lock-step");
  EXPECT_FALSE(simulation_.requests().pace().paused);
}

TEST_F(SingleSteps, that_are_too_many_leave_the_world_paused) {
  Asked asked;
  step(limits::kSingleSteps + 1, asked);
  EXPECT_EQ(asked.done_at, 0u);
  EXPECT_TRUE(simulation_.requests().pace().paused);
}

TEST(Simulation, what_still_waits_at_the_end_is_refused) {
  /// Counts requests that end, carried out or not.
  struct Ends {
    explicit Ends(int& count) : count(count) {}
    ~Ends() { ++count; }
    int& count;
  };
  int carried_out = 0, ended = 0;
  StillSimulation still(kRobot);
  still.simulation.requests().post(
      [&, ends = std::make_shared<Ends>(ended)](const world::Journal&) { ++carried_out; });
  EXPECT_EQ(ended, 0);
  still.simulation.discard();
  EXPECT_EQ(ended, 1);
  EXPECT_FALSE(still.simulation.requests().post([](const world::Journal&) {})) << "nobody would carry it out";
  still.simulation.requests().post_always(
      [&, ends = std::make_shared<Ends>(ended)](const world::Journal&) { ++carried_out; }, {});
  EXPECT_EQ(ended, 2);
  EXPECT_EQ(carried_out, 0);
}

TEST(Simulation, goes_back_to_an_instant_and_another_way_from_there) {
  StillSimulation still(kRobot);
  using Ticks = std::vector<std::uint64_t>;
  still.run(5);
  EXPECT_TRUE(still.simulation.requests().timeline()->ticks.empty()) << "nobody asked for it";
  still.simulation.requests().record(true);
  still.run(30);
  EXPECT_EQ(still.simulation.requests().timeline()->ticks, (Ticks{5, 10, 20, 30}));
  testing::rewind_to(still.simulation, 10);
  EXPECT_EQ(still.world().tick(), 10u);
  EXPECT_DOUBLE_EQ(still.simulation.time(), 1.0);
  EXPECT_EQ(still.simulation.requests().timeline()->ticks, (Ticks{5, 10, 20, 30, 35}))
      << "with the moment that was left";
  testing::rewind_to(still.simulation, 35);
  EXPECT_EQ(still.world().tick(), 35u) << "and back again";
  testing::rewind_to(still.simulation, 20, 3);
  EXPECT_EQ(still.world().tick(), 23u);
  EXPECT_EQ(still.simulation.requests().timeline()->ticks, (Ticks{5, 10, 20}))
      << "what comes later is another now";
}

TEST(Simulation, does_not_go_back_where_nothing_is_kept) {
  StillSimulation still(kRobot);
  still.simulation.requests().rewind(0);
  still.run(3);
  EXPECT_EQ(still.world().tick(), 3u);
}

TEST(Simulation, tells_followers_and_then_listeners_that_the_world_is_another) {
  StillSimulation still(kRobot);
  still.simulation.requests().record(true);
  still.run(20);
  std::string told;
  still.simulation.follow(on_event([&](const world::World& world, const world::Event& event) {
    if (event.kind == world::Event::EventKind::kReload)
      told += "reloaded " + std::to_string(world.tick()) + ", ";
  }));
  still.simulation.follow(on_show(
      [&](const world::World& world, const world::Pace&) { told += std::to_string(world.tick()) + ", "; }));
  testing::rewind_to(still.simulation, 10);
  EXPECT_EQ(told, "20, reloaded 10, 10, ") << "the pace is shown first";
}

TEST(Simulation, who_uses_a_model_goes_on_with_it_unless_it_came_back) {
  StillSimulation still(kRobot);
  still.simulation.requests().record(true);
  still.run(10);
  world::Use stays, ends;
  world::ModelId late;
  still.simulation.requests().post([&](world::Journal& journal) {
    late = *journal.spawn(0, {});
    stays.begin(journal, still.simulation.requests(), {0});
  });
  still.run(10);
  still.simulation.requests().post(
      [&](world::Journal& journal) { ends.begin(journal, still.simulation.requests(), late); });
  still.run(1);
  const auto users = [&](world::ModelId model) {
    return still.world().models.subscribers[still.world().row(model)];
  };
  EXPECT_EQ(users(late), 1u);
  testing::rewind_to(still.simulation, 10);
  EXPECT_FALSE(still.world().row(late));
  EXPECT_EQ(users({0}), 1u) << "who uses it is of now";
  testing::rewind_to(still.simulation, 20);
  ASSERT_TRUE(still.world().row(late));
  EXPECT_EQ(users(late), 0u);
  EXPECT_EQ(users({0}), 1u);
  EXPECT_FALSE(ends.end(still.simulation.journal(), still.simulation.requests()));
  EXPECT_TRUE(stays.end(still.simulation.journal(), still.simulation.requests()));
  EXPECT_EQ(users({0}), 0u);
}

TEST(Simulation, gives_no_id_a_second_time_after_it_went_back) {
  StillSimulation still(kRobot);
  world::ModelId first, second;
  still.simulation.requests().record(true);
  still.run(1);
  const std::uint64_t hash = still.world().hash();
  still.simulation.requests().post([&](world::Journal& journal) { first = *journal.spawn(0, {}); });
  still.run(3);
  testing::rewind_to(still.simulation, 1);
  still.simulation.requests().post([](const world::Journal&) {});
  still.run(0);
  EXPECT_EQ(still.world().hash(), hash) << "nobody came yet";
  still.simulation.requests().post([&](world::Journal& journal) { second = *journal.spawn(0, {}); });
  still.run(0);
  EXPECT_GT(second, first);
}

TEST(Simulation, is_paced_anew_after_it_went_back) {
  const scene::SceneDesc scene = testing::scene_of(kRobot);
  std::atomic<double> now = 0;
  Simulation simulation(std::make_unique<StillEngine>(scene),
                        {.speed = 1, .clock = [&] { return now.load(); }});
  simulation.requests().record(true);
  std::thread ticks([&] { simulation.run(); });
  const auto carry_out = [&] {
    for (int time = 0; time < 2; ++time) {
      std::atomic<bool> done = false;
      simulation.requests().post([&](const world::Journal&) { done = true; });
      while (!done) std::this_thread::yield();
    }
  };
  carry_out();  // the first instant is kept before time goes on, or its keeping looks dear
  for (int k = 1; k <= 15; ++k) {
    now = k * 0.101;
    carry_out();
  }
  simulation.requests().rewind(10);
  carry_out();
  carry_out();
  simulation.requests().stop();
  ticks.join();
  EXPECT_LE(simulation.world().tick(), 11u) << "the first is due at once, and nothing is caught up";
}

}  // namespace
}  // namespace playhouse::run
