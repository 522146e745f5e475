#include "playhouse/controllers/ways.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <utility>

namespace playhouse::controllers {
namespace {

using geom::Vec2;

constexpr double kSide = 0.2;    // m, cell size
constexpr double kCells = 1000;  // cells per side, at most: larger floors have larger cells
constexpr double kMargin = 2;    // m, of floor around all outlines
constexpr double kBeside = 0.4;  // m beyond the clearance with a higher cost
constexpr double kLane = 0.8;    // m, to either side of where others come
constexpr std::uint8_t kFree = 1, kNarrow = 3, kOncoming = 4, kBlocked = 0;  // costs of a step
constexpr int kAhead = 4;            // cells that a robot looks ahead on its way
constexpr std::int64_t kAstray = 3;  // cells, at most, to the way
constexpr std::uint32_t kNoWay = std::numeric_limits<std::uint32_t>::max();

struct Line {
  Vec2 from, to;
};

void add_loop(std::span<const Vec2> loop_B, const geom::Pose& X_WB, std::vector<Line>& lines) {
  const geom::Rotation turn = geom::Rotation::of(X_WB.a);
  for (std::size_t k = 0; k < loop_B.size(); ++k)
    lines.push_back({X_WB.xy() + turn * loop_B[k], X_WB.xy() + turn * loop_B[(k + 1) % loop_B.size()]});
}

/// Outlines of static models that robots collide with or sense, between the floor and `height`. [m, W]
std::vector<Line> outlines(const world::World& world, double height) {
  std::vector<Line> lines;
  for (const world::ModelRow row : world.models.rows()) {
    const scene::ModelDesc& desc = world.desc(row);
    if (world.models.mobility[row] != world::Mobility::kFixed) continue;
    if (!desc.obstacle_return && desc.ranger_return < 0) continue;
    const geom::Pose X_WB = geom::compose(world.models.X_WM[row], desc.X_MB);
    const auto stands = [&](const auto& body) {
      return X_WB.z + body.z_min < height && X_WB.z + body.z_max > 0;
    };
    for (const scene::Block& block : desc.blocks)
      if (stands(block)) add_loop(block.points, X_WB, lines);
    for (const scene::Contours& bitmap : desc.bitmaps)
      if (stands(bitmap))
        for (const std::vector<Vec2>& loop : bitmap.loops) add_loop(loop, X_WB, lines);
  }
  return lines;
}

double length(Vec2 v) {
  return std::sqrt(geom::dot(v, v));
}

}  // namespace

Ways::Ways(const world::World& world, Vec2 place_W, double reach, double clearance, double height,
           const std::vector<Vec2>& oncoming_W)
    : place_W_(place_W) {
  const std::vector<Line> lines = outlines(world, height);
  Vec2 low = place_W, high = place_W;
  for (const Line& line : lines) {
    low = {std::min(low.x, line.from.x), std::min(low.y, line.from.y)};
    high = {std::max(high.x, line.from.x), std::max(high.y, line.from.y)};
  }
  corner_W_ = low - Vec2{kMargin, kMargin};
  const Vec2 extent = high - low + Vec2{2 * kMargin, 2 * kMargin};
  side_ = std::max(kSide, std::max(extent.x, extent.y) / kCells);
  columns_ = static_cast<std::int64_t>(extent.x / side_) + 1;
  rows_ = static_cast<std::int64_t>(extent.y / side_) + 1;
  cost_.assign(static_cast<std::size_t>(columns_ * rows_), kFree);
  for (const Line& line : lines) mark(line.from, line.to, clearance + kBeside, kNarrow);
  for (const Vec2 p_W : oncoming_W) mark(p_W, p_W, kLane, kOncoming);
  for (const Line& line : lines) mark(line.from, line.to, clearance, kBlocked);
  search(reach);
}

Ways::Cell Ways::cell_at(Vec2 p_W) const {
  const Vec2 p = p_W - corner_W_;
  const auto within = [this](double at, std::int64_t count) {
    return static_cast<std::int64_t>(std::clamp(at / side_, 0.0, static_cast<double>(count - 1)));
  };
  return {within(p.x, columns_), within(p.y, rows_)};
}

Vec2 Ways::centre(Cell cell) const {
  return corner_W_ + side_ * Vec2{static_cast<double>(cell.x) + 0.5, static_cast<double>(cell.y) + 0.5};
}

/// Sets the cost of cells with their centre within `around` of a line.
void Ways::mark(Vec2 from_W, Vec2 to_W, double around, std::uint8_t cost) {
  const auto steps = static_cast<std::int64_t>(length(to_W - from_W) / (side_ / 2)) + 1;
  const auto cells = static_cast<std::int64_t>(around / side_) + 1;
  for (std::int64_t step = 0; step < steps; ++step) {
    const Vec2 p_W = from_W + (static_cast<double>(step) / static_cast<double>(steps)) * (to_W - from_W);
    const Cell at = cell_at(p_W);
    for (std::int64_t y = at.y - cells; y <= at.y + cells; ++y)
      for (std::int64_t x = at.x - cells; x <= at.x + cells; ++x)
        if (is_floor({x, y}) && length(centre({x, y}) - p_W) <= around) cost_[number({x, y})] = cost;
  }
}

/// Dijkstra from all cells within reach;
/// ties are broken by cell number.
void Ways::search(double reach) {
  using Entry = std::pair<std::uint32_t, std::uint32_t>;  // cost so far, number
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<std::uint32_t> best(cost_.size(), kNoWay);
  next_.assign(cost_.size(), kNoWay);
  for (Cell cell; cell.y < rows_; ++cell.y)
    for (cell.x = 0; cell.x < columns_; ++cell.x)
      if (const std::uint32_t at = number(cell); cost_[at] && length(centre(cell) - place_W_) < reach) {
        best[at] = 0;
        next_[at] = at;
        open.push({0, at});
      }
  while (!open.empty()) {
    const auto [way, at] = open.top();
    open.pop();
    if (way > best[at]) continue;
    const Cell cell{at % columns_, at / columns_};
    for (std::int64_t dy = -1; dy <= 1; ++dy)
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        const Cell to{cell.x + dx, cell.y + dy};
        if (!is_floor(to) || cost_[number(to)] == kBlocked) continue;
        const std::uint32_t longer = way + cost_[number(to)] * (dx != 0 && dy != 0 ? 7u : 5u);
        if (longer >= best[number(to)]) continue;
        best[number(to)] = longer;
        next_[number(to)] = at;
        open.push({longer, number(to)});
      }
  }
}

