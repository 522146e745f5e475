#include "playhouse/bridge/simulated/directory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "playhouse/base/limits.h"
#include "playhouse/run/testing/still_engine.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// `count` models; each name ends in `ending`.
scene::SceneDesc crowd(std::size_t count, const std::string& ending) {
  scene::SceneDesc scene;
  scene.models.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    scene.models[i].name = scene.models[i].alias = std::to_string(i) + ending;
  return scene;
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

TEST(ModelList, names_cannot_break_its_lines) {
  const scene::SceneDesc scene = crowd(1, "\ta\\b\nc");
  const world::World world(scene, 1);
  EXPECT_THAT(list_models(world, {}, 0).text, HasSubstr("\t0\\ta\\\\b\\nc\t"));
  EXPECT_EQ(lines(list_models(world, {}, 0).text), 1u);
}

TEST(ModelList, goes_on_where_an_answer_has_no_room_for_more_models) {
  const scene::SceneDesc scene = crowd(limits::kListedModels + 1, "");
  const world::World world(scene, 1);
  const ModelList first = list_models(world, {}, 0);
  EXPECT_EQ(first.next, limits::kListedModels);
  EXPECT_EQ(lines(first.text), limits::kListedModels);
  const ModelList rest = list_models(world, {}, first.next);
  EXPECT_EQ(rest.next, 0u);
  EXPECT_EQ(lines(rest.text), 1u);
  EXPECT_EQ(rest.text.find(std::to_string(limits::kListedModels)), 0u);
}

TEST(ModelList, goes_on_where_long_names_fill_an_answer) {
  const scene::SceneDesc scene = crowd(3, std::string(limits::kModelListBytes * 3 / 4, 'x'));
  const world::World world(scene, 1);
  for (std::uint32_t row = 0; row < 3; ++row) {
    const ModelList list = list_models(world, {}, row);
    EXPECT_EQ(lines(list.text), 1u);
    EXPECT_EQ(list.next, (row + 1) % 3);
  }
}

TEST(Directory, knows_no_model_of_a_device_of_the_whole_world) {
  Directory directory;
  directory.add({}, {6665, 31, 0});
  EXPECT_FALSE(directory.model_of({6665, 31, 0}));
  directory.add({2}, {6665, 4, 0});
  EXPECT_EQ(directory.model_of({6665, 4, 0}), world::ModelId{2});
  EXPECT_TRUE(directory.devices_of({0}).empty());
}

TEST(Directory, forgets_a_device_that_goes_and_keeps_nothing_of_its_model) {
  Directory directory;
  directory.add({2}, {6665, 4, 0});
  directory.add({2}, {6665, 6, 0});
  EXPECT_THAT(device_names(directory, {2}, 6666), ElementsAre("6665:position2d:0", "6665:laser:0"));
  directory.remove({6665, 4, 0});
  directory.remove({6665, 4, 0});
  EXPECT_THAT(device_names(directory, {2}, 6665), ElementsAre("laser:0"));
  directory.remove({6665, 6, 0});
  EXPECT_EQ(directory.size(), 0u);
  EXPECT_TRUE(directory.devices_of({2}).empty());
}

}  // namespace
}  // namespace playhouse::drivers
