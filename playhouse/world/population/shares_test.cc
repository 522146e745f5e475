// Shares of peers in what may be brought: counted by hand. Out of scope here: the budget of all
// (population_test.cc), who a peer is (net/http_test.cc).

#include "playhouse/world/population/shares.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/world/population/population.h"

namespace playhouse::world {
namespace {

constexpr std::uint32_t kTree = 1;  // two models: a robot with a ranger

scene::SceneDesc scene_of_shares(std::size_t sensors, std::uint32_t samples) {
  scene::SceneDesc scene;
  for (const auto& [name, kind, parent] :
       {std::tuple("wall", scene::ModelKind::kPlain, -1), std::tuple("r", scene::ModelKind::kPosition, -1),
        std::tuple("r.ranger:0", scene::ModelKind::kRanger, 1)}) {
    scene::ModelDesc desc;
    desc.name = desc.alias = name;
    desc.kind = kind;
    desc.parent = parent;
    scene.models.push_back(desc);
  }
  scene.models[1].position.emplace();
  scene.models[2].sensors.resize(sensors);
  for (scene::RangerSensorDesc& sensor : scene.models[2].sensors) sensor.samples = samples;
  return scene;
}

class SharesTest : public ::testing::Test {
 protected:
  void open(std::size_t sensors = 1, std::uint32_t samples = 1) {
    scene_ = scene_of_shares(sensors, samples);
    world_ = std::make_unique<World>(scene_, 1);
  }
  Result<void> check(const std::string& peer, std::size_t trees = 1) {
    return shares_.check(*world_, peer, std::vector<std::uint32_t>(trees, kTree));
  }
  bool bring(const std::string& peer) {
    if (!check(peer)) return false;
    const Result<ModelId> came = spawn(*world_, kTree, {}, "n" + std::to_string(number_++));
    EXPECT_TRUE(came);
    shares_.add(*world_, peer, *came);
    brought_.push_back(*came);
    return true;
  }
  std::size_t bring_all(const std::string& peer) {
    std::size_t count = 0;
    while (count <= limits::kBroughtModels && bring(peer)) ++count;
    return count;
  }

  scene::SceneDesc scene_;
  std::unique_ptr<World> world_;
  Shares shares_;
  std::vector<ModelId> brought_;
  int number_ = 0;
};

TEST_F(SharesTest, of_a_peer_are_so_many_models_and_others_have_theirs) {
  open();
  EXPECT_EQ(bring_all("a"), limits::kBroughtByOneModels / 2);
  EXPECT_EQ(check("a").error().text,
            "your share of the run is full: you brought 4096 models with 2048 sensors and 2048 beams");
  EXPECT_EQ(bring_all("b"), limits::kBroughtByOneModels / 2);
  EXPECT_EQ(bring_all("c"), limits::kBroughtByOneModels / 2);
  EXPECT_EQ(bring_all("d"), limits::kBroughtByOneModels / 2);
  EXPECT_EQ(check("e").error().text, "the run is full: 16384 models with 8192 sensors and 8192 beams came");
}

/// A tree that began within the share ended beyond it.
TEST_F(SharesTest, have_room_for_whole_trees_alone) {
  open();
  ASSERT_TRUE(bring("a"));
  EXPECT_TRUE(check("a", limits::kBroughtByOneModels / 2 - 1));
  EXPECT_EQ(check("a", limits::kBroughtByOneModels / 2).error().text,
            "your share of the run is full: you brought 2 models with 1 sensors and 1 beams");
}

TEST_F(SharesTest, are_bounded_in_sensors_and_in_beams) {
  open(64);
  EXPECT_EQ(bring_all("a"), limits::kBroughtByOneSensors / 64);
  open(64, 1024);
  shares_ = {};
  EXPECT_EQ(bring_all("a"), limits::kBroughtByOneBeams / (64 * 1024));
}

TEST_F(SharesTest, count_what_exists_whoever_removed_the_rest) {
  open();
  bring_all("a");
  ASSERT_TRUE(despawn(*world_, std::vector{brought_[7], brought_[100], brought_[2000]}));
  EXPECT_EQ(bring_all("a"), 3u);
  const std::vector<ModelId> all = brought_;
  for (const ModelId each : all)
    if (world_->row(each)) ASSERT_TRUE(despawn(*world_, each));
  EXPECT_EQ(bring_all("a"), limits::kBroughtByOneModels / 2);
}

TEST_F(SharesTest, come_no_faster_than_one_may_bring_and_go_on_with_the_time_of_the_run) {
  open();
  const auto bring_and_remove = [this](const std::string& peer) {
    std::size_t count = 0;
    for (; count < 20000 && bring(peer); ++count) EXPECT_TRUE(despawn(*world_, brought_.back()));
    return count;
  };
  EXPECT_EQ(bring_and_remove("a"), 8192u) << "16384 models at once";
  EXPECT_EQ(check("a").error().text,
            "you bring too much at a time: 1000 models a second of the run, after 16384 at once");
  EXPECT_TRUE(bring("b"));
  const double before = world_->time();
  while (world_->time() < before + 1) ++world_->tick_;
  EXPECT_EQ(bring_and_remove("a"), 500u);
}

TEST_F(SharesTest, have_nothing_to_do_with_the_drivers_of_the_program) {
  open();
  EXPECT_EQ(bring_all(""), limits::kBroughtModels / 2);
}

}  // namespace
}  // namespace playhouse::world
