#include "playhouse/drivers/vfh/vfh_step.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace playhouse::drivers {
namespace {

using geom::kPi;
using geom::normalize;
using geom::Vec2;

constexpr double kSight = 3;                        // m; range of consideration
constexpr double kWideOpening = geom::radians(80);  // smaller openings are narrow
constexpr double kFullTurn = geom::radians(45);     // heading error with the maximum turn rate
constexpr double kNoForward = geom::radians(90);    // heading error from which it turns in place
constexpr double kRest = 0.01;                      // m/s; below: turning in place

constexpr double kNothing = 1e9;  // m; range of a miss

/// A window cell that is occupied or hidden by an obstacle.
struct Cell {
  Vec2 p_RC;
  double distance = 0;
  double magnitude = 0;  // contribution to the histogram
};

/// The beams of one eye of a usable scan, with access by angle.
class Fan {
 public:
  Fan(const RangeScan& scan, std::size_t eye)
      : beams_(std::span(scan.ranges).subspan(eye * scan.beams(), scan.beams())),
        max_range_(scan.max_range),
        half_width_(scan.eyes[eye].half_width),
        step_(scan.angle_step),
        span_(scan.angle(scan.beams() - 1) - scan.first_angle),
        middle_(scan.first_angle + span_ / 2),
        p_RS_(scan.eyes[eye].X_RS.xy()),
        heading_(scan.eyes[eye].X_RS.a),
        R_RS_(geom::Rotation::of(heading_)) {}

  /// True if it sees an obstacle in a cell or before it.
  bool fills(Vec2 p_RC, double half_cell) const {
    const Vec2 p_SC = R_RS_.inverse(p_RC - p_RS_);
    const double seen_at = std::sqrt(dot(p_SC, p_SC));
    if (seen_at < half_cell) return false;
    const double bearing = geom::atan2(p_SC.y, p_SC.x), half = geom::atan2(half_cell, seen_at);
    return shows(bearing, half) && range(bearing, half) < seen_at + half_cell;
  }
  /// True if this direction of the robot, within `tolerance`, is inside the field of view.
  bool looks_to(double direction, double tolerance) const { return shows(direction - heading_, tolerance); }

 private:
  bool shows(double bearing, double tolerance) const {
    return std::abs(normalize(bearing - middle_)) <= span_ / 2 + std::max(tolerance, half_width_);
  }
  /// Minimum range within `half` of a bearing, at least of the nearest beam.
  double range(double bearing, double half) const {
    if (beams_.size() == 1) return beam(0);
    const double place = (normalize(bearing - middle_) + span_ / 2) / step_;
    const double last = static_cast<double>(beams_.size() - 1);
    const auto index = [last](double at) { return static_cast<std::size_t>(std::clamp(at, 0.0, last)); };
    double least = beam(index(std::floor(place + 0.5)));
    for (std::size_t i = index(std::ceil(place - half / step_)); i <= index(place + half / step_); ++i)
      least = std::min(least, beam(i));
    return least;
  }
  double beam(std::size_t index) const {
    const double range = beams_[index];
    if (range >= max_range_) return kNothing;
    return range >= 0 ? range : 0;  // also for NaN
  }

