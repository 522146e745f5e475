// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Act phases of kinds, each defined in playhouse/behaviour/act_NAME.cc.

#include <memory>

#include "playhouse/behaviour/act_phase.h"

namespace playhouse::behaviour {

std::unique_ptr<ActPhase> make_position_act();
std::unique_ptr<ActPhase> make_blinkenlight_act();
std::unique_ptr<ActPhase> make_gripper_act();
std::unique_ptr<ActPhase> make_actuator_act();
std::unique_ptr<ActPhase> make_camera_act();
std::unique_ptr<ActPhase> make_custom_act();

inline void add_acts(Acts& acts) {
  acts.add(make_position_act());
  acts.add(make_blinkenlight_act());
  acts.add(make_gripper_act());
  acts.add(make_actuator_act());
  acts.add(make_camera_act());
  acts.add(make_custom_act());
}

}  // namespace playhouse::behaviour
