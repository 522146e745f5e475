#include "playhouse/wire/messages.h"

#include <gtest/gtest.h>

#include <set>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/test_bytes.h"

namespace playhouse::wire {
namespace {

TEST(Catalogue, holds_43_interfaces_with_249_messages_and_9_universal_requests) {
  std::size_t messages = 0;
  for (const InterfaceDef& interface : interfaces()) messages += interface.messages.size();
  EXPECT_EQ(interfaces().size(), 43u);
  EXPECT_EQ(messages, 249u);
  EXPECT_EQ(universal_messages().size(), 9u);
}

TEST(Catalogue, finds_each_of_its_rows_and_each_name_once) {
  std::set<std::string_view> names;
  for (const InterfaceDef& interface : interfaces()) {
    EXPECT_EQ(find_interface(interface.code), &interface);
    EXPECT_EQ(find_interface(interface.name), &interface);
    for (const MessageDef& row : interface.messages) {
      EXPECT_EQ(find_message(interface.code, row.type, row.subtype), &row) << row.name;
      EXPECT_TRUE(names.insert(row.name).second) << row.name;
      EXPECT_EQ(row.has_payload, !row.payload.empty()) << row.name;
    }
  }
}

TEST(Catalogue, an_answer_shares_the_row_of_its_request) {
  const MessageDef* request = find_message(position2d::kCode, MessageType::kReq, position2d::kReqGetGeom);
  ASSERT_NE(request, nullptr);
  EXPECT_EQ(request->name, "position2d.req.get_geom");
  EXPECT_EQ(request->payload, "position2d::Geom");
  EXPECT_EQ(find_message(position2d::kCode, MessageType::kAck, position2d::kReqGetGeom), request);
  EXPECT_EQ(find_message(position2d::kCode, MessageType::kNack, position2d::kReqGetGeom), request);
}

TEST(Catalogue, universal_requests_belong_to_every_interface_known_or_not) {
  const MessageDef* row = find_message(position2d::kCode, MessageType::kReq, kReqGetIntprop);
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->name, "universal.req.get_intprop");
  EXPECT_EQ(find_message(9999, MessageType::kAck, kReqGetIntprop), row);
  EXPECT_EQ(find_message(position2d::kCode, MessageType::kCmd, kReqGetIntprop), nullptr);
}

TEST(Catalogue, what_is_not_there_is_not_found) {
  EXPECT_EQ(find_message(position2d::kCode, MessageType::kData, 99), nullptr);
  EXPECT_EQ(find_message(500, MessageType::kReq, 1), nullptr);
  EXPECT_EQ(find_message(position2d::kCode, static_cast<MessageType>(7), 1), nullptr);
  EXPECT_EQ(find_interface(std::uint16_t{500}), nullptr);
  EXPECT_EQ(find_interface("position4d"), nullptr);
}

TEST(Catalogue, an_empty_body_is_a_question_but_no_command) {
  const auto* question = find_message(position2d::kCode, MessageType::kReq, position2d::kReqGetGeom);
  const auto* command = find_message(position2d::kCode, MessageType::kCmd, position2d::kCmdVel);
  const auto* plain = find_message(position2d::kCode, MessageType::kReq, position2d::kReqResetOdom);
  EXPECT_EQ(question->check({}), "");
  EXPECT_EQ(command->check({}), "8 bytes wanted, 0 left, at byte 0 of 0");
  EXPECT_FALSE(plain->has_payload);
  EXPECT_EQ(plain->check({}), "");
}

TEST(Catalogue, commands_say_whether_a_newer_one_replaces_them) {
  EXPECT_EQ(find_message(position2d::kCode, MessageType::kCmd, position2d::kCmdVel)->policy, Policy::kLatest);
  EXPECT_EQ(find_message(12, MessageType::kCmd, 1)->policy, Policy::kQueue)
      << "words are spoken one after another";
  EXPECT_EQ(find_message(position2d::kCode, MessageType::kReq, 1)->policy, Policy::kNone);
}

std::string json_of(std::uint16_t interf, MessageType type, std::uint8_t subtype,
                    std::span<const std::byte> body) {
  std::string out;
  find_message(interf, type, subtype)->to_json(body, out);
  return out;
}

TEST(Json, a_value_is_an_object_with_every_field_by_name) {
  const auto body = encode(position2d::Data{.pos = {1.5, -2, 0.1}, .vel = {0, 0, 0}, .stall = 1});
  EXPECT_EQ(json_of(position2d::kCode, MessageType::kData, position2d::kDataState, body),
            R"({"pos":{"px":1.5,"py":-2,"pa":0.1},"vel":{"px":0,"py":0,"pa":0},"stall":1})");
}

TEST(Json, numbers_that_json_lacks_are_null) {
  const auto body = bytes_of("7ff80000 00000000 fff00000 00000000");
  EXPECT_EQ(json_of(position2d::kCode, MessageType::kCmd, position2d::kCmdCar, body),
            R"({"velocity":null,"angle":null})");
}

TEST(Json, no_body_and_no_sense_are_null) {
  EXPECT_EQ(json_of(position2d::kCode, MessageType::kReq, position2d::kReqGetGeom, {}), "null");
  EXPECT_EQ(json_of(position2d::kCode, MessageType::kReq, position2d::kReqResetOdom, {}), "null");
  EXPECT_EQ(json_of(position2d::kCode, MessageType::kCmd, position2d::kCmdVel, bytes_of("00000000")), "null");
}

}  // namespace
}  // namespace playhouse::wire
