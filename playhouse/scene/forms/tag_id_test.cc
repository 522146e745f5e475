#include "playhouse/scene/forms/tag_id.h"

#include <gtest/gtest.h>

namespace playhouse::scene {
namespace {

using namespace std::string_literals;

TEST(TagId, is_pairs_of_hexadecimal_digits_with_or_without_spaces) {
  EXPECT_EQ(tag_id("E2003412"), "\xe2\x00\x34\x12"s);
  EXPECT_EQ(tag_id(" e2 00 3412 "), "\xe2\x00\x34\x12"s);
  EXPECT_EQ(tag_id("00"), "\0"s);
}

TEST(TagId, is_nothing_else) {
  for (const char* text : {"", " ", "E", "E20", "E2 0 0", "G0", "0x12", "E2-00", "E2\t00", "\xe2\x00"})
    EXPECT_FALSE(tag_id(text)) << text;
}

TEST(TagId, is_as_long_as_an_epc_may_be) {
  std::string longest;
  for (std::size_t i = 0; i < kTagIdBytes; ++i) longest += "a5";
  EXPECT_EQ(tag_id(longest), std::string(kTagIdBytes, '\xa5'));
  EXPECT_FALSE(tag_id(longest + "a5"));
}

}  // namespace
}  // namespace playhouse::scene
