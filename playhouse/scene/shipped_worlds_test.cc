#include "playhouse/config/shipped_worlds.h"

#include <gtest/gtest.h>

#include <fstream>

#include "playhouse/base/testing_folder.h"
#include "playhouse/config/cfg.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {
namespace {

void make_worlds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "pioneer.inc") << "define pioneer2dx position( )";
}

TEST(ShippedWorlds, are_those_of_the_installation_then_those_of_the_source_tree) {
  const TestFolder own;
  const std::filesystem::path program = own.path() / "build" / "bin";
  EXPECT_EQ(config::shipped_worlds(program), "");
  make_worlds(own.path() / "worlds");
  EXPECT_EQ(config::shipped_worlds(program), own / "worlds/");
  make_worlds(own.path() / "build" / "share" / "playhouse" / "worlds");
  EXPECT_EQ(config::shipped_worlds(program), own / "build/share/playhouse/worlds/");
  EXPECT_EQ(config::shipped_worlds(""), "");
}

TEST(ShippedWorlds, are_suggested_for_a_missing_file_of_the_same_name) {
  const std::string worlds = std::string(PLAYHOUSE_SOURCE_DIR) + "/worlds/";
  const std::string missing = ": cannot be opened: no such file";
  EXPECT_EQ(load_world("nowhere/simple.world").error().line(),
            "nowhere/simple.world" + missing + " (did you mean \"" + worlds + "simple.world\"?)");
  EXPECT_EQ(config::load_cfg("avoid.cfg").error().line(),
            "avoid.cfg" + missing + " (did you mean \"" + worlds + "avoid.cfg\"?)");
  EXPECT_EQ(load_world("gone.world").error().line(), "gone.world" + missing);
}

}  // namespace
}  // namespace playhouse::scene
