// What models draw from batteries. Charging is tested where there are bodies (stage/energy_test.cc).

#include "playhouse/behaviour/energy.h"

#include <gtest/gtest.h>

#include "playhouse/world/population/population.h"

namespace playhouse::behaviour {
namespace {

constexpr std::uint32_t kRobot = 0, kScanner = 1, kLamp = 2, kTrailer = 3;

/// By rows: 0 a robot of 2 kg with 100 J; 1 its ranger of two sensors; 2 a lamp of 5 W; 3 a model on the
/// robot with 10 J of its own; 4 a blobfinder on that; 5 a loose lamp of 5 W without a battery.
class EnergyTest : public ::testing::Test {
 protected:
  static scene::SceneDesc make_scene() {
    scene::SceneDesc scene;
    scene.interval = 0.1;
    const auto add = [&](scene::ModelKind kind, int parent) -> scene::ModelDesc& {
      scene::ModelDesc& model = scene.models.emplace_back();
      model.name = model.alias = "m" + std::to_string(scene.models.size());
      model.kind = kind;
      model.parent = parent;
      return model;
    };
    scene::ModelDesc& robot = add(scene::ModelKind::kPosition, -1);
    robot.position.emplace();
    robot.mass = 2;
    robot.watts = 1000;  // its kind says what it draws
    robot.joules = 100;
    add(scene::ModelKind::kRanger, kRobot).sensors.resize(2);
    add(scene::ModelKind::kPlain, kRobot).watts = 5;
    add(scene::ModelKind::kPlain, kRobot).joules = 10;
    add(scene::ModelKind::kBlobfinder, kTrailer).blobfinder.emplace();
    scene::ModelDesc& loose = add(scene::ModelKind::kPlain, -1);
    loose.watts = 5;
    loose.gripper_return = true;
    return scene;
  }

  void tick() { energy_.drain(world_, workers_); }
  void subscribe(std::uint32_t model) { world::subscribe(world_, {model}); }

  const scene::SceneDesc scene_ = make_scene();
  world::World world_{scene_, 1};
  const world::Packs& packs_ = world_.packs;
  world::Workers workers_{1};
  Energy energy_;
};

TEST_F(EnergyTest, flows_to_models_that_somebody_subscribed) {
  ASSERT_EQ(packs_.size(), 2u);
  tick();
  EXPECT_EQ(packs_.stored, (std::vector<double>{100, 10}));
  subscribe(kScanner);
  tick();
  EXPECT_DOUBLE_EQ(packs_.stored[{0}], 100 - 0.04) << "0.2 W for each of two sensors";
  subscribe(kLamp);
  tick();
  EXPECT_DOUBLE_EQ(packs_.dissipated[{0}], 0.04 + 0.54);
  EXPECT_DOUBLE_EQ(packs_.stored[{0}] + packs_.dissipated[{0}], 100);
  EXPECT_DOUBLE_EQ(packs_.watts[{0}], 5.4);
  EXPECT_DOUBLE_EQ(packs_.stored[{1}], 10);
}

TEST_F(EnergyTest, is_not_drawn_for_who_only_watches) {
  world::watch(world_, {kScanner});
  tick();
  EXPECT_EQ(packs_.watts[{0}], 0);
  subscribe(kScanner);
  tick();
  EXPECT_DOUBLE_EQ(packs_.watts[{0}], 0.4) << "whoever watches as well";
  world::unsubscribe(world_, {kScanner});
  tick();
  EXPECT_EQ(packs_.watts[{0}], 0);
  world::unwatch(world_, {kScanner});
  EXPECT_EQ(world_.models.subscribers[{kScanner}], 0u);
}

TEST_F(EnergyTest, is_drawn_by_a_robot_as_fast_as_it_drives) {
  subscribe(kRobot);
  tick();
  EXPECT_DOUBLE_EQ(packs_.watts[{0}], 1) << "at rest, whatever its words say";
  world_.positions.velocity[{0}] = {0.5, -0.25, 0, -0.25};
  tick();
  EXPECT_DOUBLE_EQ(packs_.watts[{0}], 1 + 10 * 2 * 1.0);
}

TEST_F(EnergyTest, comes_from_the_nearest_battery_around) {
  subscribe(4);
  tick();
  EXPECT_DOUBLE_EQ(packs_.watts[{1}], 2);
  EXPECT_EQ(packs_.watts[{0}], 0);
}

TEST_F(EnergyTest, of_an_empty_battery_is_not_drawn) {
  subscribe(4);
  for (int i = 0; i < 60; ++i) tick();
  EXPECT_EQ(packs_.stored[{1}], 0);
  EXPECT_NEAR(packs_.dissipated[{1}], 10, 1e-9);
  EXPECT_EQ(packs_.watts[{1}], 0);
}

TEST_F(EnergyTest, below_nothing_never_ends) {
  world_.packs.stored[{1}] = -1;
  subscribe(4);
  for (int i = 0; i < 60; ++i) tick();
  EXPECT_EQ(packs_.stored[{1}], -1);
  EXPECT_NEAR(packs_.dissipated[{1}], 12, 1e-9);
}

TEST_F(EnergyTest, follows_models_that_become_parts_of_others) {
  constexpr std::uint32_t kLoose = 5;
  subscribe(kLoose);
  tick();
  EXPECT_EQ(packs_.watts[{0}], 0);
  ASSERT_TRUE(world::attach(world_, {kLoose}, {kRobot}, {}));
  tick();
  EXPECT_DOUBLE_EQ(packs_.watts[{0}], 5);
  ASSERT_TRUE(world::detach(world_, {kLoose}));
  tick();
  EXPECT_EQ(packs_.watts[{0}], 0);
}

TEST_F(EnergyTest, of_robots_that_come_and_go_stays_with_them) {
  subscribe(kRobot);
  tick();
  const world::ModelId another = *world::spawn(world_, kRobot, {});
  tick();
  ASSERT_EQ(packs_.size(), 4u);
  EXPECT_DOUBLE_EQ(packs_.stored[{2}], 100);
  EXPECT_DOUBLE_EQ(packs_.stored[{0}], 99.8);
  world::subscribe(world_, world_.row(another));
  ASSERT_TRUE(world::despawn(world_, {kRobot}));
  tick();
  ASSERT_EQ(packs_.size(), 2u);
  EXPECT_DOUBLE_EQ(packs_.stored[{0}], 99.9);
  EXPECT_EQ(packs_.model[{0}], world_.row(another));
  world::return_to_start(world_);
  EXPECT_EQ(packs_.stored, (std::vector<double>{100, 10}));
}

}  // namespace
}  // namespace playhouse::behaviour
