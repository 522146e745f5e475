#include "playhouse/stage/walls.h"

#include <algorithm>

namespace playhouse::stage {
namespace {

constexpr double kBorder =
    1e-9;  // m; an edge this near to a cell is listed in it, so that rounding loses nothing

double length(const Walls::Edge& edge) {
  const Vec2 e = edge.b - edge.a;
  return std::sqrt(geom::dot(e, e));
}

/// Cells that hold a few typical edges, not so small that the long ones fill memory.
double cell_for(double total_length, std::size_t edges) {
  const double typical = total_length / static_cast<double>(edges);
  const double affordable = total_length / (8.0 * static_cast<double>(edges) + 65536.0);
  return std::clamp(2 * typical, std::max(0.1, affordable), std::max(2.0, affordable));
}

/// Enough that far apart places seldom share a cell: the whole extent where that is affordable.
std::size_t cells_for(const std::vector<Walls::Edge>& edges, double total_length, double cell) {
  geom::Box box;
  for (const Walls::Edge& edge : edges) {
    box.add(edge.a);
    box.add(edge.b);
  }
  const double across = std::max(box.x_max - box.x_min, box.y_max - box.y_min) / cell + 2;
  const double listings = static_cast<double>(edges.size()) + total_length / cell;
  return static_cast<std::size_t>(std::min(across * across, std::clamp(16 * listings, 65536.0, 4194304.0)));
}

}  // namespace

/// The cells an edge touches, row by row.
template <typename Visit>
void Walls::rasterise(const Edge& edge, const Visit& visit) const {
  const Vec2 low = edge.a.y <= edge.b.y ? edge.a : edge.b, high = edge.a.y <= edge.b.y ? edge.b : edge.a;
  const double rise = high.y - low.y, run = high.x - low.x;
  const std::int64_t y0 = torus_.along(low.y - kBorder), y1 = torus_.along(high.y + kBorder);
  for (std::int64_t cy = y0; cy <= y1; ++cy) {
    double from = low.x, to = high.x;
    if (y1 > y0 && rise > 0) {
      const double bottom = std::max(low.y, static_cast<double>(cy) * torus_.cell() - kBorder);
      const double top = std::min(high.y, static_cast<double>(cy + 1) * torus_.cell() + kBorder);
      from = low.x + run * std::clamp((bottom - low.y) / rise, 0.0, 1.0);
      to = low.x + run * std::clamp((top - low.y) / rise, 0.0, 1.0);
    }
    const std::int64_t x0 = torus_.along(std::min(from, to) - kBorder),
                       x1 = torus_.along(std::max(from, to) + kBorder);
    for (std::int64_t cx = x0; cx <= x1; ++cx) visit(torus_.index(cx, cy));
  }
}

Walls::Walls(const Solids& solids) {
  std::vector<Edge> all;
  double total_length = 0;
  for (std::size_t row = solids.moving; row < solids.size(); ++row) {
    const std::span<const Vec2> polygon = solids.polygon(row);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      all.push_back({polygon[i], polygon[(i + 1) % polygon.size()], static_cast<std::uint32_t>(row),
                     static_cast<std::uint32_t>(all.size())});
      total_length += length(all.back());
    }
  }
  edge_count_ = all.size();
  if (all.empty()) return;

  const double cell = cell_for(total_length, all.size());
  torus_ = Torus(cell, cells_for(all, total_length, cell));
  first_.assign(torus_.cells() + 1, 0);
  for (const Edge& edge : all) rasterise(edge, [&](std::size_t index) { ++first_[index + 1]; });
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  edges_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const Edge& edge : all) rasterise(edge, [&](std::size_t index) { edges_[next[index]++] = edge; });
  measure_clearance();
  if (all.size() <= kFew) few_ = all;
}

/// Along rows first, then across them; both wrap round.
void Walls::measure_clearance() {
  const auto side = static_cast<std::int64_t>(torus_.side());
  std::vector<std::uint8_t> along_row(torus_.cells(), kFarthest);
  for (std::int64_t y = 0; y < side; ++y) {
    int left = kFarthest, right = kFarthest;
    for (std::int64_t i = -kFarthest; i < side; ++i) {  // from before the row's begin, for what wraps
      const std::size_t up = torus_.index(i, y), down = torus_.index(side - 1 - i, y);
      left = first_[up] != first_[up + 1] ? 0 : std::min(left + 1, kFarthest);
      right = first_[down] != first_[down + 1] ? 0 : std::min(right + 1, kFarthest);
      along_row[up] = static_cast<std::uint8_t>(std::min<int>(along_row[up], left));
      along_row[down] = static_cast<std::uint8_t>(std::min<int>(along_row[down], right));
    }
  }
  clearance_.assign(torus_.cells(), kFarthest);
  for (std::int64_t y = 0; y < side; ++y) {
    std::uint8_t* const row = clearance_.data() + torus_.index(0, y);
    for (int dy = 1 - kFarthest; dy < kFarthest; ++dy) {
      const std::uint8_t* const other = along_row.data() + torus_.index(0, y + dy);
      const auto far = static_cast<std::uint8_t>(dy < 0 ? -dy : dy);
      for (std::int64_t x = 0; x < side; ++x) row[x] = std::min(row[x], std::max(other[x], far));
    }
  }
}

}  // namespace playhouse::stage
