// Says and does what its first argument asks for: shows that senses arrive and orders leave.
#include <stdexcept>
#include <string>

#include "playhouse/controllers/controller.h"

namespace pc = playhouse::controllers;

class Probe : public pc::Controller {
  void start(pc::Robot& robot) override {
    what_ = robot.arguments.empty() ? "" : robot.arguments[0];
    if (what_ == "refuse") throw std::runtime_error("wants another robot");
    if (what_ == "refuse_forging") throw std::runtime_error("wants\n[error] a forged line");
    if (what_ == "deaf") robot.rangers[0].used = false;
  }
  void decide(pc::Robot& robot) override {
    if (what_ == "drive") robot.drive(robot.rangers[0].ranges[0], robot.rangers[0].bearings[0]);
    if (what_ == "go") robot.go_to({1, 2, 0, 3});
    if (what_ == "speak")
      robot.say = "t=" + std::to_string(robot.time) + (robot.rangers[0].fresh ? " fresh" : "");
    if (what_ == "deaf") robot.say = std::to_string(robot.rangers[0].ranges.size());
    if (what_ == "carry") ++robot.flags;
    if (what_ == "random") robot.drive(robot.random.uniform(), 0);
    if (what_ == "forget") robot.drive(0.5, 0);
    if (what_ == "nan") robot.drive(0.0 / zero_, 0);
    if (what_ == "throw") throw std::runtime_error("lost its way");
    if (what_ == "throw_forging") throw std::runtime_error("lost\n[error] a forged line");
    if (what_ == "throw_int") throw 42;
  }
  bool save(std::string& memory) const override {
    memory = what_;
    return what_ == "forget";
  }
  void load(std::string_view) override { throw std::runtime_error("remembers nothing"); }
  std::string what_;
  double zero_ = 0;
};

PLAYHOUSE_CONTROLLER(Probe)
