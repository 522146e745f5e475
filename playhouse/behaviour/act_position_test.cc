// Limits of a robot on the way to a goal, which clients set.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "playhouse/behaviour/generated/acts.h"
#include "playhouse/world/changes/journal.h"

namespace playhouse::behaviour {
namespace {

namespace changes = world::changes;
using geom::Twist;

/// A robot that goes where it is told, in a world of ten ticks a second.
class Way : public ::testing::Test {
 protected:
  Way() { world::subscribe(world, {0}); }

  double speed_after(int ticks) {
    for (int k = 0; k < ticks; ++k) {
      phase_->act(world, workers_);
      world.positions.X_OM[{0}].x += 0.1 * world.positions.velocity[{0}].x;
      world.positions.X_OM[{0}].a += 0.1 * world.positions.velocity[{0}].a;
    }
    return world.positions.velocity[{0}].x;
  }
  double turn_after(int ticks) { return speed_after(ticks), world.positions.velocity[{0}].a; }
  bool limit(const Twist& speed, const Twist& acceleration) {
    return journal.apply(changes::LimitWay{world.id({0}), speed.x, speed.a, acceleration.x, acceleration.a});
  }
  void go_to(const geom::Pose& goal) { journal.apply(changes::DriveTo{world.id({0}), goal}); }

 private:
  static scene::SceneDesc make_scene() {
    scene::SceneDesc scene;
    scene::ModelDesc& robot = scene.models.emplace_back();
    robot.kind = scene::ModelKind::kPosition;
    robot.position.emplace();
    return scene;
  }

  const scene::SceneDesc scene_ = make_scene();
  world::Workers workers_{1};
  std::unique_ptr<ActPhase> phase_ = make_position_act();

 public:
  world::World world{scene_, 1};
  world::Journal journal{world};
};

TEST_F(Way, has_speeds_of_its_own_or_those_that_are_set) {
  go_to({10, 0, 0, 0});
  EXPECT_EQ(speed_after(1), 0.4);
  EXPECT_TRUE(limit({0.1, 0, 0, 0}, {}));
  EXPECT_EQ(speed_after(1), 0.1);
  EXPECT_TRUE(limit({0.8, 0, 0, 0.25}, {}));
  EXPECT_EQ(speed_after(1), 0.8);
  go_to({-10, 0, 0, 0});
  EXPECT_EQ(turn_after(1), 0.25);
  EXPECT_TRUE(limit({7, 0, 0, 0}, {}));
  go_to({10, 0, 0, 0});
  world.positions.X_OM[{0}].a = 0;
  EXPECT_EQ(speed_after(1), 1) << "its velocity_bounds hold in any case";
}

TEST_F(Way, speeds_up_as_fast_as_is_set_and_brakes_at_once) {
  EXPECT_TRUE(limit({}, {0.5, 0, 0, 1}));
  go_to({10, 0, 0, 0});
  EXPECT_NEAR(speed_after(1), 0.05, 1e-12);
  EXPECT_NEAR(speed_after(1), 0.1, 1e-12);
  EXPECT_NEAR(speed_after(10), 0.4, 1e-12);
  go_to({world.positions.X_OM[{0}].x + 0.1, 0, 0, 0});
  EXPECT_NEAR(speed_after(1), 0.1, 1e-9);
  go_to({-10, 0, 0, 0});
  EXPECT_NEAR(std::fabs(turn_after(1)), 0.1, 1e-12);
}

TEST_F(Way, has_no_limits_that_are_none) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(limit({-1, 0, 0, 0}, {}));
  EXPECT_FALSE(limit({nan, 0, 0, 0}, {}));
  EXPECT_FALSE(limit({0, 0, 0, infinity}, {}));
  EXPECT_FALSE(limit({}, {0, 0, 0, -1}));
  EXPECT_FALSE(limit({}, {nan, 0, 0, 0}));
  EXPECT_TRUE(journal.entries().empty());
}

/// Saved runs and recordings of before have hashes of worlds without these columns.
TEST_F(Way, limits_are_part_of_the_hash_only_while_they_are_set) {
  const std::uint64_t before = world.hash();
  EXPECT_TRUE(limit({0.5, 0, 0, 0}, {}));
  const std::uint64_t slow = world.hash();
  EXPECT_NE(slow, before);
  EXPECT_TRUE(limit({}, {0.5, 0, 0, 0}));
  EXPECT_NE(world.hash(), before);
  EXPECT_NE(world.hash(), slow) << "another limit of the same value";
  EXPECT_TRUE(limit({}, {}));
  EXPECT_EQ(world.hash(), before);
}

}  // namespace
}  // namespace playhouse::behaviour
