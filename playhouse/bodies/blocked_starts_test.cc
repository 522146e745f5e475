// Robots that start in something: by hand, and against the tests of places that robots join at.

#include "playhouse/bodies/blocked_starts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "playhouse/scene/world_loader.h"

namespace playhouse::bodies {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kBitmap =
    "P1 8 8\n"
    "1 1 1 1 1 1 1 1\n"
    "1 0 0 0 0 0 0 1\n"
    "1 0 0 0 0 0 0 1\n"
    "1 0 0 0 0 0 0 1\n"
    "1 0 0 0 1 1 1 1\n"
    "1 0 0 0 1 1 1 1\n"
    "1 0 0 0 1 1 1 1\n"
    "1 1 1 1 1 1 1 1\n";
constexpr const char* kPlan =
    "define plan model( size [4 4 1] obstacle_return 1 )\n"
    "define robot position( size [0.4 0.4 0.3] origin [0 0 0 0] )\n";

std::vector<std::string> lines_of(const std::string& models) {
  config::MemoryFiles files(std::map<std::string, std::string>{{"plan.pbm", kBitmap}});
  const auto scene = scene::load_world_text(kPlan + models, "t.world", files);
  EXPECT_TRUE(scene) << (scene ? "" : scene.error().line());
  const world::World world(scene.value(), 1);
  return blocked_starts(world);
}

TEST(BlockedStarts, are_none_where_bodies_only_touch_or_are_above_each_other) {
  EXPECT_THAT(lines_of("robot( name \"a\" ) robot( name \"b\" pose [0.4 0 0 0] )"), IsEmpty());
  EXPECT_THAT(lines_of("robot( name \"a\" ) model( size [1 1 0.2] pose [0 0 0.3 0] )"), IsEmpty());
  EXPECT_THAT(lines_of("robot( name \"a\" ) model( size [1 1 1] obstacle_return 0 )"), IsEmpty());
  EXPECT_THAT(lines_of("robot( name \"a\" ranger( ) model( size [0.1 0.1 0.1] pose [0 0 -0.2 0] ) )"),
              IsEmpty());
}

TEST(OverlappedBy, is_what_a_model_was_put_into) {
  config::MemoryFiles files(std::map<std::string, std::string>{{"plan.pbm", kBitmap}});
  const auto scene = scene::load_world_text(std::string(kPlan) +
                                                "model( name \"box\" size [1 1 1] )\n"
                                                "robot( name \"a\" pose [3 0 0 0] ranger( name \"eye\" ) )\n"
                                                "plan( name \"walls\" pose [9 0 0 0] bitmap \"plan.pbm\" )\n",
                                            "t.world", files);
  ASSERT_TRUE(scene) << scene.error().line();
  world::World world(scene.value(), 1);
  const world::ModelRow robot = world.find("a"), box = world.find("box");
  EXPECT_EQ(overlapped_by(world, robot), "");
  ASSERT_TRUE(world::set_pose(world, robot, {0.6, 0, 0, 0}));
  EXPECT_EQ(overlapped_by(world, robot), "\"box\"");
  EXPECT_EQ(overlapped_by(world, box), "\"a\"") << "also what stands onto a robot";
  ASSERT_TRUE(world::set_pose(world, robot, {8, -1, 0, 0}));
  EXPECT_EQ(overlapped_by(world, robot), "");
  ASSERT_TRUE(world::set_pose(world, robot, {10, -1, 0, 0}));
  EXPECT_EQ(overlapped_by(world, robot), "\"walls\"");
}

TEST(BlockedStarts, have_a_line_for_each_pair_at_the_robots_place_in_the_file) {
  EXPECT_THAT(lines_of("model( name \"box\" size [1 1 1] )\n"
                       "robot( name \"a\" pose [0.3 0 0 0] )\n"
                       "robot( name \"b\" pose [0.5 0 0 45] )\n"
                       "robot( name \"far\" pose [3 0 0 0] )\n"),
              ElementsAre("t.world:4: \"a\" starts in \"box\": it stalls there",
                          "t.world:4: \"a\" starts in \"b\": it stalls there",
                          "t.world:5: \"b\" starts in \"box\": it stalls there"));
  EXPECT_THAT(lines_of("robot( name \"a\" )\nrobot( name \"b\" )\n"),
              ElementsAre("t.world:3: \"a\" starts in \"b\": it stalls there"))
      << "at one place";
}

TEST(BlockedStarts, see_walls_of_bitmaps_from_within_and_across) {
  const std::string plan = "plan( name \"plan\" bitmap \"plan.pbm\" )\n";
  EXPECT_THAT(lines_of(plan + "robot( name \"free\" pose [-1 0 0 0] )\n"), IsEmpty());
  EXPECT_THAT(lines_of(plan + "robot( name \"edge\" pose [-1.5 0 0 0] )\n"),
              ElementsAre("t.world:4: \"edge\" starts in \"plan\": it stalls there"));
  EXPECT_THAT(lines_of(plan + "robot( name \"deep\" pose [1 -1 0 30] )\n"),
              ElementsAre("t.world:4: \"deep\" starts in \"plan\": it stalls there"));
}

TEST(BlockedStarts, are_twenty_at_most_and_not_looked_for_in_large_populations) {
  const auto pile = [](int robots) {
    std::string models = "model( name \"box\" size [1 1 1] )\n";
    for (int i = 0; i < robots; ++i) models += "robot( pose [" + std::to_string(i % 2 * 0.1) + " 0 0 0] )\n";
    return lines_of(models);
  };
  const std::vector<std::string> lines = pile(30);
  ASSERT_EQ(lines.size(), 21u);
  EXPECT_EQ(lines.back(), "t.world: further robots start in something");
  EXPECT_EQ(pile(10'000).size(), 21u);
  EXPECT_THAT(pile(10'001), IsEmpty());
}

}  // namespace
}  // namespace playhouse::bodies
