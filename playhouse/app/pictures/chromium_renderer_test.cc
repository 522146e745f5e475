// The page in the Chromium of this machine, where there is one: who comes and goes between two pictures.

#include "playhouse/app/pictures/chromium_renderer.h"

#include <gtest/gtest.h>

#include "playhouse/run/testing/still_engine.h"
#include "playhouse/stage/engine.h"
#include "playhouse/web_server/page_files.h"
#include "playhouse/world/population/population.h"

namespace playhouse::app {
namespace {

constexpr const char* kWorld = R"(
model( name "edge" size [8 8 0.1] color "white" obstacle_return 0 ranger_return -1 )
position( name "r" pose [-2 -2 0 0] size [1 1 0.3] color "green" )
)";
constexpr Viewport kView{.width = 160, .height = 160, .left = -4, .top = 4, .pixels_per_metre = 20};

class AChromium : public testing::Test {
 protected:
  void SetUp() override {
    program_ = find_chromium();
    if (!program_ || web_server::page_files().empty())
      GTEST_SKIP() << "there is no chromium, or no built page";
  }

  /// Whether there is something green below the middle of a place. [m]
  static bool is_green(const images::RgbImage& picture, double x, double y) {
    const auto column = static_cast<std::size_t>((x - kView.left) * kView.pixels_per_metre);
    const auto row = static_cast<std::size_t>((kView.top - y + 0.2) * kView.pixels_per_metre);
    const std::uint8_t* const at = &picture.rgb[3 * (row * static_cast<std::size_t>(kView.width) + column)];
    return at[1] > at[0] + 40 && at[1] > at[2] + 40;
  }

  std::optional<std::string> program_;
  const Interrupt interrupt_;
};

TEST_F(AChromium, draws_who_came_and_draws_no_more_who_has_gone) {
  const scene::SceneDesc scene = run::testing::scene_of(kWorld);
  const Result<std::unique_ptr<world::Engine>> engine = stage::make_engine(scene, {});
  ASSERT_TRUE(engine);
  world::World& world = (*engine)->world();
  const SensorShapes nothing;
  ChromiumRenderer chromium(*program_, world, nothing, interrupt_);

  const Result<images::RgbImage> before = chromium.draw(world, kView);
  ASSERT_TRUE(before) << before.error().text;
  EXPECT_EQ(before->rgb.size(), 3u * 160 * 160);
  EXPECT_TRUE(is_green(*before, -2, -2));
  EXPECT_FALSE(is_green(*before, 2, 1));

  const world::ModelRow first = world.find("r");
  ASSERT_TRUE(world::spawn(world, world.models.desc[first], {2, 1, 0, 0}));
  const Result<images::RgbImage> both = chromium.draw(world, kView);
  ASSERT_TRUE(both) << both.error().text;
  EXPECT_TRUE(is_green(*both, -2, -2));
  EXPECT_TRUE(is_green(*both, 2, 1));

  ASSERT_TRUE(world::despawn(world, world.id(world.find("r"))));
  const Result<images::RgbImage> after = chromium.draw(world, kView);
  ASSERT_TRUE(after) << after.error().text;
  EXPECT_FALSE(is_green(*after, -2, -2));
  EXPECT_TRUE(is_green(*after, 2, 1));
}

}  // namespace
}  // namespace playhouse::app
