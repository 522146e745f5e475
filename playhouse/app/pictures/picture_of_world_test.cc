#include "playhouse/app/pictures/picture_of_world.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "playhouse/arena/engine.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::app {
namespace {

/// A board of 0.2 x 0.6 x 1.6 m that lies on its side, with its top along x; beside it a post.
constexpr const char* kBoard = R"(
model( name "board" size [0.2 0.6 1.6] gripper_return 1 color "green" )
model( name "post" pose [0 2 0 0] size [0.2 0.2 1] gui_move 0 )
)";

struct Lying {
  Result<scene::SceneDesc> scene = scene::load_world_text(kBoard, "board.world", files);
  std::unique_ptr<world::Engine> engine = *arena::make_engine(*scene, {.seed = 1, .workers = 1});

  Lying() {
    const geom::Tilt tilt{0, 0.5 * geom::kPi};
    EXPECT_TRUE(world::set_spatial_pose(engine->world(), engine->world().find("board"), {{}, tilt}));
  }

 private:
  static inline scene::MemoryFiles files{{}};
};

TEST(PictureOfWorld, frames_bodies_as_they_lie) {
  const Lying lying;
  const Result<Viewport> view = view_of(lying.engine->world(), 400);
  ASSERT_TRUE(view);
  // From 0 m to 1.6 m along x, but for the post, and from -0.3 m to 2.1 m along y; 3 % of the longer side
  // beside it.
  EXPECT_NEAR(view->left, -0.1 - 0.03 * 2.4, 1e-6);
  EXPECT_NEAR(view->width / view->pixels_per_metre, 1.7 + 0.06 * 2.4, 1e-6);
  EXPECT_NEAR(view->top, 2.1 + 0.03 * 2.4, 1e-6);
}

TEST(PictureOfWorld, shows_bodies_as_they_lie) {
  const Lying lying;
  const Viewport view{200, 200, -1, 1, 100};
  const scene::RgbImage picture = picture_of(lying.engine->world(), view, {});
  const auto is_green = [&](double x, double y) {
    const auto column = static_cast<std::size_t>((x + 1) * 100),
               row = static_cast<std::size_t>((1 - y) * 100);
    const std::uint8_t* rgb = &picture.rgb[3 * (row * 200 + column)];
    return rgb[1] > rgb[0] + 50 && rgb[1] > rgb[2] + 50;
  };
  EXPECT_TRUE(is_green(0.02, 0.25));
  EXPECT_TRUE(is_green(0.9, -0.25));
  EXPECT_FALSE(is_green(-0.05, 0));
  EXPECT_FALSE(is_green(0.9, 0.35));
}

}  // namespace
}  // namespace playhouse::app
