#include "playhouse/record/whole_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string_view>

namespace playhouse::record {
namespace {

Bytes random_bytes(std::mt19937& random, std::size_t size) {
  Bytes bytes(size);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random() & 0xFF);
  return bytes;
}

TEST(WholeState, a_difference_makes_after_of_before) {
  std::mt19937 random(1);
  for (int round = 0; round < 500; ++round) {
    const Bytes before = random_bytes(random, random() % 200);
    Bytes after = before;
    for (std::size_t n = random() % 8; n > 0 && !after.empty(); --n)
      after[random() % after.size()] = static_cast<std::byte>(random() & 0xFF);
    if (round % 5 == 0) after.resize(random() % 200);
    const Result<Bytes> got = patched(before, difference(before, after));
    ASSERT_TRUE(got.ok()) << got.error().line();
    ASSERT_EQ(*got, after);
  }
}

TEST(WholeState, a_difference_costs_what_differs) {
  const Bytes before(100000);
  Bytes after = before;
  after[7] = after[5000] = after[99999] = std::byte{1};
  EXPECT_LT(difference(before, after).size(), 20u);
}

TEST(WholeState, a_difference_of_another_state_is_refused_or_stays_in_its_bounds) {
  std::mt19937 random(2);
  const Bytes before(64);
  std::size_t refused = 0;
  for (int round = 0; round < 2000; ++round) {
    Bytes wild = random_bytes(random, 1 + random() % 20);
    wild[0] = std::byte{1};
    const Result<Bytes> got = patched(before, wild);
    if (got)
      EXPECT_EQ(got->size(), before.size());
    else
      ++refused;
  }
  EXPECT_GT(refused, 1000u);
  EXPECT_FALSE(patched(before, {}).ok());
}

}  // namespace
}  // namespace playhouse::record
