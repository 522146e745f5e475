/// Controllers from shared libraries: what reaches them, what they order, and what becomes of bad ones.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "playhouse/base/testing_folder.h"
#include "playhouse/controllers/attach.h"
#include "playhouse/controllers/testing/scenes.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::controllers {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Two robots with a ring of four sensors and the same `ctrl`.
struct Fixture {
  explicit Fixture(const std::string& ctrl, const Libraries& libraries = {.folders = {TEST_LIBRARIES}})
      : scene(testing::robots(2, testing::ring(4), ctrl)), world(scene, 7) {
    const auto attached = attach(world, libraries);
    error = attached ? "" : attached.error().line();
    if (attached) warnings = *attached;
  }
  void tick() {
    testing::measure(world, {1.5f});
    testing::decide(world);
  }

  scene::SceneDesc scene;
  world::World world;
  std::string error;
  std::vector<std::string> warnings;
};

TEST(Loaded, reads_ranges_and_bearings_and_drives) {
  Fixture f("probe drive");
  ASSERT_EQ(f.error, "");
  f.tick();
  EXPECT_EQ(f.world.positions.command[{1}], (geom::Twist{1.5, 0, 0, 0}));
}

TEST(Loaded, sends_a_robot_to_a_pose) {
  Fixture f("probe go");
  f.tick();
  EXPECT_EQ(f.world.positions.mode[{0}], world::ControlMode::kPosition);
  EXPECT_EQ(f.world.positions.goal[{0}], (geom::Pose{1, 2, 0, 3}));
}

TEST(Loaded, knows_the_time_and_whether_a_scan_is_new) {
  Fixture f("probe speak");
  f.tick();
  EXPECT_EQ(f.world.models.say[{0}], "t=0.100000 fresh");
  ++f.world.tick_;
  testing::decide(f.world);
  EXPECT_EQ(f.world.models.say[{0}], "t=0.200000");
}

TEST(Loaded, carries_flags) {
  Fixture f("probe carry");
  f.tick();
  f.tick();
  EXPECT_EQ(f.world.models.flags[{0}], 2);
}

TEST(Loaded, gives_flags_and_texts_when_all_have_decided) {
  Fixture carries("probe carry"), speaks("probe speak");
  for (world::World* world : {&carries.world, &speaks.world})
    world->deciders[0]->decide(*world, 0, world->deciders[0]->size());
  EXPECT_EQ(carries.world.models.flags[{0}], 0);
  EXPECT_EQ(speaks.world.models.say[{0}], "");
  carries.world.deciders[0]->deliver(carries.world);
  speaks.world.deciders[0]->deliver(speaks.world);
  EXPECT_EQ(carries.world.models.flags[{0}], 1);
  EXPECT_EQ(speaks.world.models.say[{0}], "t=0.000000");
}

TEST(Loaded, leaves_flags_and_texts_alone_that_others_give_its_robot) {
  Fixture f("probe drive");
  world::add_flags(f.world, {0}, 3);
  world::set_say(f.world, {0}, "hello");
  f.tick();
  EXPECT_EQ(f.world.models.flags[{0}], 3);
  EXPECT_EQ(f.world.models.say[{0}], "hello");
}

TEST(Loaded, draws_random_numbers_that_differ_by_robot_and_tick_and_repeat_with_the_seed) {
  Fixture f("probe random"), again("probe random");
  f.tick();
  again.tick();
  const double first = f.world.positions.command[{0}].x;
  EXPECT_EQ(first, again.world.positions.command[{0}].x);
  EXPECT_NE(first, f.world.positions.command[{1}].x);
  f.tick();
  EXPECT_NE(first, f.world.positions.command[{0}].x);
}

TEST(Loaded, wakes_only_the_rangers_that_the_controller_uses) {
  Fixture all("probe"), deaf("probe deaf");
  EXPECT_EQ(all.world.models.subscribers[{1}], 1u);
  EXPECT_EQ(deaf.world.models.subscribers[{1}], 0u);
  EXPECT_EQ(deaf.world.models.subscribers[{0}], 1u);
}

TEST(Loaded, shows_nothing_of_what_a_ranger_that_is_switched_off_measures_for_others) {
  Fixture watched("probe deaf"), alone("probe deaf");
  world::subscribe(watched.world, {1});
  watched.tick();
  alone.tick();
  watched.world.sensors.ranges[{0}] += 1;
  EXPECT_EQ(watched.world.models.say[{0}], "0");
  EXPECT_EQ(watched.world.hash(), alone.world.hash());
}

