#include "playhouse/record/selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/scene/world_loader.h"

namespace playhouse::record {
namespace {

constexpr const char* kWorld = R"(
define eye ranger( sensor( range [0 8] samples 3 ) )
define robot position( eye() )
robot( name "a" pose [0 0 0 0] ) robot( name "b" pose [2 0 0 0] joules 100 )
)";

class SelectionTest : public testing::Test {
 protected:
  bool has(const char* selection, const char* model, const char* kind) {
    return Selection::parse(selection)->has(world_, world_.find(model), kind);
  }
  config::MemoryFiles files_{{}};
  scene::SceneDesc scene_ = *scene::load_world_text(kWorld, "t.world", files_, {}, nullptr);
  world::World world_{scene_, 1};
};

TEST_F(SelectionTest, is_everything_unless_something_is_said) {
  EXPECT_TRUE(Selection().has(world_, world_.find("a"), "position"));
}

TEST_F(SelectionTest, of_a_kind_has_all_of_that) {
  EXPECT_TRUE(has("ranger", "a.ranger:0", "ranger"));
  EXPECT_FALSE(has("ranger", "a", "position"));
}

TEST_F(SelectionTest, of_a_name_has_all_that_is_in_it) {
  EXPECT_TRUE(has("@a", "a.ranger:0", "ranger"));
  EXPECT_TRUE(has("@a", "a", "position"));
  EXPECT_FALSE(has("@a", "b", "position"));
}

TEST_F(SelectionTest, of_both_has_what_is_both) {
  EXPECT_TRUE(has("pack,ranger@b", "b.ranger:0", "ranger"));
  EXPECT_FALSE(has("pack,ranger@b", "a.ranger:0", "ranger"));
  EXPECT_FALSE(has("pack,ranger@b", "b", "position"));
  EXPECT_TRUE(has("pack,ranger@b", "b", "pack"));
}

TEST_F(SelectionTest, of_poses_has_nothing_else) {
  EXPECT_FALSE(has("poses", "a", "position"));
  EXPECT_FALSE(has("poses", "a.ranger:0", "ranger"));
}

TEST_F(SelectionTest, refuses_what_is_none_with_the_nearest_word) {
  EXPECT_EQ(Selection::parse("postion@a").error().text,
            "no kind that can be recorded is called \"postion\" (did you mean \"position\"?)");
  EXPECT_FALSE(Selection::parse("").ok());
  EXPECT_FALSE(Selection::parse("ranger,").ok());
  EXPECT_FALSE(Selection::parse("ranger@").ok());
}

TEST_F(SelectionTest, knows_names_that_nobody_has) {
  EXPECT_THAT(Selection::parse("ranger@a,@c")->unknown_names(world_), testing::ElementsAre("c"));
}

}  // namespace
}  // namespace playhouse::record
