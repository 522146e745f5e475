#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "playhouse/behaviour/generated/acts.h"
#include "playhouse/world/gripper.h"
#include "playhouse/world/population/population.h"

namespace playhouse::behaviour {
namespace {

using world::GripperCommand;
using world::ModelId;
using world::PaddleState;

/// Robots that carry a gripper each (rows 0 and 1, 2 and 3), a puck (4) and a heavy thing with a handle (5,
/// 6), without an engine: what the grippers sense is told.
class GripperActTest : public ::testing::Test {
 protected:
  static constexpr ModelId kGripper{1}, kOther{3}, kPuck{4}, kChest{5}, kHandle{6};

  GripperActTest() {
    for (const std::string name : {"a", "b"}) {
      scene::ModelDesc& robot = add(name, scene::ModelKind::kPosition, {0, 0, 0, 0});
      robot.position.emplace();
      scene::ModelDesc& gripper =
          add(name + ".gripper:0", scene::ModelKind::kGripper, {0.3, 0, 0, 0}, scene_.models.size() - 1);
      gripper.size = {0.2, 0.3, 0.2};
      gripper.gripper.emplace();
    }
    scene::ModelDesc& puck = add("puck", scene::ModelKind::kPlain, {0.36, 0, 0, 1});
    puck.size = {0.08, 0.08, 0.1};
    puck.gripper_return = true;
    add("chest", scene::ModelKind::kPlain, {1, 0, 0, 0}).size = {1, 1, 1};
    scene::ModelDesc& handle = add("handle", scene::ModelKind::kPlain, {}, 5);
    handle.gripper_return = true;
  }

  scene::ModelDesc& add(const std::string& name, scene::ModelKind kind, const geom::Pose& X_PM,
                        std::size_t parent = -1) {
    scene::ModelDesc& model = scene_.models.emplace_back();
    model.name = model.alias = name;
    model.kind = kind;
    model.X_PM = X_PM;
    model.parent = static_cast<std::int32_t>(parent);
    model.alwayson = true;
    return model;
  }
  scene::GripperDesc& desc() { return *scene_.models[kGripper.value].gripper; }

  world::World& world() {
    if (!world_) world_ = std::make_unique<world::World>(scene_, 1);
    return *world_;
  }
  world::GripperRow row(ModelId gripper = kGripper) { return world().models.part[world().row(gripper)]; }
  double paddles() { return world().grippers.paddles[row()]; }
  double lift() { return world().grippers.lift[row()]; }
  PaddleState state() { return world::paddle_state(world().grippers, row()); }
  ModelId held(ModelId gripper = kGripper) { return world().grippers.held[row(gripper)]; }
  ModelId parent(ModelId model) { return world().models.parent_id[world().row(model)]; }
  void command(GripperCommand command, ModelId gripper = kGripper) {
    world::command_gripper(world(), row(gripper), command);
  }
  /// The paddles of a gripper touch this in the tick that comes; in later ones they do not.
  void touch(ModelId thing, ModelId gripper = kGripper) { touches_.push_back({gripper, thing}); }

  void step(int ticks = 1) {
    for (int k = 0; k < ticks; ++k) {
      act_->act(world(), workers_);
      act_->change(world());
      ++world().tick_;
      world::Grippers& grippers = world().grippers;
      for (const world::GripperRow gripper : grippers.rows()) {
        const world::ModelRow model = grippers.model[gripper];
        const double period = world().desc(model).update_interval / scene_.interval;
        if (static_cast<double>(world().tick() - grippers.measured_tick[gripper]) < std::round(period))
          continue;
        grippers.measured_tick[gripper] = world().tick();
        grippers.touched[gripper] = {};
      }
      for (const auto& [gripper, thing] : touches_) grippers.touched[row(gripper)] = thing;
      touches_.clear();
    }
  }

 private:
  scene::SceneDesc scene_;
  std::unique_ptr<world::World> world_;
  world::Workers workers_{1};
  std::unique_ptr<ActPhase> act_ = make_gripper_act();
  std::vector<std::pair<ModelId, ModelId>> touches_;

