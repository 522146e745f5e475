// What is drawn for viewers: in layers, within limits, and no part of what a run depends on.

#include "playhouse/world/drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/base/limits.h"
#include "playhouse/world/changes/journal.h"
#include "playhouse/world/saving/state.h"
#include "playhouse/world/testing_scene.h"

namespace playhouse::world {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr scene::Color kRed{1, 0, 0, 1}, kGlass{0, 0, 1, 0.2f};
constexpr ModelId kRobot{0}, kBox{2};

class Drawing : public ::testing::Test {
 protected:
  bool draw(ModelId model, std::uint32_t layer, std::uint32_t corners, std::vector<geom::Vec3> points,
            const scene::Color& color = kRed) {
    return journal_.apply(changes::Draw{model, layer, corners, color, std::move(points)});
  }
  void clear(ModelId model, std::uint32_t layer) {
    EXPECT_TRUE(journal_.apply(changes::ClearDrawing{model, layer}));
  }
  const std::vector<DrawnCorner>& of(ModelId model) const { return world_.models.drawing[world_.row(model)]; }

  const scene::SceneDesc scene_ = testing::small_scene();
  World world_{scene_, 1};
  Journal journal_{world_};
};

TEST_F(Drawing, grows_by_what_is_drawn_in_order) {
  EXPECT_TRUE(draw(kRobot, kLayer2d, 2, {{0, 0, 0}, {1, -0.5, 0.25}}));
  EXPECT_TRUE(draw(kRobot, kLayer3d, 1, {{3, 0, 0}}, kGlass));
  EXPECT_THAT(of(kRobot), ElementsAre(DrawnCorner{0, 0, 0, 0xFF0000FF, 2, 0},
                                      DrawnCorner{1, -0.5f, 0.25f, 0xFF0000FF, 2, 0},
                                      DrawnCorner{3, 0, 0, 0x0000FF33, 1, 1}));
  EXPECT_THAT(of(kBox), IsEmpty());
  EXPECT_EQ(journal_.entries().size(), 2u);
}

TEST_F(Drawing, is_cleared_by_layers) {
  draw(kRobot, kLayer2d, 1, {{1, 0, 0}});
  draw(kRobot, kLayer3d, 1, {{2, 0, 0}});
  draw(kRobot, kLayer2d, 1, {{3, 0, 0}});
  clear(kRobot, kLayer2d);
  EXPECT_THAT(of(kRobot), ElementsAre(DrawnCorner{2, 0, 0, 0xFF0000FF, 1, 1}));
  clear(kRobot, kLayer3d);
  EXPECT_THAT(of(kRobot), IsEmpty());
}

TEST_F(Drawing, tells_viewers_of_every_difference) {
  const std::uint64_t before = world_.drawn();
  clear(kRobot, kLayer2d);
  EXPECT_EQ(world_.drawn(), before) << "there was nothing to clear";
  draw(kRobot, kLayer2d, 1, {{1, 0, 0}});
  const std::uint64_t with = world_.drawn();
  EXPECT_NE(with, before);
  clear(kRobot, kLayer2d);
  EXPECT_NE(world_.drawn(), with);
}

TEST_F(Drawing, refuses_what_is_no_drawing) {
  EXPECT_FALSE(draw(kRobot, kLayer2d, 2, {{0, 0, 0}})) << "half a line";
  EXPECT_FALSE(draw(kRobot, kLayer2d, 0, {{0, 0, 0}}));
  EXPECT_FALSE(draw(kRobot, kLayer2d, 4, {{}, {}, {}, {}}));
  EXPECT_FALSE(draw(kRobot, 2, 1, {{0, 0, 0}}));
  EXPECT_FALSE(draw(kRobot, kLayer2d, 1, {{NAN, 0, 0}}));
  EXPECT_FALSE(draw(kRobot, kLayer2d, 1, {{0, 0, 0}, {0, 1e300, 0}})) << "not finite as a float";
  EXPECT_FALSE(draw(kRobot, kLayer2d, 1, {{0, 0, 0}}, {NAN, 0, 0, 1}));
  EXPECT_FALSE(draw(kRobot, kLayer2d, 1, {}));
  EXPECT_FALSE(draw({77}, kLayer2d, 1, {{0, 0, 0}})) << "nobody";
  EXPECT_THAT(of(kRobot), IsEmpty());
  EXPECT_TRUE(journal_.entries().empty());
}

TEST_F(Drawing, has_a_limit_in_each_layer) {
  EXPECT_TRUE(draw(kRobot, kLayer2d, 1, std::vector<geom::Vec3>(limits::kDrawnCorners - 1)));
  EXPECT_FALSE(draw(kRobot, kLayer2d, 2, std::vector<geom::Vec3>(2)));
  EXPECT_TRUE(draw(kRobot, kLayer2d, 1, std::vector<geom::Vec3>(1)));
  EXPECT_FALSE(draw(kRobot, kLayer2d, 1, std::vector<geom::Vec3>(1)));
  EXPECT_TRUE(draw(kRobot, kLayer3d, 1, std::vector<geom::Vec3>(1)));
  EXPECT_TRUE(draw(kBox, kLayer2d, 1, std::vector<geom::Vec3>(1)));
  EXPECT_EQ(corners_in(of(kRobot), kLayer2d), limits::kDrawnCorners);
  clear(kRobot, kLayer2d);
  EXPECT_TRUE(draw(kRobot, kLayer2d, 1, std::vector<geom::Vec3>(limits::kDrawnCorners)));
}

TEST_F(Drawing, is_in_no_hash) {
  const std::uint64_t hash = world_.hash(), sensed = world_.sensed_hash();
  draw(kRobot, kLayer2d, 1, {{1, 0, 0}});
  EXPECT_EQ(world_.hash(), hash);
  EXPECT_EQ(world_.sensed_hash(), sensed);
  EXPECT_FALSE(first_difference(world_, World(scene_, 1)).has_value());
}

TEST_F(Drawing, goes_with_its_model_alone) {
  draw(kRobot, kLayer2d, 1, {{1, 0, 0}});
  draw(kBox, kLayer2d, 1, {{2, 0, 0}});
  ASSERT_TRUE(journal_.despawn(kRobot));
  EXPECT_THAT(of(kBox), ElementsAre(DrawnCorner{2, 0, 0, 0xFF0000FF, 1, 0}));
}

TEST_F(Drawing, is_as_it_was_in_a_state_that_is_loaded) {
  std::vector<std::byte> without, with;
  ASSERT_TRUE(save_state(world_, without));
  draw(kBox, kLayer3d, 3, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const std::vector<DrawnCorner> drawn = of(kBox);
  ASSERT_TRUE(save_state(world_, with));
  const std::uint64_t version = world_.drawn();
  ASSERT_TRUE(load_state(world_, without));
  EXPECT_THAT(of(kBox), IsEmpty());
  EXPECT_NE(world_.drawn(), version);
  ASSERT_TRUE(load_state(world_, with));
  EXPECT_EQ(of(kBox), drawn);
}

TEST_F(Drawing, is_damaged_without_all_corners_of_a_shape) {
  const DrawnCorner line{0, 0, 0, 0xFF, 2, 0}, point{0, 0, 0, 0xFF, 1, 0}, nowhere{0, 0, 0, 0xFF, 1, 9},
      nothing{}, other{0, 0, 0, 0xFE, 2, 0};
  using Corners = std::vector<DrawnCorner>;
  EXPECT_TRUE(is_drawing(Corners{line, line, point, line, line}));
  for (const Corners& bad : {Corners{line}, Corners{line, point}, Corners{line, other}, Corners{nowhere},
                             Corners{nothing}, Corners(limits::kDrawnCorners + 1, point)}) {
    EXPECT_FALSE(is_drawing(bad));
    World world(scene_, 1);
    world.models.drawing.own({0}) = bad;
    std::vector<std::byte> bytes;
    ASSERT_TRUE(save_state(world, bytes));
    const Result<void> loaded = load_state(world, bytes);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().text, "is damaged: a model has a drawing with incomplete shapes");
  }
}

}  // namespace
}  // namespace playhouse::world
