#include "playhouse/wire/json.h"

#include <gtest/gtest.h>

#include <vector>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/blobfinder.h"
#include "playhouse/wire/generated/wifi.h"

namespace playhouse::wire {
namespace {

std::string text_of(std::string_view raw) {
  std::string out;
  json_text(out, raw);
  return out;
}

TEST(JsonText, ends_at_the_first_nul) {
  EXPECT_EQ(text_of(std::string_view("ab\0cd", 5)), R"("ab")");
}

TEST(JsonText, escapes_quotes_backslashes_and_control_characters) {
  EXPECT_EQ(text_of("a\"b\\c\n\x01"), R"("a\"b\\c\u000a\u0001")");
}

TEST(JsonText, keeps_utf8_and_replaces_what_is_none) {
  EXPECT_EQ(text_of("\xC3\xA4 \xE2\x82\xAC \xF0\x9F\xA4\x96"), "\"\xC3\xA4 \xE2\x82\xAC \xF0\x9F\xA4\x96\"");
  EXPECT_EQ(text_of("\xE4"), R"("\u00e4")") << "a lone lead byte";
  EXPECT_EQ(text_of("\xC0\x80"), R"("\u00c0\u0080")") << "an over-long form";
  EXPECT_EQ(text_of("\xED\xA0\x80"), R"("\u00ed\u00a0\u0080")") << "half of a pair";
}

TEST(JsonBytes, few_are_numbers_and_many_are_base64) {
  std::string out;
  json_bytes(out, std::vector<std::uint8_t>{1, 255});
  EXPECT_EQ(out, "[1,255]");
  out.clear();
  json_bytes(out, std::vector<std::int8_t>{1, -1});
  EXPECT_EQ(out, "[1,-1]");
  out.clear();
  json_bytes(out, std::vector<std::uint8_t>(kJsonByteNumbers + 1, 0xFF));
  EXPECT_TRUE(out.starts_with(R"({"base64":"////)")) << out.substr(0, 20);
  EXPECT_TRUE(out.ends_with("///8=\"}")) << "1025 = 3 * 341 + 2: " << out.substr(out.size() - 12);
}

TEST(JsonNumbers, are_the_shortest_that_read_back) {
  std::string out;
  json_value(out, 0.1f);
  out += ' ';
  json_value(out, 1e300);
  out += ' ';
  json_value(out, std::int64_t{-9007199254740993});
  out += ' ';
  json_value(out, static_cast<char>(0xFF));
  EXPECT_EQ(out, "0.1 1e+300 -9007199254740993 -1");
}

/// The protocol has these unsigned; their values are signed, in two's complement: the bytes are the same.
TEST(JsonNumbers, may_be_below_zero_where_the_definition_says_so) {
  std::string out;
  wifi::Data data{.links = {{.freq = 4'000'000'000, .level = -30, .noise = -100}},
                  .maxlevel = -1,
                  .maxnoise = 0x7FFFFFFF};
  to_json(out, data);
  for (const char* const part : {R"("freq":4000000000,)", R"("level":-30,"noise":-100})", R"("maxlevel":-1,)",
                                 R"("maxnoise":2147483647,)"})
    EXPECT_NE(out.find(part), std::string::npos) << part << " in " << out;
  out.clear();
  to_json(out, blobfinder::ColorConfig{.channel = -1});
  EXPECT_TRUE(out.starts_with(R"({"channel":-1,)")) << out;

  const std::vector<std::byte> bytes = encode(blobfinder::ColorConfig{.channel = -2, .rmin = 1});
  EXPECT_EQ(std::vector(bytes.begin(), bytes.begin() + 8),
            (std::vector{std::byte{0xFF}, std::byte{0xFF}, std::byte{0xFF}, std::byte{0xFE}, std::byte{0},
                         std::byte{0}, std::byte{0}, std::byte{1}}));
  EXPECT_EQ(decode<blobfinder::ColorConfig>(bytes)->channel, -2);
}

}  // namespace
}  // namespace playhouse::wire
