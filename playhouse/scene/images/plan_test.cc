#include "playhouse/scene/images/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "playhouse/images/write_png.h"
#include "playhouse/scene/images/ros_map.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {
namespace {

using ::testing::HasSubstr;

/// Walls of one pixel about a room of 8 x 4, with a margin of two pixels on the left and one on top.
constexpr const char* kRoom =
    "P1 12 7\n"
    "000000000000\n"
    "001111111111\n"
    "001000000001\n"
    "001000000001\n"
    "001000000001\n"
    "001000000001\n"
    "001111111111\n";

/// The box about all corners of the walls of a world, in the world.
geom::Box walls_of(const std::string& world, const char* image = kRoom) {
  config::MemoryFiles files({{"room.pbm", std::string(image)}});
  const auto scene = load_world_text(world, "w.world", files);
  EXPECT_TRUE(scene) << scene.error().line();
  geom::Box all;
  const ModelDesc& walls = scene->models.at(0);
  for (const auto& loop : walls.bitmaps.at(0).loops)
    for (const geom::Vec2 p : loop) all.add(geom::transform(geom::compose(walls.X_PM, walls.X_MB), p));
  return all;
}

TEST(Plan, has_its_walls_where_the_pixels_are_whatever_the_margin) {
  const auto plan = plan_of_image(kRoom, "room", 0.5);
  ASSERT_TRUE(plan);
  const auto world = world_of_plan(*plan, "room.pbm", 1.5);
  ASSERT_TRUE(world);
  const geom::Box walls = walls_of(*world);
  EXPECT_NEAR(walls.x_min, -2, 1e-6);  // of an image from -3 to 3
  EXPECT_NEAR(walls.x_max, 3, 1e-6);
  EXPECT_NEAR(walls.y_min, -1.75, 1e-6);  // from -1.75 to 1.75
  EXPECT_NEAR(walls.y_max, 1.25, 1e-6);
  EXPECT_THAT(*world, HasSubstr("1.5]"));
}

TEST(Plan, has_pixels_that_a_world_file_can_tell) {
  for (const double resolution : {2e-85, 9e-6}) {
    const auto world = world_of_plan(*plan_of_image(kRoom, "room", resolution), "room.pbm", 1);
    ASSERT_FALSE(world);
    EXPECT_EQ(world.error().text, "has pixels of less than 0.01 mm");
  }
  EXPECT_TRUE(world_of_plan(*plan_of_image(kRoom, "room", 1e-5), "room.pbm", 1));
}

TEST(Plan, puts_the_robot_where_it_has_room) {
  const auto plan = plan_of_image(kRoom, "room", 0.5);
  const auto world = world_of_plan(*plan, "room.pbm", 1);
  config::MemoryFiles files({{"room.pbm", std::string(kRoom)}});
  const auto scene = load_world_text(*world, "w.world", files);
  ASSERT_TRUE(scene);
  const ModelDesc& robot = scene->models.at(1);
  EXPECT_EQ(robot.kind, ModelKind::kPosition);
  EXPECT_GT(robot.X_PM.x, -1);
  EXPECT_LT(robot.X_PM.x, 2);
  EXPECT_GT(robot.X_PM.y, -1);
  EXPECT_LT(robot.X_PM.y, 0.5);
}

/// The pixels that a fill from (x, y) reaches over free ones; rows from the top.
std::vector<std::string> filled(std::vector<std::string> rows, int x, int y) {
  std::vector<std::pair<int, int>> open{{x, y}};
  while (!open.empty()) {
    const auto [u, v] = open.back();
    open.pop_back();
    if (v < 0 || u < 0 || v >= static_cast<int>(rows.size()) || u >= static_cast<int>(rows[0].size()))
      continue;
    char& pixel = rows[static_cast<std::size_t>(v)][static_cast<std::size_t>(u)];
    if (pixel != '0') continue;
    pixel = '2';
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) open.push_back({u + dx, v + dy});
  }
  return rows;
}

// The truth is a fill from the robot's place: it reaches the pixel that is named, in the largest free space.
TEST(Plan, puts_the_robot_into_the_largest_free_space_that_is_connected) {
  struct Case {
    std::vector<std::string> rows;  // from the top
    int x, y;                       // of a pixel in the space that counts
  };
  const Case cases[] = {
      // A closed shaft in the middle, with more room around its centre than the corridor about it.
      {{"1111111111111", "1000000000001", "1000000000001", "1001111111001", "1001000001001", "1001000001001",
        "1001000001001", "1001000001001", "1001111111001", "1000000000001", "1000000000001", "1111111111111"},
       1,
       1},
      // A room, and a white margin around the building that is larger.
      {{"0000000000000000", "0000000000000000", "0001111111110000", "0001000000010000", "0001000000010000",
        "0001111111110000", "0000000000000000", "0000000000000000"},
       4,
       3},
      // Two rooms that a diagonal of wall divides; the right one is larger.
      {{"111111111", "100100001", "100100001", "101000001", "111111111"}, 7, 1},
  };
  for (const Case& each : cases) {
    const std::size_t width = each.rows[0].size(), height = each.rows.size();
    std::string image = "P1 " + std::to_string(width) + " " + std::to_string(height) + "\n";
    for (const std::string& row : each.rows) image += row + "\n";
    const auto plan = plan_of_image(image, "room", 0.5);
    ASSERT_TRUE(plan);
    const auto world = world_of_plan(*plan, "room.pbm", 1);
    config::MemoryFiles files({{"room.pbm", image}});
    const auto scene = load_world_text(*world, "w.world", files);
    ASSERT_TRUE(scene);
    const geom::Pose& X = scene->models.at(1).X_PM;
    const int x = static_cast<int>(std::floor(X.x / 0.5 + 0.5 * static_cast<double>(width))),
              y = static_cast<int>(std::floor(0.5 * static_cast<double>(height) - X.y / 0.5));
    const std::vector<std::string> reached = filled(each.rows, x, y);
    EXPECT_EQ(reached[static_cast<std::size_t>(each.y)][static_cast<std::size_t>(each.x)], '2')
        << image << "the robot is at " << x << ", " << y;
  }
}

