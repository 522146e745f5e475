// Maps with cells of another size, by what each new cell covers.

#include "playhouse/drivers/maps/mapscale.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/drivers/testing/driver_bench.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Four by two cells of 0.1 m.
GridMap eight_cells() {
  return {{0.1f, 4, 2, {-1, -2, 0.5}}, {-1, -1, 0, -1, -1, 1, -1, -1}};
}

TEST(MapScale, a_coarser_cell_is_as_bad_as_the_worst_that_it_covers) {
  const GridMap coarse = *MapScale{0.2}.map(eight_cells());
  EXPECT_EQ(coarse.info, (wire::map::Info{0.2f, 2, 1, {-1, -2, 0.5}}));
  EXPECT_THAT(coarse.cells, ElementsAre(1, 0));
}

TEST(MapScale, a_finer_cell_is_as_the_one_that_it_is_in) {
  const GridMap fine = *MapScale{0.05}.map(eight_cells());
  EXPECT_EQ(fine.info.width, 8u);
  EXPECT_EQ(fine.info.height, 4u);
  EXPECT_THAT(fine.cells, ElementsAre(-1, -1, -1, -1, 0, 0, -1, -1, -1, -1, -1, -1, 0, 0, -1, -1, -1, -1, 1,
                                      1, -1, -1, -1, -1, -1, -1, 1, 1, -1, -1, -1, -1));
}

TEST(MapScale, what_reaches_over_the_edge_is_unknown) {
  const GridMap coarse = *MapScale{0.3}.map({{0.1f, 4, 3, {}}, std::vector<std::int8_t>(12, -1)});
  EXPECT_EQ(coarse.info.width, 2u);
  EXPECT_EQ(coarse.info.height, 1u);
  EXPECT_THAT(coarse.cells, ElementsAre(-1, 0));
  EXPECT_THAT(MapScale{1000}.map(eight_cells())->cells, ElementsAre(1));
}

TEST(MapScale, the_same_size_is_the_same_map) {
  GridMap wide{{0.1f, 5000, 1, {}}, std::vector<std::int8_t>(5000, -1)};
  wide.cells[4321] = 1;
  const GridMap same = *MapScale{0.1}.map(wide);
  EXPECT_EQ(same.info, wide.info);
  EXPECT_EQ(same.cells, wide.cells);
}

TEST(MapScale, makes_no_more_cells_than_a_map_may_have) {
  const Result<GridMap> huge = MapScale{0.0001}.map({{1000, 4, 2, {}}, std::vector<std::int8_t>(8, -1)});
  ASSERT_FALSE(huge);
  EXPECT_THAT(huge.error().text, HasSubstr("would have more than 67108864 cells of 0.0001 m"));
  EXPECT_THAT(MapScale{1000}.map({{1e-30f, 2, 1, {}}, {-1, 1}})->cells, ElementsAre(1));
}

TEST(MapScaleSection, says_what_is_wrong) {
  const auto fault = [](const std::string& options) {
    return testing::fault_of(
        "driver( name \"dummy\" provides [\"map:0\"] )\n"
        "driver( name \"mapscale\" provides [\"map:1\"] requires [\"map:0\"] " +
        options + " )");
  };
  EXPECT_EQ(fault("resolution 0.5"), "");
  EXPECT_EQ(fault(""), "test.cfg:2: resolution is needed, from 0.0001 to 1000 m per cell");
  EXPECT_EQ(fault("resolution 0"), "test.cfg:2: resolution is needed, from 0.0001 to 1000 m per cell");
}

}  // namespace
}  // namespace playhouse::drivers
