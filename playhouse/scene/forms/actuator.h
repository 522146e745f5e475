#pragma once

/// Kinematics of actuators that slide or rotate. Frames: M the model, P its parent.

#include "playhouse/geom/pose.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

class Properties;

/// Unit vector in M of the slide or rotation axis; default: x to slide, z to
/// rotate. Rotation is about z only, so of another axis only the sign of z counts.
struct Axis {
  double x = 0, y = 0, z = 0;
};
Axis axis_of(const ActuatorDesc& desc);

/// X_MN: displacement of M by `way` along its axis. [m or rad]
geom::Pose way_along(const ActuatorDesc& desc, double way);

/// Clamps a position to the actuator's range. [m or rad]
double within_reach(const ActuatorDesc& desc, double position);

/// Validates range and start position, adjusting them with
/// a warning; also warns of a rotation axis other than z.
void check_actuator(const Properties& properties, ActuatorDesc& desc);

}  // namespace playhouse::scene
