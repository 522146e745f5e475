// Laws of the encoding: round trips, and hostile bytes that are a wire error and nothing else.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <memory>
#include <random>
#include <string>

#include "fake_server.h"
extern "C" {
#include "generated/catalogue.h"
#include "player_types.h"
}

namespace playhouse_c {
namespace {

/// Structs by name, so that every run goes through them in the same order.
using Types = std::map<std::string, const ph_struct_type *>;

void collect(const ph_struct_type *type, Types &found) {
  if (type == nullptr || !found.emplace(type->name, type).second) return;
  for (std::size_t i = 0; i < type->field_count; ++i) collect(type->fields[i].of, found);
}

/// Every struct that a message has.
Types payloads() {
  Types found;
  for (const ph_interface &each : ph_interfaces) {
    for (std::size_t i = 0; i < each.message_count; ++i) collect(each.messages[i].payload, found);
  }
  for (const ph_message_type &each : player_messages) collect(each.payload, found);  // by their old names
  return found;
}

/// A value of any type, decoded or zero.
class Value {
 public:
  explicit Value(const ph_struct_type &type) : type_(type), bytes_(type.size / 8 + 1) {}
  ~Value() { ph_arena_free(&arena_); }

  ph_status decode(const Bytes &body, ph_error *error = nullptr) {
    // A copy without spare memory, so that the sanitizer sees a read behind it.
    const std::unique_ptr<std::uint8_t[]> exact(new std::uint8_t[body.size()]);
    if (!body.empty()) std::memcpy(exact.get(), body.data(), body.size());
    return ph_decode(&type_, bytes_.data(), exact.get(), body.size(), &arena_, error);
  }
  Bytes encode() const { return encoded(type_, bytes_.data()); }

 private:
  const ph_struct_type &type_;
  std::vector<std::uint64_t> bytes_;  // zeros, aligned for every field
  ph_arena arena_ = {nullptr};
};

void append(Bytes &bytes, std::uint32_t word) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(word >> shift));
}

Bytes words(std::initializer_list<std::uint32_t> values) {
  Bytes bytes;
  for (const std::uint32_t value : values) append(bytes, value);
  return bytes;
}

/// Words as bodies have them: mostly small numbers, so that lengths are often believable.
Bytes random_words(std::mt19937 &random, std::size_t count) {
  Bytes bytes;
  for (std::size_t i = 0; i < count; ++i) {
    const auto kind = static_cast<std::uint32_t>(random() % 5);
    append(bytes, kind < 4 ? kind : static_cast<std::uint32_t>(random()));
  }
  return bytes;
}

TEST(Wire, WhatDecodesEncodesToBytesThatMeanTheSame) {
  const Types types = payloads();
  ASSERT_GT(types.size(), 400U);
  for (const auto &[name, type] : types) {
    std::mt19937 random(1);
    int decoded = 0;
    for (int i = 0; i < 300; ++i) {
      Value value(*type), again(*type);
      if (value.decode(random_words(random, 1 + random() % 59)) != PH_OK) continue;
      ++decoded;
      const Bytes body = value.encode();
      ASSERT_EQ(again.decode(body), PH_OK) << name;
      ASSERT_EQ(again.encode(), body) << name;
    }
    EXPECT_GT(decoded, 0) << name;
  }
}

TEST(Wire, ABodyThatIsCutShortIsAnError) {
  for (const auto &[name, type] : payloads()) {
    const Bytes body = Value(*type).encode();
    EXPECT_EQ(body.size(), type->min_bytes) << name;
    for (std::size_t size = 0; size < body.size(); ++size) {
      Value value(*type);
      EXPECT_EQ(value.decode(Bytes(body.begin(), body.begin() + static_cast<std::ptrdiff_t>(size))),
                PH_WIRE_ERROR)
          << name << " cut to " << size;
    }
  }
}

TEST(Wire, BytesAfterTheEndAreIgnored) {
  Bytes body = encoded(ph_common_uint32_type, std::make_unique<ph_common_uint32>(ph_common_uint32{7}).get());
  body.insert(body.end(), {1, 2, 3, 4});
  ph_common_uint32 value;
  ph_arena arena = {nullptr};
  EXPECT_EQ(ph_common_uint32_decode(&value, body.data(), body.size(), &arena, nullptr), PH_OK);
  EXPECT_EQ(value.value, 7U);
  EXPECT_EQ(arena.newest, nullptr) << "numbers need no memory";
}

TEST(Wire, AHugeLengthIsAnErrorBeforeAnythingIsAllocated) {
  const Bytes body = words({0xFFFFFFFF, 0xFFFFFFFF});
  ph_arena arena = {nullptr};
  ph_player_device_devlist list;
  ph_common_intprop_req property;
  EXPECT_FAILS(ph_player_device_devlist_decode(&list, body.data(), body.size(), &arena, &error),
               PH_WIRE_ERROR,
               "player.DeviceDevlist: byte 8: devices has a length of 4294967295, over its limit of 4096");
  EXPECT_FAILS(ph_common_intprop_req_decode(&property, body.data(), body.size(), &arena, &error),
               PH_WIRE_ERROR, "key claims 4294967295 elements, but 0 bytes are left");
  EXPECT_EQ(arena.newest, nullptr);
}