TEST(Loaded, ends_a_controller_that_throws_and_stops_its_robot) {
  for (const char* ctrl : {"probe throw", "probe throw_int", "probe nan"}) {
    Fixture f(ctrl);
    ASSERT_EQ(f.error, "");
    f.world.positions.command[{0}] = {0.3, 0, 0, 0};
    const std::uint64_t before = f.world.hash();
    f.tick();
    EXPECT_EQ(f.world.positions.command[{0}], geom::Twist{}) << ctrl;
    f.world.positions.command[{0}] = {0.3, 0, 0, 0};
    f.tick();
    EXPECT_EQ(f.world.positions.command[{0}].x, 0.3) << ctrl << " is not called again";
    EXPECT_NE(before, f.world.hash());
  }
}

TEST(Loaded, refuses_a_robot_with_the_text_of_the_controller) {
  EXPECT_EQ(Fixture("probe refuse").error,
            "test.world:1: controller \"probe\" of \"r0\": wants another robot");
}

/// What the log says during `act`.
template <typename Act>
std::string logged(const Act& act) {
  std::ostringstream text;
  const auto before = spdlog::default_logger();
  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_st>(text)));
  act();
  spdlog::set_default_logger(before);
  return text.str();
}

TEST(Loaded, tells_what_was_thrown_in_one_line) {
  Fixture f("probe throw_forging");
  ASSERT_EQ(f.error, "");
  const std::string log = logged([&] { f.tick(); });
  EXPECT_EQ(std::ranges::count(log, '\n'), 2) << "one line for each of the two robots:\n" << log;
  EXPECT_THAT(log, HasSubstr("controller \"probe\" of \"r1\" ended: lost\\x0a[error] a forged line\n"));
  EXPECT_THAT(Fixture("probe refuse_forging").error, EndsWith(": wants\\x0a[error] a forged line"));
}

TEST(Loaded, that_cannot_remember_is_ended_with_one_line_and_the_state_is_loaded) {
  Fixture f("probe forget");
  f.tick();
  EXPECT_EQ(f.world.positions.command[{1}].x, 0.5);
  std::vector<std::byte> state;
  ASSERT_TRUE(world::save_state(f.world, state).ok());
  const std::string log = logged([&] { EXPECT_TRUE(world::load_state(f.world, state).ok()); });
  EXPECT_EQ(std::ranges::count(log, '\n'), 2) << "one line for each of the two robots:\n" << log;
  EXPECT_THAT(log, HasSubstr("controller \"probe\" of \"r1\" ended: remembers nothing\n"));
  f.tick();
  EXPECT_EQ(f.world.positions.command[{1}], geom::Twist{}) << "it is not called again";
}

TEST(Library, of_another_version_is_refused) {
  EXPECT_THAT(Fixture("old").error, AllOf(StartsWith("test.world:1: controller \"old\": "),
                                          HasSubstr("version 999"), EndsWith("build it again")));
}

TEST(Library, whose_controller_can_not_be_made_is_refused) {
  EXPECT_THAT(Fixture("broken").error, EndsWith("has no batteries"));
}

TEST(Library, built_for_stage_is_explained) {
  EXPECT_THAT(Fixture("stage_style").error, HasSubstr("built for Stage's library"));
}

TEST(Library, that_is_no_controller_is_refused) {
  EXPECT_THAT(Fixture("stranger").error, HasSubstr("lacks PLAYHOUSE_CONTROLLER"));
}

TEST(Library, that_is_no_library_is_refused) {
  const TestFolder folder;
  std::ofstream(folder / "text.so") << "this is no shared library\n";
  const scene::SceneDesc scene = testing::robots(1, testing::ring(4), "text");
  world::World world(scene, 7);
  const auto attached = attach(world, {.folders = {folder.path()}});
  ASSERT_FALSE(attached);
  EXPECT_THAT(attached.error().line(), HasSubstr("can't be loaded"));
}

TEST(Library, names_are_suggested_when_one_is_misspelt) {
  EXPECT_THAT(Fixture("prob").error, EndsWith("no controller \"prob\" (did you mean \"probe\"?)"));
}

