#pragma once

/// One step on the way to a goal: plans a path on the map if there is none yet, and tells the waypoint that
/// the robot is to go to. A function of its arguments alone; it gives the same bits on every machine.
///
/// In: options; the robot's pose and goal in the map's frame W; what was seen, and from where; the memory of the
///   previous step.
///
/// Out: the path or why there is none, the current waypoint, and what to tell the device that drives, in its
///   frame O; the memory for the next step. It plans anew, twice a second at most, when something that is not on the
///   map is in the rest of the path, and when some of what it leads round has gone.
///
/// Cost: a few comparisons; that of plan_path.h when it plans: the map's part once
///   per map, the goal's once per goal, and path_to_goal() or path_past() each time. With a scan that of
///   seen_obstacles.h, and the cells along the rest of the path if it shows something new.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/drivers/algorithm/scan.h"
#include "playhouse/drivers/grid_map/grid_map.h"
#include "playhouse/drivers/wavefront/plan_path.h"
#include "playhouse/drivers/wavefront/seen_obstacles.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

struct WavefrontOptions {
  PlanOptions plan;
  SeenOptions sight;
  double distance_epsilon = 0.5;             // m
  double angle_epsilon = geom::radians(10);  // rad
  double replan_distance = 2;                // m; 0 or less: plans once
  double replan_time = 2;                    // s; 0 or less: plans once
  bool turns = true;                         // turns on the spot before legs of another direction
  bool refresh_map = false;                  // reads the map for each goal
};

struct Waypoint {
  geom::Pose X_WP;
  bool turn = false;  // reached only with this heading
};

struct Route {
  std::vector<Waypoint> waypoints;  // not empty; the last one is the goal
  double length = 0;                // m; from where the robot was
};

/// The waypoints of a path with these corners, the last of which is the goal X_WT.
Route route_of(const WavefrontOptions& options, const std::vector<geom::Vec2>& p_WC, const geom::Pose& X_WR,
               const geom::Pose& X_WT);

/// What the robot's sensor saw, and from where.
struct PlacedScan {
  RangeScan scan;
  geom::Pose X_WR;  // at the time of the scan
};

struct FollowIn {
  double time = 0;         // s
  std::uint64_t goal = 0;  // its number, not 0: another one is planned for anew
  geom::Pose X_WT;         // the goal
  geom::Pose X_WR, X_OR;
  bool enabled = true;                 // drives
  std::shared_ptr<const GridMap> map;  // null: there is none
  std::string map_fault{};             // why not; may be empty
  std::optional<PlacedScan> seen{};    // since the previous step
};

struct FollowOut {
  std::string fault;  // why there is no path; empty: there is one
  // Of something that is not on the map, and has not been in the way for long: it may go by itself.
  bool may_pass = false;
  std::shared_ptr<const Route> route;
  std::size_t waypoint = 0;        // the current one; the number of waypoints: goal reached
  std::optional<geom::Pose> X_OP;  // a new goal for the device that drives
  bool again = false;              // it was told before, and the robot stands

  bool done() const { return route != nullptr && waypoint == route->waypoints.size(); }
};

struct FollowMemory {
  // Of the map, and of the goal on it.
  std::shared_ptr<const GridMap> map;
  std::shared_ptr<const CostMap> costs;
  std::optional<Result<CostToGoal>> to_goal;

  // Beyond the map; none before the first scan.
  std::optional<SeenObstacles> seen;
  bool is_detour = false;                 // round something seen, or there is no way past it
  std::optional<double> blocked_since{};  // s; since when there is no way past something seen
  std::uint64_t come = 0;                 // of seen; so many obstacles are not in the way
  std::uint64_t gone = 0;                 // of seen; when it was planned

  std::uint64_t goal = 0;  // for which `out` is planned; 0: none
  geom::Pose X_WT;
  geom::Pose X_WR;  // when it was planned
  double time = 0;  // s; when it was planned
  FollowOut out;
  std::size_t sent = 0;            // the waypoint last told to the device that drives
  std::optional<geom::Pose> X_OP;  // that waypoint as told; none: none was told
  std::optional<geom::Pose>
      X_WR_still;          // where the robot has been standing; none: it was told a waypoint since
  double still_since = 0;  // s
};

FollowOut follow_path(const WavefrontOptions& options, const FollowIn& in, FollowMemory& memory);

}  // namespace playhouse::drivers
