#pragma once

/// One step of Nearness Diagram navigation: from obstacle points to a velocity towards the goal that avoids
/// them. A pure function; its arithmetic gives the same bits on every machine.
///
/// In: options, the robot, new scans with the pose at which they were taken; the memory of the previous step.
///
/// Out: a velocity, zero and `done` once the goal is reached, zero and `stuck` if the robot makes no
///   progress; the memory for the next step.
///
/// Cost: points kept, plus pairs of occupied sectors for each gap; with the defaults, 181 beams and
/// 16 sonars, in a release build, below 0.1 ms.
///
/// Source: J. Minguez, L. Montano: "Nearness Diagram (ND) Navigation: Collision Avoidance in Troublesome
/// Scenarios", IEEE Trans. Robotics and Automation 20(1), 2004, for sectors, gaps, regions, the test of
/// whether a region can be reached, and the five situations. How far the motion is turned away from obstacles
/// is a linear law here, and what the robot is about to touch limits its velocity (nd_guard.h).

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "playhouse/drivers/algorithm/scan.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

struct NdOptions {
  double goal_distance = 0.5;                // m; tolerance
  double goal_angle = geom::radians(10);     // rad; tolerance
  double max_speed = 0.3;                    // m/s
  double max_turn_rate = geom::radians(45);  // rad/s
  double min_speed = 0.05;                   // m/s; when it drives at all
  double min_turn_rate = geom::radians(10);  // rad/s; when turning in place
  double avoid_distance = 0.5;               // m; obstacles nearer than this to the body are avoided
  double safety_distance = 0;                // m; the body is enlarged by it
  bool wait_on_stall = false;
  double rotate_stuck_time = 2, translate_stuck_time = 2;  // s
  double translate_stuck_distance = 0.25;                  // m
  double translate_stuck_angle = geom::radians(20);        // rad
  int laser_buffer = 10, sonar_buffer = 10;  // scans whose points are kept; those of rings are the second
  std::vector<int> bad_sonars;               // of rings; not used
};

/// Constants of a robot.
struct NdRobot {
  geom::Box body;  // about its center of rotation, in R [m]
};

struct NdIn {
  double time = 0;  // s
  geom::Pose X_OG;  // the goal
  geom::Pose X_OR;
  bool stall = false;
  std::vector<std::optional<RangeScan>> scans;  // of each device, if there is a new one
};

/// Since when the robot has not got on.
struct NdProgress {
  bool turning = false;  // to the goal's heading
  geom::Pose X_OR;       // at that time
  double time = 0;       // s
};

struct NdMemory {
  std::vector<std::deque<std::vector<geom::Vec2>>> points;  // of obstacles, of each device's last scans, in O
  std::optional<double> direction;                          // of the last chosen region, in O [rad]
  std::optional<NdProgress> progress;
  double time = 0;       // of the previous step [s]
  double turn_rate = 0;  // last commanded [rad/s]
};

/// The paper's five situations, and those in which there is no way to choose.
enum class NdSituation : std::uint8_t {
  kHighSafetyGoalInRegion,  // HSGR
  kHighSafetyWideRegion,    // HSWR
  kHighSafetyNarrowRegion,  // HSNR
  kLowSafetyOneSide,        // LS1
  kLowSafetyBothSides,      // LS2
  kBlocked,                 // no region can be reached
  kStuck,                   // no progress
  kAtGoal,
  kWaiting,  // for the end of a stall, or for a scan
};

struct NdOut {
  double speed = 0;      // m/s
  double turn_rate = 0;  // rad/s
  NdSituation situation = NdSituation::kWaiting;
  bool done = false;   // goal reached, velocity zero
  bool stuck = false;  // no progress, velocity zero
};

NdOut nd_step(const NdOptions& options, const NdRobot& robot, const NdIn& in, NdMemory& memory);

}  // namespace playhouse::drivers
