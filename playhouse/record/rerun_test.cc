#include "playhouse/record/rerun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/scene/world_loader.h"
#include "playhouse/world/changes/journal.h"
#include "playhouse/world/changes/packed_change.h"
#include "playhouse/world/saving/whole_state.h"

namespace playhouse::record {
namespace {

using testing::HasSubstr;

constexpr const char* kWorld =
    "interval_sim 100\nposition( name \"r0\" ) position( name \"r1\" pose [2 0 0 0] )\n";

/// Time goes on, and nothing else happens.
class TimeEngine final : public world::Engine {
 public:
  explicit TimeEngine(const scene::SceneDesc& scene) : world_(scene, 1) {}
  void step() override { ++world_.tick_; }
  world::World& world() override { return world_; }
  world::Workers& workers() override { return workers_; }
  std::uint64_t rays() const override { return 0; }

 private:
  world::World world_;
  world::Workers workers_{1};
};

class RerunTest : public testing::Test {
 protected:
  RerunTest() {
    keep_state();
    for (int tick = 0; tick < 20; ++tick) {
      if (tick == 5) happen(world::changes::Place{{1}, {3, 4, 0, 1}});
      if (tick == 8) happen(world::changes::Spawn{0, {}, "late", 0});
      if (tick == 10) keep_state();
      if (tick == 12) happen(world::changes::Subscribe{{0}});
      engine_.step();
    }
    check();
  }
  void keep_state() {
    Recording::State state{engine_.world().tick(), recording_.items.size(), {}};
    Bytes bytes;
    ASSERT_TRUE(world::save_whole(engine_.world(), bytes));
    state.bytes = PackedBytes(bytes);
    recording_.states.push_back(state);
  }
  void happen(const world::Change& change) {
    const std::uint64_t tick = engine_.world().tick();
    ASSERT_TRUE(world::Journal(engine_.world()).apply(change));
    Bytes packed;
    world::pack(change, packed);
    recording_.items.push_back({tick, PackedBytes(packed), 0, 0});
  }
  void check() {
    const world::World& world = engine_.world();
    recording_.items.push_back({world.tick(), {}, world.hash(), world.sensed_hash()});
  }
  std::unique_ptr<Rerun> rerun() {
    auto rerun = std::make_unique<Rerun>(recording_, std::make_unique<TimeEngine>(scene_));
    EXPECT_TRUE(rerun->begin());
    return rerun;
  }
  static void run(Rerun& rerun) {
    while (!rerun.at_end() && !rerun.differs()) rerun.step();
  }

  config::MemoryFiles files_{{}};
  scene::SceneDesc scene_ = *scene::load_world_text(kWorld, "t.world", files_);
  TimeEngine engine_{scene_};
  Recording recording_;
};

TEST_F(RerunTest, does_what_was_recorded) {
  const auto again = rerun();
  run(*again);
  EXPECT_FALSE(again->differs()) << *again->differs();
  EXPECT_EQ(again->world().tick(), 20u);
  EXPECT_EQ(again->world().hash(), engine_.world().hash());
  EXPECT_EQ(again->world().models.subscribers, engine_.world().models.subscribers);
  EXPECT_EQ(again->checks(), 1u);
}

/// The truth is the world that was loaded and went on.
TEST_F(RerunTest, goes_back_where_the_run_was_taken_back) {
  Bytes whole = recording_.states[1].bytes.unpacked();
  const std::span<const std::byte> state = world::state_of(whole);
  happen(world::changes::Load{1, std::make_shared<const std::vector<std::byte>>(state.begin(), state.end())});
  EXPECT_EQ(engine_.world().tick(), 10u);
  happen(world::changes::Spawn{0, {5, 5, 0, 0}, "again", 77});
  for (int tick = 0; tick < 5; ++tick) engine_.step();
  check();
  const auto again = rerun();
  run(*again);
  EXPECT_FALSE(again->differs()) << *again->differs();
  EXPECT_EQ(again->checks(), 2u);
  EXPECT_EQ(again->world().tick(), 15u);
  EXPECT_EQ(again->world().id(again->world().find("again")), world::ModelId{77});
}

TEST_F(RerunTest, goes_to_any_moment_and_on_from_there) {
  const auto again = rerun();
  for (const std::uint64_t tick : {20, 3, 15, 0, 9, 10}) {
    again->seek(tick);
    EXPECT_EQ(again->world().tick(), tick);
    EXPECT_EQ(again->world().find("late").valid(), tick > 8) << tick;
  }
  run(*again);
  EXPECT_FALSE(again->differs());
  EXPECT_EQ(again->world().hash(), engine_.world().hash());
  again->seek(1000);
  EXPECT_EQ(again->world().tick(), 20u) << "the last there is";
  EXPECT_EQ(again->last_tick(), 20u);
}

TEST_F(RerunTest, says_where_a_run_is_another_one) {
  recording_.items.back().hash ^= 1;
  const auto again = rerun();
  run(*again);
  ASSERT_TRUE(again->differs());
  EXPECT_THAT(*again->differs(), HasSubstr("at 2 s, tick 20: robots did something else"));
}

TEST_F(RerunTest, says_where_a_change_cannot_be_made) {
  Bytes packed;
  world::pack(world::changes::Place{{7}, {3, 4, 0, 1}}, packed);
  recording_.items[1].change = PackedBytes(packed);
  const auto again = rerun();
  run(*again);
  ASSERT_TRUE(again->differs());
  EXPECT_THAT(*again->differs(), HasSubstr("tick 8: the change \"place\" of the recording cannot be made"));
}

TEST_F(RerunTest, of_a_damaged_change_or_state_leaves_a_world_that_can_be_looked_at) {
  const auto cut = [](PackedBytes& bytes, std::size_t size) {
    Bytes some = bytes.unpacked();
    some.resize(size);
    bytes = PackedBytes(some);
  };
  cut(recording_.items[1].change, 10);
  cut(recording_.states[1].bytes, 60);
  const auto again = rerun();
  run(*again);
  ASSERT_TRUE(again->differs());
  EXPECT_THAT(*again->differs(), HasSubstr("damaged"));
  EXPECT_EQ(again->world().models.size(), 2u);
  again->seek(15);
  ASSERT_TRUE(again->differs());
  EXPECT_EQ(again->world().models.size(), 2u);
  again->seek(7);
  EXPECT_FALSE(again->differs()) << "what comes before is whole";
}

}  // namespace
}  // namespace playhouse::record
