#include "playhouse/run/history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "playhouse/run/testing/still_engine.h"
#include "playhouse/world/changes/packed_change.h"
#include "playhouse/world/decider.h"
#include "playhouse/world/saving/whole_state.h"

namespace playhouse::run {
namespace {

using ::testing::ElementsAre;
using Ticks = std::vector<std::uint64_t>;

constexpr std::uint64_t kSecond = 10;  // ticks

/// A world whose states all have one size, its history, and a clock that is stopped.
class HistoryTest : public ::testing::Test {
 protected:
  void run_to(History& history, std::uint64_t tick) {
    while (world_.tick() < tick) {
      history.continue_from(world_.tick());
      ++world_.tick_;
      history.record(world_);
    }
  }
  std::size_t state_bytes() const {
    std::vector<std::byte> state;
    EXPECT_TRUE(world::save_whole(world_, state));
    return state.size();
  }
  std::uint64_t before(const History& history, std::uint64_t tick) {
    world::World world(scene_, 1);
    EXPECT_TRUE(world::load_whole(world, *history.before(tick).whole));
    EXPECT_EQ(world.tick(), history.before(tick).tick);
    return world.tick();
  }
  static std::vector<std::string> said_at(const History& history, std::uint64_t tick) {
    std::vector<std::string> said;
    for (Unpacker in(history.changes_at(tick)); !in.at_end();)
      said.push_back(std::get<world::changes::Say>(*world::unpack_change(in)).text);
    return said;
  }
  static void say(History& history, const std::string& text) {
    const world::Change change = world::changes::Say{{0}, text};
    history.changed({&change, 1});
  }

