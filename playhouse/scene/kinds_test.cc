/// The tables of kinds against what loading a file does: defaults and limits are as told, and every word is
/// known.

#include "playhouse/scene/kinds.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Result<SceneDesc> load(const std::string& text) {
  config::MemoryFiles files({});
  return load_world_text(text, "w/t.world", files);
}

SceneDesc loaded(const std::string& text) {
  Result<SceneDesc> scene = load(text);
  EXPECT_TRUE(scene.ok()) << text << ": " << (scene ? "" : scene.error().line());
  return scene ? std::move(*scene) : SceneDesc{};
}

/// A file in which an entity of that kind has these words.
std::string file_with(const Kind& kind, const std::string& words) {
  if (kind.entity == EntityForm::kWorld) return words;
  const std::string entity = std::string(kind.name) + "( " + words + " )\n";
  return kind.entity == EntityForm::kPart ? std::string(kind.inside) + "( " + entity + ")" : entity;
}

/// The words that this build reads, but of blocks: those without points are errors.
std::vector<std::pair<const Kind*, const Word*>> words_that_are_read() {
  std::vector<std::pair<const Kind*, const Word*>> found;
  for (const Kind& kind : kinds()) {
    for (const Word& word : kind.words) {
      if (word.use == Support::kRead && kind.name != "block") found.emplace_back(&kind, &word);
    }
  }
  return found;
}

TEST(Kinds, a_word_with_its_default_says_the_same_as_none) {
  int compared = 0;
  for (const auto& [kind, word] : words_that_are_read()) {
    if (word->otherwise.empty()) continue;
    const std::string said = std::string(word->name) + " " + std::string(word->otherwise);
    const SceneDesc with = loaded(file_with(*kind, said)), without = loaded(file_with(*kind, ""));
    EXPECT_THAT(with.warnings, IsEmpty()) << said;
    EXPECT_EQ(static_cast<const WorldDesc&>(with), static_cast<const WorldDesc&>(without)) << said;
    EXPECT_EQ(with.window, without.window) << said;
    ASSERT_EQ(with.models.size(), without.models.size());
    for (std::size_t row = 0; row < with.models.size(); ++row) {
      EXPECT_EQ(static_cast<const PlainDesc&>(with.models[row]),
                static_cast<const PlainDesc&>(without.models[row]))
          << said;
      EXPECT_EQ(static_cast<const KindDescs&>(with.models[row]),
                static_cast<const KindDescs&>(without.models[row]))
          << said;
      EXPECT_EQ(with.models[row].blocks.size(), without.models[row].blocks.size()) << said;
      EXPECT_EQ(with.models[row].stacked, without.models[row].stacked) << said;
    }
    ++compared;
  }
  EXPECT_GE(compared, 40);
}

std::string repeated(const std::string& text, std::ptrdiff_t times) {
  std::string all;
  for (; times > 0; --times) all += text;
  return all;
}

TEST(Kinds, values_beyond_the_limits_that_are_told_have_a_line_that_names_the_word) {
  const auto line_of = [](const Kind& kind, const Word& word, const std::string& value) {
    const Result<SceneDesc> scene = load(file_with(kind, std::string(word.name) + " " + value));
    if (!scene) return scene.error().line();
    return scene->warnings.empty() ? "nothing" : scene->warnings.front();
  };
  const std::map<std::string_view, std::vector<std::string>> beyond = {
      {"above 0", {"0", "-1"}},
      {"not negative", {"-1"}},
      {"0 <= min <= max", {"[-1 2]", "[2 1]"}},
  };
  /// Of "from 1 to 4096", and of a tuple of such numbers: one of them is beyond.
  const auto outside = [&](const Word& word) -> std::vector<std::string> {
    int least = 0, most = 0;
    if (std::sscanf(std::string(word.limits).c_str(), "from %d to %d", &least, &most) != 2)
      return beyond.contains(word.limits) ? beyond.at(word.limits) : std::vector<std::string>();
    if (word.type == "tuple") {
      const std::ptrdiff_t others = std::ranges::count(word.form, ' ');
      return {fmt::format("[{}{}]", repeated(fmt::format("{} ", least), others), most + 1),
              fmt::format("[{}{}]", least - 1, repeated(fmt::format(" {}", most), others))};
    }
    return {std::to_string(least - 1), std::to_string(most + 1), "-1"};
  };
  int told = 0;
  for (const auto& [kind, word] : words_that_are_read()) {
    if (word->limits.empty()) continue;
    ASSERT_FALSE(outside(*word).empty()) << word->limits;
    for (const std::string& value : outside(*word)) {
      EXPECT_THAT(line_of(*kind, *word, value), HasSubstr('"' + std::string(word->name) + '"')) << value;
      ++told;
    }
  }
  EXPECT_GE(told, 15);
}

TEST(Kinds, every_word_is_known_where_it_belongs_and_nowhere_else) {
  for (const Kind& kind : kinds()) {
    for (const Word& word : kind.words) EXPECT_EQ(find_word(kind, word.name), &word);
  }
  const Kind &position = *find_kind("position"), &fiducial = *find_kind("fiducial");
  EXPECT_NE(find_word(position, "mass"), nullptr) << "every model has it";
  EXPECT_EQ(find_word(fiducial, "drive"), nullptr);
  EXPECT_EQ(find_word(*find_kind("sensor"), "mass"), nullptr);
}

TEST(Kinds, are_found_by_their_names) {
  EXPECT_EQ(find_model_type("ranger")->kind, ModelKind::kRanger);
  EXPECT_EQ(find_model_type("sensor"), nullptr) << "no model";
  EXPECT_EQ(find_entity("sensor")->inside, "ranger");
  EXPECT_EQ(find_entity("world"), nullptr) << "the file itself";
  EXPECT_EQ(find_kind("world"), &world_kind());
  EXPECT_EQ(find_kind("laser"), nullptr);
}

TEST(Kinds, parts_belong_into_models_of_their_type) {
  const Kind &block = *find_kind("block"), &sensor = *find_kind("sensor");
  EXPECT_TRUE(is_part_of(block, *find_kind("gripper")));
  EXPECT_TRUE(is_part_of(sensor, *find_kind("ranger")));
  EXPECT_FALSE(is_part_of(sensor, *find_kind("position")));
  EXPECT_FALSE(is_part_of(*find_kind("position"), *find_kind("model"))) << "a model of its own";
}

}  // namespace
}  // namespace playhouse::scene
