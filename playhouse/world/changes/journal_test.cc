#include "playhouse/world/changes/journal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/base/limits.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/saving/state.h"
#include "playhouse/world/testing_scene.h"

namespace playhouse::world {
namespace {

constexpr ModelId kRobot{0}, kRanger{1}, kBox{2}, kNobody{77};

class JournalTest : public ::testing::Test {
 protected:
  const scene::SceneDesc scene_ = testing::small_scene();
  World world_{scene_, 1};
  Journal journal_{world_};
};

TEST_F(JournalTest, keeps_what_it_did_in_order) {
  EXPECT_TRUE(journal_.apply(changes::Drive{kRobot, {0.5, 0, 0, 0}}));
  EXPECT_TRUE(journal_.apply(changes::Subscribe{kRanger}));
  ASSERT_EQ(journal_.entries().size(), 2u);
  EXPECT_TRUE(std::holds_alternative<changes::Drive>(journal_.entries()[0]));
  EXPECT_EQ(std::get<changes::Subscribe>(journal_.entries()[1]).model, kRanger);
  EXPECT_EQ(world_.positions.command[{0}].x, 0.5);
  EXPECT_EQ(world_.models.subscribers[{1}], 1u);
  journal_.clear();
  EXPECT_TRUE(journal_.entries().empty());
}

TEST_F(JournalTest, does_nothing_to_who_is_gone_or_of_another_kind) {
  const std::uint64_t hash = world_.hash(), sensed = world_.sensed_hash();
  EXPECT_FALSE(journal_.apply(changes::Drive{kNobody, {1, 0, 0, 0}}));
  EXPECT_FALSE(journal_.apply(changes::Drive{kBox, {1, 0, 0, 0}}));
  EXPECT_FALSE(journal_.apply(changes::Place{kNobody, {}}));
  EXPECT_FALSE(journal_.apply(changes::SetCharging{kRobot, false, false})) << "it has no battery";
  EXPECT_FALSE(journal_.apply(changes::Grip{kRobot, GripperCommand::kOpen}));
  EXPECT_EQ(world_.hash(), hash);
  EXPECT_EQ(world_.sensed_hash(), sensed);
  EXPECT_TRUE(journal_.entries().empty());
}

TEST_F(JournalTest, refuses_what_no_device_would_ask_for) {
  const std::uint64_t hash = world_.hash(), sensed = world_.sensed_hash();
  EXPECT_FALSE(journal_.apply(changes::Drive{kRobot, {NAN, 0, 0, 0}}));
  EXPECT_FALSE(journal_.apply(changes::Place{kBox, {INFINITY, 0, 0, 0}}));
  EXPECT_FALSE(journal_.apply(changes::PlaceIn3D{kBox, {{}, {10, 0}}}));
  EXPECT_FALSE(journal_.apply(changes::SetColor{kBox, {NAN, 0, 0, 1}}));
  EXPECT_FALSE(journal_.apply(changes::Unsubscribe{kRanger})) << "nobody uses it";
  EXPECT_FALSE(journal_.apply(changes::Unwatch{kRanger}));
  EXPECT_FALSE(journal_.apply(changes::Attach{{kBox}, kRobot, {}})) << "without its pose";
  EXPECT_FALSE(journal_.apply(changes::Load{}));
  EXPECT_FALSE(journal_.spawn(99, {}));
  EXPECT_EQ(world_.hash(), hash);
  EXPECT_EQ(world_.sensed_hash(), sensed);
  EXPECT_TRUE(journal_.entries().empty());
}

TEST_F(JournalTest, ends_only_the_uses_that_were_begun) {
  subscribe_controller(world_, world_.row(kRanger));
  EXPECT_TRUE(journal_.apply(changes::Watch{kRanger}));
  EXPECT_FALSE(journal_.apply(changes::Unsubscribe{kRanger}))
      << "one is a controller's, the other a watcher's";
  EXPECT_TRUE(journal_.apply(changes::Unwatch{kRanger}));
  EXPECT_FALSE(journal_.apply(changes::Unwatch{kRanger}));
  EXPECT_EQ(world_.models.subscribers[{1}], 1u);
}

TEST_F(JournalTest, refuses_what_is_named_twice_without_effect) {
  const ModelId puck = *journal_.spawn(2, {5, 5, 0, 0}, "puck");
  EXPECT_FALSE(journal_.apply(changes::Attach{{puck, puck}, kRobot, {{}, {}}}));
  ASSERT_TRUE(journal_.apply(changes::Attach{{puck}, kRobot, {{}}}));
  const std::uint64_t hash = world_.hash();
  EXPECT_FALSE(journal_.apply(changes::Detach{{puck, puck}}));
  EXPECT_EQ(world_.hash(), hash);
  EXPECT_TRUE(journal_.apply(changes::Detach{{puck}}));
  EXPECT_FALSE(journal_.apply(changes::Despawn{{puck, puck}}));
}

TEST(Journal, has_what_a_radio_drops_for_that_is_counted) {
  config::MemoryFiles files({}, {});
  const scene::SceneDesc scene = *scene::load_world_text("model( wifi() )", "t.world", files);
  World world(scene, 1), again(scene, 1);
  Journal journal(world), other(again);
  const ModelId radio = world.id(world.wifis.model[{0}]);
  for (std::size_t n = 0; n < limits::kRadioSends + 3; ++n)
    journal.apply(changes::Send{radio, {}, {1, 2, 3}});
  EXPECT_EQ(world.wifis.dropped[{0}], 3u);
  EXPECT_FALSE(
      journal.apply(changes::Send{radio, {}, std::vector<std::uint8_t>(limits::kRadioMessageBytes + 1)}));
  for (const Change& change : journal.entries()) EXPECT_TRUE(other.apply(change));
  EXPECT_EQ(first_difference(world, again), std::nullopt);
}

/// The truth is what the same changes did the first time.
TEST_F(JournalTest, applied_to_the_same_world_gives_the_same_world) {
  std::vector<std::byte> start;
  ASSERT_TRUE(save_state(world_, start));
  const auto kept = std::make_shared<const std::vector<std::byte>>(start);
  const ModelId first = *journal_.spawn(0, {5, 5, 0, 0}, "late");
  journal_.apply(changes::Drive{first, {1, 0, 0, 0}});
  ASSERT_TRUE(journal_.load(kept, 9));
  const ModelId second = *journal_.spawn_copy(kRobot, {6, 5, 0, 0});
  journal_.apply(changes::SetColor{second, {0, 1, 0, 1}});
  EXPECT_GT(second, first) << "no id names two models";
  EXPECT_FALSE(journal_.spawn(0, {7, 7, 0, 0}, "box")) << "the name is taken";

  World again(scene_, 1);
  Journal other(again);
  for (const Change& change : journal_.entries()) ASSERT_TRUE(other.apply(change));
  EXPECT_EQ(again.seed(), 9u);
  EXPECT_EQ(again.row(second), world_.row(second));
  EXPECT_EQ(again.hash(), world_.hash());
  EXPECT_EQ(first_difference(again, world_), std::nullopt);
}

}  // namespace
}  // namespace playhouse::world
