#pragma once

/// Walls: edges of the static solids in a uniform grid on a torus. Rebuilt
/// when a static solid is moved. An edge is listed in every cell it touches.
///
/// In: the static solids.
/// Out: their edges by cell, and how far each cell is from any.
/// Cost: made by a visit of all cells that edges touch, and four passes over all cells; a traversal
///   visits the cells along the ray, and skips empty squares of them.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "playhouse/bodies/bodies.h"
#include "playhouse/bodies/torus.h"
#include "playhouse/simd/vectors.h"

namespace playhouse::bodies {

class Walls {
 public:
  struct Edge {
    Vec2 a, b;  // m, in W
    SolidRow solid;
    EdgeRow row;  // equal in all cells that list it

    bool reaches(const geom::Box& box) const {
      return int{std::max(a.x, b.x) >= box.x_min} & int{std::min(a.x, b.x) <= box.x_max} &
             int{std::max(a.y, b.y) >= box.y_min} & int{std::min(a.y, b.y) <= box.y_max};
    }
  };

  /// Up to four edges of one solid in one cell, a chain
  /// of points; unused points are NaN. Two cache lines.
  struct alignas(64) Group {
    double x[simd::kFour + 1];  // m, in W
    double z_min, z_max;        // m, in W
    double y[simd::kFour + 1];  // m, in W
    SolidRow solid;
    std::uint32_t count;
    EdgeRow first;       // its edges are consecutive
    SeenByBits seen_by;  // visibility mask of the solid

    Edge edge(std::uint32_t i) const { return {{x[i], y[i]}, {x[i + 1], y[i + 1]}, solid, first + i}; }
  };

  Walls() = default;
  /// Lists the edges of the static solids.
  explicit Walls(const Solids& solids);

  std::size_t edge_count() const { return edge_count_; }
  const Torus& torus() const { return torus_; }

  /// Calls visit(edge) for every listing in cells that intersect the box:
  /// an edge comes once per cell, and edges outside the box may come.
  template <typename Visit>
  void near(const geom::Box& box, const Visit& visit) const {
    if (edge_count_ == 0) return;
    torus_.runs(box, [&](std::size_t first, std::size_t last) {
      for (std::uint32_t g = first_[first]; g < first_[last + 1]; ++g)
        for (std::uint32_t i = 0; i < groups_[g].count; ++i) visit(groups_[g].edge(i));
    });
  }

  /// Number of groups that near(box) would visit.
  std::size_t count_near(const geom::Box& box) const {
    std::size_t count = 0;
    if (edge_count_ == 0) return 0;
    torus_.runs(box, [&](std::size_t first, std::size_t last) { count += first_[last + 1] - first_[first]; });
    return count;
  }

  /// Side, in cells, of the largest empty square with cell `index` of the torus at its corner, in the
  /// direction of a quadrant; 0 if the cell has edges. At most kFarthest. Lets traversal skip empty cells.
  int clearance(unsigned quadrant, std::size_t index) const { return clearances()[4 * index + quadrant]; }
  static unsigned quadrant(Vec2 d) { return (d.x < 0 ? 1u : 0u) + (d.y < 0 ? 2u : 0u); }
  /// Lower bound on the distance from p to any edge. [m]
  double clear_about(Vec2 p) const {
    if (edge_count_ == 0) return std::numeric_limits<double>::infinity();
    const std::uint8_t* const here = clearances() + 4 * torus_.index(p);
    return (std::min({here[0], here[1], here[2], here[3]}) - 1) * torus_.cell();
  }
  /// By cell and quadrant, at 4 * index + quadrant; index -1 is readable.
  const std::uint8_t* clearances() const { return clearance_.data() + 1; }
  std::span<const Group> in_cell(std::size_t index) const {
    return {groups_.data() + first_[index], first_[index + 1] - first_[index]};
  }

  /// All edges once, if there are so few that brute force is cheaper than the grid; otherwise empty.
  static constexpr std::size_t kFew = 64;
  const std::vector<Edge>& few() const { return few_; }

  /// Grid traversal: calls visit(edge) along the ray from p towards the unit vector
  /// d, cell by cell, up to the distance `*reach`; visit may shorten *reach.
  template <typename Visit>
  void along(Vec2 p, Vec2 d, const double* reach, const Visit& visit) const;

 private:
  static constexpr int kFarthest = 32;
  /// Edges are also listed in cells this near to them: tolerance for rounding in a traversal.  [cells]
  static constexpr double kBorder = 1.0 / 64;

  template <typename Visit>
  void rasterise(const Edge& edge, const Visit& visit) const;

  void list(const std::vector<Edge>& edges, const Solids& solids);
  void measure_clearance();

  Torus torus_;
  geom::Box bounds_;  // of all edges, plus one cell
  std::size_t edge_count_ = 0;
  std::vector<std::uint32_t> first_;     // (cells + 1)
  std::vector<Group> groups_;            // by cell
  std::vector<std::uint8_t> clearance_;  // (cells x quadrants)
  std::vector<Edge> few_;                // all edges once, if at most kFew
};

template <typename Visit>
void Walls::along(Vec2 p, Vec2 d, const double* reach, const Visit& visit) const {
  if (edge_count_ == 0) return;
  const double cell = torus_.cell();
  const double per_x = d.x == 0 ? 0 : 1 / d.x, per_y = d.y == 0 ? 0 : 1 / d.y;
  // Torus cells repeat: clip the ray to the bounds of the edges, or it would revisit them forever.
  const auto [entry, exit] = bounds_.along(p, d);
  double t = std::max(0.0, entry);
  std::int64_t cx = torus_.along(p.x + t * d.x), cy = torus_.along(p.y + t * d.y);
  const unsigned towards = quadrant(d);
  while (t <= std::min(*reach, exit)) {
    const std::size_t index = torus_.index(cx, cy);
    std::int64_t hop = clearance(towards, index);
    if (hop == 0) {
      for (const Group& group : in_cell(index))
        for (std::uint32_t i = 0; i < group.count; ++i) visit(group.edge(i));
      hop = 1;
    }
    // The square of `hop` cells ahead is done: advance to where the ray leaves it.
    constexpr double kNever = 1e300;
    const double border_x = static_cast<double>(cx + (d.x < 0 ? 1 - hop : hop)) * cell;
    const double border_y = static_cast<double>(cy + (d.y < 0 ? 1 - hop : hop)) * cell;
    const double t_x = d.x == 0 ? kNever : (border_x - p.x) * per_x;
    const double t_y = d.y == 0 ? kNever : (border_y - p.y) * per_y;
    if (t_x < t_y) {
      t = t_x;
      cx += d.x < 0 ? -hop : hop;
      if (hop > 1)
        cy = std::clamp(torus_.along(p.y + t * d.y), d.y < 0 ? cy - (hop - 1) : cy,
                        d.y < 0 ? cy : cy + (hop - 1));
    } else {
      t = t_y;
      cy += d.y < 0 ? -hop : hop;
      if (hop > 1)
        cx = std::clamp(torus_.along(p.x + t * d.x), d.x < 0 ? cx - (hop - 1) : cx,
                        d.x < 0 ? cx : cx + (hop - 1));
    }
  }
}

}  // namespace playhouse::bodies
