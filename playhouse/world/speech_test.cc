#include "playhouse/world/speech.h"

#include <gtest/gtest.h>

#include "playhouse/base/limits.h"
#include "playhouse/world/saving/state.h"
#include "playhouse/world/world.h"

namespace playhouse::world {
namespace {

using std::string_literals::operator""s;

/// Two boxes, of which one says something that is not a line.
scene::SceneDesc scene_with(const std::string& text) {
  scene::SceneDesc scene;
  scene.models.resize(2);
  scene.models[1].say = text;
  return scene;
}

TEST(Spoken, is_one_line_of_text) {
  EXPECT_EQ(spoken(""), "");
  EXPECT_EQ(spoken("rob\u00f6t \"7\""), "rob\u00f6t \"7\"");
  EXPECT_EQ(spoken("a\0b"s), "a");
  EXPECT_EQ(spoken("a\r\n\tb\x7f"), "a   b ");
  EXPECT_EQ(spoken("\xff\xc3x\xed\xa0\x80"), "??x???");
}

TEST(Spoken, ends_with_a_whole_character) {
  const std::string most(limits::kSayBytes - 1, 'x');
  EXPECT_EQ(spoken(most + "yz"), most + "y");
  EXPECT_EQ(spoken(most + "\u20acz"), most);
}

TEST(Spoken, is_left_as_it_is_by_itself) {
  for (const std::string& text : {"a\0b"s, "\r\x01\xff"s, std::string(2 * limits::kSayBytes, '\xc3')}) {
    EXPECT_FALSE(can_be_said(text));
    EXPECT_TRUE(can_be_said(spoken(text)));
    EXPECT_EQ(spoken(spoken(text)), spoken(text));
  }
}

TEST(Spoken, is_what_a_world_file_and_who_sets_it_have_a_model_say) {
  const scene::SceneDesc scene = scene_with("one\ntwo");
  World world(scene, 1);
  EXPECT_EQ(world.models.say[{1}], "one two");
  set_say(world, {0}, "three\n");
  EXPECT_EQ(world.models.say[{0}], "three ");
}

TEST(Spoken, is_counted_when_it_changes) {
  const scene::SceneDesc scene = scene_with("a");
  World world(scene, 1);
  const std::uint64_t before = world.said();
  set_say(world, {1}, "a");
  EXPECT_EQ(world.said(), before);
  set_say(world, {1}, "b");
  EXPECT_NE(world.said(), before);
}

TEST(Spoken, is_all_that_a_saved_run_can_hold) {
  const scene::SceneDesc scene = scene_with("a");
  for (const std::string& text :
       {"fine"s, "a\0b"s, "\xff"s, "a\nb"s, std::string(limits::kSayBytes + 1, 'x')}) {
    World world(scene, 1), loaded(scene, 1);
    world.models.say.own({0}) = text;
    std::vector<std::byte> bytes;
    ASSERT_TRUE(save_state(world, bytes).ok());
    const std::uint64_t before = loaded.said();
    const Result<void> read = load_state(loaded, bytes);
    EXPECT_EQ(read.ok(), text == "fine");
    if (!read.ok()) EXPECT_EQ(read.error().text, "is damaged: a model says what is not a line of text");
    if (read.ok()) EXPECT_NE(loaded.said(), before);
  }
}

}  // namespace
}  // namespace playhouse::world