TEST(Library, that_is_nowhere_is_told_with_the_places) {
  EXPECT_THAT(Fixture("nowhere").error,
              EndsWith("it is not built in, and \"nowhere.so\" is not in " TEST_LIBRARIES
                       "; if you trust one elsewhere, run with --allow-library FILE.so"));
}

const std::string kProbe = TEST_LIBRARIES "/probe";

TEST(Library, has_a_line_in_the_log_before_it_is_loaded) {
  EXPECT_THAT(logged([] { Fixture("probe"); }),
              HasSubstr("controller \"probe\": loads " TEST_LIBRARIES "/probe.so\n"));
}

TEST(Library, outside_the_folders_is_loaded_only_if_it_is_allowed) {
  const std::filesystem::path elsewhere = std::filesystem::path(TEST_LIBRARIES) / "sub";
  std::filesystem::create_directories(elsewhere);
  for (const std::string& name : {kProbe, std::string("../probe")}) {
    const Fixture refused(name, {.folders = {elsewhere}});
    EXPECT_EQ(refused.error, "test.world:1: controller \"" + name +
                                 "\" is code outside the folders of controllers; if you trust it, run with "
                                 "--allow-library " +
                                 kProbe + ".so");
    EXPECT_TRUE(refused.world.deciders.empty());
    EXPECT_EQ(Fixture(name, {.folders = {elsewhere}, .allowed = {"/none.so", kProbe + ".so"}}).error, "");
  }
  EXPECT_EQ(Fixture("sub/../probe").error, "") << "stays inside";
  EXPECT_EQ(Fixture(kProbe).error, "") << "leads inside";
  EXPECT_EQ(Fixture("../probe", {.folders = {elsewhere, TEST_LIBRARIES}}).error, "") << "into another folder";
  EXPECT_EQ(Fixture("probe.so").error, "") << "as Stage takes it";
  EXPECT_EQ(Fixture("/none/probe").error,
            "test.world:1: no controller \"/none/probe\": there is no file \"/none/probe.so\"");
}

TEST(Library, is_found_and_never_loaded_where_a_file_is_only_checked) {
  const Libraries find{.folders = {TEST_LIBRARIES}, .use = Libraries::LibraryUse::kFind};
  // stranger and broken would fail if they were loaded.
  for (const std::string name : {"probe", "stranger", "broken"}) {
    const Fixture f(name, find);
    EXPECT_EQ(f.error, "");
    EXPECT_TRUE(f.world.deciders.empty());
    EXPECT_EQ(f.warnings,
              std::vector<std::string>{"test.world:1: controller \"" + name + "\" is " TEST_LIBRARIES "/" +
                                       name + ".so, which is there and not checked: checking loads no code"});
  }
  const Libraries elsewhere{.folders = {"/none"}, .use = Libraries::LibraryUse::kFind};
  EXPECT_THAT(Fixture(kProbe, elsewhere).warnings.at(0),
              EndsWith("; running it takes --allow-library " + kProbe + ".so"));
  EXPECT_THAT(Fixture("prob", find).error, EndsWith("(did you mean \"probe\"?)"));
}

TEST(Library, is_looked_for_beside_the_world_then_in_the_environment_then_with_the_program) {
  setenv("PLAYHOUSE_PATH", "/a:/b", 1);
  setenv("STAGEPATH", ":/c", 1);
  const std::vector<std::filesystem::path> expected{"worlds", "/a", "/b", "/c", "/program"};
  EXPECT_EQ(libraries::library_folders("worlds", "STAGEPATH", "/program"), expected);
  EXPECT_EQ(libraries::library_folders("", "STAGEPATH", "/program"),
            (std::vector<std::filesystem::path>{"/a", "/b", "/c", "/program"}));
  unsetenv("PLAYHOUSE_PATH");
  unsetenv("STAGEPATH");
}

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(std::string(PLAYHOUSE_SOURCE_DIR) + "/" + path).rdbuf();
  return text.str();
}

TEST(Documentation, shows_the_example_as_it_is) {
  const std::string example = text_of("examples/controller/shy.cc");
  ASSERT_NE(example.find("#include"), std::string::npos);
  EXPECT_THAT(text_of("docs/controllers.md"), HasSubstr(example.substr(example.find("#include"))));
}

}  // namespace
}  // namespace playhouse::controllers
