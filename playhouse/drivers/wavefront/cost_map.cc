#include "playhouse/drivers/wavefront/cost_map.h"

#include <algorithm>
#include <cmath>

#include "playhouse/drivers/grid_map/distances.h"

namespace playhouse::drivers {
namespace {

constexpr double kCellRounding = 1e-4;  // cells; the wire's cell size has 24 bits

/// Weight of a cell that is no obstacle, so far from the nearest one. [cells]
std::uint16_t weight_at(double distance, double scale, const PlanOptions& options) {
  if (is_too_near(distance, scale, options)) return CostMap::kNear;
  const double clearance = distance - 0.5;
  const double safety = options.safety_distance / scale, most = options.max_radius / scale;
  const double nearness = most > safety ? std::clamp((most - clearance) / (most - safety), 0.0, 1.0) : 0;
  return static_cast<std::uint16_t>(std::floor(CostMap::kPlain * (1 + options.penalty * nearness) + 0.5));
}

/// The cells with the border, as obstacles and others.
CostMap obstacles_of(const GridMap& grid) {
  CostMap map{grid.width() + 2, grid.height() + 2, grid.info.scale, {}};
  map.weights.assign(map.count(), CostMap::kObstacle);
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x)
      if (grid.cells[static_cast<std::size_t>(y) * grid.info.width + static_cast<std::size_t>(x)] < 0)
        map.weights[map.cell(x + 1, y + 1)] = CostMap::kPlain;
  return map;
}

}  // namespace

std::optional<CellIndex> CostMap::cell_of(geom::Vec2 p_G) const {
  const double x = std::floor(p_G.x / scale) + 1, y = std::floor(p_G.y / scale) + 1;
  if (!(x >= 1 && y >= 1 && x <= width - 2 && y <= height - 2)) return std::nullopt;
  return cell(static_cast<int>(x), static_cast<int>(y));
}

bool is_too_near(double cells, double scale, const PlanOptions& options) {
  return cells - 0.5 < options.safety_distance / scale - kCellRounding;
}

CostMap cost_map(const GridMap& grid, const PlanOptions& options) {
  CostMap map = obstacles_of(grid);
  const std::vector<std::uint32_t> squares = squares_from_obstacles(map);
  for (CellIndex cell = 0; cell < squares.size(); ++cell) {
    if (map.weights[cell] == CostMap::kObstacle) continue;
    map.weights[cell] = weight_at(std::sqrt(static_cast<double>(squares[cell])), map.scale, options);
  }
  return map;
}

std::vector<std::uint32_t> squares_from_obstacles(const CostMap& map) {
  std::vector<std::uint8_t> obstacles;
  obstacles.reserve(map.count());
  for (const std::uint16_t weight : map.weights) obstacles.push_back(weight == CostMap::kObstacle ? 1 : 0);
  return squared_distances(map.width, map.height, obstacles);
}

std::uint32_t dearest_step(const CostMap& map) {
  return 2 * std::uint32_t{*std::ranges::max_element(map.weights)} * 181 / 128;
}

}  // namespace playhouse::drivers
