// Rangers that look over everything, by hand.

#include "playhouse/bodies/blind_rangers.h"

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

/// A robot of 0.2 m with a scanner 0.1 m above its top, at 0.3 m.
constexpr const char* kRobot =
    "define robot position( size [0.4 0.4 0.2] ranger( pose [0 0 0 0] size [0.1 0.1 0.2] "
    "sensor( pose [0 0 0.1 0] size [0 0 0] samples 3 ) ) )\n";

std::vector<std::string> lines_of(const std::string& models) {
  config::MemoryFiles files(std::map<std::string, std::string>{{"plan.pbm", "P1 3 1\n1 0 1\n"}});
  const auto scene = scene::load_world_text(kRobot + models, "t.world", files);
  EXPECT_TRUE(scene) << (scene ? "" : scene.error().line());
  return blind_rangers(world::World(scene.value(), 1));
}

TEST(BlindRangers, are_none_where_something_else_reaches_their_height) {
  EXPECT_THAT(lines_of("robot( name \"a\" ) model( size [1 1 0.31] pose [3 0 0 0] )"), IsEmpty());
  EXPECT_THAT(lines_of("robot( name \"a\" ) model( size [3 1 1] bitmap \"plan.pbm\" pose [3 0 0 0] )"),
              IsEmpty());
  EXPECT_THAT(lines_of("robot( name \"a\" ) robot( name \"b\" pose [3 0 0 0] model( size [0.1 0.1 0.2] ) )"),
              testing::SizeIs(1))
      << "b sees nothing, a sees the mast of b";
  EXPECT_THAT(lines_of("robot( name \"a\" )"), IsEmpty()) << "there is nothing at all";
  EXPECT_THAT(lines_of("robot( name \"a\" ) model( size [3 1 0.1] pose [3 0 0 0] tilt [0 -20] )"), IsEmpty())
      << "a ramp of the arena";
}

TEST(BlindRangers, have_one_line_at_the_first_of_them) {
  EXPECT_THAT(lines_of("model( size [1 1 0.29] pose [3 0 0 0] )\nrobot( name \"a\" )\n"),
              ElementsAre("t.world:3: nothing else reaches the height of the beams of \"a.ranger:0\": "
                          "they see nothing"));
  EXPECT_THAT(lines_of("model( size [1 1 9] pose [3 0 0 0] ranger_return -1 )\nmodel( size [1 1 0.1] )\n"
                       "robot( name \"a\" ranger( sensor( samples 2 ) ) )\n"),
              ElementsAre("t.world:4: nothing else reaches the height of the beams of \"a.ranger:0\" "
                          "(and of 1 more): they see nothing"))
      << "what rangers do not see";
  EXPECT_THAT(lines_of("model( size [1 1 0.1] pose [3 0 0 0] )\nrobot( name \"a\" pose [0 0 2 0] )\n"
                       "model( size [1 1 0.1] pose [3 0 2.25 0] )\n"),
              IsEmpty())
      << "up there";
}

}  // namespace
}  // namespace playhouse::bodies
