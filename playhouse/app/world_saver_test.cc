#include "playhouse/app/world_saver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "playhouse/app/whole_file.h"
#include "playhouse/base/testing_folder.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/population/population.h"

namespace playhouse::app {
namespace {

using testing::HasSubstr;
using testing::Not;

class WorldSaverTest : public testing::Test {
 protected:
  std::string text_of(const std::string& file) {
    const Result<std::string> text = read_file(folder_ / file);
    return text ? *text : "";
  }

  const TestFolder folder_;
  config::MemoryFiles none_{{}};
  scene::SceneDesc scene_ =
      *scene::load_world_text("model ( name \"a\" )\nmodel ( name \"b\" )", "t.world", none_);
  world::World world_{scene_, 1};
};

TEST_F(WorldSaverTest, a_file_has_the_world_of_the_moment_at_which_it_was_saved) {
  WorldSaver saver;
  saver.save(world_, folder_ / "one.world");
  ASSERT_TRUE(world::despawn(world_, world_.id(world_.find("a"))).ok());
  saver.save(world_, folder_ / "two.world");
  EXPECT_TRUE(saver.finish());
  EXPECT_THAT(text_of("one.world"), HasSubstr("\"a\""));
  EXPECT_THAT(text_of("two.world"), Not(HasSubstr("\"a\"")));
  EXPECT_THAT(text_of("two.world"), HasSubstr("\"b\""));
}

TEST_F(WorldSaverTest, the_newest_of_many_into_one_file_is_in_it) {
  WorldSaver saver;
  for (int i = 0; i < 50; ++i) {
    world::set_pose(world_, world_.find("a"), {static_cast<double>(i), 0, 0, 0});
    saver.save(world_, folder_ / "w.world");
  }
  EXPECT_TRUE(saver.finish());
  EXPECT_THAT(text_of("w.world"), HasSubstr("name \"a\" pose [49 0 0 0]"));
  saver.save(world_, folder_ / "later.world");
  EXPECT_TRUE(saver.finish()) << "it goes on after a pause";
  EXPECT_THAT(text_of("later.world"), HasSubstr("[49 0 0 0]"));
}

TEST_F(WorldSaverTest, what_cannot_be_written_is_told_and_leaves_the_old_file) {
  WorldSaver saver;
  saver.save(world_, folder_ / "none/w.world");
  EXPECT_FALSE(saver.finish());
  std::filesystem::create_directory(folder_ / "w.world.part");
  std::ofstream(folder_ / "w.world") << "good";
  saver.save(world_, folder_ / "w.world");
  EXPECT_FALSE(saver.finish());
  EXPECT_EQ(text_of("w.world"), "good");
}

}  // namespace
}  // namespace playhouse::app
