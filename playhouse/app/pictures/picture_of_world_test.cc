#include "playhouse/app/pictures/picture_of_world.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "playhouse/arena/engine.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/drawing.h"

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
  static inline config::MemoryFiles files{{}};
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
  const images::RgbImage picture = picture_of(lying.engine->world(), view, {});
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

TEST(PictureOfWorld, shows_drawings_where_their_models_lie_without_gaps) {
  Lying lying;
  world::World& world = lying.engine->world();
  const scene::Color red{1, 0, 0, 1};
  // In the frame of the board, whose z is x of the world: a square of 1 m that stands on it, 0.4 m above the floor.
  const std::vector<geom::Vec3> square{{-0.4, -0.5, 0.5}, {-0.4, 0.5, 0.5}, {-0.4, 0.5, 1.5},
                                       {-0.4, -0.5, 0.5}, {-0.4, 0.5, 1.5}, {-0.4, -0.5, 1.5}};
  ASSERT_TRUE(world::draw(world, world.find("board"), {world::kLayer3d, 3, red, square}));
  const std::vector<geom::Vec3> line{{-0.5, -0.5, 1.2}, {-0.5, 0.5, 1.2}};
  ASSERT_TRUE(world::draw(world, world.find("post"), {world::kLayer3d, 2, {0, 0, 1, 1}, line}));
  const Viewport view{200, 300, -1, 2, 100};
  const images::RgbImage picture = picture_of(world, view, {});
  const auto at = [&](double x, double y) {
    const auto column = static_cast<std::size_t>((x + 1) * 100),
               row = static_cast<std::size_t>((2 - y) * 100);
    return std::vector<int>(&picture.rgb[3 * (row * 200 + column)],
                            &picture.rgb[3 * (row * 200 + column) + 3]);
  };
  for (double x = 0.52; x < 0.99; x += 0.01)
    for (double y = -0.48; y < 0.49; y += 0.01)
      EXPECT_EQ(at(x, y), (std::vector{255, 0, 0})) << x << ", " << y;
  EXPECT_EQ(at(0.4, 0.4), at(0.4, -0.4)) << "beside it";
  EXPECT_NE(at(0.4, 0.4), (std::vector{255, 0, 0}));
  EXPECT_GT(at(-0.5, 1.6)[2], at(-0.5, 1.6)[0] + 100) << "a line";
}

TEST(PictureOfWorld, shows_points_on_lines_on_areas_on_the_floor_whatever_came_first) {
  Lying lying;
  world::World& world = lying.engine->world();
  const world::ModelRow post = world.find("post");
  const auto draw = [&](std::uint32_t corners, const scene::Color& color,
                        const std::vector<geom::Vec3>& points) {
    ASSERT_TRUE(world::draw(world, post, {world::kLayer2d, corners, color, points}));
  };
  draw(1, {0, 1, 0, 1}, {{-0.5, -0.5, 0.02}});
  draw(2, {0, 0, 1, 1}, {{-0.9, -0.5, 0.02}, {-0.1, -0.5, 0.02}});
  draw(3, {1, 0, 0, 1}, {{-0.9, -0.9, 0.02}, {-0.1, -0.9, 0.02}, {-0.5, 0.5, 0.02}});
  const Viewport view{200, 300, -1, 2, 100};
  const images::RgbImage picture = picture_of(world, view, {});
  const auto pixel = [&](double x, double y) {
    const auto column = static_cast<std::size_t>((x + 1) * 100),
               row = static_cast<std::size_t>((2 - y) * 100);
    const std::uint8_t* rgb = &picture.rgb[3 * (row * 200 + column)];
    return std::ranges::max_element(rgb, rgb + 3) - rgb;
  };
  EXPECT_EQ(pixel(-0.5, 1.5), 1) << "the point";
  EXPECT_EQ(pixel(-0.6, 1.5), 2) << "the line";
  EXPECT_EQ(pixel(-0.5, 1.3), 0) << "the area";
}

}  // namespace
}  // namespace playhouse::app
