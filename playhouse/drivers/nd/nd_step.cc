#include "playhouse/drivers/nd/nd_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/drivers/nd/nd_diagram.h"
#include "playhouse/drivers/nd/nd_guard.h"

namespace playhouse::drivers {
namespace {

using geom::normalize;
using geom::radians;
using geom::Vec2;

constexpr double kSonarHalfCone = radians(10);      // of the directions in which an echo may be
constexpr double kSonarPointsApart = radians(2.5);  // on its arc
constexpr double kPassing = 0.05;                   // m; beside the body, for a gap to be passable
constexpr double kAway = radians(135);              // from an obstacle that touches: the direction of motion
constexpr double kFullTurn = radians(45);           // heading error with the maximum turn rate
constexpr double kBehind = radians(120);            // heading error from which both senses of a turn will do
constexpr double kNoForward = radians(75);          // heading error from which it turns in place
constexpr double kSlowing = 1;                      // s; speed before the goal is distance / this
constexpr double kTurned = radians(1);              // progress of a turn

double length(Vec2 p) {
  return std::sqrt(dot(p, p));
}

/// Points on the arc where an echo may be; one, if the cone is as narrow as a beam.
void add_echo(const ScanEye& eye, double range, const geom::Pose& X_OR, std::vector<Vec2>& points) {
  const geom::Pose X_OS = geom::compose(X_OR, eye.X_RS);
  const double half = std::min(eye.half_width, kSonarHalfCone);
  const int most =
      static_cast<int>(std::floor(half / kSonarPointsApart + 0.5));  // to each side of its middle
  for (int k = -most; k <= most; ++k) {
    const double angle = normalize(X_OS.a + (most == 0 ? 0 : k * half / most));
    points.push_back(X_OS.xy() + geom::Rotation::of(angle) * Vec2{range, 0});
  }
}

std::vector<Vec2> points_of(const NdOptions& options, const RangeScan& scan, const geom::Pose& X_OR) {
  const auto is_bad = [&](std::size_t i) {
    return std::ranges::find(options.bad_sonars, static_cast<int>(i)) != options.bad_sonars.end();
  };
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    if (range >= scan.max_range || range >= kNdSight) continue;
    if (!scan.is_ring()) {
      points.push_back(geom::transform(X_OR, end_of_beam(scan, i)));
    } else if (!is_bad(i)) {
      add_echo(scan.eyes[i], range, X_OR, points);
    }
  }
  return points;
}

/// Keeps the points of new scans. False if one cannot be used.
bool take_scans(const NdOptions& options, const NdIn& in, NdMemory& memory) {
  memory.points.resize(in.scans.size());
  for (std::size_t device = 0; device < in.scans.size(); ++device) {
    const std::optional<RangeScan>& scan = in.scans[device];
    if (!scan) continue;
    if (!is_usable(*scan) || !std::ranges::all_of(scan->ranges, [](float range) { return range >= 0; }))
      return false;
    std::deque<std::vector<Vec2>>& kept = memory.points[device];
    kept.push_back(points_of(options, *scan, in.X_OR));
    const int most = scan->is_ring() ? options.sonar_buffer : options.laser_buffer;
    while (kept.size() > static_cast<std::size_t>(most)) kept.pop_front();
  }
  return true;
}

NdDiagram diagram_of(const geom::Box& body, const geom::Pose& X_OR, const NdMemory& memory) {
  NdDiagram diagram(body);
  const geom::Rotation R_OR = geom::Rotation::of(X_OR.a);
  for (const std::deque<std::vector<Vec2>>& scans : memory.points) {
    for (const std::vector<Vec2>& points : scans)
      for (const Vec2 p_OC : points) diagram.add(R_OR.inverse(p_OC - X_OR.xy()));
  }
  return diagram;
}

/// Turn rate proportional to the heading error, with a minimum when turning in place.
double turn_rate(const NdOptions& options, double off, double speed) {
  const double rate = std::clamp(off / kFullTurn, -1.0, 1.0) * options.max_turn_rate;
  if (speed > 0 || off == 0) return rate;
  return off > 0 ? std::max(rate, options.min_turn_rate) : std::min(rate, -options.min_turn_rate);
}

/// An obstacle of the security zone.
struct Danger {
  double bearing = 0;   // rad
  double nearness = 0;  // 0 at the edge of the zone, 1 where it touches
};

/// The obstacles of the zone that count: not those beyond the goal.
std::vector<Danger> find_dangers(const NdDiagram& diagram, double zone, double reach) {
  std::vector<Danger> dangers;
  for (const NdSector& sector : diagram.sectors()) {
    if (sector.occupied() && sector.clearance < zone && length(sector.nearest) <= reach)
      dangers.push_back({geom::atan2(sector.nearest.y, sector.nearest.x), 1 - sector.clearance / zone});
  }
  return dangers;
}

/// How much an obstacle is in the way of a motion: its nearness if it is right ahead, 0 if it is behind.
double hindrance(const Danger& danger, double direction) {
  return danger.nearness * std::max(0.0, 1 - std::abs(normalize(danger.bearing - direction)) / kAway);
}

/// Turns of a direction away from the obstacles on its sides.
struct Avoidance {
  double to_left = 0, to_right = 0;  // rad
};

Avoidance avoid(const std::vector<Danger>& dangers, double direction) {
  Avoidance avoidance;
  for (const Danger& danger : dangers) {
    const bool on_right = normalize(danger.bearing - direction) < 0;
    double& turn = on_right ? avoidance.to_left : avoidance.to_right;
    turn = std::max(turn, kAway * hindrance(danger, direction));
  }
  return avoidance;
}

/// 1: nothing of the zone is in the way of a motion; 0: something touches that is right ahead.
double safety(const std::vector<Danger>& dangers, double direction) {
  double most = 0;
  for (const Danger& danger : dangers) most = std::max(most, hindrance(danger, direction));
  return 1 - most;
}

NdSituation situation_of(const NdRegion& region, const Avoidance& avoidance) {
  if (avoidance.to_left > 0 && avoidance.to_right > 0) return NdSituation::kLowSafetyBothSides;
  if (avoidance.to_left > 0 || avoidance.to_right > 0) return NdSituation::kLowSafetyOneSide;
  if (region.has_goal) return NdSituation::kHighSafetyGoalInRegion;
  return region.wide ? NdSituation::kHighSafetyWideRegion : NdSituation::kHighSafetyNarrowRegion;
}

/// Turns in place where the body has room. To an aim behind it keeps the sense of the last turn: which side
/// is nearer to the aim changes while it turns.
double turn_in_place(const NdOptions& options, const NdDiagram& diagram, const geom::Box& body, double off,
                     double last_rate) {
  const bool behind = std::abs(off) > kBehind;
  const double rate = turn_rate(options, behind && off * last_rate < 0 ? -off : off, 0);
  const double room = guarded(diagram, body, {0, rate}).turn_rate;
  return room == 0 && behind ? guarded(diagram, body, {0, -rate}).turn_rate : room;
}

/// Drives in a direction; turns in place to one that is not ahead.
NdVelocity velocity_towards(const NdOptions& options, const NdDiagram& diagram, const geom::Box& body,
                            double off, double fastest, double last_rate) {
  const double ahead = 1 - std::abs(off) / kNoForward;
  if (ahead > 0) {
    const double speed = std::max(options.min_speed, fastest * ahead);
    return guarded(diagram, body, {speed, turn_rate(options, off, speed)});
  }
  const double rate = turn_in_place(options, diagram, body, off, last_rate);
  if (rate != 0) return {0, rate};
  return guarded(diagram, body, {options.min_speed, 0});  // to where it has room to turn
}

NdOut drive_to_goal(const NdOptions& options, const NdDiagram& diagram, const geom::Box& body, const NdIn& in,
                    NdMemory& memory) {
  const Vec2 p_RG = geom::Rotation::of(in.X_OR.a).inverse(in.X_OG.xy() - in.X_OR.xy());
  const double distance = length(p_RG);
  NdWay way;
  way.radius = std::max(body.y_max, -body.y_min) + kPassing;
  way.spare = kPassing;
  way.avoid_distance = options.avoid_distance;
  way.p_RG = ((distance - options.goal_distance) / distance) * p_RG;  // where the tolerance begins
  if (memory.direction) way.last = normalize(*memory.direction - in.X_OR.a);
  const std::optional<NdRegion> region = choose_region(diagram, way);
  if (!region) {
    memory.direction.reset();
    return {0, turn_in_place(options, diagram, body, geom::atan2(p_RG.y, p_RG.x), memory.turn_rate),
            NdSituation::kBlocked};
  }
  memory.direction = normalize(region->direction + in.X_OR.a);

  const std::vector<Danger> dangers = find_dangers(diagram, options.avoid_distance, distance + body.x_max);
  const Avoidance avoidance = avoid(dangers, region->direction);
  const double off = normalize(region->direction + avoidance.to_left - avoidance.to_right);
  const double fastest = std::min(options.max_speed * safety(dangers, off), distance / kSlowing);
  const NdVelocity velocity = velocity_towards(options, diagram, body, off, fastest, memory.turn_rate);
  return {velocity.speed, velocity.turn_rate, situation_of(*region, avoidance)};
}

/// True if the robot has not got on for too long; when it gets on, the reference is replaced.
bool is_stuck(const NdOptions& options, const NdIn& in, bool turning, NdMemory& memory) {
  const bool other_aim = !memory.progress || memory.progress->turning != turning;
  if (other_aim) memory.progress = NdProgress{turning, in.X_OR, in.time};
  NdProgress& since = *memory.progress;
  const auto to_heading = [&](const geom::Pose& X_OR) { return std::abs(normalize(in.X_OG.a - X_OR.a)); };
  const bool got_on =
      turning ? to_heading(in.X_OR) <= to_heading(since.X_OR) - kTurned
              : length(in.X_OR.xy() - since.X_OR.xy()) >= options.translate_stuck_distance ||
                    std::abs(normalize(in.X_OR.a - since.X_OR.a)) >= options.translate_stuck_angle;
  if (got_on) since = {turning, in.X_OR, in.time};
  return in.time - since.time > (turning ? options.rotate_stuck_time : options.translate_stuck_time);
}

/// A time of waiting does not count as time without progress.
NdOut wait_for_end_of_stall(const NdIn& in, NdMemory& memory) {
  if (memory.progress) memory.progress->time += std::max(0.0, in.time - memory.time);
  return {};
}

NdOut decide(const NdOptions& options, const NdRobot& robot, const NdIn& in, NdMemory& memory) {
  const bool usable = take_scans(options, in, memory);
  if (in.stall && options.wait_on_stall) return wait_for_end_of_stall(in, memory);
  const double heading_off = normalize(in.X_OG.a - in.X_OR.a);
  const bool near = length(in.X_OG.xy() - in.X_OR.xy()) <= options.goal_distance;
  if (near && std::abs(heading_off) <= options.goal_angle) return {0, 0, NdSituation::kAtGoal, true};
  const bool turns_on = near && memory.progress && memory.progress->turning;
  if (is_stuck(options, in, near, memory)) return {0, 0, NdSituation::kStuck, false, true};
  if (!usable) return {};
  const geom::Box body = robot.body.grown(options.safety_distance);
  const NdDiagram diagram = diagram_of(body, in.X_OR, memory);
  if (near) {
    const double last_rate = turns_on ? memory.turn_rate : 0;
    return {0, turn_in_place(options, diagram, body, heading_off, last_rate), NdSituation::kAtGoal};
  }
  return drive_to_goal(options, diagram, body, in, memory);
}

}  // namespace

NdOut nd_step(const NdOptions& options, const NdRobot& robot, const NdIn& in, NdMemory& memory) {
  const NdOut out = decide(options, robot, in, memory);
  memory.time = in.time;
  memory.turn_rate = out.turn_rate;
  return out;
}

}  // namespace playhouse::drivers
