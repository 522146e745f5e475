// What clients draw, checked against the world's column.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/wire/generated/graphics2d.h"
#include "playhouse/wire/generated/graphics3d.h"
#include "playhouse/world/drawing.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

namespace g2d = wire::graphics2d;
namespace g3d = wire::graphics3d;
using ::testing::ElementsAre;
using ::testing::FloatNear;
using ::testing::IsEmpty;

constexpr const char* kWorld = R"(
position( name "r0" ranger( name "eye" ) )
model( name "box" )
)";
constexpr wire::Color kRed{255, 255, 0, 0}, kGlass{51, 0, 0, 255}, kUnset{0, 0, 255, 0};

class DrawingDevices : public ::testing::Test {
 protected:
  void open(device::DeviceId id, std::uint16_t interf, const char* model) {
    driver_.add(id, make_device(still_.devices, interf, still_.world().find(model)));
    ASSERT_TRUE(driver_.start(id));
    still_.run(0);
  }
  device::Taken command(device::DeviceId id, std::uint8_t subtype, std::span<const std::byte> body = {}) {
    return driver_.command({id, static_cast<std::uint8_t>(wire::MessageType::kCmd), subtype, body});
  }
  template <typename Payload>
  device::Taken command_with(device::DeviceId id, std::uint8_t subtype, const Payload& payload) {
    return command(id, subtype, wire::encode(payload));
  }
  void draw(std::int32_t mode, std::vector<wire::Point3d> points, const wire::Color& color = kRed) {
    EXPECT_EQ(command_with(k3d, g3d::kCmdDraw, g3d::CmdDraw{static_cast<std::uint32_t>(mode), points, color}),
              device::Taken::kQueued);
  }
  void draw_points(device::DeviceId id, std::vector<wire::Point2d> points, const wire::Color& color = kRed) {
    EXPECT_EQ(command_with(id, g2d::kCmdPoints, g2d::CmdPoints{std::move(points), color}),
              device::Taken::kQueued);
  }
  std::vector<world::DrawnCorner> drawn(const char* model) {
    still_.run(0);
    return still_.world().models.drawing[still_.world().find(model)];
  }
  /// As x, y, z of each corner.
  std::vector<float> places(const char* model) {
    std::vector<float> out;
    for (const world::DrawnCorner& corner : drawn(model))
      for (const float value : {corner.x, corner.y, corner.z}) out.push_back(value);
    return out;
  }

  static constexpr device::DeviceId k2d{3}, k3d{4}, kOther{5};
  testing::StillDevices still_{kWorld};
  SimulatedDriver driver_{still_.devices, "stage"};
};

MATCHER_P4(Corner, x, y, rgba, corners, "") {
  return arg.x == static_cast<float>(x) && arg.y == static_cast<float>(y) && arg.color == rgba &&
         arg.corners == corners;
}

TEST_F(DrawingDevices, draw_points_and_lines_a_little_above_the_floor) {
  open(k2d, g2d::kCode, "r0.eye");
  draw_points(k2d, {{1, 2}});
  command_with(k2d, g2d::kCmdPolyline, g2d::CmdPolyline{{{0, 0}, {1, 0}, {1, 1}}, kGlass});
  command_with(k2d, g2d::kCmdMultiline, g2d::CmdMultiline{{{5, 0}, {6, 0}, {7, 0}}, kUnset});
  const auto all = drawn("r0.eye");
  EXPECT_THAT(all, ElementsAre(Corner(1, 2, 0xFF0000FFu, 1), Corner(0, 0, 0x0000FF33u, 2),
                               Corner(1, 0, 0x0000FF33u, 2), Corner(1, 0, 0x0000FF33u, 2),
                               Corner(1, 1, 0x0000FF33u, 2), Corner(5, 0, 0x00FF00FFu, 2),
                               Corner(6, 0, 0x00FF00FFu, 2)))
      << "an opacity that is not set is full";
  for (const world::DrawnCorner& corner : all) {
    EXPECT_EQ(corner.z, 0.02f);
    EXPECT_EQ(corner.layer, world::kLayer2d);
  }
  EXPECT_THAT(drawn("r0"), IsEmpty()) << "not in the model around it";
}

