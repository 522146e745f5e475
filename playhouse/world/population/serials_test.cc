#include "playhouse/world/population/serials.h"

#include <gtest/gtest.h>

#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::world {
namespace {

TEST(Serials, are_ids_until_there_is_a_gap) {
  const Serials serials;
  EXPECT_EQ(serials.of({0}), 0u);
  EXPECT_EQ(serials.of({7}), 7u);
  EXPECT_EQ(serials.of({}), ModelId::kNone);
}

TEST(Serials, leave_gaps_out) {
  Serials serials;
  ASSERT_TRUE(serials.add({3, 10}));
  ASSERT_TRUE(serials.add({12, 13}));
  EXPECT_EQ(serials.of({2}), 2u);
  EXPECT_EQ(serials.of({10}), 3u);
  EXPECT_EQ(serials.of({11}), 4u);
  EXPECT_EQ(serials.of({13}), 5u);
  EXPECT_EQ(serials.of({}), ModelId::kNone);
  EXPECT_FALSE(serials.is_in_gap({2}));
  EXPECT_TRUE(serials.is_in_gap({3}));
  EXPECT_TRUE(serials.is_in_gap({9}));
  EXPECT_FALSE(serials.is_in_gap({10}));
}

TEST(Serials, refuse_gaps_that_are_empty_or_not_above_the_others) {
  Serials serials;
  EXPECT_FALSE(serials.add({3, 3}));
  EXPECT_FALSE(serials.add({3, 2}));
  ASSERT_TRUE(serials.add({3, 10}));
  EXPECT_FALSE(serials.add({10, 12})) << "one gap, not two";
  EXPECT_FALSE(serials.add({5, 12}));
  EXPECT_EQ(serials.gaps().size(), 1u);
}

/// A scene of two boxes, to which another came behind a gap of ids.
class AfterGap : public ::testing::Test {
 protected:
  AfterGap() {
    come(world_, {});
    come(gapped_, {2, 40});
  }
  static void come(World& world, const Serials::Gap& gap) {
    Population population(world);
    if (population.serials().add(gap)) population.next_id() = gap.end;
    const Result<ModelId> id = spawn(world, 0, {1, 2, 0, 0}, "third");
    ASSERT_TRUE(id);
    ASSERT_TRUE(attach(world, *id, {1}, {}).ok());
  }

  static scene::SceneDesc two_boxes() {
    scene::SceneDesc scene;
    scene.models.resize(2);
    return scene;
  }

  const scene::SceneDesc scene_ = two_boxes();
  World world_{scene_, 1}, gapped_{scene_, 1};
};

TEST_F(AfterGap, a_world_is_what_it_would_be_without) {
  EXPECT_EQ(world_.id({2}), ModelId{2});
  EXPECT_EQ(gapped_.id({2}), ModelId{40});
  EXPECT_EQ(gapped_.serial(ModelRow{2}), 2u);
  EXPECT_EQ(gapped_.hash(), world_.hash());
  EXPECT_EQ(gapped_.sensed_hash(), world_.sensed_hash());
  EXPECT_FALSE(first_difference(gapped_, world_).has_value());
}

TEST_F(AfterGap, a_state_keeps_the_gap) {
  std::vector<std::byte> state, again;
  ASSERT_TRUE(save_state(gapped_, state).ok());
  World read(scene_, 1);
  ASSERT_TRUE(load_state(read, state).ok());
  EXPECT_EQ(read.id({2}), ModelId{40});
  EXPECT_EQ(read.hash(), world_.hash());
  ASSERT_TRUE(save_state(read, again).ok());
  EXPECT_EQ(again, state);
}

TEST_F(AfterGap, a_state_with_a_model_in_a_gap_is_refused) {
  Population(gapped_).serials().clear();
  ASSERT_TRUE(Population(gapped_).serials().add({1, 40}));
  std::vector<std::byte> state;
  ASSERT_TRUE(save_state(gapped_, state).ok());
  World read(scene_, 1);
  EXPECT_FALSE(load_state(read, state).ok());
}

}  // namespace
}  // namespace playhouse::world