std::vector<std::string> warnings_of(const std::string& size) {
  config::MemoryFiles files({{"room.pbm", std::string(kRoom)}});
  const auto scene = load_world_text("model( bitmap \"room.pbm\" size [" + size + " 1] )", "w.world", files);
  EXPECT_TRUE(scene);
  return scene->warnings;
}

TEST(Plan, with_a_margin_that_somebody_measured_is_told_with_the_numbers) {
  EXPECT_THAT(warnings_of("10 6"), ::testing::IsEmpty()) << "the size of the walls";
  const std::vector<std::string> warnings = warnings_of("12 7");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "w.world:1: bitmap \"room.pbm\" has a margin: the size is that of its 10 x 6 dark "
            "pixels, not of "
            "all 12 x 7, so a pixel is 1.2 x 1.167 m");
}

TEST(Plan, without_walls_is_no_world) {
  const auto plan = plan_of_image("P1 2 2 0 0 0 0", "empty", 1);
  ASSERT_TRUE(plan);
  EXPECT_THAT(world_of_plan(*plan, "empty.pbm", 1).error().text, HasSubstr("no dark pixel"));
  const auto quoted = plan_of_image(kRoom, "a\"b", 1);
  EXPECT_FALSE(world_of_plan(*quoted, "room.pbm", 1));
}

TEST(Plan, that_no_world_can_hold_is_refused) {
  for (const double resolution : {1e9, 1e30}) {
    const auto plan = plan_of_image(kRoom, "room", resolution);
    EXPECT_EQ(world_of_plan(*plan, "room.pbm", 1).error().text,
              "has a place or a size beyond 1e9 m, the largest number of a world file");
  }
  auto plan = plan_of_image(kRoom, "room", 1);
  EXPECT_THAT(world_of_plan(*plan, "room.pbm", 1e300).error().text, HasSubstr("beyond 1e9 m"));
  plan->X_WI.y = 1e300;
  EXPECT_THAT(world_of_plan(*plan, "room.pbm", 1).error().text, HasSubstr("beyond 1e9 m"));
  EXPECT_TRUE(world_of_plan(*plan_of_image(kRoom, "room", 1e7), "room.pbm", 1));
}

TEST(RosMap, is_read_with_everything_that_it_says) {
  const auto map = read_ros_map(
      "image: maps/lab.pgm\nresolution: 0.05\norigin: [-10.0, 2.5, 1.5]\nnegate: 1\noccupied_thresh: 0.7\n"
      "free_thresh: 0.1\nmode: scale\n");
  ASSERT_TRUE(map);
  EXPECT_EQ(map->image, "maps/lab.pgm");
  EXPECT_EQ(map->resolution, 0.05);
  EXPECT_EQ(map->origin.x, -10);
  EXPECT_EQ(map->origin.a, 1.5);
  EXPECT_TRUE(map->negate);
  EXPECT_EQ(map->occupied, 0.7);
  EXPECT_EQ(map->free, 0.1);
}

std::string fault(const std::string& text) {
  const auto map = read_ros_map(text);
  return map ? "" : map.error().line();
}

TEST(RosMap, with_a_fault_is_told_with_its_line) {
  EXPECT_EQ(fault("image: a.pgm\nresolution: fine\n"), "2: \"resolution\" needs a number");
  EXPECT_EQ(fault("image: a.pgm\nresolution: 0\norigin: [0, 0, 0]\n"),
            "2: \"resolution\" needs a number above 0");
  EXPECT_EQ(fault("image: a.pgm\nresolution: .nan\n"), "2: \"resolution\" needs a number");
  EXPECT_EQ(fault("image: a.pgm\nresoluton: 1\n"),
            "2: there is no key \"resoluton\" (did you mean \"resolution\"?)");
  EXPECT_EQ(fault("resolution: 1\n"), "lacks \"image\"");
  EXPECT_EQ(fault("image: a.pgm\nresolution: 1\norigin: [1]\n"), "3: \"origin\" needs [x, y, yaw]");
  EXPECT_EQ(fault("image: a.pgm\nresolution: 1\norigin: [1, 2]\n"), "3: \"origin\" needs [x, y, yaw]");
  EXPECT_EQ(fault("image: a.pgm\nresolution: 1\n"), "lacks \"origin\"");
  EXPECT_EQ(fault("image: a.pgm\nresolution: 1\nmode: rawe\n"),
            "3: there is no mode \"rawe\" (did you mean \"raw\"?)");
  EXPECT_THAT(fault("image: a.pgm\nresolution: 1\norigin: [0, 0, 0]\nfree_thresh: 0.9\n"),
              HasSubstr("might be both"));
  EXPECT_THAT(fault("just a line"), HasSubstr("not a map of ROS"));
  EXPECT_THAT(fault("image: ["), HasSubstr("1: "));
}