TEST_F(DrawingDevices, fill_polygons_below_their_outlines) {
  open(k2d, g2d::kCode, "r0");
  const std::vector<wire::Point2d> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  command_with(k2d, g2d::kCmdPolygon, g2d::CmdPolygon{square, kRed, kGlass, 0});
  EXPECT_EQ(drawn("r0").size(), 8u) << "an outline of four lines";
  command(k2d, g2d::kCmdClear);
  command_with(k2d, g2d::kCmdPolygon, g2d::CmdPolygon{square, kRed, kGlass, 1});
  const auto all = drawn("r0");
  ASSERT_EQ(all.size(), 6u + 8u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_THAT(all[i], Corner(all[i].x, all[i].y, 0x0000FF33u, 3));
  for (std::size_t i = 6; i < 14; ++i) EXPECT_THAT(all[i], Corner(all[i].x, all[i].y, 0xFF0000FFu, 2));
}

TEST_F(DrawingDevices, draw_the_outline_of_a_polygon_whose_inside_does_not_fit) {
  constexpr std::size_t kHeld = limits::kDrawnCorners - 20;
  open(k2d, g2d::kCode, "r0");
  draw_points(k2d, std::vector<wire::Point2d>(kHeld));
  // Its inside has eight triangles.
  const std::vector<wire::Point2d> hexagon{{0, 0}, {2, 1}, {2, 3}, {0, 5}, {-2, 4}, {-2, 2}};
  EXPECT_EQ(command_with(k2d, g2d::kCmdPolygon, g2d::CmdPolygon{hexagon, kRed, kGlass, 1}),
            device::Taken::kQueued);
  const auto all = drawn("r0");
  EXPECT_EQ(all.size(), kHeld + 2 * hexagon.size());
  EXPECT_EQ(all.back().corners, 2);
}

TEST_F(DrawingDevices, clear_what_was_drawn_by_their_interface) {
  open(k2d, g2d::kCode, "r0");
  open(kOther, g2d::kCode, "r0");
  open(k3d, g3d::kCode, "r0");
  draw_points(k2d, {{1, 0}});
  draw_points(kOther, {{2, 0}});
  draw(g3d::kDrawPoints, {{3, 0, 0}});
  EXPECT_EQ(drawn("r0").size(), 3u);
  command(k2d, g2d::kCmdClear);
  EXPECT_THAT(drawn("r0"), ElementsAre(Corner(3, 0, 0xFF0000FFu, 1)));
  command(k3d, g3d::kCmdClear);
  EXPECT_THAT(drawn("r0"), IsEmpty());
}

TEST_F(DrawingDevices, what_is_drawn_stays_when_the_client_goes) {
  open(k2d, g2d::kCode, "r0");
  draw_points(k2d, {{1, 0}});
  driver_.stop(k2d);
  EXPECT_EQ(drawn("r0").size(), 1u);
}

TEST_F(DrawingDevices, draw_in_a_frame_that_is_moved_and_turned_within_itself) {
  open(k3d, g3d::kCode, "box");
  command_with(k3d, g3d::kCmdTranslate, g3d::CmdTranslate{1, 0, 0.5});
  command(k3d, g3d::kCmdPush);
  command_with(k3d, g3d::kCmdRotate, g3d::CmdRotate{geom::kPi / 2, 0, 0, 7});
  command_with(k3d, g3d::kCmdTranslate, g3d::CmdTranslate{2, 0, 0});
  draw(g3d::kDrawPoints, {{1, 0, 0}});  // left of the frame
  command(k3d, g3d::kCmdPop);
  draw(g3d::kDrawPoints, {{1, 0, 0}});
  command(k3d, g3d::kCmdPop);  // one too many
  command_with(k3d, g3d::kCmdRotate, g3d::CmdRotate{geom::kPi / 2, 0, -2, 0});
  draw(g3d::kDrawPoints, {{1, 0, 0}});  // up
  const auto near = [](double value) { return FloatNear(static_cast<float>(value), 1e-6f); };
  EXPECT_THAT(places("box"), ElementsAre(near(1), near(3), near(0.5), near(2), near(0), near(0.5), near(1),
                                         near(0), near(1.5)));
  command(k3d, g3d::kCmdClear);
  draw(g3d::kDrawPoints, {{1, 0, 0}});
  EXPECT_THAT(places("box"), ElementsAre(1, 0, 0)) << "as at the start";
}

TEST_F(DrawingDevices, turn_about_an_axis_of_any_length) {
  open(k3d, g3d::kCode, "box");
  const auto near = [](double value) { return FloatNear(static_cast<float>(value), 1e-6f); };
  for (const double length : {1e200, 1e-170, 1.7e308, 5e-324}) {
    command(k3d, g3d::kCmdClear);
    EXPECT_EQ(command_with(k3d, g3d::kCmdRotate, g3d::CmdRotate{geom::kPi, length, length, 0}),
              device::Taken::kQueued);
    draw(g3d::kDrawPoints, {{1, 0, 0}});
    EXPECT_THAT(places("box"), ElementsAre(near(0), near(1), near(0))) << length;
  }
}

TEST_F(DrawingDevices, begin_in_the_frame_of_the_model_for_the_next_client) {
  open(k3d, g3d::kCode, "box");
  command_with(k3d, g3d::kCmdTranslate, g3d::CmdTranslate{9, 9, 9});
  driver_.stop(k3d);
  ASSERT_TRUE(driver_.start(k3d));
  draw(g3d::kDrawPoints, {{1, 0, 0}});
  EXPECT_THAT(places("box"), ElementsAre(1, 0, 0));
}

TEST_F(DrawingDevices, pops_beyond_the_deepest_frame_belong_to_its_pushes) {
  open(k3d, g3d::kCode, "box");
  for (int k = 0; k < 100; ++k) command(k3d, g3d::kCmdPush);
  command_with(k3d, g3d::kCmdTranslate, g3d::CmdTranslate{5, 0, 0});
  for (int k = 0; k < 100; ++k) command(k3d, g3d::kCmdPop);
  draw(g3d::kDrawPoints, {{1, 0, 0}});
  EXPECT_THAT(places("box"), ElementsAre(1, 0, 0));
}

TEST_F(DrawingDevices, take_no_nonsense) {
  open(k2d, g2d::kCode, "r0");
  open(k3d, g3d::kCode, "r0");
  const std::byte cut[3] = {};
  EXPECT_EQ(command(k2d, g2d::kCmdPoints, cut), device::Taken::kNo);
  EXPECT_EQ(command(k2d, 99), device::Taken::kNo);
  EXPECT_EQ(command_with(k3d, g3d::kCmdDraw, g3d::CmdDraw{10, {{1, 0, 0}}, kRed}), device::Taken::kNo);
  EXPECT_EQ(command_with(k3d, g3d::kCmdTranslate, g3d::CmdTranslate{NAN, 0, 0}), device::Taken::kNo);
  EXPECT_EQ(command_with(k3d, g3d::kCmdRotate, g3d::CmdRotate{1, 0, 0, 0}), device::Taken::kNo) << "no axis";
  EXPECT_EQ(command_with(k3d, g3d::kCmdRotate, g3d::CmdRotate{INFINITY, 0, 0, 1}), device::Taken::kNo);
  EXPECT_EQ(command_with(k2d, g2d::kCmdPoints,
                         g2d::CmdPoints{std::vector<wire::Point2d>(limits::kDrawnCorners + 1), kRed}),
            device::Taken::kNo);
  draw_points(k2d, {{NAN, 0}, {1, 0}, {0, INFINITY}, {1e300, 0}});
  EXPECT_THAT(drawn("r0"), ElementsAre(Corner(1, 0, 0xFF0000FFu, 1)));
}

TEST_F(DrawingDevices, leave_out_what_does_not_fit_until_the_drawing_is_cleared) {
  open(k2d, g2d::kCode, "r0");
  draw_points(k2d, std::vector<wire::Point2d>(limits::kDrawnCorners));
  draw_points(k2d, {{1, 0}});
  EXPECT_EQ(drawn("r0").size(), limits::kDrawnCorners);
  command(k2d, g2d::kCmdClear);
  draw_points(k2d, {{1, 0}});
  EXPECT_THAT(drawn("r0"), ElementsAre(Corner(1, 0, 0xFF0000FFu, 1)));
}

TEST_F(DrawingDevices, keep_a_few_drawings_waiting_and_no_more) {
  open(k2d, g2d::kCode, "r0");
  const g2d::CmdPoints whole{std::vector<wire::Point2d>(limits::kDrawnCorners), kRed};
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(command(k2d, g2d::kCmdClear), device::Taken::kQueued);
    EXPECT_EQ(command_with(k2d, g2d::kCmdPoints, whole), device::Taken::kQueued);
  }
  EXPECT_EQ(command_with(k2d, g2d::kCmdPoints, whole), device::Taken::kNo);
  still_.run(0);
  EXPECT_EQ(command_with(k2d, g2d::kCmdPoints, whole), device::Taken::kQueued);
}

