#include "playhouse/bridge/simulated/retired_indices.h"

#include <gtest/gtest.h>

namespace playhouse::drivers {
namespace {

constexpr double kRest = RetiredIndices::kRest;

TEST(RetiredIndices, are_given_again_in_the_order_in_which_they_retired_once_they_have_rested) {
  RetiredIndices indices;
  for (const std::size_t index : {3u, 1u, 2u}) indices.hold(index);
  indices.release(2, 10);
  indices.release(3, 11);
  EXPECT_FALSE(indices.take(kRest + 9.9));
  EXPECT_EQ(indices.take(kRest + 10), 2u);
  EXPECT_FALSE(indices.take(kRest + 10)) << "the next went later, and one is there";
  EXPECT_EQ(indices.take(kRest + 20), 3u);
  EXPECT_FALSE(indices.take(1e9));
}

TEST(RetiredIndices, retire_with_the_last_device_that_has_them) {
  RetiredIndices indices;
  indices.hold(7);
  indices.hold(7);
  indices.release(7, 0);
  EXPECT_FALSE(indices.take(1e9));
  indices.release(7, 5);
  EXPECT_EQ(indices.take(kRest + 5), 7u);
  indices.hold(7);
  indices.release(7, 200);
  EXPECT_FALSE(indices.take(kRest + 199));
  EXPECT_EQ(indices.take(kRest + 200), 7u);
}

TEST(RetiredIndices, of_models_that_came_back_wait_no_more) {
  RetiredIndices indices;
  indices.hold(1);
  indices.hold(2);
  indices.release(1, 50);
  indices.release(2, 90);
  indices.rewind_to(40);
  indices.hold(1);
  EXPECT_EQ(indices.size(), 1u);
  EXPECT_EQ(indices.take(kRest + 40), 2u) << "which rests from when the run was taken back";
  EXPECT_FALSE(indices.take(1e9));
  indices.release(1, 60);
  EXPECT_EQ(indices.take(kRest + 60), 1u);
}

}  // namespace
}  // namespace playhouse::drivers