 protected:
  scene::SceneDesc& scene() { return scene_; }
};

TEST_F(GripperActTest, paddles_take_twenty_updates_to_close_and_to_open) {
  EXPECT_EQ(state(), PaddleState::kOpen);
  command(GripperCommand::kClose);
  for (int k = 1; k < 20; ++k) {
    step();
    EXPECT_NEAR(paddles(), 0.05 * k, 1e-12);
    EXPECT_EQ(state(), PaddleState::kMoving);
  }
  step();
  EXPECT_EQ(paddles(), 1);
  EXPECT_EQ(state(), PaddleState::kClosed);
  command(GripperCommand::kOpen);
  step(19);
  EXPECT_EQ(state(), PaddleState::kMoving);
  step();
  EXPECT_EQ(paddles(), 0);
  EXPECT_EQ(state(), PaddleState::kOpen);
  EXPECT_EQ(lift(), 0);
}

TEST_F(GripperActTest, the_lift_takes_twenty_updates_up_and_down) {
  command(GripperCommand::kRaise);
  step(19);
  EXPECT_NEAR(lift(), 0.95, 1e-12);
  step(2);
  EXPECT_EQ(lift(), 1);
  command(GripperCommand::kLower);
  step(20);
  EXPECT_EQ(lift(), 0);
  EXPECT_EQ(paddles(), 0);
}

TEST_F(GripperActTest, stop_leaves_both_where_they_are) {
  command(GripperCommand::kClose);
  command(GripperCommand::kRaise);
  step(4);
  command(GripperCommand::kStop);
  step(4);
  EXPECT_NEAR(paddles(), 0.2, 1e-12);
  EXPECT_NEAR(lift(), 0.2, 1e-12);
  EXPECT_EQ(state(), PaddleState::kStopped);
}

TEST_F(GripperActTest, starts_as_the_file_says) {
  desc().paddles = scene::Paddles::kClosed;
  desc().lift = scene::Lift::kUp;
  EXPECT_EQ(state(), PaddleState::kClosed);
  EXPECT_EQ(lift(), 1);
  step();
  EXPECT_EQ(paddles(), 1);
}

TEST_F(GripperActTest, moves_in_its_own_updates_alone) {
  scene().models[kGripper.value].update_interval = 0.3;
  command(GripperCommand::kClose);
  step(2);
  EXPECT_EQ(paddles(), 0);
  step();
  EXPECT_NEAR(paddles(), 0.05, 1e-12);
  step(2);
  EXPECT_NEAR(paddles(), 0.05, 1e-12);
  step();
  EXPECT_NEAR(paddles(), 0.1, 1e-12);
}

TEST_F(GripperActTest, stands_while_nobody_uses_it) {
  scene().models[kGripper.value].alwayson = false;
  command(GripperCommand::kClose);
  step(3);
  EXPECT_EQ(paddles(), 0);
  world::subscribe(world(), world().row(kGripper));
  step(3);
  EXPECT_NEAR(paddles(), 0.15, 1e-12);
}

TEST_F(GripperActTest, what_is_touched_while_it_closes_is_taken_up_and_let_go_where_the_gripper_is) {
  command(GripperCommand::kClose);
  step(13);
  touch(kPuck);
  step();
  EXPECT_EQ(held(), ModelId{});
  step();
  EXPECT_EQ(held(), kPuck);
  EXPECT_EQ(parent(kPuck), kGripper);
  EXPECT_EQ(world().models.X_PM[{kPuck.value}], geom::Pose{});
  EXPECT_NEAR(paddles(), 0.68, 1e-12) << "1 - 0.08 / (0.3 - 0.1 / 2)";
  EXPECT_EQ(state(), PaddleState::kClosed);
  step(5);
  EXPECT_NEAR(paddles(), 0.68, 1e-12);
  world::set_pose(world(), {0}, {2, 1, 0, 0.5});
  command(GripperCommand::kOpen);
  step();
  EXPECT_EQ(held(), ModelId{});
  EXPECT_EQ(parent(kPuck), ModelId{});
  EXPECT_EQ(world().models.X_WM[{kPuck.value}], world().models.X_WM[{kGripper.value}]);
  EXPECT_EQ(state(), PaddleState::kMoving);
  step(13);
  EXPECT_EQ(state(), PaddleState::kOpen);
  command(GripperCommand::kClose);
  step(20);
  EXPECT_EQ(paddles(), 1) << "nothing is in between any more";
}

TEST_F(GripperActTest, what_is_as_wide_as_the_gripper_is_let_go_as_well) {
  scene().models[kPuck.value].size.y = 0.3;
  command(GripperCommand::kClose);
  touch(kPuck);
  step(2);
  EXPECT_EQ(held(), kPuck);
  EXPECT_EQ(paddles(), 0);
  EXPECT_EQ(state(), PaddleState::kClosed);
  command(GripperCommand::kOpen);
  step();
  EXPECT_EQ(held(), ModelId{});
  EXPECT_EQ(state(), PaddleState::kOpen);
}

TEST_F(GripperActTest, what_paddles_meet_as_they_come_to_their_end_is_taken_up) {
  scene().models[kPuck.value].size.y = 0.001;
  command(GripperCommand::kClose);
  step(19);
  touch(kPuck);
  step();
  EXPECT_EQ(paddles(), 1);
  step();
  EXPECT_EQ(held(), kPuck);
}

TEST_F(GripperActTest, takes_nothing_while_it_opens_or_stands_or_holds_something) {
  touch(kPuck);
  step(2);
  EXPECT_EQ(held(), ModelId{});
  command(GripperCommand::kClose);
  step(3);
  touch(kPuck);
  step();
  command(GripperCommand::kOpen);
  step();
  EXPECT_EQ(held(), ModelId{});
  step(10);
  command(GripperCommand::kClose);
  touch(kPuck);
  step(2);
  ASSERT_EQ(held(), kPuck);
  touch(*world::spawn(world(), kPuck.value, {0.3, 0, 0, 0}));
  step(2);
  EXPECT_EQ(held(), kPuck);
}

TEST_F(GripperActTest, takes_what_was_touched_in_the_last_tick_and_not_what_was_long_ago) {
  scene().models[kGripper.value].update_interval = 0.5;
  step(4);
  touch(kPuck);
  step();
  step();
  command(GripperCommand::kClose);
  step();
  EXPECT_EQ(held(), ModelId{});
}

TEST_F(GripperActTest, takes_neither_robots_nor_parts_nor_what_stands_fast_nor_itself) {
  const auto tries = [&](ModelId thing) {
    command(GripperCommand::kClose);
    touch(thing);
    step(2);
    return held();
  };
  EXPECT_EQ(tries({2}), ModelId{});
  EXPECT_EQ(tries(kOther), ModelId{});
  EXPECT_EQ(tries(kGripper), ModelId{});
  EXPECT_EQ(tries(kHandle), ModelId{}) << "the chest is no thing for grippers";
  EXPECT_EQ(tries({99}), ModelId{}) << "gone";
  EXPECT_TRUE(world::attach(world(), kPuck, {2}, {}).ok());
  EXPECT_EQ(tries(kPuck), ModelId{}) << "a part of a robot by now";
}

TEST_F(GripperActTest, takes_a_whole_thing_by_a_part_of_it) {
  scene().models[kChest.value].gripper_return = true;
  command(GripperCommand::kClose);
  touch(kHandle);
  step(2);
  EXPECT_EQ(held(), kChest);
  EXPECT_EQ(parent(kChest), kGripper);
}

TEST_F(GripperActTest, of_two_that_touch_one_thing_the_first_gets_it) {
  command(GripperCommand::kClose);
  command(GripperCommand::kClose, kOther);
  touch(kPuck, kOther);
  touch(kPuck);
  step(2);
  EXPECT_EQ(held(), kPuck);
  EXPECT_EQ(held(kOther), ModelId{});
}

TEST_F(GripperActTest, what_it_holds_stays_where_it_is_when_the_robot_goes) {
  command(GripperCommand::kClose);
  touch(kPuck);
  step(2);
  ASSERT_EQ(parent(kPuck), kGripper);
  const geom::Pose at = world().models.X_WM[{kPuck.value}];
  ASSERT_TRUE(world::despawn(world(), {0}).ok());
  step(3);
  const world::ModelRow puck = world().row(kPuck);
  EXPECT_EQ(world().models.X_WM[puck], at);
  EXPECT_EQ(parent(kPuck), ModelId{});
}

TEST_F(GripperActTest, forgets_what_was_taken_from_it) {
  command(GripperCommand::kClose);
  touch(kPuck);
  step(2);
  ASSERT_TRUE(world::detach(world(), kPuck).ok());
  EXPECT_FALSE(world::held_by(world(), row()));
  step();
  EXPECT_EQ(held(), ModelId{});
  ASSERT_TRUE(world::despawn(world(), kPuck).ok());
  command(GripperCommand::kClose);
  step(20);
  EXPECT_EQ(paddles(), 1);
}

TEST_F(GripperActTest, is_empty_and_as_the_file_says_again_at_the_start) {
  command(GripperCommand::kClose);
  touch(kPuck);
  step();
  world::return_to_start(world());
  step();
  EXPECT_EQ(held(), ModelId{}) << "touched before";
  command(GripperCommand::kClose);
  touch(kPuck);
  step(2);
  ASSERT_EQ(held(), kPuck);
  world::return_to_start(world());
  EXPECT_EQ(held(), ModelId{});
  EXPECT_EQ(parent(kPuck), ModelId{});
  EXPECT_EQ(state(), PaddleState::kOpen);
}

TEST_F(GripperActTest, with_autosnatch_beams_open_and_close_it_and_commands_let_go) {
  desc().autosnatch = true;
  const auto beams = [&](std::uint32_t bits) { world().grippers.beams[row()] = bits; };
  step(3);
  EXPECT_EQ(state(), PaddleState::kOpen);
  beams(2);
  step();
  EXPECT_NEAR(paddles(), 0.05, 1e-12);
  touch(kPuck);
  step(2);
  EXPECT_EQ(held(), kPuck);
  beams(0);
  step(5);
  EXPECT_EQ(held(), kPuck) << "what it holds breaks no beam";
  command(GripperCommand::kOpen);
  step();
  EXPECT_EQ(held(), ModelId{});
  step(20);
  EXPECT_EQ(state(), PaddleState::kOpen);
}

}  // namespace
}  // namespace playhouse::behaviour
