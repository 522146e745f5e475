#include "playhouse/bodies/walls.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace playhouse::bodies {
namespace {

double length(const Walls::Edge& edge) {
  const Vec2 e = edge.b - edge.a;
  return std::sqrt(geom::dot(e, e));
}

/// Side of a cell in multiples of a typical edge. Small cells mean few failed tests per ray; but once
/// the grid outgrows the processor's caches, fewer and larger cells are faster (docs/benchmarks.md).
double edges_across(std::size_t edges) {
  constexpr std::size_t kInCaches = 16384;
  return edges <= kInCaches ? 1.5 : 6;
}

/// Side of a cell: a few typical edges, bounded below by memory for long edges. Bounded above
/// for scenes of long edges such as rooms, where a large cell would list every wall of its room.
double cell_for(double total_length, std::size_t edges) {
  constexpr double kLeast = 0.05, kMost = 0.5;  // m
  const double typical = total_length / static_cast<double>(edges);
  const double affordable = total_length / (static_cast<double>(edges) + 65536.0);
  return std::clamp(edges_across(edges) * typical, std::max(kLeast, affordable), std::max(kMost, affordable));
}

/// Number of cells: enough to make collisions on the torus rare, the whole extent if affordable.
std::size_t cells_for(const geom::Box& box, std::size_t edges, double total_length, double cell) {
  const double across = std::max(box.x_max - box.x_min, box.y_max - box.y_min) / cell + 2;
  const double listings = static_cast<double>(edges) + total_length / cell;
  return static_cast<std::size_t>(std::min(across * across, std::clamp(16 * listings, 65536.0, 16777216.0)));
}

}  // namespace

/// Visits the cells that an edge touches, row by row (conservative rasterisation).
template <typename Visit>
void Walls::rasterise(const Edge& edge, const Visit& visit) const {
  const Vec2 low = edge.a.y <= edge.b.y ? edge.a : edge.b, high = edge.a.y <= edge.b.y ? edge.b : edge.a;
  const double rise = high.y - low.y, run = high.x - low.x;
  const double border = kBorder * torus_.cell();
  const std::int64_t y0 = torus_.along(low.y - border), y1 = torus_.along(high.y + border);
  for (std::int64_t cy = y0; cy <= y1; ++cy) {
    double from = low.x, to = high.x;
    if (y1 > y0 && rise > 0) {
      const double bottom = std::max(low.y, static_cast<double>(cy) * torus_.cell() - border);
      const double top = std::min(high.y, static_cast<double>(cy + 1) * torus_.cell() + border);
      from = low.x + run * std::clamp((bottom - low.y) / rise, 0.0, 1.0);
      to = low.x + run * std::clamp((top - low.y) / rise, 0.0, 1.0);
    }
    const std::int64_t x0 = torus_.along(std::min(from, to) - border),
                       x1 = torus_.along(std::max(from, to) + border);
    for (std::int64_t cx = x0; cx <= x1; ++cx) visit(torus_.index(cx, cy));
  }
}

Walls::Walls(const Solids& solids) {
  std::vector<Edge> all;
  double total_length = 0;
  for (const SolidRow row : solids.fixed_rows()) {
    const std::span<const Vec2> polygon = solids.polygon(row);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      all.push_back({polygon[i], polygon[(i + 1) % polygon.size()], row,
                     EdgeRow{static_cast<std::uint32_t>(all.size())}});
      total_length += length(all.back());
    }
  }
  edge_count_ = all.size();
  if (all.empty()) return;

  const double cell = cell_for(total_length, all.size());
  for (const Edge& edge : all) {
    bounds_.add(edge.a);
    bounds_.add(edge.b);
  }
  torus_ = Torus(cell, cells_for(bounds_, all.size(), total_length, cell));
  bounds_ = bounds_.grown(cell);
  list(all, solids);
  measure_clearance();
  if (all.size() <= kFew) few_ = all;
}

/// Edges come in ascending order, so that each cell has at most one open group.
void Walls::list(const std::vector<Edge>& edges, const Solids& solids) {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  struct Last {
    SolidRow solid;  // of the open group, as the others
    std::uint32_t edges = 0;
    EdgeRow next;
  };
  // Calls visit(edge, index, is_new) for each edge and each of its cells; is_new if it opens a group there.
  const auto each = [&](const auto& visit) {
    std::vector<Last> last(torus_.cells());
    for (const Edge& edge : edges)
      rasterise(edge, [&](std::size_t index) {
        Last& group = last[index];
        const bool is_new = group.solid != edge.solid || group.next != edge.row || group.edges == simd::kFour;
        group = {edge.solid, is_new ? 1 : group.edges + 1, edge.row + 1};
        visit(edge, index, is_new);
      });
  };
  first_.assign(torus_.cells() + 1, 0);
  each([&](const Edge&, std::size_t index, bool is_new) { first_[index + 1] += is_new; });
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  groups_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  each([&](const Edge& edge, std::size_t index, bool is_new) {
    next[index] += is_new;
    Group& group = groups_[next[index] - 1];
    if (is_new) {
      std::fill_n(group.x, std::size(group.x), kNowhere);
      std::fill_n(group.y, std::size(group.y), kNowhere);
      group.z_min = solids.z_min[edge.solid];
      group.z_max = solids.z_max[edge.solid];
      group.solid = edge.solid;
      group.seen_by = solids.seen_by[edge.solid];
      group.first = edge.row;
      group.count = 0;
      group.x[0] = edge.a.x;
      group.y[0] = edge.a.y;
    }
    ++group.count;
    group.x[group.count] = edge.b.x;
    group.y[group.count] = edge.b.y;
  });
}

/// Dynamic programming: a square is one larger than the least of its three neighbours'
/// squares. The sweep goes on beyond the wrap-around as far as a square can reach.
void Walls::measure_clearance() {
  const std::size_t side = torus_.side(), last = side - 1,
                    farthest = std::min<std::size_t>(kFarthest, side / 2);
  clearance_.assign(1 + 4 * torus_.cells(), static_cast<std::uint8_t>(farthest));
  for (unsigned quadrant = 0; quadrant < 4; ++quadrant) {
    const std::size_t dx = quadrant & 1 ? last : 1, dy = quadrant & 2 ? last : 1;  // wrapped
    for (std::size_t i = 0, y = 0; i < side + farthest; ++i, y = (y - dy) & last) {
      const std::uint32_t* const first = first_.data() + y * side;
      std::uint8_t* const here = clearance_.data() + 1 + 4 * y * side + quadrant;
      const std::uint8_t* const ahead = clearance_.data() + 1 + 4 * ((y + dy) & last) * side + quadrant;
      std::size_t beside = here[4 * dx], across = ahead[4 * dx];
      for (std::size_t k = 0, x = 0; k < side + farthest; ++k, x = (x - dx) & last) {
        const std::size_t above = ahead[4 * x], square = std::min({beside, across, above}) + 1;
        beside = first[x] == first[x + 1] ? std::min(square, farthest) : 0;
        across = above;
        here[4 * x] = static_cast<std::uint8_t>(beside);
      }
    }
  }
}

}  // namespace playhouse::bodies
