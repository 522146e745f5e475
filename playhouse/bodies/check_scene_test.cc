// What the stage engine leaves out of a scene, told in one line.

#include "playhouse/bodies/check_scene.h"

#include <gmock/gmock.h>

#include <map>
#include <string>

#include "playhouse/scene/world_loader.h"

namespace playhouse::bodies {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> left_out(const std::string& text) {
  config::MemoryFiles files(std::map<std::string, std::string>{{"w.world", text}});
  const Result<scene::SceneDesc> scene = scene::load_world_text(text, "w.world", files);
  EXPECT_TRUE(scene) << scene.error().line();
  return scene ? left_out_in_the_plane(*scene) : std::vector<std::string>{};
}

TEST(LeftOut, is_nothing_where_a_scene_asks_for_nothing_more) {
  EXPECT_THAT(left_out("gravity 9.81 ground \"concrete\" position( mass 3 ranger( sensor( rings 1 ) ) )"),
              IsEmpty());
}

TEST(LeftOut, is_one_line_with_every_word_at_the_first_model_that_has_one) {
  EXPECT_THAT(
      left_out("gravity 1.62\nground \"ice\"\nmodel( )\nmodel( friction 0.3 )\nmodel( friction_axes [1 0.1] "
               "restitution 0.5 roughness 0.1 )\nranger( sensor( rings 3 ) )"),
      ElementsAre(
          "w.world:4: friction, friction_axes, gravity, ground, restitution, rings, roughness have "
          "their full effect with --engine arena only: the stage engine is a plane without physics and "
          "light"));
  EXPECT_THAT(
      left_out("fog 30\nmodel( )"),
      ElementsAre("w.world: fog has its full effect with --engine arena only: the stage engine is a plane "
                  "without physics and light"));
}

TEST(LeftOut, is_not_what_sensors_of_the_plane_measure) {
  EXPECT_THAT(left_out("model( material \"glass\" lamp 3 ) detector( )"), IsEmpty());
  EXPECT_THAT(left_out("gravity 1.62 position( imu( ) )"), IsEmpty());
  EXPECT_THAT(left_out("gravity 1.62 model( lamp 3 )"), testing::SizeIs(1));
}

}  // namespace
}  // namespace playhouse::bodies
