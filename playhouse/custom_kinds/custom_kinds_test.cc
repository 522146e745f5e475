/// From the name of a library in a world file to the code of custom models, and what is told of bad ones.

#include "playhouse/custom_kinds/custom_kinds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "playhouse/base/testing_folder.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::custom_kinds {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A world with two custom models of this `library`.
struct Fixture {
  explicit Fixture(const std::string& library,
                   const libraries::Libraries& libraries = {.folders = {TEST_LIBRARIES}}) {
    config::MemoryFiles none({});
    auto loaded = scene::load_world_text(
        "define probe custom( library \"" + library + "\" )\nprobe()\nprobe()\nmodel()", "test.world", none);
    EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().line());
    scene = std::move(*loaded);
    world = std::make_unique<world::World>(scene, 7);
    const auto attached = attach_custom_kinds(*world, libraries);
    error = attached ? "" : attached.error().line();
    if (attached) warnings = *attached;
  }

  scene::SceneDesc scene;
  std::unique_ptr<world::World> world;
  std::string error;
  std::vector<std::string> warnings;
};

TEST(CustomKinds, begin_with_as_many_numbers_as_they_want) {
  const Fixture f("probe");
  ASSERT_EQ(f.error, "");
  EXPECT_THAT(f.world->customs.state[{1}], ElementsAre(4, 0)) << "it calls the program's functions";
  EXPECT_THAT(f.world->customs.command[{1}], ElementsAre(5));
}

TEST(CustomKinds, get_the_words_behind_the_name) {
  EXPECT_EQ(Fixture("probe two 1 2").error, "");
  EXPECT_EQ(Fixture("probe two 1").error, "test.world:2: custom model \"probe\": two wants two numbers");
}

TEST(CustomKinds, that_refuse_their_arguments_are_told_in_one_line) {
  EXPECT_EQ(Fixture("probe refuse").error,
            "test.world:2: custom model \"probe\": wants another world\\x0a[error] a forged line");
  EXPECT_THAT(Fixture("probe refuse_int").error, EndsWith("threw something that is not a std::exception"));
}

/// The loader maps what a file that was cut off does not have; looking at it would end the program.
TEST(CustomKinds, of_a_library_that_is_cut_off_are_refused) {
  std::ifstream whole(std::filesystem::path(TEST_LIBRARIES) / "probe.so", std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(whole), {});
  ASSERT_GT(bytes.size(), 8000u);
  const TestFolder folder;
  for (int share = 1; share < 100; share += 3) {
    const std::string part = bytes.substr(0, bytes.size() * static_cast<std::size_t>(share) / 100);
    std::ofstream(folder / "part.so", std::ios::binary) << part;
    EXPECT_THAT(Fixture("part", {.folders = {folder.path()}}).error, HasSubstr("its end is missing"))
        << share;
  }
}

TEST(CustomKinds, have_no_more_numbers_than_there_is_room_for) {
  EXPECT_EQ(Fixture("probe many").error,
            "test.world:2: custom model \"probe\": needs more than 4096 commands, state or readings");
}

TEST(CustomKinds, without_a_library_are_refused) {
  EXPECT_EQ(Fixture("").error, "test.world:2: a custom model needs a library \"NAME ARGUMENTS\"");
}

TEST(CustomKinds, whose_library_is_misspelt_or_nowhere_are_told_with_the_nearest_and_the_places) {
  EXPECT_EQ(Fixture("prob").error, "test.world:2: no custom model \"prob\" (did you mean \"probe\"?)");
  EXPECT_EQ(Fixture("nowhere").error,
            "test.world:2: no custom model \"nowhere\": \"nowhere.so\" is not in " TEST_LIBRARIES
            "; if you trust one elsewhere, run with --allow-library FILE.so");
}

TEST(CustomKinds, whose_library_is_none_of_them_are_refused) {
  EXPECT_THAT(Fixture("stranger").error,
              AllOf(StartsWith("test.world:2: custom model \"stranger\": "),
                    EndsWith("is not a custom model: it lacks PLAYHOUSE_CUSTOM_KIND")));
  const TestFolder folder;
  std::ofstream(folder / "text.so") << "this is no shared library\n";
  EXPECT_THAT(Fixture("text", {.folders = {folder.path()}}).error, HasSubstr("can't be loaded"));
}

TEST(CustomKinds, whose_library_is_of_another_program_are_refused) {
  EXPECT_THAT(Fixture("old").error, AllOf(HasSubstr("version 999"), EndsWith("build it again")));
  EXPECT_THAT(Fixture("other").error, EndsWith("build it again with those of this one"));
}

TEST(CustomKinds, that_can_not_be_made_are_refused) {
  EXPECT_THAT(Fixture("broken").error, EndsWith("has no batteries"));
}

TEST(CustomKinds, are_found_and_never_loaded_where_a_file_is_only_checked) {
  const libraries::Libraries find{.folders = {TEST_LIBRARIES},
                                  .use = libraries::Libraries::LibraryUse::kFind};
  const Fixture f("stranger", find);  // which would fail
  EXPECT_EQ(f.error, "");
  EXPECT_THAT(f.warnings,
              ElementsAre("test.world:2: custom model \"stranger\" is " TEST_LIBRARIES
                          "/stranger.so, which is there and not checked: checking loads no code"));
  EXPECT_TRUE(f.world->customs.state[{0}].empty());
}

TEST(CustomKinds, outside_the_folders_are_loaded_only_if_it_is_allowed) {
  const std::string probe = TEST_LIBRARIES "/probe";
  EXPECT_THAT(Fixture(probe, {.folders = {}}).error, HasSubstr("there is no file"));
  const libraries::Libraries elsewhere{.folders = {"/tmp"}};
  EXPECT_THAT(Fixture(probe, elsewhere).error, EndsWith("run with --allow-library " + probe + ".so"));
  EXPECT_EQ(Fixture(probe, {.folders = {"/tmp"}, .allowed = {probe + ".so"}}).error, "");
}

}  // namespace
}  // namespace playhouse::custom_kinds