  scene::SceneDesc scene_ = testing::scene_of("interval_sim 100\nposition( name \"r0\" )\n");
  world::World world_{scene_, 1};
  double now_ = 0;  // s
  std::function<double()> clock_ = [this] { return now_; };
};

TEST_F(HistoryTest, has_an_instant_at_once_and_then_every_whole_second) {
  History history(scene_.interval, clock_);
  EXPECT_TRUE(history.empty());
  world_.tick_ = 4;
  run_to(history, 35);
  EXPECT_EQ(history.timeline()->ticks, (Ticks{5, 10, 20, 30}));
  EXPECT_EQ(history.timeline()->why_none, "");
}

TEST_F(HistoryTest, has_the_last_keyframe_before_each_tick) {
  History history(scene_.interval, clock_);
  run_to(history, 33);
  EXPECT_EQ(history.timeline()->ticks, (Ticks{1, 10, 20, 30}));
  history.leave(world_);
  EXPECT_EQ(history.timeline()->ticks, (Ticks{1, 10, 20, 30, 33}));
  for (const auto& [tick, nearest, keyframe] : std::vector<std::array<std::uint64_t, 3>>{
           {0, 1, 1}, {10, 10, 10}, {19, 19, 10}, {20, 20, 20}, {32, 32, 30}, {33, 33, 33}, {4000, 33, 33}}) {
    EXPECT_EQ(history.nearest(tick), nearest) << tick;
    EXPECT_EQ(before(history, nearest), keyframe) << tick;
  }
}

TEST_F(HistoryTest, has_the_changes_between_ticks_of_the_run_that_went_on) {
  History history(scene_.interval, clock_);
  say(history, "before there is anything to repeat");
  run_to(history, 5);
  EXPECT_THAT(said_at(history, 0), ElementsAre());
  say(history, "a");
  say(history, "b");
  run_to(history, 12);
  say(history, "c");
  EXPECT_THAT(said_at(history, 5), ElementsAre("a", "b"));
  EXPECT_THAT(said_at(history, 12), ElementsAre()) << "the run has not gone on";

  history.leave(world_);
  world_.tick_ = 7;
  history.arrive(world_);
  say(history, "dropped, for the run goes forth again");
  world_.tick_ = 12;
  history.arrive(world_);
  run_to(history, 13);
  EXPECT_THAT(said_at(history, 7), ElementsAre());
  EXPECT_THAT(said_at(history, 12), ElementsAre()) << "the keyframe of that tick has had it";
  EXPECT_EQ(before(history, 12), 12u);

  history.leave(world_);
  world_.tick_ = 5;
  history.arrive(world_);
  say(history, "d");
  run_to(history, 6);
  EXPECT_THAT(said_at(history, 5), ElementsAre("d"));
  EXPECT_THAT(said_at(history, 12), ElementsAre());
}

TEST_F(HistoryTest, keeps_changes_within_half_of_its_room) {
  constexpr std::size_t kRoom = 20;
  const std::string line(state_bytes() / 2, 'x');
  History history(scene_.interval, clock_, kRoom * state_bytes());
  for (std::uint64_t tick = 1; tick < 100; ++tick) {
    run_to(history, tick);
    say(history, line);
    ASSERT_FALSE(history.empty());
    ASSERT_GE(history.timeline()->ticks.front() + 20, tick);
  }
  for (int line_of_one_tick = 0; line_of_one_tick < 22; ++line_of_one_tick) say(history, line);
  EXPECT_TRUE(history.empty()) << "there is nothing to go back to from a tick with more";
  run_to(history, 101);
  EXPECT_EQ(history.timeline()->ticks, (Ticks{100}));
}

TEST_F(HistoryTest, has_drawings_in_keyframes_alone) {
  History history(scene_.interval, clock_, 20 * state_bytes());
  const world::Change drawn = world::changes::Draw{{0}, 0, 1, {}, std::vector<geom::Vec3>(state_bytes())},
                      cleared = world::changes::ClearDrawing{{0}, 0};
  for (std::uint64_t tick = 1; tick < 100; ++tick) {
    run_to(history, tick);
    for (const world::Change& change : {cleared, drawn}) history.changed({&change, 1});
    EXPECT_TRUE(history.changes_at(tick - 1).empty());
    ASSERT_FALSE(history.empty());
  }
  EXPECT_EQ(history.timeline()->ticks.front(), 1u) << "they take no room of what can be repeated";
  world_.models.drawing.own({0}).push_back({1, 0, 0, 0xFF, 1, 0});
  run_to(history, 100);
  world::World then(scene_, 1);
  ASSERT_TRUE(world::load_whole(then, *history.before(100).whole));
  EXPECT_EQ(then.models.drawing[{0}].size(), 1u);
}

TEST_F(HistoryTest, of_any_length_has_the_last_minutes_alone) {
  History history(scene_.interval, clock_);
  const auto span = static_cast<std::uint64_t>(limits::kHistorySeconds) * kSecond;
  run_to(history, 3 * span);
  const Ticks& ticks = history.timeline()->ticks;
  EXPECT_EQ(ticks.size(), static_cast<std::size_t>(limits::kHistorySeconds) + 1);
  EXPECT_EQ(ticks.front(), 2 * span);
  EXPECT_EQ(ticks.back(), 3 * span);
}

TEST_F(HistoryTest, without_room_is_sparser_the_longer_ago) {
  constexpr std::size_t kRoom = 40;
  History history(scene_.interval, clock_, kRoom * state_bytes());
  const auto span = static_cast<std::uint64_t>(limits::kHistorySeconds) * kSecond;
  for (std::uint64_t end = span / 2; end <= 4 * span; end += 7 * kSecond) {
    run_to(history, end);
    const Ticks& ticks = history.timeline()->ticks;
    ASSERT_LE(ticks.size(), kRoom);
    ASSERT_GE(ticks.size(), kRoom / 2);
    ASSERT_GE(world_.tick() - ticks.front(), end < span ? end - 1 : span * 3 / 4) << "it reaches far back";
    ASSERT_LE(world_.tick() - ticks.front(), span);
    for (std::size_t i = 1; i < ticks.size(); ++i) {
      const std::uint64_t gap = ticks[i] - ticks[i - 1], age = world_.tick() - ticks[i - 1];
      ASSERT_LE(gap, std::max(2 * kSecond, age * 2 / 5)) << end << ": " << ticks[i];
    }
  }
}

TEST_F(HistoryTest, forgets_what_lies_after_a_tick) {
  History history(scene_.interval, clock_);
  run_to(history, 30);
  history.continue_from(20);
  EXPECT_EQ(history.timeline()->ticks, (Ticks{1, 10, 20}));
  history.continue_from(19);
  EXPECT_EQ(history.timeline()->ticks, (Ticks{1, 10}));
  world_.tick_ = 10;
  run_to(history, 20);
  EXPECT_EQ(history.timeline()->ticks, (Ticks{1, 10, 20}));
}

TEST_F(HistoryTest, is_the_same_list_until_it_changes) {
  History history(scene_.interval, clock_);
  run_to(history, 11);
  const auto timeline = history.timeline();
  run_to(history, 19);
  EXPECT_EQ(history.timeline(), timeline);
  run_to(history, 20);
  EXPECT_NE(history.timeline(), timeline);
}

TEST_F(HistoryTest, costs_a_hundredth_of_the_time_at_most) {
  // Each look at the clock takes 10 ms, so a state seems to; a second passes in 0.1 s.
  History history(scene_.interval, [this] { return now_ += 0.01; });
  for (int tick = 1; tick <= 1000; ++tick) {
    run_to(history, static_cast<std::uint64_t>(tick));
    now_ += 0.01;
  }
  const std::size_t states = history.timeline()->ticks.size();
  EXPECT_LE(static_cast<double>(states) * 0.01, now_ / 100 + 0.01);
  EXPECT_GE(states, 8u);
}

/// A controller that cannot say what it remembers.
class Mute final : public world::Decider {
 public:
  std::string_view name() const override { return "mute"; }
  std::size_t size() const override { return 0; }
  void follow(world::World&) override {}
  void decide(world::World&, std::size_t, std::size_t) override {}
  void hash(const world::World&, Hash&) const override {}
  Result<void> save(Packer&) const override { return Error{"", "controller mute cannot be saved"}; }
  bool load(world::World&, Unpacker&) override { return false; }
};

TEST_F(HistoryTest, says_why_there_is_none) {
  History history(scene_.interval, clock_);
  world_.deciders.push_back(std::make_unique<Mute>());
  run_to(history, 20);
  EXPECT_TRUE(history.empty());
  EXPECT_EQ(history.timeline()->why_none, "controller mute cannot be saved");

  History lost(scene_.interval, clock_);
  world_.deciders.clear();
  world_.models.X_PM.own({0}).x = 1e10;
  run_to(lost, 30);
  EXPECT_TRUE(lost.empty()) << "it could not be loaded";
  EXPECT_NE(lost.timeline()->why_none, "");
  world_.models.X_PM.own({0}).x = 0;
  run_to(lost, 40);
  EXPECT_FALSE(lost.empty());
  EXPECT_EQ(lost.timeline()->why_none, "");

  History small(scene_.interval, clock_, 10);
  run_to(small, 50);
  EXPECT_TRUE(small.empty());
  EXPECT_NE(small.timeline()->why_none, "");
}

}  // namespace
}  // namespace playhouse::run
