#include "playhouse/drivers/wavefront/follow_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace playhouse::drivers {
namespace {

using geom::normalize;
using geom::Pose;
using geom::Vec2;

constexpr double kTurn = geom::radians(45);  // change of direction from which it turns on the spot
// A robot that moves less for so long stands.
constexpr double kStillLength = 0.02, kStillAngle = geom::radians(2), kStillTime = 2;  // m, rad, s
constexpr double kSeenPause = 0.5;  // s; from a plan to the next one for what is seen
constexpr double kShorter = 0.95;   // times the rest of a route that is given up for another one
constexpr double kStillSlack = 2;   // epsilons within which a robot that stands has reached its waypoint

double distance(Vec2 a, Vec2 b) {
  return std::sqrt(dot(b - a, b - a));
}

/// Direction of a leg; `otherwise` for one without length.
double direction(Vec2 from, Vec2 to, double otherwise) {
  return from == to ? otherwise : geom::atan2(to.y - from.y, to.x - from.x);
}

bool sharp(double from, double to) {
  return std::abs(normalize(to - from)) > kTurn;
}

bool within(const Pose& a, const Pose& b, double length, double angle) {
  return distance(a.xy(), b.xy()) <= length && std::abs(normalize(b.a - a.a)) <= angle;
}

/// Keeps what is known of the map, as long as it is the same.
void use_map(const WavefrontOptions& options, const FollowIn& in, FollowMemory& memory) {
  if (memory.map == in.map) return;
  memory.map = in.map;
  memory.costs =
      in.map == nullptr ? nullptr : std::make_shared<const CostMap>(cost_map(*in.map, options.plan));
  memory.to_goal.reset();
  memory.seen.reset();
  memory.is_detour = false;
  memory.come = memory.gone = 0;
}

void look(const WavefrontOptions& options, const FollowIn& in, FollowMemory& memory) {
  if (in.map == nullptr) return;
  if (!memory.seen && in.seen) memory.seen.emplace(memory.costs, options.plan, options.sight);
  if (!memory.seen) return;
  memory.seen->pass_time(in.time);
  if (in.seen) memory.seen->take(in.seen->scan, compose(inverse(in.map->X_WG()), in.seen->X_WR));
}

/// In the map's frame G.
Result<std::vector<Vec2>> plan_corners(const FollowIn& in, FollowMemory& memory, Vec2 p_GR, Vec2 p_GT) {
  if (!memory.to_goal || memory.X_WT != in.X_WT) memory.to_goal = cost_to_goal(*memory.costs, p_GT);
  memory.X_WT = in.X_WT;
  memory.is_detour = false;
  if (!*memory.to_goal) return memory.to_goal->error();
  const CostToGoal& to_goal = **memory.to_goal;
  if (!memory.seen || !memory.seen->any()) return path_to_goal(*memory.costs, to_goal, p_GR);
  if (std::optional<PathPast> past = path_past(memory.seen->costs(), to_goal, p_GR)) {
    memory.is_detour = past->is_detour;
    return std::move(past->corners);
  }
  Result<std::vector<Vec2>> without = path_to_goal(*memory.costs, to_goal, p_GR);
  if (!without) return without.error();
  memory.is_detour = true;
  return Error{"", "something that is not on the map is in the way"};
}

/// Uses what is known of the map, the goal and what was seen, as far as they are the same.
Result<Route> plan(const WavefrontOptions& options, const FollowIn& in, FollowMemory& memory) {
  if (in.map == nullptr)
    return Error{"", in.map_fault.empty() ? "there is no map" : "there is no map: " + in.map_fault};
  const Pose X_WG = in.map->X_WG(), X_GW = inverse(X_WG);
  Result<std::vector<Vec2>> corners =
      plan_corners(in, memory, transform(X_GW, in.X_WR.xy()), transform(X_GW, in.X_WT.xy()));
  if (!corners) return corners.error();
  for (Vec2& corner : *corners) corner = transform(X_WG, corner);
  return route_of(options, *corners, in.X_WR, in.X_WT);
}

bool replans(const WavefrontOptions& options) {
  return options.replan_distance > 0 && options.replan_time > 0;
}

bool strayed(const WavefrontOptions& options, const FollowIn& in, const FollowMemory& memory) {
  return replans(options) && in.time - memory.time >= options.replan_time &&
         distance(memory.X_WR.xy(), in.X_WR.xy()) >= options.replan_distance;
}

void plan_again(const WavefrontOptions& options, const FollowIn& in, FollowMemory& memory) {
  Result<Route> route = plan(options, in, memory);
  memory.goal = in.goal;
  memory.X_WR = in.X_WR;
  memory.time = in.time;
  memory.X_OP.reset();
  memory.out = {};
  if (memory.seen) {
    memory.come = memory.seen->come();
    memory.gone = memory.seen->gone();
  }
  if (!route) {
    memory.out.fault = route.error().text;
    if (!memory.is_detour) memory.blocked_since.reset();
    if (memory.is_detour && !memory.blocked_since) memory.blocked_since = in.time;
  } else {
    memory.blocked_since.reset();
    memory.out.route = std::make_shared<const Route>(std::move(*route));
  }
}

/// True if the rest of the route leads through cells that what was seen blocks. The robot may come out of some.
bool is_blocked(const FollowIn& in, const FollowMemory& memory) {
  const SeenObstacles& seen = *memory.seen;
  const Pose X_GW = inverse(in.map->X_WG());
  const double step = memory.costs->scale / 2;
  Vec2 from = transform(X_GW, in.X_WR.xy());
  if (!memory.costs->cell_of(from)) return false;  // off the map, maybe far
  bool is_out = false;
  for (std::size_t i = memory.out.waypoint; i < memory.out.route->waypoints.size(); ++i) {
    const Vec2 to = transform(X_GW, memory.out.route->waypoints[i].X_WP.xy());
    const double steps = std::ceil(distance(from, to) / step);
    for (double k = 0; k <= steps; ++k) {
      const std::optional<CellIndex> cell =
          memory.costs->cell_of(from + k / std::max(steps, 1.0) * (to - from));
      if (!cell) continue;
      const bool blocked = seen.blocks(*cell);
      if (blocked && (is_out || seen.is_obstacle(*cell))) return true;
      is_out = is_out || !blocked;
    }
    from = to;
  }
  return false;
}

/// True if something was seen that is in the way of the plan.
bool is_news_in_the_way(const FollowIn& in, FollowMemory& memory) {
  if (!memory.seen || memory.out.route == nullptr || memory.come == memory.seen->come()) return false;
  if (in.time - memory.time < kSeenPause) return false;
  if (is_blocked(in, memory)) return true;
  memory.come = memory.seen->come();
  return false;
}

/// True if some of what the plan leads round has gone.
bool may_be_shorter(const FollowIn& in, const FollowMemory& memory) {
  return memory.is_detour && memory.gone != memory.seen->gone() && in.time - memory.time >= kSeenPause;
}

double length_left(const FollowIn& in, const FollowOut& out) {
  double length = 0;
  Vec2 from = in.X_WR.xy();
  for (std::size_t i = out.waypoint; i < out.route->waypoints.size(); ++i) {
    length += distance(from, out.route->waypoints[i].X_WP.xy());
    from = out.route->waypoints[i].X_WP.xy();
  }
  return length;
}

/// Keeps a route that is hardly longer, so that the robot need not turn for nothing.
void plan_shorter(const WavefrontOptions& options, const FollowIn& in, FollowMemory& memory) {
  const FollowOut before = memory.out;
  const std::optional<Pose> X_OP = memory.X_OP;
  plan_again(options, in, memory);
  if (before.route == nullptr) return;
  if (memory.out.route != nullptr && memory.out.route->length < kShorter * length_left(in, before)) return;
  memory.out = before;
  memory.X_OP = X_OP;
}

/// `slack`: times the epsilons.
bool reached(const WavefrontOptions& options, const Waypoint& waypoint, const Pose& X_WR, double slack) {
  return within(waypoint.X_WP, X_WR, slack * options.distance_epsilon,
                waypoint.turn ? slack * options.angle_epsilon : geom::kPi);
}

/// True if the robot has not moved for a time since the waypoint was told.
bool stands(const FollowIn& in, FollowMemory& memory) {
  if (!memory.X_WR_still || !within(*memory.X_WR_still, in.X_WR, kStillLength, kStillAngle)) {
    memory.X_WR_still = in.X_WR;
    memory.still_since = in.time;
  }
  return in.time - memory.still_since >= kStillTime;
}

/// In the frame of the device that drives, by where both say that the robot is.
Pose in_output(const FollowIn& in, const Pose& X_WP) {
  if (in.X_OR == in.X_WR) return X_WP;  // to the bit
  return compose(compose(in.X_OR, inverse(in.X_WR)), X_WP);
}

/// The current waypoint, if it is news to the device that drives: another
/// one than before, or shifted as its frame turned out to be elsewhere.
std::optional<Pose> news(const WavefrontOptions& options, const FollowIn& in, FollowMemory& memory) {
  const Pose X_OP = in_output(in, memory.out.route->waypoints[memory.out.waypoint].X_WP);
  if (memory.X_OP && memory.sent == memory.out.waypoint &&
      within(*memory.X_OP, X_OP, options.distance_epsilon / 2, options.angle_epsilon / 2))
    return std::nullopt;
  memory.sent = memory.out.waypoint;
  memory.X_OP = X_OP;
  memory.X_WR_still.reset();
  return X_OP;
}

}  // namespace

