#include "playhouse/observers/siphash.h"

#include <gtest/gtest.h>

#include <vector>

namespace playhouse::observers {
namespace {

constexpr SipKey kKey = {0x0706050403020100u, 0x0f0e0d0c0b0a0908u};

std::uint64_t of_first(std::size_t count) {
  std::vector<std::byte> bytes;
  for (std::size_t k = 0; k < count; ++k) bytes.push_back(static_cast<std::byte>(k));
  return siphash(kKey, bytes);
}

TEST(SipHash, gives_the_values_of_its_paper) {
  EXPECT_EQ(of_first(0), 0x726fdb47dd0e0e31u);
  EXPECT_EQ(of_first(8), 0x93f5f5799a932462u);
  EXPECT_EQ(of_first(15), 0xa129ca6149be45e5u);
}

TEST(SipHash, depends_on_the_key) {
  EXPECT_NE(siphash({1, 2}, {}), siphash({1, 3}, {}));
}

}  // namespace
}  // namespace playhouse::observers
