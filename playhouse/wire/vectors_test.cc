// Bytes as the original server and its clients sent them, against values.

#include <gtest/gtest.h>

#include <algorithm>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/camera.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/map.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/simulation.h"
#include "playhouse/wire/generated/wifi.h"
#include "playhouse/wire/header.h"
#include "playhouse/wire/test_bytes.h"

namespace playhouse::wire {
namespace {

constexpr std::uint32_t kPort = 16665;

/// Both directions at once: the value encodes to the bytes, the bytes decode to the value.
template <typename T>
void expect_same(const T& value, std::string_view hex) {
  const auto bytes = bytes_of(hex);
  EXPECT_EQ(encode(value), bytes);
  const Result<T> decoded = decode<T>(bytes);
  ASSERT_TRUE(decoded.ok()) << decoded.error().text;
  EXPECT_EQ(*decoded, value);
}

Header decode_header_of(std::string_view hex) {
  const auto bytes = bytes_of(hex);
  return decode_header(std::span<const std::byte, limits::kHeaderBytes>(bytes));
}

TEST(Vectors, the_header_of_a_datamode_request) {
  const std::string_view hex =
      "00000000 00000000 00000001 00000000 00000003 00000005 41dac05c 55c47bc8 00000000 00000004";
  const Header header = decode_header_of(hex);
  EXPECT_EQ(header.interf, player::kCode);
  EXPECT_EQ(header.type, MessageType::kReq);
  EXPECT_EQ(header.subtype, player::kReqDatamode);
  EXPECT_NEAR(header.timestamp, 1.795256663e9, 1000.0);
  EXPECT_EQ(header.size, 4u);
  std::array<std::byte, limits::kHeaderBytes> again;
  encode_header(header, again);
  EXPECT_TRUE(std::ranges::equal(again, bytes_of(hex)));
}

TEST(Vectors, a_server_on_this_machine_calls_itself_01_00_00_7f) {
  const Header header{
      .host = kLocalhost, .robot = kPort, .interf = 1, .type = MessageType::kAck, .subtype = 5};
  std::array<std::byte, limits::kHeaderBytes> bytes;
  encode_header(header, bytes);
  EXPECT_TRUE(std::ranges::equal(
      bytes,
      bytes_of("0100007f 00004119 00000001 00000000 00000004 00000005 00000000 00000000 00000000 00000000")));
}

TEST(Vectors, only_the_low_bits_of_the_small_header_fields_count) {
  const Header header = decode_header_of(
      "00000000 00000000 abcd0004 12340002 ffffff03 fffffff8 00000000 00000000 00000000 ffffffd8");
  EXPECT_EQ(header.interf, 4);
  EXPECT_EQ(header.index, 2);
  EXPECT_EQ(header.type, MessageType::kReq);
  EXPECT_EQ(header.subtype, 248);
  EXPECT_EQ(header.size, 0xFFFFFFD8u);
}

TEST(Vectors, datamode_pull) {
  expect_same(player::DeviceDatamodeReq{.mode = player::kDatamodePull}, "00000002");
}

TEST(Vectors, a_device_list_has_its_count_twice) {
  expect_same(player::DeviceDevlist{.devices = {{kLocalhost, kPort, 31, 0}, {kLocalhost, kPort, 4, 0}}},
              "00000002 00000002 0100007f 00004119 0000001f 00000000 0100007f 00004119 00000004 00000000");
}

TEST(Vectors, driver_info_in_question_and_answer) {
  player::DeviceDriverinfo info{.addr = {kLocalhost, kPort, 31, 0}};
  expect_same(info, "0100007f 00004119 0000001f 00000000 00000000 00000000");
  info.driver_name = c_string("stage");
  expect_same(info, "0100007f 00004119 0000001f 00000000 00000006 00000006 73746167 65000000");
}

TEST(Vectors, opening_a_device_and_its_answers) {
  expect_same(player::DeviceReq{.addr = {0, 0, 4, 0}, .access = player::kOpenMode},
              "00000000 00000000 00000004 00000000 00000001 00000000 00000000");
  expect_same(player::DeviceReq{{kLocalhost, kPort, 4, 0}, player::kOpenMode, c_string("stage")},
              "0100007f 00004119 00000004 00000000 00000001 00000006 00000006 73746167 65000000");
  expect_same(player::DeviceReq{.addr = {kLocalhost, kPort, 4, 77}, .access = player::kErrorMode},
              "0100007f 00004119 00000004 0000004d 00000003 00000000 00000000");
}

TEST(Vectors, a_velocity_command) {
  expect_same(position2d::CmdVel{.vel = {0.3, 0, 0.2}, .state = 1},
              "3fd33333 33333333 00000000 00000000 3fc99999 9999999a 00000001");
}

TEST(Vectors, a_replace_rule) {
  expect_same(player::AddReplaceRuleReq{-1, -1, 1, -1, player::kMsgReplaceRuleReplace},
              "ffffffff ffffffff 00000001 ffffffff 00000001");
}

TEST(Vectors, a_map_tile_has_its_range_between_count_and_length) {
  map::Data tile{.col = 0, .row = 0, .width = 20, .height = 10, .data_range = 1};
  for (const std::byte b : bytes_of("789cfbff 7f780000 3ad6c739"))
    tile.data.push_back(static_cast<std::int8_t>(b));
  expect_same(tile,
              "00000000 00000000 00000014 0000000a 0000000c 00000001 0000000c 789cfbff 7f780000 3ad6c739");
}

TEST(Vectors, a_property_question) {
  expect_same(IntpropReq{.key = c_string("skip_lines")},
              "0000000b 0000000b 736b6970 5f6c696e 65730000 00000000");
}

TEST(Vectors, a_char_is_sign_extended) {
  expect_same(BoolpropReq{.key = c_string("a"), .value = static_cast<char>(0xFF)},
              "00000002 00000002 61000000 ffffffff");
}

TEST(Vectors, a_count_of_overflow) {
  expect_same(Uint32{7}, "00000007");
}

// What the original does with (count, length) pairs of an 8-byte array.
struct Pair {
  std::string_view words;
  bool accepted;
  std::size_t length;
};

class CountAndLength : public testing::TestWithParam<Pair> {};

TEST_P(CountAndLength, follow_the_original) {
  auto bytes = bytes_of(GetParam().words);
  const auto payload = bytes_of("0102030405060708");
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  const Result<opaque::Data> decoded = decode<opaque::Data>(bytes);
  ASSERT_EQ(decoded.ok(), GetParam().accepted);
  if (GetParam().accepted) {
    EXPECT_EQ(decoded->data.size(), GetParam().length);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Vectors, CountAndLength,
    testing::Values(Pair{"00000008 00000008", true, 8}, Pair{"00000008 00000004", true, 4},
                    Pair{"00000008 00000000", true, 0}, Pair{"00000004 00000008", false, 0},
                    Pair{"00000000 00000008", false, 0}, Pair{"00000010 00000010", false, 0},
                    Pair{"40000000 00000008", true, 8}));

TEST(Vectors, a_bounded_array_is_bounded_by_its_limit_not_by_its_count) {
  // 65 bytes of driver name, where 64 is the limit.
  auto bytes = bytes_of("00000000 00000000 00000004 00000000 00000001 00000041 00000041");
  bytes.resize(bytes.size() + 68);
  const auto decoded = decode<player::DeviceReq>(bytes);
  ASSERT_FALSE(decoded.ok());
  EXPECT_EQ(decoded.error().text, "driver_name has a length of 65, over its limit of 64, at byte 28 of 96");
  // A count of 0 before a length of 2: fine here.
  EXPECT_TRUE(decode<player::DeviceReq>(
                  bytes_of("00000000 00000000 00000004 00000000 00000001 00000000 00000002 61000000"))
                  .ok());
}

TEST(Vectors, text_of_fixed_length_has_no_count) {
  const auto bytes = encode(wifi::IwspyAddrReq{.address = "00:11"});
  ASSERT_EQ(bytes.size(), 32u);
  const auto decoded = decode<wifi::IwspyAddrReq>(bytes);
  EXPECT_EQ(decoded->address.size(), 32u);
  EXPECT_EQ(text(decoded->address), "00:11");
}

TEST(Vectors, an_array_over_its_limit_is_an_error_of_the_writer) {
  std::vector<std::byte> out;
  Writer writer(out);
  write(writer, player::DeviceReq{.driver_name = std::string(65, 'x')});
  EXPECT_EQ(writer.error(), "driver_name has a length of 65, over its limit of 64");
}

}  // namespace
}  // namespace playhouse::wire
