#include "playhouse/record/message_type.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "playhouse/record/messages.h"

namespace playhouse::record {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string fault_of(const std::string& text) {
  const Result<MessageSchema> type = MessageSchema::parse(text);
  return type ? "" : type.error().text;
}

TEST(MessageSchema, has_a_row_of_its_fields) {
  const MessageSchema type =
      *MessageSchema::parse("uint32 id  # a number\nstring name\nfloat64[2] place\nfloat32[] more\n");
  EXPECT_THAT(type.fields(), ElementsAre("id", "name", "place", "more"));
  CdrWriter message;
  message.number(std::uint32_t{7});
  message.text("seven");
  message.number(1.5);
  message.number(-2.0);
  message.floats(std::vector<float>{0.25f});
  const Result<MessageSchema::Rows> rows = type.rows(message.message());
  ASSERT_TRUE(rows.ok()) << rows.error().line();
  EXPECT_THAT(*rows, ElementsAre(ElementsAre(ElementsAre("7"), ElementsAre("seven"), ElementsAre("1.5", "-2"),
                                             ElementsAre("0.25"))));
}

TEST(MessageSchema, of_names_that_are_too_long_in_each_other_is_refused) {
  const std::string name(40'000, 'n');
  std::string text;  // 8 in 8 in 8: 512 fields of 120,000 letters
  for (int level = 0; level < 3; ++level) {
    if (level > 0) text += "===\nMSG: p/L" + std::to_string(level) + "\n";
    for (int k = 0; k < 8; ++k)
      text += (level < 2 ? "p/L" + std::to_string(level + 1) : "uint8") + " " + name + "\n";
  }
  EXPECT_EQ(fault_of(text), "has a schema with names that are too long in each other");
}

TEST(MessageSchema, of_every_table_has_fields_with_names_in_words) {
  for (const TableMessages& table : table_messages()) {
    const MessageSchema type = *MessageSchema::parse(table.text);
    for (const std::string& field : type.fields()) {
      EXPECT_THAT(field, testing::MatchesRegex("[a-z][a-z0-9_]*(\\.[xyz]|\\.heading|\\.turn_[xyz])?"))
          << table.schema;
      EXPECT_THAT(field, testing::Not(testing::MatchesRegex("(x|p|v|tilt)_[a-z][a-z]"))) << table.schema;
    }
  }
}

TEST(MessageSchema, of_a_list_of_messages_has_a_row_for_each) {
  const std::vector<Transform> transforms{{"world", "a", {{1, 2, 3, 0}, {}}},
                                          {"world", "b", {{4, 5, 6, 0}, {}}}};
  const MessageSchema type = *MessageSchema::parse(schema_text(kTransforms));
  const Result<MessageSchema::Rows> rows = type.rows(transforms_message(0, transforms));
  ASSERT_TRUE(rows.ok()) << rows.error().line();
  ASSERT_EQ(rows->size(), 2u);
  EXPECT_EQ(type.fields()[1], "transforms.child_frame_id");
  EXPECT_THAT((*rows)[1][1], ElementsAre("b"));
  EXPECT_EQ(type.fields()[2], "transforms.transform.translation.x");
  EXPECT_THAT((*rows)[1][2], ElementsAre("4"));
}

TEST(MessageSchema, has_the_fields_behind_a_list_whatever_they_are_called) {
  const MessageSchema type =
      *MessageSchema::parse("a/Item[] list\nuint32 list.more\nuint32 last\n===\nMSG: a/Item\nuint32 value\n");
  EXPECT_THAT(type.fields(), ElementsAre("list.value", "list.more", "last"));
  CdrWriter message;
  for (const std::uint32_t number : {2u, 10u, 20u, 7u, 8u}) message.number(number);
  const Result<MessageSchema::Rows> rows = type.rows(message.message());
  ASSERT_TRUE(rows.ok()) << rows.error().line();
  EXPECT_THAT(*rows, ElementsAre(ElementsAre(ElementsAre("10"), ElementsAre("7"), ElementsAre("8")),
                                 ElementsAre(ElementsAre("20"), ElementsAre("7"), ElementsAre("8"))));
}

TEST(MessageSchema, knows_every_schema_of_a_recording) {
  for (const char* const name : {kTransforms, kLaserScan, kRanges, kEvent, kState, kChange, kCheck})
    EXPECT_TRUE(MessageSchema::parse(schema_text(name)).ok()) << name;
  for (const TableMessages& table : table_messages())
    EXPECT_EQ(fault_of(schema_text(table.schema)), "") << table.schema;
}

TEST(MessageSchema, has_no_value_for_a_model_that_is_absent) {
  const MessageSchema type = *MessageSchema::parse(
      "uint32 held  # id; 4294967295: no model\nuint32[] touched  # mm; id; 4294967295: no model\nuint32 "
      "plain\n");
  CdrWriter message;
  for (const std::uint32_t number : {4294967295u, 2u, 4294967295u, 7u, 4294967295u}) message.number(number);
  const Result<MessageSchema::Rows> rows = type.rows(message.message());
  ASSERT_TRUE(rows.ok()) << rows.error().line();
  EXPECT_THAT(*rows,
              ElementsAre(ElementsAre(ElementsAre(""), ElementsAre("", "7"), ElementsAre("4294967295"))));
}

TEST(MessageSchema, says_of_every_model_id_what_no_model_is) {
  std::size_t ids = 0;
  for (const TableMessages& table : table_messages())
    for (std::size_t at = table.text.find("id; 4294967295: no model"); at != std::string::npos;
         at = table.text.find("id; 4294967295: no model", at + 1))
      ++ids;
  EXPECT_EQ(ids, 3u) << "held and touched of grippers, hits of bumpers";
}

TEST(MessageSchema, has_names_in_words_for_the_parts_of_a_list_s_elements_and_no_value_for_an_absent_model) {
  const auto type = MessageSchema::parse(
      "float64[] hits  # 3 numbers each: target(model) range size.x; more\nuint32[] plain  # m\n");
  ASSERT_TRUE(type);
  EXPECT_EQ(type->name_of(0, 0), "hits.0.target");
  EXPECT_EQ(type->name_of(0, 4), "hits.1.range");
  EXPECT_EQ(type->name_of(0, 5), "hits.1.size.x");
  EXPECT_EQ(type->name_of(1, 3), "plain.3");
  CdrWriter out;
  out.count(6);
  for (const double number : {7.0, 1.5, 0.5, 4294967295.0, 4294967295.0, 0.25}) out.number(number);
  out.count(1);
  out.number<std::uint32_t>(4294967295);
  const auto rows = type->rows(out.message());
  ASSERT_TRUE(rows);
  EXPECT_EQ((*rows)[0][0], (std::vector<std::string>{"7", "1.5", "0.5", "", "4294967295", "0.25"}));
  EXPECT_EQ((*rows)[0][1], (std::vector<std::string>{"4294967295"}));
}

TEST(MessageSchema, of_every_table_has_a_name_for_every_number_of_a_list_s_elements) {
  std::size_t lists = 0;
  for (const TableMessages& table : table_messages()) {
    std::istringstream lines(table.text);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t at = line.find(kNumbersEach);
      EXPECT_EQ(line.find("[]") != std::string::npos && line.find(" each") != std::string::npos,
                at != std::string::npos)
          << line;
      EXPECT_FALSE(std::regex_search(line, std::regex("^[a-z0-9]+\\[[0-9]+\\]")))
          << line << ": numbers without names";
      if (at == std::string::npos) continue;
      ++lists;
      const std::size_t count = std::stoul(line.substr(line.rfind(' ', at - 1)));
      const std::string names = line.substr(at + kNumbersEach.size());
      EXPECT_EQ(std::ranges::count(names.substr(0, names.find(';')), ' ') + 1, static_cast<long>(count))
          << line;
    }
  }
  EXPECT_GE(lists, 5u) << "hits, blobs, links, echoes, detections";
}

TEST(MessageSchema, refuses_messages_that_are_cut) {
  const MessageSchema type = *MessageSchema::parse(schema_text(kTransforms));
  const std::vector<Transform> transforms{{"world", "a", {}}};
  const Bytes whole = transforms_message(0, transforms);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(type.rows(std::span(whole).first(size)).ok()) << size;
}

TEST(MessageSchema, refuses_a_short_message_that_would_make_a_huge_table) {
  std::string wide = "a/A[] list\nMSG: a/A\n";
  for (int i = 0; i < 20'000; ++i) wide += "uint8[] f" + std::to_string(i) + "\n";
  const MessageSchema type = *MessageSchema::parse(wide);
  CdrWriter message;
  message.floats(std::vector<float>(50'000));  // read as 50,000 rows of 20,000 fields
  const Result<MessageSchema::Rows> rows = type.rows(message.message());
  ASSERT_FALSE(rows.ok());
  EXPECT_EQ(rows.error().text, "has a message of too many values");
}

TEST(MessageSchema, refuses_a_long_list_that_every_row_would_repeat) {
  const MessageSchema type = *MessageSchema::parse("float32[] all\na/A[] list\nMSG: a/A\nuint8 one\n");
  CdrWriter message;
  message.floats(std::vector<float>(100'000));
  message.number(std::uint32_t{100'000});
  for (int i = 0; i < 100'000; ++i) message.number(std::uint8_t{1});
  const Result<MessageSchema::Rows> rows = type.rows(message.message());
  ASSERT_FALSE(rows.ok());
  EXPECT_EQ(rows.error().text, "has a message of too many values");
}

TEST(MessageSchema, refuses_schemas_that_are_none) {
  EXPECT_THAT(fault_of("float64"), HasSubstr("an invalid line"));
  EXPECT_THAT(fault_of("some/Thing thing"), HasSubstr("lacks type \"some/Thing\""));
  EXPECT_THAT(fault_of("float64[99999999] big"), HasSubstr("an invalid array size"));
  EXPECT_THAT(fault_of("a/A x\nMSG: a/A\na/A x\n"), HasSubstr("too deep"));
  std::string wide = "a/A x\n";
  for (char type = 'A'; type < 'K'; ++type) {
    wide += std::string("MSG: a/") + type + "\n";
    for (int i = 0; i < 20; ++i) wide += std::string("a/") + static_cast<char>(type + 1) + " x\n";
  }
  EXPECT_THAT(fault_of(wide + "MSG: a/K\n"), HasSubstr("too many"));
}

}  // namespace
}  // namespace playhouse::record