  std::span<const float> beams_;
  double max_range_;                          // m
  double half_width_, step_, span_, middle_;  // rad
  Vec2 p_RS_;
  double heading_;  // in R [rad]
  geom::Rotation R_RS_;
};

std::vector<Fan> fans_of(const RangeScan& scan) {
  std::vector<Fan> fans;
  fans.reserve(scan.eyes.size());
  for (std::size_t eye = 0; eye < scan.eyes.size(); ++eye) fans.emplace_back(scan, eye);
  return fans;
}

/// Occupied and hidden cells within `reach`.
std::vector<Cell> filled_cells(const VfhOptions& options, std::span<const Fan> fans, double reach) {
  const double half_cell = options.cell_size / 2;
  const double edge = (options.window - 1) / 2.0;
  std::vector<Cell> cells;
  for (int row = 0; row < options.window; ++row) {
    for (int column = 0; column < options.window; ++column) {
      const Vec2 p_RC{(column - edge) * options.cell_size, (row - edge) * options.cell_size};
      const double distance = std::sqrt(dot(p_RC, p_RC));
      if (distance < half_cell || distance >= std::min(kSight, reach)) continue;
      if (std::ranges::none_of(fans, [&](const Fan& fan) { return fan.fills(p_RC, half_cell); })) continue;
      const double depth = (kSight - distance) * (kSight - distance);
      cells.push_back({p_RC, distance, 1e4 * depth * depth});
    }
  }
  return cells;
}

/// Bearing of a sector from the robot. Sectors are
/// fixed in O, to be comparable between steps.
double bearing_of(int sector, const VfhOptions& options, const VfhIn& in) {
  return normalize(sector * geom::kTwoPi / options.sectors - in.X_OR.a);
}

/// Polar histogram of obstacles: a cell counts in a direction
/// if the robot, enlarged by `radius`, would touch its centre.
std::vector<double> histogram(const VfhOptions& options, const VfhIn& in, std::span<const Cell> cells,
                              double radius) {
  std::vector<double> sums(static_cast<std::size_t>(options.sectors));
  for (int sector = 0; sector < options.sectors; ++sector) {
    const geom::Rotation ahead = geom::Rotation::of(bearing_of(sector, options, in));
    double& sum = sums[static_cast<std::size_t>(sector)];
    for (const Cell& cell : cells) {
      const Vec2 seen = ahead.inverse(cell.p_RC);
      if (seen.x > 0 && std::abs(seen.y) <= radius) sum += cell.magnitude;
    }
  }
  return sums;
}

/// Limits of heading changes while moving, by collision of the turning circles with cells.
struct Turns {
  double right = -kPi, left = kPi;  // rad, about its heading
};

Turns possible_turns(const VfhOptions& options, std::span<const Cell> cells, double speed, double radius) {
  Turns turns;
  const double rate = options.max_turn_rate.at(speed);
  if (speed < kRest || rate <= 0) return turns;
  const double turn = options.turn_radius_factor * speed / rate;
  const double touching = (turn + radius) * (turn + radius);
  for (const Cell& cell : cells) {
    const double bearing = geom::atan2(cell.p_RC.y, cell.p_RC.x);
    const Vec2 from_left = cell.p_RC - Vec2{0, turn}, from_right = cell.p_RC - Vec2{0, -turn};
    if (bearing > 0 && dot(from_left, from_left) < touching) turns.left = std::min(turns.left, bearing);
    if (bearing < 0 && dot(from_right, from_right) < touching) turns.right = std::max(turns.right, bearing);
  }
  return turns;
}

/// Candidate sectors: free, visible and reachable. Updates `blocked` (hysteresis).
std::vector<std::uint8_t> open_sectors(const VfhOptions& options, const VfhIn& in, std::span<const Fan> fans,
                                       std::span<const Cell> cells, double radius,
                                       std::vector<std::uint8_t>& blocked) {
  const double speed = std::max(0.0, in.speed);
  const double free_below = options.free_cutoff.at(speed), blocked_above = options.blocked_cutoff.at(speed);
  const std::vector<double> sums = histogram(options, in, cells, radius);
  const Turns turns = possible_turns(options, cells, speed, radius);
  blocked.resize(sums.size());
  std::vector<std::uint8_t> open(sums.size());
  for (std::size_t sector = 0; sector < sums.size(); ++sector) {
    if (sums[sector] > blocked_above) {
      blocked[sector] = 1;
    } else if (sums[sector] <= free_below) {
      blocked[sector] = 0;
    }
    const double bearing = bearing_of(static_cast<int>(sector), options, in);
    const auto looks_there = [&](const Fan& fan) { return fan.looks_to(bearing, kPi / options.sectors); };
    open[sector] = blocked[sector] == 0 && bearing >= turns.right && bearing <= turns.left &&
                   std::ranges::any_of(fans, looks_there);
  }
  return open;
}

struct Candidate {
  double direction = 0;  // in O [rad]
  double max_speed = 0;  // m/s
};

/// Candidate directions of an opening, from its right edge to its left.
void add_candidates(const VfhOptions& options, double right, double left, double wanted,
                    std::vector<Candidate>& candidates) {
  if (left - right < kWideOpening) {
    candidates.push_back({(right + left) / 2, options.max_speed_narrow});
    return;
  }
  const double first = right + kWideOpening / 2, last = left - kWideOpening / 2;
  candidates.push_back({first, options.max_speed_wide});
  candidates.push_back({last, options.max_speed_wide});
  const double middle = (first + last) / 2, off = normalize(wanted - middle);
  if (std::abs(off) <= (last - first) / 2) candidates.push_back({middle + off, options.max_speed_wide});
}

std::vector<Candidate> find_candidates(const VfhOptions& options, std::span<const std::uint8_t> open,
                                       double wanted) {
  const double width = geom::kTwoPi / options.sectors;
  const std::size_t count = open.size();
  const auto first_shut = static_cast<std::size_t>(std::ranges::find(open, 0) - open.begin());
  if (first_shut == count) return {{wanted, options.max_speed_wide}};
  std::vector<Candidate> candidates;
  std::size_t length = 0;  // of the current opening, in sectors
  for (std::size_t i = first_shut + 1; i <= first_shut + count; ++i) {
    if (open[i % count] != 0) {
      ++length;
    } else if (length > 0) {
      const double left = static_cast<double>(i - 1) * width;
      add_candidates(options, left - static_cast<double>(length - 1) * width, left, wanted, candidates);
      length = 0;
    }
  }
  return candidates;
}

std::optional<Candidate> choose(const VfhOptions& options, std::span<const Candidate> candidates,
                                double wanted, double current) {
  const auto cost = [&](const Candidate& candidate) {
    return options.weight_desired * std::abs(normalize(candidate.direction - wanted)) +
           options.weight_current * std::abs(normalize(candidate.direction - current));
  };
  const auto best = std::ranges::min_element(candidates, {}, cost);
  if (best == candidates.end()) return std::nullopt;
  return *best;
}

/// Turn rate proportional to the heading error, with a minimum when turning in place.
double turn_rate(const VfhOptions& options, double off, double speed) {
  const double most = std::max(0.0, options.max_turn_rate.at(speed));
  const double rate = std::clamp(off / kFullTurn, -1.0, 1.0) * most;
  if (speed > 0 || off == 0) return rate;
  const double least = std::min(options.min_turn_rate, most);
  return off > 0 ? std::max(rate, least) : std::min(rate, -least);
}

/// The highest speed that allows stopping within `room`.
double stopping_speed(const VfhOptions& options, double room) {
  return std::sqrt(2 * options.max_acceleration * std::max(0.0, room));
}

/// Free distance straight ahead.
double room_ahead(std::span<const Cell> cells, double radius) {
  double room = kSight;
  for (const Cell& cell : cells)
    if (cell.p_RC.x > 0 && std::abs(cell.p_RC.y) <= radius) room = std::min(room, cell.p_RC.x - radius);
  return room;
}

VfhOut turn_to_goal(const VfhOptions& options, const VfhIn& in) {
  const double off = normalize(in.X_OG.a - in.X_OR.a);
  if (std::abs(off) <= options.angle_epsilon) return {0, 0, true};
  return {0, turn_rate(options, off, 0)};
}

/// No free direction: turns in place, keeping the present sense.
VfhOut look_round(const VfhOptions& options, const VfhMemory& memory, double wanted) {
  const double side = memory.turn_rate != 0 ? memory.turn_rate : wanted;
  return {0, side < 0 ? -options.max_turn_rate.at_rest : options.max_turn_rate.at_rest};
}

VfhOut drive_to_goal(const VfhOptions& options, const VfhRobot& robot, const VfhIn& in, VfhMemory& memory) {
  if (!is_usable(in.scan)) return {};
  const std::vector<Fan> fans = fans_of(in.scan);
  const Vec2 way = in.X_OG.xy() - in.X_OR.xy();
  const double distance = std::sqrt(dot(way, way));
  const double radius = robot.radius + std::max(0.0, options.safety_distance.at(std::max(0.0, in.speed)));
  const std::vector<Cell> cells = filled_cells(options, fans, distance + radius);
  const std::vector<std::uint8_t> open = open_sectors(options, in, fans, cells, radius, memory.blocked);

  const double wanted = geom::atan2(way.y, way.x);
  const std::optional<Candidate> chosen =
      choose(options, find_candidates(options, open, wanted), wanted, memory.direction.value_or(in.X_OR.a));
  if (!chosen) return look_round(options, memory, normalize(wanted - in.X_OR.a));
  memory.direction = normalize(chosen->direction);

  const double off = normalize(chosen->direction - in.X_OR.a);
  const double elapsed = memory.time ? std::max(0.0, in.time - *memory.time) : 0;
  const double speed = std::min(
      {std::min(options.max_speed, chosen->max_speed) * std::max(0.0, 1 - std::abs(off) / kNoForward),
       stopping_speed(options, distance), stopping_speed(options, room_ahead(cells, radius)),
       memory.speed + options.max_acceleration * elapsed});
  return {speed, turn_rate(options, off, speed)};
}

/// Escape manoeuvre from a stall, alternating sides.
std::optional<VfhOut> escape(const VfhOptions& options, const VfhIn& in, VfhMemory& memory) {
  if (options.escape_speed == 0 || options.escape_time <= 0) return std::nullopt;
  if (in.stall && in.time >= memory.escape_end) {
    memory.escape_end = in.time + options.escape_time;
    ++memory.escapes;
  }
  if (memory.escapes == 0 || in.time >= memory.escape_end) return std::nullopt;
  return VfhOut{options.escape_speed,
                memory.escapes % 2 == 1 ? options.escape_turn_rate : -options.escape_turn_rate};
}

VfhOut decide(const VfhOptions& options, const VfhRobot& robot, const VfhIn& in, VfhMemory& memory) {
  const Vec2 way = in.X_OG.xy() - in.X_OR.xy();
  if (dot(way, way) <= options.distance_epsilon * options.distance_epsilon) return turn_to_goal(options, in);
  if (const std::optional<VfhOut> out = escape(options, in, memory)) return *out;
  return drive_to_goal(options, robot, in, memory);
}

}  // namespace

VfhOut vfh_step(const VfhOptions& options, const VfhRobot& robot, const VfhIn& in, VfhMemory& memory) {
  const VfhOut out = decide(options, robot, in, memory);
  memory.time = in.time;
  memory.speed = std::max(0.0, out.speed);
  memory.turn_rate = out.turn_rate;
  return out;
}

}  // namespace playhouse::drivers
