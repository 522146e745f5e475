/// Trees that are alike are made and kept once; what a file says and what is told of it does not show that.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "playhouse/scene/testing_expanded.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {
namespace {

struct Loaded {
  SceneDesc scene;
  std::vector<std::string> lines;  // errors, or warnings if there is none
};

Loaded load(const std::string& text, const WorldLimits& limits = {}) {
  config::MemoryFiles files(
      {{"w/plan", std::string("P1 2 2 1 0 0 1")}, {"w/part.inc", "model( name \"in\" fooo 1 )"}});
  std::vector<Error> others;
  Result<SceneDesc> scene = load_world_text(text, "w/t.world", files, limits, &others);
  if (scene) return {*scene, scene->warnings};
  Loaded loaded{{}, {scene.error().line()}};
  for (const Error& other : others) loaded.lines.push_back(other.line());
  return loaded;
}

/// Words of an instance, as files have them.
std::string any_words() {
  static const std::vector<std::string> kWords = {
      "name \"a\"",
      "name \"b\"",
      "name \"position:1\"",
      "name \"a.ranger:0\"",
      "name \"c.x\"",
      "name \"/b\"",
      "name []",
      "pose [1 2 3 4]",
      "pose [1 2 0 45 6]",
      "pose [1]",
      "color \"red\"",
      "color \"bleu\"",
      "color \"random\"",
      "color_rgba [0 1 0 1]",
      "fiducial_return 5",
      "fiducial_return \"x\"",
      "say \"hello\"",
      "fooo 1",
      "size [0 1 1]",
      "ctrl \"wander\"",
      "bitmap \"plan\"",
      "bitmap \"none\"",
      "include \"part.inc\"\n",
      "ranger( name \"x\" sensor( ) )",
      "model( name \"/b\" )",
      "model( name \"x\" ctrl \"wander\" )",
      "model( color \"random\" )",
      "model(\n fooo 2 )",
  };
  std::string words;
  for (const auto count = *rc::gen::inRange(0, 4);
       const auto& word : *rc::gen::container<std::vector<std::string>>(static_cast<std::size_t>(count),
                                                                        rc::gen::elementOf(kWords)))
    words += " " + word;
  return words;
}

std::string any_body() {
  static const std::vector<std::string> kParts = {
      "ranger( pose [0.1 0 0 0] sensor( samples 3 ) )",
      "model( name \"x\" model( name \"y\" ) )",
      "model( name \"/b\" model( ) )",
      "model( name \"x\" )",
      "model( color \"random\" )",
      "model( fooo 3 )",
      "model( size [0 1 1] )",
      "block( points 2 point[0] [0 0] point[1] [1 0] )",
      "color \"random\"",
      "name \"a\"",
      "late( )",
      "pose [1 1 1 1]",
  };
  std::string body;
  for (const auto count = *rc::gen::inRange(0, 4);
       const auto& part : *rc::gen::container<std::vector<std::string>>(static_cast<std::size_t>(count),
                                                                        rc::gen::elementOf(kParts)))
    body += " " + part;
  return body;
}

void expect_same(const ModelDesc& a, const ModelDesc& b) {
  RC_ASSERT(a.name == b.name);
  RC_ASSERT(a.alias == b.alias);
  RC_ASSERT(a.type == b.type);
  RC_ASSERT(a.parent == b.parent);
  RC_ASSERT(static_cast<const PlainDesc&>(a) == static_cast<const PlainDesc&>(b));
  RC_ASSERT(static_cast<const KindDescs&>(a) == static_cast<const KindDescs&>(b));
  RC_ASSERT(a.blocks == b.blocks);
  RC_ASSERT(a.bitmaps == b.bitmaps);
  // A part's line is that of the first that is like it, but where it is told to people.
  if (a.parent < 0 || !a.ctrl.empty())
    RC_ASSERT(a.where.file == b.where.file && a.where.line == b.where.line);
}

/// Each tree of the other file is of a word of its own, so nothing repeats there.
RC_GTEST_PROP(Repeats, say_what_they_would_say_word_by_word, ()) {
  const int count = *rc::gen::inRange(1, 12);
  std::string shared = "define robot position (" + any_body() + " )\n";
  for (int k = 0; k < count; ++k) shared += "define w" + std::to_string(k) + " robot ( )\n";
  std::string alone = shared;
  std::vector<std::string> kinds_of_words = {any_words(), any_words(), any_words()};
  for (int k = 0; k < count; ++k) {
    if (*rc::gen::inRange(0, 10) == 0) {
      for (std::string* text : {&shared, &alone})
        *text += "define late model ( mass " + std::to_string(k) + " )\n";
    }
    const std::string words =
        *rc::gen::elementOf(kinds_of_words) + (*rc::gen::inRange(0, 3) == 0 ? "" : "\n");
    shared += "robot(" + words + " )";
    alone += "w" + std::to_string(k) + "(" + words + " )";
    if (*rc::gen::inRange(0, 4) > 0) shared += "\n", alone += "\n";
  }
  const Loaded a = load(shared), b = load(alone);
  RC_ASSERT(a.lines == b.lines);
  const SceneDesc all = expanded(a.scene), each = expanded(b.scene);
  RC_ASSERT(all.models.size() == each.models.size());
  for (std::size_t row = 0; row < all.models.size(); ++row) expect_same(all.models[row], each.models[row]);
  RC_TAG(a.scene.models.size() < b.scene.models.size() ? "shares" : "shares nothing");
}

constexpr const char* kRobot =
    "define eye ranger ( sensor( samples 2 ) )\ndefine robot position ( eye( ) eye( pose [0 0 0 90] ) )\n";

TEST(Repeats, of_a_swarm_share_one_tree_of_descriptions) {
  const SceneDesc scene =
      load(std::string(kRobot) +
           "robot( name \"a\" pose [1 0 0 0] )\nrobot( name \"b\" pose [2 0 0 0] color \"red\" )\n"
           "robot( fiducial_return 3 )\nmodel( name \"box\" )\nrobot( pose [3 0 0 0] mass 5 )\n")
          .scene;
  ASSERT_EQ(scene.trees.size(), 5u);
  EXPECT_EQ(scene.models.size(), 3u + 1u + 3u) << "a heavier robot is another one";
  EXPECT_EQ(scene.trees[1].top, 0u);
  EXPECT_EQ(scene.trees[1].name, "b");
  EXPECT_EQ(scene.trees[1].X_WM.x, 2);
  EXPECT_EQ(scene.trees[1].color, (Color{1, 0, 0, 1}));
  EXPECT_EQ(scene.trees[1].where.line, 4u);
  EXPECT_EQ(scene.trees[2].top, 0u);
  EXPECT_EQ(scene.trees[2].name, "position:2");
  EXPECT_EQ(scene.trees[2].fiducial_return, 3);
  EXPECT_EQ(scene.trees[4].top, 4u);
}

TEST(Repeats, are_called_by_the_word_that_made_them) {
  const SceneDesc scene = load(std::string(kRobot) + "robot( name \"a\" )\nmodel( name \"box\" )\n").scene;
  EXPECT_EQ(scene.models[scene.trees[0].top].prototype, "robot");
  EXPECT_EQ(scene.models[scene.trees[1].top].prototype, "box");
}

TEST(Repeats, with_parts_of_their_own_share_too) {
  std::string text(kRobot);
  for (int k = 0; k < 9; ++k)
    text += "robot( pose [" + std::to_string(k) + " 0 0 0] ctrl \"wander\"\n eye( ) )\n";
  EXPECT_EQ(load(text).scene.models.size(), 4u);
}

TEST(Repeats, with_a_fault_each_are_told_of_each_and_are_one_all_the_same) {
  std::string text(kRobot);
  for (int k = 0; k < 9; ++k) text += "robot( fooo 1 )\n";
  const Loaded loaded = load(text);
  EXPECT_EQ(loaded.lines.size(), 9u);
  EXPECT_EQ(loaded.scene.models.size(), 3u);
}

TEST(Repeats, count_for_every_limit) {
  std::string text(kRobot);
  for (int k = 0; k < 4; ++k) text += "robot( )\n";
  EXPECT_TRUE(load(text, {.models = 12, .descriptions = 3}).lines.empty());
  EXPECT_THAT(load(text, {.models = 11}).lines,
              testing::ElementsAre("w/t.world:6: the world holds more than 11 models"));
  EXPECT_THAT(load(text, {.sensors = 7}).lines,
              testing::ElementsAre("w/t.world:6: the world holds more than 7 sensors"));
  EXPECT_THAT(load(text, {.descriptions = 2}).lines,
              testing::ElementsAre("w/t.world:2: the world holds more than 2 models that are like no other"));
}

}  // namespace
}  // namespace playhouse::scene
