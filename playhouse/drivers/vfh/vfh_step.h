#pragma once

/// One step of VFH+: from what a scanner sees to a velocity that brings a robot nearer to its goal and past
/// what is in the way. A function of its arguments alone, made of arithmetic that gives the same bits
/// everywhere.
///
/// In: options, the robot, one scan with the pose at which it was taken; what the step before remembered.
///
/// Out: a velocity, and what the next step is to know.
///
/// Cost: cells of the window with something in them times sectors; with the defaults and 181 beams, in a
/// release build, 0.2 ms of a processor in the open and 0.5 ms between walls a metre away.
///
/// Source: I. Ulrich, J. Borenstein: "VFH+: Reliable Obstacle Avoidance for Fast Mobile Robots", ICRA 1998,
/// for enlarged obstacles, thresholds with hysteresis, turning circles, openings and costs. Cells are weighed
/// as in Player's driver, (3 m - distance)^4 with what is behind an obstacle counted as well, so that its
/// cutoffs mean the same.

#include <cstdint>
#include <optional>
#include <vector>

#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

/// A value that depends on the robot's speed: given at rest and at 1 m/s, a straight line through both.
struct AtSpeed {
  double at_rest = 0, at_1 = 0;
  double at(double speed) const { return at_rest + (at_1 - at_rest) * speed; }
};

struct VfhOptions {
  double cell_size = 0.1;             // m
  int window = 61;                    // cells along a side of the square around the robot
  int sectors = 72;                   // of the full circle
  AtSpeed safety_distance{0.1, 0.1};  // m
  double max_speed = 0.2, max_speed_narrow = 0.2, max_speed_wide = 0.2;  // m/s
  double max_acceleration = 0.2;                                         // m/s^2
  double min_turn_rate = geom::radians(10);                              // rad/s; when it turns on the spot
  AtSpeed max_turn_rate{geom::radians(40), geom::radians(40)};           // rad/s
  double turn_radius_factor = 1;
  AtSpeed free_cutoff{2e6, 2e6};     // a direction of less is free
  AtSpeed blocked_cutoff{2e6, 2e6};  // one of more is blocked; between them it stays what it was
  double weight_desired = 5, weight_current = 3;
  double distance_epsilon = 0.5;                 // m
  double angle_epsilon = geom::radians(10);      // rad
  double escape_speed = 0;                       // m/s; 0: no escape from a stall
  double escape_time = 0, escape_turn_rate = 0;  // s, rad/s
};

/// What does not change from step to step.
struct VfhRobot {
  double radius = 0;  // m, about its centre of turning
  geom::Pose X_RS;    // where the scanner is
};

struct VfhIn {
  double time = 0;  // s
  geom::Pose X_OG;  // the goal
  geom::Pose X_OR;
  double speed = 0;  // forward, as measured [m/s]
  bool stall = false;
  double max_range = 0;                    // m; a beam that reaches it hit nothing
  double first_angle = 0, angle_step = 0;  // of the beams, counter-clockwise in S [rad]
  std::vector<float> ranges;               // m; what is no number or negative counts as 0
};

struct VfhMemory {
  std::vector<std::uint8_t> blocked;  // per sector: 1 where the histogram was too high
  std::optional<double> direction;    // that was taken, in O [rad]
  std::optional<double> time;         // of the step before [s]
  double speed = 0, turn_rate = 0;    // that was wanted [m/s, rad/s]
  double escape_end = 0;              // s
  int escapes = 0;                    // begun so far
};

struct VfhOut {
  double speed = 0;      // m/s
  double turn_rate = 0;  // rad/s
  bool done = false;     // the goal is reached, and the velocity is zero
};

VfhOut vfh_step(const VfhOptions& options, const VfhRobot& robot, const VfhIn& in, VfhMemory& memory);

}  // namespace playhouse::drivers
