// Who uses what, in states that have it and in those that do not.

#include "playhouse/world/saving/whole_state.h"

#include <gtest/gtest.h>

#include <vector>

#include "playhouse/world/changes/journal.h"
#include "playhouse/world/saving/state.h"
#include "playhouse/world/testing_scene.h"

namespace playhouse::world {
namespace {

constexpr ModelId kPair{0}, kOne{1};

scene::SceneDesc two_cameras() {
  scene::SceneDesc scene;
  scene::ModelDesc& pair = scene.models.emplace_back();
  pair.name = pair.alias = "pair";
  pair.kind = scene::ModelKind::kCamera;
  pair.camera.emplace().baseline = 0.1;
  scene::ModelDesc one = pair;
  one.name = one.alias = "one";
  one.camera->baseline = 0;
  scene.models.push_back(one);
  return scene;
}

class StereoUse : public ::testing::Test {
 protected:
  bool open(bool is_open, ModelId camera = kPair) {
    return Journal(world_).apply(changes::OpenStereo{camera, is_open});
  }
  scene::SceneDesc scene_ = two_cameras();
  World world_{scene_, 1};
  std::vector<std::byte> state_;
};

TEST_F(StereoUse, is_of_cameras_with_two_lenses) {
  EXPECT_TRUE(open(true));
  EXPECT_FALSE(open(true, kOne));
}

TEST_F(StereoUse, stays_as_it_is_when_an_earlier_state_is_loaded) {
  ASSERT_TRUE(save_state(world_, state_));
  EXPECT_TRUE(open(true));
  ASSERT_TRUE(load_state(world_, state_));
  EXPECT_TRUE(world_.cameras.stereo_open[{0}]);
  state_.clear();
  ASSERT_TRUE(save_state(world_, state_));
  EXPECT_TRUE(open(false));
  ASSERT_TRUE(load_state(world_, state_));
  EXPECT_FALSE(world_.cameras.stereo_open[{0}]);
}

TEST_F(StereoUse, is_in_a_whole_state) {
  EXPECT_TRUE(open(true));
  ASSERT_TRUE(save_whole(world_, state_));
  EXPECT_TRUE(open(false));
  ASSERT_TRUE(load_whole(world_, state_));
  EXPECT_TRUE(world_.cameras.stereo_open[{0}]);
  state_.pop_back();
  EXPECT_FALSE(load_whole(world_, state_));
}

}  // namespace
}  // namespace playhouse::world
