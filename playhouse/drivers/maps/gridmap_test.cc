// A map of beams, by the cells that each line passes and ends in.

#include "playhouse/drivers/maps/gridmap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "playhouse/drivers/grid_map/testing_tiles.h"
#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/geom/trig.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace map = wire::map;
namespace p2d = wire::position2d;
namespace snr = wire::sonar;

constexpr device::Address kWheels{6665, p2d::kCode, 0}, kSonars{6665, snr::kCode, 0},
    kMade{6665, map::kCode, 0};

GridMapOptions cells(int width, int height, double scale) {
  GridMapOptions options;
  options.width = width;
  options.height = height;
  options.scale = scale;
  return options;
}

/// '#' occupied, '.' free, '?' unknown; the last row is the bottom one.
std::string drawing(const std::vector<std::int8_t>& cells, std::size_t width) {
  std::string text;
  for (std::size_t row = cells.size() / width; row-- > 0;) {
    for (std::size_t column = 0; column < width; ++column) {
      const std::int8_t cell = cells[row * width + column];
      text += cell > 0 ? '#' : cell < 0 ? '.' : '?';
    }
    text += '\n';
  }
  return text;
}

TEST(BeamMap, a_beam_frees_what_it_passes_and_hits_what_it_ends_in) {
  BeamMap beams(cells(6, 3, 0.5));  // from (-1.5, -0.75)
  beams.add({-1.25, 0}, {1.25, 0});
  EXPECT_EQ(drawing(beams.map().cells, 6),
            "??????\n"
            ".....#\n"
            "??????\n");
  beams.add({-1.25, -0.5}, {-0.25, 0.5});
  EXPECT_EQ(drawing(beams.map().cells, 6),
            "??#???\n"
            ".....#\n"
            "..????\n")
      << "a corner belongs to one of the cells beside it, too";
  EXPECT_EQ(beams.map().info, (map::Info{0.5f, 6, 3, {-1.5, -0.75, 0}}));
}

TEST(BeamMap, one_hit_weighs_three_beams_that_pass) {
  BeamMap beams(cells(3, 1, 1));
  beams.add({-1, 0}, {0, 0});
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(drawing(beams.map().cells, 3), i == 0 ? ".#?\n" : ".##\n");
    beams.add({-1, 0}, {1, 0});
  }
  EXPECT_EQ(drawing(beams.map().cells, 3), ".?#\n");
  for (int i = 0; i < 500; ++i) beams.add({-1, 0}, {1, 0});
  EXPECT_EQ(drawing(beams.map().cells, 3), "..#\n");
  for (int i = 0; i < 34; ++i) beams.add({-1, 0}, {0, 0});
  EXPECT_EQ(drawing(beams.map().cells, 3), ".##\n") << "it is never too sure to change";
  beams.clear();
  EXPECT_EQ(drawing(beams.map().cells, 3), "???\n");
}

TEST(BeamMap, beams_may_begin_and_end_anywhere) {
  BeamMap beams(cells(2, 2, 1));
  beams.add({-5, 0.5}, {5, 0.5});
  EXPECT_EQ(drawing(beams.map().cells, 2), "..\n??\n");
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kHuge = 1e300;
  for (const double bad : {kNan, kHuge, -kHuge}) {
    beams.add({bad, 0}, {0, 0});
    beams.add({0, 0}, {0, bad});
  }
  EXPECT_EQ(drawing(beams.map().cells, 2), "..\n??\n");
}

TEST(GridMap, maps_the_ranges_of_sonars_where_the_robot_is) {
  testing::DriverBench bench(
      "driver( name \"gridmap\" provides [\"map:0\"] requires [\"position2d:0\" \"sonar:0\"] width 8 height "
      "4 scale 1 startx 1 "
      "sonartreshold 4 )",
      {kWheels, kSonars}, kMade);
  bench.close();
  // One looks ahead, one to the left.
  bench.answers(kSonars, snr::kReqGetGeom, snr::Geom{{{}, {0, 0, 0, 0, 0, geom::radians(90)}}});
  ASSERT_TRUE(bench.open());
  const auto drawn = [&bench] {
    return drawing(
        unpacked(*wire::decode<map::Data>(*bench.ask(map::kReqGetData, wire::encode(map::Data{0, 0, 8, 4})))),
        8);
  };
  bench.says(kSonars, snr::kDataRanges, 1, snr::Data{{2, 1}});
  EXPECT_EQ(drawn(), "????????\n????????\n????????\n????????\n") << "no pose is known yet";
  // At (-2.5, -0.5) in the odometry's frame, which is 1 m to the right of the middle.
  bench.says(kWheels, p2d::kDataState, 2, p2d::Data{{-2.5, -0.5, 0}, {}, 0});
  bench.says(kSonars, snr::kDataRanges, 2, snr::Data{{3, 5}});  // 5 m are too far
  EXPECT_EQ(drawn(), "????????\n????????\n??...#??\n????????\n");
  bench.says(kSonars, snr::kDataRanges, 2, snr::Data{{std::numeric_limits<float>::quiet_NaN(), 2}});
  EXPECT_EQ(drawn(), "??#?????\n??.?????\n??...#??\n????????\n");
}

TEST(GridMapSection, says_what_is_wrong) {
  const auto fault = [](const std::string& options) {
    return testing::fault_of(
        "driver( name \"dummy\" provides [\"position2d:0\" \"laser:0\"] )\n"
        "driver( name \"gridmap\" provides [\"map:1\"] requires [\"position2d:0\" \"laser:0\"] " +
        options + " )");
  };
  EXPECT_EQ(fault(""), "");
  EXPECT_EQ(fault("width 0"), "test.cfg:2: width is from 1 to 8192");
  EXPECT_EQ(fault("scale 0"), "test.cfg:2: scale is 0.001 at least");
  EXPECT_EQ(fault("scale 2000"), "test.cfg:2: scale is 1000 m at most");
  EXPECT_THAT(
      testing::fault_of("driver( name \"gridmap\" provides [\"map:1\"] requires [\"position2d:0\"] )"),
      HasSubstr("requires one position2d and one laser, ranger or sonar"));
}

}  // namespace
}  // namespace playhouse::drivers