TEST(Wire, TheSecondLengthCountsAndMayNotExceedTheFirst) {
  Bytes body = words({4, 3, 0x61626364, 5});
  ph_arena arena = {nullptr};
  ph_common_intprop_req property;
  EXPECT_WORKS(ph_common_intprop_req_decode(&property, body.data(), body.size(), &arena, &error));
  EXPECT_STREQ(property.key, "abc") << "the NUL is behind the text, not in it";
  EXPECT_EQ(property.key_count, 3U);
  EXPECT_EQ(property.value, 5);
  body = words({3, 4, 0x61626364, 5});
  EXPECT_FAILS(ph_common_intprop_req_decode(&property, body.data(), body.size(), &arena, &error),
               PH_WIRE_ERROR, "common.IntpropReq: byte 8: key has a length of 4, over its limit of 3");
  ph_arena_free(&arena);
}

TEST(Wire, ACountMayTravelApartFromItsList) {
  const std::int8_t cells[] = {1, -1};
  ph_map_data tile{};
  tile.col = 1;
  tile.row = 2;
  tile.width = 3;
  tile.height = 4;
  tile.data_range = -1;
  tile.data = cells;
  tile.data_count = 2;
  const Bytes body = encoded(ph_map_data_type, &tile);
  EXPECT_EQ(body, words({1, 2, 3, 4, 2, 0xFFFFFFFF, 2, 0x01FF0000}));
  ph_map_data again;
  ph_arena arena = {nullptr};
  EXPECT_WORKS(ph_map_data_decode(&again, body.data(), body.size(), &arena, &error));
  EXPECT_EQ(again.data_count, 2U);
  EXPECT_EQ(again.data[1], -1);
  EXPECT_EQ(again.data_range, -1);
  ph_arena_free(&arena);
}

TEST(Wire, ListsOverTheirLimitAndListsAtNullAreErrorsThatLeaveTheBuffer) {
  ph_buffer out = {nullptr, 0, 0};
  const char name[65] = "x";
  const ph_player_device_req request = {{0, 0, 4, 0}, 1, name, sizeof name};
  EXPECT_FAILS(ph_player_device_req_encode(&request, &out, &error), PH_WIRE_ERROR,
               "driver_name has 65 elements, over its limit of 64");
  const ph_opaque_data nothing = {nullptr, 3};
  EXPECT_FAILS(ph_opaque_data_encode(&nothing, &out, &error), PH_WIRE_ERROR, "data has 3 elements at NULL");
  EXPECT_EQ(out.size, 0U);
  ph_buffer_free(&out);
}

TEST(Wire, NarrowNumbersKeepTheirLowBits) {
  const Bytes color = words({0x101, 0x1FF, 0, 0});
  ph_common_color value;
  ph_arena arena = {nullptr};
  EXPECT_EQ(ph_common_color_decode(&value, color.data(), color.size(), &arena, nullptr), PH_OK);
  EXPECT_EQ(value.alpha, 1);
  EXPECT_EQ(value.red, 255);
  Bytes head = words({0, 0, 0x10004, 0x10001, 0x101, 0x102, 0, 0, 0, 0});
  const ph_header header = ph_header_decode(head.data());
  EXPECT_EQ(header.interface_code, 4);
  EXPECT_EQ(header.index, 1);
  EXPECT_EQ(header.kind, 1);
  EXPECT_EQ(header.subtype, 2);
}

TEST(Wire, AnswersShareTheRowOfTheirRequest) {
  EXPECT_EQ(ph_find_message(4, PH_KIND_ACK, 1), PH_POSITION2D_REQ_GET_GEOM);
  EXPECT_EQ(ph_find_message(999, PH_KIND_NACK, 255), PH_COMMON_REQ_CAPABILITIES);
  EXPECT_EQ(ph_find_message(4, PH_KIND_DATA, 99), nullptr);
  EXPECT_STREQ(PH_POSITION2D_CMD_VEL->name, "position2d.cmd.vel");
}

TEST(Wire, EveryInterfaceIsFoundByItsCodeAndItsName) {
  EXPECT_STREQ(ph_interface_name(PH_POSITION2D_CODE), "position2d");
  for (std::size_t i = 1; i < PH_INTERFACE_COUNT; ++i) {
    EXPECT_STREQ(ph_interface_name(ph_interfaces[i].code), ph_interfaces[i].name);
    EXPECT_EQ(ph_interface_code(ph_interfaces[i].name), ph_interfaces[i].code);
  }
  EXPECT_EQ(ph_interface_name(0), nullptr);
  EXPECT_EQ(ph_interface_code("universal"), 0);
}

}  // namespace
}  // namespace playhouse_c