TEST(RosMap, takes_a_pixel_by_its_thresholds) {
  const std::string image = std::string("P5 4 1 255 ") + '\x00' + '\x5a' + '\x59' + '\xff';  // 0, 90, 89, 255
  const auto map = read_ros_map("image: a.pgm\nresolution: 1\norigin: [0, 0, 0]\n");
  const auto plan = plan_of_ros_map(*map, image, "a");
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->solid.solid, (std::vector<std::uint8_t>{1, 0, 1, 0}));  // 0.647 and 0.651 of 0.65
  EXPECT_EQ(plan->free.solid, (std::vector<std::uint8_t>{0, 0, 0, 1}));
  EXPECT_FALSE(is_plain(*plan, image));
  EXPECT_TRUE(is_plain(*plan, pgm_of(plan->solid)));
}

/// "#" for a wall, "." for what is free, "?" for what is unknown.
std::string cells(const std::string& mode, const std::string& image) {
  const auto map = read_ros_map("image: a\nresolution: 1\norigin: [0, 0, 0]\nmode: " + mode + "\n");
  const auto plan = plan_of_ros_map(*map, image, "a");
  EXPECT_TRUE(plan) << plan.error().line();
  std::string told;
  for (std::size_t i = 0; plan && i < plan->solid.solid.size(); ++i)
    told += plan->solid.solid[i] ? '#' : plan->free.solid[i] ? '.' : '?';
  return told;
}

TEST(RosMap, in_mode_raw_has_the_occupancy_itself_as_pixels) {
  EXPECT_EQ(cells("raw", "P2 7 1 255 0 24 50 66 100 101 255"), "..?##??");
  EXPECT_EQ(cells("trinary", "P2 7 1 255 0 24 50 66 100 101 255"), "####??.");
}

TEST(RosMap, is_as_light_as_the_mean_of_its_colors) {
  const std::string red_cyan_dark_white = "P3 4 1 255 255 0 0 0 255 255 90 90 87 255 255 255";
  EXPECT_EQ(cells("trinary", red_cyan_dark_white), "#?#.");
  EXPECT_EQ(cells("scale", red_cyan_dark_white), "#?#.");
}

TEST(RosMap, counts_alpha_as_a_color_in_mode_trinary_and_as_unknown_in_mode_scale) {
  std::vector<std::uint8_t> pixels;  // black, white and dark, opaque and not
  for (const std::uint8_t grey : std::vector<std::uint8_t>{0x00, 0xff, 0x60})
    for (const std::uint8_t alpha : std::vector<std::uint8_t>{0xff, 0x00})
      pixels.insert(pixels.end(), {grey, grey, grey, alpha});
  const std::string image = *images::png_of(6, 1, 4, pixels);
  EXPECT_EQ(cells("trinary", image), "##.??#");
  EXPECT_EQ(cells("scale", image), "#?.???");
}

TEST(RosMap, has_its_walls_where_its_origin_says_also_when_it_is_turned) {
  const auto map = read_ros_map("image: room.pbm\nresolution: 0.5\norigin: [10, 20, 1.5707963267948966]\n");
  const auto plan = plan_of_ros_map(*map, kRoom, "room");
  ASSERT_TRUE(plan);
  const auto world = world_of_plan(*plan, "room.pbm", 1);
  ASSERT_TRUE(world);
  const geom::Box walls = walls_of(*world);
  EXPECT_NEAR(walls.x_min, 10 - 3, 1e-5);  // y of the image goes to the left: 0 to 6 of 7 pixels
  EXPECT_NEAR(walls.x_max, 10, 1e-5);
  EXPECT_NEAR(walls.y_min, 20 + 1, 1e-5);  // 2 to 12 pixels
  EXPECT_NEAR(walls.y_max, 20 + 6, 1e-5);
}

TEST(RosMap, is_written_as_it_is_read) {
  auto plan = plan_of_image(kRoom, "room", 0.25);
  plan->X_WI = {-1.25, 3, 0, 0.5};
  const auto map = read_ros_map(ros_map_of(*plan, "room.pgm"));
  ASSERT_TRUE(map);
  const auto again = plan_of_ros_map(*map, pgm_of(plan->solid), "room");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->solid.solid, plan->solid.solid);
  EXPECT_EQ(again->resolution, plan->resolution);
  EXPECT_EQ(again->X_WI, plan->X_WI);
}

}  // namespace
}  // namespace playhouse::scene