TEST_F(DrawingDevices, change_nothing_that_a_run_depends_on) {
  open(k2d, g2d::kCode, "r0");
  const std::uint64_t hash = still_.world().hash(), sensed = still_.world().sensed_hash();
  draw_points(k2d, {{1, 0}});
  EXPECT_EQ(drawn("r0").size(), 1u);
  EXPECT_EQ(still_.world().hash(), hash);
  EXPECT_EQ(still_.world().sensed_hash(), sensed) << "the model is not used for it";
}

TEST_F(DrawingDevices, drawings_are_those_of_the_moment_to_which_the_run_was_taken_back) {
  constexpr std::uint64_t kMoment = 10;  // a full second
  still_.simulation.requests().record(true);
  open(k2d, g2d::kCode, "r0");
  still_.run(1);
  draw_points(k2d, {{1, 0}});
  while (still_.world().tick() < kMoment) still_.run(1);
  draw_points(k2d, {{2, 0}});
  still_.run(1);
  command(k2d, g2d::kCmdClear);
  still_.run(2);
  EXPECT_THAT(drawn("r0"), IsEmpty());
  for (const std::uint64_t tick : {kMoment, kMoment + 2}) {
    run::testing::rewind_to(still_.simulation, tick);
    EXPECT_EQ(still_.world().tick(), tick);
    EXPECT_THAT(drawn("r0"), ElementsAre(Corner(1, 0, 0xFF0000FFu, 1))) << "of the moment before " << tick;
  }
}

TEST_F(DrawingDevices, draw_nothing_for_a_model_that_has_gone) {
  open(k2d, g2d::kCode, "box");
  draw_points(k2d, {{1, 0}});
  ASSERT_TRUE(world::despawn(still_.world(), still_.world().id(still_.world().find("box"))).ok());
  still_.run(1);
  EXPECT_EQ(still_.world().drawn(), 0u);
}

}  // namespace
}  // namespace playhouse::drivers
