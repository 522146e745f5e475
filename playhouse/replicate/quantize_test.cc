#include "playhouse/replicate/quantize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "playhouse/base/rng.h"

namespace playhouse::replicate {
namespace {

TEST(QuantizeRanges, each_is_the_nearest_part_of_range_max) {
  Rng rng(1);
  std::vector<float> ranges{0.0f, 8.0f, 9.0f, -1.0f, std::numeric_limits<float>::infinity(), 4.0f};
  for (int i = 0; i < 1001; ++i) ranges.push_back(static_cast<float>(rng.uniform(0, 8)));
  std::vector<std::uint16_t> parts(ranges.size());
  quantize_ranges(ranges, 8, parts.data());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double exact = std::clamp(static_cast<double>(ranges[i]) / 8, 0.0, 1.0) * 65535;
    EXPECT_LE(std::fabs(parts[i] - exact), 0.5 + 1e-9) << ranges[i];
    EXPECT_EQ(parts[i], quantize_range(static_cast<double>(ranges[i]), 8)) << ranges[i];
  }
}

TEST(QuantizeRanges, what_is_not_a_number_and_a_sensor_without_a_range_are_the_whole_of_it) {
  const std::vector<float> ranges{std::numeric_limits<float>::quiet_NaN(), 1.0f};
  std::vector<std::uint16_t> parts(2);
  quantize_ranges(ranges, 2, parts.data());
  EXPECT_EQ(parts, (std::vector<std::uint16_t>{65535, 32768}));
  quantize_ranges(ranges, 0, parts.data());
  EXPECT_EQ(parts, (std::vector<std::uint16_t>{65535, 65535}));
}

}  // namespace
}  // namespace playhouse::replicate