std::optional<Ways::Cell> Ways::nearest_with_way(Cell from) const {
  std::optional<Cell> nearest;
  for (std::int64_t dy = -kAstray; dy <= kAstray; ++dy)
    for (std::int64_t dx = -kAstray; dx <= kAstray; ++dx) {
      const Cell cell{from.x + dx, from.y + dy};
      if (!is_floor(cell) || next_[number(cell)] == kNoWay) continue;
      const auto off = [&](Cell at) {
        return (at.x - from.x) * (at.x - from.x) + (at.y - from.y) * (at.y - from.y);
      };
      if (!nearest || off(cell) < off(*nearest)) nearest = cell;
    }
  return nearest;
}

std::vector<Vec2> Ways::route(Vec2 p_W) const {
  std::vector<Vec2> places;
  const std::optional<Cell> from = nearest_with_way(cell_at(p_W));
  if (!from) return places;
  for (std::uint32_t at = number(*from);; at = next_[at]) {
    places.push_back(centre({at % columns_, at / columns_}));
    if (next_[at] == at) return places;
  }
}

std::optional<Vec2> Ways::next(Vec2 p_W) const {
  const std::optional<Cell> from = nearest_with_way(cell_at(p_W));
  if (!from) return std::nullopt;
  std::uint32_t at = number(*from);
  for (int step = 0; step < kAhead; ++step) at = next_[at];
  return next_[at] == at ? place_W_ : centre({at % columns_, at / columns_});
}

}  // namespace playhouse::controllers
