// The walls of a model of a configuration file as interface map.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/drivers/grid_map/testing_tiles.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers {
namespace {

namespace map = wire::map;
using ::testing::ElementsAreArray;
using testing::MemorySite;
using testing::OutputRecorder;

constexpr device::Address kMap{6665, map::kCode, 0};
constexpr std::uint8_t kReq = 3;

/// A wall of 2 x 1 m with a shelf of 0.2 m at its end, turned by 90 degrees, and things that are no part of
/// it.
std::string world(const std::string& words) {
  return "model( name \"wall\" size [2 1 1] pose [10 5 0 90] " + words +
         R"( model( size [0.2 0.2 0.5] pose [1.1 0 -1 0] ) )
model( name "box" size [1 1 1] pose [20 0 0 0] )
position( name "robot" size [0.4 0.4 0.2] pose [0 0 0 0] )
)";
}

class MapOfModelTest : public ::testing::Test {
 protected:
  void build(const std::string& words, const std::string& model = "wall") {
    site = std::make_unique<MemorySite>(world(words));
    ASSERT_EQ(site->build("driver( name \"stage\" provides [\"simulation:0\"] worldfile \"some.world\" )\n"
                          "driver( name \"stage\" provides [\"map:0\"] model \"" +
                          model + "\" )"),
              "");
    ASSERT_TRUE(site->hold(site->id(kMap)));
  }
  testing::OutputRecorder::RecordedAnswer ask(std::uint8_t subtype, const std::vector<std::byte>& body) {
    site->driver(kMap).request({site->id(kMap), kReq, subtype, body}, device::Replier(site->recorder, 1));
    site->run(0);
    return site->recorder.answers.at(1);
  }

  std::unique_ptr<MemorySite> site;
};

TEST_F(MapOfModelTest, has_its_walls_and_those_of_its_parts_where_they_are) {
  build("map_resolution 0.5");
  const auto info = wire::decode<map::Info>(ask(map::kReqGetInfo, {}).body);
  ASSERT_TRUE(info);
  EXPECT_EQ(*info, (map::Info{0.5f, 4, 7, {9, 3.5, 0}})) << "a margin of one cell around 1 x 2.2 m";
  const auto tile = wire::decode<map::Data>(ask(map::kReqGetData, wire::encode(map::Data{0, 0, 4, 7})).body);
  ASSERT_TRUE(tile);
  EXPECT_THAT(unpacked(*tile), ElementsAreArray({-1, -1, -1, -1,  //
                                                 -1, 1,  1,  -1,  //
                                                 -1, 1,  1,  -1,  //
                                                 -1, 1,  1,  -1,  //
                                                 -1, 1,  1,  -1,  //
                                                 -1, 1,  1,  -1,  // the shelf, thinner than a cell
                                                 -1, -1, -1, -1}));
}

/// The cells above, with two lines of each direction.
TEST_F(MapOfModelTest, has_its_walls_as_lines_between_cells) {
  build("map_resolution 0.5");
  const auto lines = wire::decode<map::DataVector>(ask(map::kReqGetVector, {}).body);
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->maxx, 2);
  EXPECT_EQ(lines->maxy, 3.5f);
  EXPECT_THAT(lines->segments,
              ElementsAreArray({wire::Segment{0.5, 0.5, 1.5, 0.5}, wire::Segment{0.5, 3, 1.5, 3},
                                wire::Segment{0.5, 0.5, 0.5, 3}, wire::Segment{1.5, 0.5, 1.5, 3}}));
}

/// A frame whose sides are a third of a cell, in one body.
TEST_F(MapOfModelTest, walls_thinner_than_a_cell_are_closed) {
  build(R"(map_resolution 0.3 size [3 3 1] pose [0 0 0 0] block( points 10
    point[0] [0 0] point[1] [30 0] point[2] [30 30] point[3] [0 30] point[4] [0 0]
    point[5] [1 1] point[6] [1 29] point[7] [29 29] point[8] [29 1] point[9] [1 1] z [0 1] ))");
  const auto info = wire::decode<map::Info>(ask(map::kReqGetInfo, {}).body);
  ASSERT_TRUE(info);
  const std::uint32_t width = info->width, height = info->height;
  const auto tile =
      wire::decode<map::Data>(ask(map::kReqGetData, wire::encode(map::Data{0, 0, width, height})).body);
  ASSERT_TRUE(tile);
  const std::vector<std::int8_t> cells = unpacked(*tile);
  // What can be reached from the corner over free cells, diagonally too.
  std::vector<bool> seen(cells.size());
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t cell = open.back();
    open.pop_back();
    if (seen[cell] || cells[cell] == 1) continue;
    seen[cell] = true;
    const std::uint32_t x = cell % width, y = cell / width;
    for (std::uint32_t v = std::max(y, 1u) - 1; v < std::min(y + 2, height); ++v)
      for (std::uint32_t u = std::max(x, 1u) - 1; u < std::min(x + 2, width); ++u)
        open.push_back(v * width + u);
  }
  EXPECT_FALSE(seen[height / 2 * width + width / 2]);
  EXPECT_EQ(cells[height / 2 * width + width / 2], -1);
}

/// A table whose top is at 0.7 m, on a leg at its left: no sensor of a robot below sees the top.
TEST_F(MapOfModelTest, shows_what_stands_at_its_map_height) {
  const std::string table =
      R"(model( name "table" map_resolution 0.5 size [2 1 0.75] pose [0 0 -1 -90]
      block( points 4 point[0] [0 0] point[1] [20 0] point[2] [20 10] point[3] [0 10] z [0.7 0.75] )
      block( points 4 point[0] [0 0] point[1] [5 0] point[2] [5 10] point[3] [0 10] z [0 0.7] ) )";
  const auto width_of = [&](const std::string& more) {
    build(table + more + " )", "wall.table");
    const auto info = wire::decode<map::Info>(ask(map::kReqGetInfo, {}).body);
    return info ? info->width : 0;
  };
  EXPECT_EQ(width_of(""), 3u) << "the leg is one cell wide, with a margin of one on both sides";
  EXPECT_EQ(width_of("map_height 0.72"), 6u);
  EXPECT_EQ(width_of("map_height 0.8"), 0u);
}

TEST_F(MapOfModelTest, refuses_what_there_is_not) {
  build("map_resolution 0");
  EXPECT_FALSE(ask(map::kReqGetVector, {}).ack);
  EXPECT_FALSE(ask(map::kReqGetInfo, {}).ack);
  build("", "robot");
  EXPECT_FALSE(ask(map::kReqGetInfo, {}).ack) << "it moves";
  build("map_resolution 1e-9");
  EXPECT_FALSE(ask(map::kReqGetInfo, {}).ack) << "too many cells";
}

}  // namespace
}  // namespace playhouse::drivers