Route route_of(const WavefrontOptions& options, const std::vector<Vec2>& p_WC, const Pose& X_WR,
               const Pose& X_WT) {
  Route route;
  Vec2 from = X_WR.xy();
  double heading = X_WR.a;
  for (const Vec2 to : p_WC) {
    const double length = distance(from, to), ahead = direction(from, to, heading);
    const bool turn = options.turns && sharp(heading, ahead);
    if (!route.waypoints.empty()) {
      route.waypoints.back().X_WP.a = ahead;
      route.waypoints.back().turn = turn;
    } else if (turn && length > options.distance_epsilon) {
      route.waypoints.push_back({{from.x, from.y, 0, ahead}, true});
    }
    route.waypoints.push_back({{to.x, to.y, 0, ahead}});
    route.length += length;
    heading = ahead;
    from = to;
  }
  route.waypoints.back() = {X_WT, true};
  return route;
}

FollowOut follow_path(const WavefrontOptions& options, const FollowIn& in, FollowMemory& memory) {
  FollowOut& out = memory.out;
  double slack = 1;
  bool may_have_given_up = false;
  use_map(options, in, memory);
  look(options, in, memory);
  if (memory.goal != in.goal) memory.blocked_since.reset();
  if (memory.goal != in.goal || strayed(options, in, memory) || is_news_in_the_way(in, memory)) {
    plan_again(options, in, memory);
  } else if (may_be_shorter(in, memory)) {
    plan_shorter(options, in, memory);
  } else if (out.route != nullptr && !out.done() && in.enabled && stands(in, memory)) {
    if (reached(options, out.route->waypoints[out.waypoint], in.X_WR, kStillSlack)) {
      slack = kStillSlack;
    } else {  // the device that drives
      may_have_given_up = true;
      if (replans(options)) plan_again(options, in, memory);
      memory.X_OP.reset();
    }
  }
  out.may_pass = memory.blocked_since && in.time - *memory.blocked_since < options.sight.lasts;
  out.X_OP.reset();
  out.again = false;
  if (out.route == nullptr || !in.enabled) return out;
  const std::vector<Waypoint>& waypoints = out.route->waypoints;
  for (; !out.done() && reached(options, waypoints[out.waypoint], in.X_WR, slack); ++out.waypoint) slack = 1;
  if (!out.done()) out.X_OP = news(options, in, memory);
  out.again = may_have_given_up && out.X_OP;
  return out;
}

}  // namespace playhouse::drivers
