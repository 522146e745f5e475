// A controller in twenty lines: drives forward, and backs away from objects closer than its argument
// (default 0.7 m).
#include <algorithm>
#include <string>

#include "playhouse/controllers/controller.h"

namespace pc = playhouse::controllers;

class Shy : public pc::Controller {
  void start(pc::Robot& robot) override {
    if (!robot.arguments.empty()) distance_ = std::stof(robot.arguments[0]);
  }
  void decide(pc::Robot& robot) override {
    float nearest = 1e9f;
    for (const pc::Ranger& ranger : robot.rangers) {
      for (const float range : ranger.ranges) nearest = std::min(nearest, range);
    }
    const bool afraid = nearest < distance_;
    robot.say = afraid ? "eek" : "";
    robot.drive(afraid ? -0.1 : 0.3, afraid ? robot.random.uniform(-1, 1) : 0);
  }
  float distance_ = 0.7f;
};

PLAYHOUSE_CONTROLLER(Shy)
