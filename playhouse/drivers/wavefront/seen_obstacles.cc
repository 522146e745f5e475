#include "playhouse/drivers/wavefront/seen_obstacles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace playhouse::drivers {
namespace {

using geom::Pose;
using geom::Vec2;

constexpr double kHalfDiagonal = 0.7072;  // of a cell

/// True of each cell whose centre is so near to an obstacle's edge that what is seen there is that one.
std::vector<bool> near_obstacles(const CostMap& map, double tolerance) {
  const std::vector<std::uint32_t> squares = squares_from_obstacles(map);
  std::vector<bool> near(squares.size());
  for (std::size_t cell = 0; cell < squares.size(); ++cell)
    near[cell] =
        squares[cell] == 0 || std::sqrt(static_cast<double>(squares[cell])) - 0.5 < tolerance / map.scale;
  return near;
}

/// Of the rows 0, 1 ... away from an obstacle: how many cells to each side of it are too near to it.
std::vector<int> reach_of(const CostMap& map, const PlanOptions& options) {
  const int most = std::max(map.width, map.height);
  const auto is_near = [&](double x, double y) {
    return x + y == 0 || is_too_near(std::sqrt(x * x + y * y), map.scale, options);
  };
  std::vector<int> reach;
  for (int x = most, y = 0; y < most; ++y) {
    while (x >= 0 && !is_near(x, y)) --x;
    if (x < 0) break;
    reach.push_back(x);
  }
  return reach;
}

/// True if there are beams of an eye that cross a cell at p_S, and all go on beyond it.
bool sees_through(const RangeScan& scan, std::size_t eye, Vec2 p_S, double scale) {
  const double distance = std::sqrt(dot(p_S, p_S));
  if (distance <= kHalfDiagonal * scale) return false;
  const auto beams = static_cast<double>(scan.beams());
  const double half_width = kHalfDiagonal * scale / distance, middle = (beams - 1) / 2;
  const double step = scan.beams() > 1 ? scan.angle_step : 1;
  const bool is_circle = step * (beams + 0.5) > 2 * geom::kPi;
  const double ahead = geom::normalize(geom::atan2(p_S.y, p_S.x) - scan.first_angle - middle * step);
  const double first = std::ceil(middle + (ahead - half_width) / step);
  const double last = std::floor(middle + (ahead + half_width) / step);
  if (!(first <= last && last - first < beams)) return false;
  if (!is_circle && (first < 0 || last >= beams)) return false;
  for (double i = first; i <= last; ++i) {
    const auto beam = static_cast<std::size_t>(i < 0 ? i + beams : i >= beams ? i - beams : i);
    if (!(scan.ranges[eye * scan.beams() + beam] > distance + scale)) return false;
  }
  return true;
}

}  // namespace

SeenObstacles::SeenObstacles(std::shared_ptr<const CostMap> map, const PlanOptions& options,
                             const SeenOptions& sight)
    : map_(std::move(map)),
      sight_(sight),
      costs_(*map_),
      on_map_(near_obstacles(*map_, sight.tolerance)),
      near_(map_->count()),
      reach_(reach_of(*map_, options)) {}

void SeenObstacles::pass_time(double time) {
  const bool went_back = time < time_;
  time_ = time;
  for (auto each = seen_.begin(); each != seen_.end();) {
    SeenCell& sighting = each->second;
    const double age = time - sighting.time;
    if (sighting.is_obstacle && (went_back || age > sighting.lasts)) {
      sighting.is_obstacle = false;
      unblock(each->first);
    }
    const bool is_long_ago = age > sighting.lasts + kMostPatience * sight_.lasts;
    each = went_back || is_long_ago ? seen_.erase(each) : std::next(each);
  }
}

void SeenObstacles::take(const RangeScan& scan, const Pose& X_GR) {
  if (!is_usable(scan)) return;
  see_through(scan, X_GR);
  const double most = std::min(scan.max_range, sight_.range);
  const geom::Rotation heading = geom::Rotation::of(X_GR.a);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (!(scan.ranges[i] > 0 && scan.ranges[i] < most)) continue;
    const std::optional<CellIndex> cell = map_->cell_of(X_GR.xy() + heading * end_of_beam(scan, i));
    if (cell && !on_map_[*cell]) see(*cell);
  }
}

void SeenObstacles::see_through(const RangeScan& scan, const Pose& X_GR) {
  for (std::size_t eye = 0; eye < scan.eyes.size() && !seen_.empty(); ++eye) {
    const Pose X_GS = compose(X_GR, scan.eyes[eye].X_RS);
    const geom::Rotation R_GS = geom::Rotation::of(X_GS.a);
    for (auto each = seen_.begin(); each != seen_.end();) {
      const Vec2 p_S = R_GS.inverse(map_->centre(each->first) - X_GS.xy());
      if (!sees_through(scan, eye, p_S, map_->scale)) {
        ++each;
        continue;
      }
      if (each->second.is_obstacle) unblock(each->first);
      each = seen_.erase(each);
    }
  }
}

const SeenObstacles::SeenCell* SeenObstacles::find(CellIndex cell) const {
  const auto found = seen_.find(cell);
  return found != seen_.end() && found->second.is_obstacle ? &found->second : nullptr;
}

void SeenObstacles::see(CellIndex cell) {
  const auto found = seen_.find(cell);
  if (found != seen_.end() && found->second.is_obstacle) {
    found->second.time = time_;
  } else if (found != seen_.end()) {
    found->second = {time_, std::min(2 * found->second.lasts, kMostPatience * sight_.lasts), true};
    block(cell);
  } else if (seen_.size() < kMostRemembered) {
    seen_[cell] = {time_, sight_.lasts, true};
    block(cell);
  }
}

template <typename Change>
void SeenObstacles::change_around(CellIndex cell, Change change) {
  const int x = map_->column(cell), y = map_->row(cell), rows = static_cast<int>(reach_.size());
  for (int v = std::max(0, y - rows + 1); v < std::min(map_->height, y + rows); ++v) {
    const int reach = reach_[static_cast<std::size_t>(std::abs(v - y))];
    for (int u = std::max(0, x - reach); u <= std::min(map_->width - 1, x + reach); ++u)
      change(map_->cell(u, v));
  }
}

void SeenObstacles::block(CellIndex cell) {
  ++obstacles_;
  ++come_;
  change_around(cell, [this](CellIndex near) {
    ++near_[near];
    costs_.weights[near] = std::min(costs_.weights[near], CostMap::kNear);
  });
  costs_.weights[cell] = CostMap::kObstacle;
}

void SeenObstacles::unblock(CellIndex cell) {
  --obstacles_;
  ++gone_;
  costs_.weights[cell] = std::min(map_->weights[cell], CostMap::kNear);
  change_around(cell, [this](CellIndex near) {
    if (--near_[near] == 0) costs_.weights[near] = map_->weights[near];
  });
}

}  // namespace playhouse::drivers
