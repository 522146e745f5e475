#pragma once

/// Where an actuator comes to be that slides or turns. Frames: M the model, P its parent.

#include "playhouse/geom/pose.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

class Properties;

/// The unit vector in M along which it slides, or about which it turns: ahead, or up, where the file has
/// none. Nothing turns about another axis than z, so of one that is asked to the sign of z counts.
struct Axis {
  double x = 0, y = 0, z = 0;
};
Axis axis_of(const ActuatorDesc& desc);

/// X_MN, where N is M after it has gone `way` along its axis. [m or rad]
geom::Pose way_along(const ActuatorDesc& desc, double way);

/// The nearest position that it can have. [m or rad]
double within_reach(const ActuatorDesc& desc, double position);

/// Makes the ends a way and the start a position on it; warns where they were none, and of an axis about
/// which nothing turns.
void check_actuator(const Properties& properties, ActuatorDesc& desc);

}  // namespace playhouse::scene
