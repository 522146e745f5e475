#pragma once

/// What a driver of goals tells the robot of two_eyes.h that is to go ahead, with a post before it on the right.

#include <string>

#include "playhouse/drivers/testing/goal_test.h"
#include "playhouse/drivers/testing/two_eyes.h"

namespace playhouse::drivers::testing {

class PostOnTheRight final : public GoalTest {
 public:
  /// `section`: that of the driver.
  explicit PostOnTheRight(const std::string& section) : GoalTest(two_eyes_world(), section + kTwoEyesStage) {
    see(world(), [](int degrees) { return degrees > -35 && degrees < 8 ? 0.9 : 8; });
    go_to(5, 0);
    site.run(6);
  }
  geom::Twist told() { return GoalTest::told(); }

 private:
  void TestBody() override {}
};

}  // namespace playhouse::drivers::testing
