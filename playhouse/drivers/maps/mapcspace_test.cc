// A map whose obstacles have grown, by the exact distances of cells; and what a driver of maps does while it reads.

#include "playhouse/drivers/maps/mapcspace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <string>

#include "playhouse/drivers/grid_map/testing_tiles.h"
#include "playhouse/drivers/testing/driver_bench.h"

namespace playhouse::drivers {
namespace {

using ::testing::HasSubstr;
namespace map = wire::map;

constexpr device::Address kMap{6665, map::kCode, 0}, kGrown{6665, map::kCode, 1};

/// '#' occupied, '.' free, '?' unknown; the last row is the bottom one.
GridMap drawn(const std::vector<std::string>& rows, float scale) {
  GridMap grid{{scale,
                static_cast<std::uint32_t>(rows.front().size()),
                static_cast<std::uint32_t>(rows.size()),
                {1, 2, 0.5}},
               {}};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char c : *row) grid.cells.push_back(c == '#' ? 1 : c == '.' ? -1 : 0);
  return grid;
}

TEST(MapCSpace, grows_obstacles_by_the_radius) {
  const GridMap room = drawn({".......",  //
                              ".......",  //
                              ".......",  //
                              "...#...",  //
                              ".......",  //
                              ".......",  //
                              "......."},
                             0.1f);
  const GridMap one = drawn({".......",  //
                             ".......",  //
                             "...#...",  //
                             "..###..",  //
                             "...#...",  //
                             ".......",  //
                             "......."},
                            0.1f);
  EXPECT_EQ(MapCSpace{0.0}.map(room)->cells, room.cells);
  EXPECT_EQ(MapCSpace{0.099}.map(room)->cells, room.cells);
  EXPECT_EQ(MapCSpace{0.1}.map(room)->cells, one.cells);
  EXPECT_EQ(MapCSpace{0.14}.map(room)->cells, one.cells) << "the diagonal is 0.1414";
  EXPECT_EQ(MapCSpace{0.1}.map(room)->info, room.info);
  EXPECT_EQ(MapCSpace{1e300}.map(room)->cells, std::vector<std::int8_t>(49, 1));
}

TEST(MapCSpace, unknown_cells_grow_too_but_not_over_obstacles) {
  EXPECT_EQ(MapCSpace{0.1}.map(drawn({"?...#.."}, 0.1f))->cells, drawn({"??.###."}, 0.1f).cells);
  EXPECT_EQ(MapCSpace{0.2}.map(drawn({"?..#..."}, 0.1f))->cells, drawn({"?#####."}, 0.1f).cells);
  EXPECT_EQ(MapCSpace{5}.map(drawn({"...."}, 0.1f))->cells, drawn({"...."}, 0.1f).cells);
}

RC_GTEST_PROP(MapCSpaceOracle, is_that_of_all_pairs_of_cells, ()) {
  const int width = *rc::gen::inRange(1, 9), height = *rc::gen::inRange(1, 9),
            radius = *rc::gen::inRange(0, 5);
  GridMap grid{{0.5f, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}}, {}};
  for (int i = 0; i < width * height; ++i)
    grid.cells.push_back(static_cast<std::int8_t>(*rc::gen::weightedElement<int>({{8, -1}, {1, 0}, {1, 1}})));
  const GridMap grown = *MapCSpace{0.5 * radius}.map(grid);
  for (int at = 0; at < width * height; ++at) {
    int worst = -1;
    for (int other = 0; other < width * height; ++other) {
      const int dx = at % width - other % width, dy = at / width - other / width;
      const int cell = grid.cells[static_cast<std::size_t>(other)];
      if (dx * dx + dy * dy <= radius * radius) worst = std::max(worst, cell);
    }
    RC_ASSERT(int{grown.cells[static_cast<std::size_t>(at)]} == worst);
  }
}

class MapCSpaceDriverTest : public ::testing::Test {
 protected:
  MapCSpaceDriverTest()
      : bench("driver( name \"mapcspace\" provides [\"map:1\"] requires [\"map:0\"] robot_radius 0.1 )",
              {kMap}, kGrown) {
    bench.close();
    const GridMap source = drawn({"....#"}, 0.1f);
    bench.answers(kMap, map::kReqGetInfo, source.info);
    bench.answers(kMap, map::kReqGetData, map::Data{0, 0, 5, 1, 1, source.cells});
  }
  std::vector<std::byte> whole() { return wire::encode(map::Data{0, 0, 5, 1}); }

  testing::DriverBench bench;
};

TEST_F(MapCSpaceDriverTest, answers_as_a_map) {
  ASSERT_TRUE(bench.open());
  EXPECT_EQ(wire::decode<map::Info>(*bench.ask(map::kReqGetInfo))->origin, (wire::Pose2d{1, 2, 0.5}));
  EXPECT_EQ(unpacked(*wire::decode<map::Data>(*bench.ask(map::kReqGetData, whole()))),
            drawn({"...##"}, 0.1f).cells);
  EXPECT_FALSE(bench.ask(map::kReqGetVector));
}

TEST_F(MapCSpaceDriverTest, requests_wait_for_the_map) {
  bench.told().holds = true;
  ASSERT_TRUE(bench.open());
  device::Driver& driver = bench.site().driver(kGrown);
  const device::DeviceId id = bench.site().id(kGrown);
  driver.request({id, 3, map::kReqGetData, whole()}, device::Replier(bench.site().recorder, 7));
  EXPECT_FALSE(bench.site().recorder.answers.contains(7));
  bench.told().holds = false;
  bench.told().held.front().ack(bench.told().answers.at({bench.site().id(kMap).row, map::kReqGetInfo}));
  ASSERT_TRUE(bench.site().recorder.answers.contains(7));
  EXPECT_EQ(unpacked(*wire::decode<map::Data>(bench.site().recorder.answers.at(7).body)),
            drawn({"...##"}, 0.1f).cells);
}

TEST_F(MapCSpaceDriverTest, refuses_what_waits_when_there_is_no_map_after_all) {
  bench.told().holds = true;
  ASSERT_TRUE(bench.open());
  device::Driver& driver = bench.site().driver(kGrown);
  const device::DeviceId id = bench.site().id(kGrown);
  driver.request({id, 3, map::kReqGetInfo, {}}, device::Replier(bench.site().recorder, 7));
  bench.told().held.clear();  // NACK
  ASSERT_TRUE(bench.site().recorder.answers.contains(7));
  EXPECT_FALSE(bench.site().recorder.answers.at(7).ack);
  EXPECT_FALSE(bench.ask(map::kReqGetInfo));
}

TEST(MapCSpaceSection, says_what_is_wrong) {
  const auto fault = [](const std::string& options) {
    return testing::fault_of(
        "driver( name \"dummy\" provides [\"map:0\"] )\n"
        "driver( name \"mapcspace\" provides [\"map:1\"] requires [\"map:0\"] " +
        options + " )");
  };
  EXPECT_EQ(fault("robot_radius 0.2 robot_shape \"circle\""), "");
  EXPECT_EQ(fault(""), "test.cfg:2: robot_radius is needed, 0 m at least");
  EXPECT_EQ(fault("robot_radius -1"), "test.cfg:2: robot_radius is needed, 0 m at least");
  EXPECT_EQ(fault("robot_radius 1 robot_shape \"square\""), "test.cfg:2: robot_shape is \"circle\"");
}

}  // namespace
}  // namespace playhouse::drivers
