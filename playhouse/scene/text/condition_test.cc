// What detectors are to see, as files say it.

#include "playhouse/scene/text/condition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace playhouse::scene {
namespace {

using testing::HasSubstr;
using Compare = Term::Compare;

std::string fault(std::string_view text) {
  const Result<Condition> condition = read_condition(text);
  return condition ? "none" : condition.error().text;
}

TEST(Condition, has_terms_between_spaces) {
  const Result<Condition> condition =
      read_condition("  kind=position  color=red mass>2.5 says!='two words' ");
  ASSERT_TRUE(condition.ok()) << condition.error().line();
  ASSERT_EQ(condition->size(), 4u);
  EXPECT_EQ((*condition)[0].kind, ModelKind::kPosition);
  EXPECT_EQ((*condition)[1].rgb, 0xff0000u);
  EXPECT_EQ((*condition)[2].number, 2.5);
  EXPECT_EQ((*condition)[2].compare, Compare::kAbove);
  EXPECT_EQ((*condition)[3].text, "two words");
  EXPECT_EQ((*condition)[3].compare, Compare::kIsNot);
  EXPECT_FALSE((*condition)[3].prefix);
}

TEST(Condition, takes_beginnings_of_texts_colors_as_numbers_and_lights_that_are_off) {
  const Result<Condition> condition = read_condition("name=r* color=#0a0B0c light=off light!=off");
  ASSERT_TRUE(condition.ok()) << condition.error().line();
  EXPECT_TRUE((*condition)[0].prefix);
  EXPECT_EQ((*condition)[0].text, "r");
  EXPECT_EQ((*condition)[1].rgb, 0x0a0b0cu);
  EXPECT_EQ((*condition)[2].compare, Compare::kIsNot);
  EXPECT_EQ((*condition)[3].compare, Compare::kIs);
}

TEST(Condition, that_says_nothing_known_is_refused_with_the_nearest_word) {
  EXPECT_EQ(fault("colour=red"), "has an unknown property \"colour\" (did you mean \"color\"?)");
  EXPECT_EQ(fault("kind=positon"), "has an unknown kind \"positon\" (did you mean \"position\"?)");
  EXPECT_EQ(fault("kind=sensor"), "has an unknown kind \"sensor\"") << "parts have no bodies";
  EXPECT_THAT(fault("color=reed"), HasSubstr("has an unknown color \"reed\" (did you mean \"red\""));
  EXPECT_THAT(fault("color=#12345"), HasSubstr("unknown color"));
  EXPECT_THAT(fault("color=#12345x"), HasSubstr("unknown color"));
  EXPECT_EQ(fault("mass>heavy"), "needs a number behind \"mass\", found \"heavy\"");
  EXPECT_EQ(fault("mass"), "needs =, !=, < or > behind \"mass\"");
  EXPECT_EQ(fault("mass!3"), "needs =, !=, < or > behind \"mass\"");
  EXPECT_EQ(fault("material<glass"), "\"material\" is not a number: it has = and != only");
  EXPECT_EQ(fault("light=green"), "needs light=on or =off, found \"green\"");
  EXPECT_EQ(fault("says='hello"), "lacks a closing ' in \"says='hello\"");
  EXPECT_EQ(fault("  "), "has a condition without a term");
  EXPECT_EQ(fault("=3"), "has an unknown property \"\"");
}

TEST(Condition, properties_are_all_in_the_documentation) {
  std::ifstream in(std::filesystem::path(PLAYHOUSE_SOURCE_DIR) / "docs" / "detectors.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  for (const std::string_view name : property_names())
    EXPECT_THAT(page, HasSubstr("| `" + std::string(name)));
}

}  // namespace
}  // namespace playhouse::scene
