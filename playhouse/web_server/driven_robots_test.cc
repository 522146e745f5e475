#include "playhouse/web_server/driven_robots.h"

#include <gtest/gtest.h>

#include "playhouse/base/limits.h"
#include "playhouse/net/simulated.h"
#include "playhouse/replicate/small_world.h"
#include "playhouse/world/population/population.h"

namespace playhouse::web_server {
namespace {

using replicate::SmallWorld;

constexpr double kStep = 0.1;    // s, between two renewals
const int kAlice = 0, kBob = 0;  // two drivers: their addresses

/// Carries everything out at once, in the order in which it was asked for.
class AtOnce final : public world::Control {
 public:
  explicit AtOnce(world::World& world) : world_(world) {}
  void pause() override {}
  void resume() override {}
  void step_once() override {}
  void set_speed(double) override {}
  void drive(world::ModelId robot, const geom::Twist& velocity) override {
    world::Journal(world_).apply(world::changes::Drive{robot, velocity});
  }
  bool post(std::function<void(world::Journal&)> change, world::ModelId) override {
    if (full) return false;
    world::Journal journal(world_);
    change(journal);
    return true;
  }
  void record(bool) override {}
  std::shared_ptr<const world::Timeline> timeline() const override {
    return std::make_shared<world::Timeline>();
  }
  void rewind(std::uint64_t) override {}
  std::uint64_t generation(world::ModelId) const override { return 0; }
  bool full = false;

 private:
  world::World& world_;
};

class DrivenRobotsTest : public testing::Test {
 protected:
  void drive(int robot, double forward, const int& driver = kAlice) {
    driven_.drive({SmallWorld::id(robot), forward, 0, 0, 0}, &driver);
  }
  double speed(std::uint32_t robot) const { return small_.world.positions.command[{robot}].x; }
  std::uint32_t open(int robot) const { return small_.world.models.subscribers[{SmallWorld::robot(robot)}]; }

  SmallWorld small_{2};
  net::SimulatedNetwork network_{1};
  AtOnce control_{small_.world};
  DrivenRobots driven_{network_, control_};
};

TEST_F(DrivenRobotsTest, wheels_are_open_while_they_are_driven) {
  drive(1, 0.4);
  EXPECT_EQ(open(1), 1u);
  EXPECT_EQ(speed(1), 0.4);
  drive(1, 0.2);
  EXPECT_EQ(open(1), 1u);
  EXPECT_EQ(speed(1), 0.2);
  drive(1, 0);
  EXPECT_EQ(open(1), 0u);
  EXPECT_EQ(speed(1), 0);
  EXPECT_EQ(open(0), 0u);
}

TEST_F(DrivenRobotsTest, a_velocity_that_is_renewed_holds_and_one_that_is_not_stops) {
  for (int k = 0; k < 20; ++k) {
    drive(0, 0.4);
    network_.run_for(kStep);
    EXPECT_EQ(speed(0), 0.4);
  }
  network_.run_for(limits::kViewerDriveSeconds - 1.5 * kStep);
  EXPECT_EQ(speed(0), 0.4);
  network_.run_for(kStep);
  EXPECT_EQ(speed(0), 0);
  EXPECT_EQ(open(0), 0u);
}

TEST_F(DrivenRobotsTest, a_driver_who_leaves_stops_what_nobody_else_drives_by_now) {
  drive(0, 0.4);
  drive(1, 0.4);
  drive(1, 0.3, kBob);
  driven_.left(&kAlice);
  EXPECT_EQ(open(0), 0u);
  EXPECT_EQ(speed(0), 0);
  EXPECT_EQ(open(1), 1u);
  EXPECT_EQ(speed(1), 0.3);
}

TEST_F(DrivenRobotsTest, a_client_that_has_the_wheels_keeps_them) {
  world::subscribe(small_.world, {SmallWorld::robot(0)});
  drive(0, 0.4);
  drive(0, 0);
  EXPECT_EQ(open(0), 1u);
  world::command_velocity(small_.world, {0}, {0.7, 0, 0, 0});
  drive(0, 0);
  network_.run_for(1);
  EXPECT_EQ(speed(0), 0.7) << "a page that holds nothing lets go of nothing";
}

TEST_F(DrivenRobotsTest, a_full_queue_neither_loses_a_stop_nor_counts_twice) {
  control_.full = true;
  drive(0, 0.4);
  EXPECT_EQ(open(0), 0u);
  control_.full = false;
  drive(0, 0.4);
  EXPECT_EQ(open(0), 1u);
  control_.full = true;
  drive(0, 0);
  EXPECT_EQ(speed(0), 0);
  EXPECT_EQ(open(0), 1u);
  control_.full = false;
  network_.run_for(1);
  EXPECT_EQ(open(0), 0u);
}

TEST_F(DrivenRobotsTest, a_robot_that_goes_while_it_is_driven_is_let_go) {
  drive(0, 0.4);
  ASSERT_TRUE(world::despawn(small_.world, SmallWorld::id(0)).ok());
  drive(0, 0.4);
  network_.run_for(1);
  drive(0, 0);
  EXPECT_EQ(small_.world.positions.size(), 1u);
  EXPECT_EQ(small_.world.models.subscribers[{0}], 0u);
}

}  // namespace
}  // namespace playhouse::web_server
