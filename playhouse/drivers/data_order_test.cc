#include "playhouse/drivers/data_order.h"

#include <gmock/gmock.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(DataOrder, puts_each_behind_what_it_requires_and_else_keeps_the_numbers) {
  EXPECT_THAT(data_order({{2}, {}, {3}, {}}).order, ElementsAre(1, 3, 2, 0));
  EXPECT_THAT(data_order({{}, {}, {}}).order, ElementsAre(0, 1, 2));
  EXPECT_THAT(data_order({{1, 1}, {}}).order, ElementsAre(1, 0)) << "two devices of one driver";
}

TEST(DataOrder, a_circle_is_told_from_its_first_node_on) {
  EXPECT_THAT(data_order({{}, {3}, {1}, {2}}).circle, ElementsAre(1, 3, 2));
  EXPECT_THAT(data_order({{}, {3}, {1}, {2}}).order, IsEmpty());
  EXPECT_THAT(data_order({{0}}).circle, ElementsAre(0));
  EXPECT_THAT(data_order({{1}, {2}, {1}}).circle, ElementsAre(1, 2)) << "what leads into it is no part of it";
}

RC_GTEST_PROP(DataOrder, is_an_order_or_a_circle, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 12);
  const auto required = *rc::gen::container<std::vector<std::vector<std::size_t>>>(
      count, rc::gen::resize(
                 3, rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, count))));
  const auto [order, circle] = data_order(required);
  RC_ASSERT(order.empty() != circle.empty());
  if (circle.empty()) RC_ASSERT(order.size() == count);
  for (std::size_t node = 0; node < count && circle.empty(); ++node) {
    for (const std::size_t other : required[node])
      RC_ASSERT(std::ranges::find(order, other) < std::ranges::find(order, node));
  }
  for (std::size_t i = 0; i < circle.size(); ++i) {
    const std::size_t next = circle[(i + 1) % circle.size()];
    RC_ASSERT(std::ranges::find(required[circle[i]], next) != required[circle[i]].end());
  }
}

}  // namespace
}  // namespace playhouse::drivers
