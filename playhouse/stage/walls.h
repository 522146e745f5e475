#pragma once

/// Walls: the edges of everything that stands still, in cells. Built once and again when such a thing is put
/// elsewhere. An edge is listed in every cell it touches.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "playhouse/stage/bodies.h"
#include "playhouse/stage/torus.h"
#include "playhouse/stage/vectors.h"

namespace playhouse::stage {

class Walls {
 public:
  struct Edge {
    Vec2 a, b;             // m, in W
    std::uint32_t solid;   // row of Solids
    std::uint32_t number;  // of this edge; the same in every cell that lists it

    bool reaches(const geom::Box& box) const {
      return int{std::max(a.x, b.x) >= box.x_min} & int{std::min(a.x, b.x) <= box.x_max} &
             int{std::max(a.y, b.y) >= box.y_min} & int{std::min(a.y, b.y) <= box.y_max};
    }
  };

  /// Up to four edges of one solid in one cell, each from a point to the next; points that are left are not
  /// numbers. Two lines of memory.
  struct alignas(64) Group {
    double x[kFour + 1];  // m, in W
    double z_min, z_max;  // m, in W
    double y[kFour + 1];  // m, in W
    std::uint32_t solid;  // row of Solids
    std::uint32_t count;
    std::uint32_t number;  // of the first edge; others follow it
    Observers seen_by;     // who sees the solid

    Edge edge(std::uint32_t i) const { return {{x[i], y[i]}, {x[i + 1], y[i + 1]}, solid, number + i}; }
  };

  Walls() = default;
  /// Edges of the solids that stand still.
  explicit Walls(const Solids& solids);

  std::size_t edge_count() const { return edge_count_; }
  const Torus& torus() const { return torus_; }

  /// Calls visit(edge) for every listing in cells that meet the box; an edge comes once per cell, and far
  /// ones may come.
  template <typename Visit>
  void near(const geom::Box& box, const Visit& visit) const {
    if (edge_count_ == 0) return;
    torus_.runs(box, [&](std::size_t first, std::size_t last) {
      for (std::uint32_t g = first_[first]; g < first_[last + 1]; ++g)
        for (std::uint32_t i = 0; i < groups_[g].count; ++i) visit(groups_[g].edge(i));
    });
  }

  /// How many groups of edges near(box) would visit.
  std::size_t count_near(const geom::Box& box) const {
    std::size_t count = 0;
    if (edge_count_ == 0) return 0;
    torus_.runs(box, [&](std::size_t first, std::size_t last) { count += first_[last + 1] - first_[first]; });
    return count;
  }

  /// Side, in cells, of the largest square without edges that has cell `index` of the torus at its corner and
  /// lies where rays of a quadrant go; 0 if the cell has edges. At most kFarthest.
  int clearance(unsigned quadrant, std::size_t index) const { return clearances()[4 * index + quadrant]; }
  static unsigned quadrant(Vec2 d) { return (d.x < 0 ? 1u : 0u) + (d.y < 0 ? 2u : 0u); }
  /// No edge is nearer to p than this. [m]
  double clear_about(Vec2 p) const {
    if (edge_count_ == 0) return std::numeric_limits<double>::infinity();
    const std::uint8_t* const here = clearances() + 4 * torus_.index(p);
    return (std::min({here[0], here[1], here[2], here[3]}) - 1) * torus_.cell();
  }
  /// Of cells and quadrants, at 4 * index + quadrant; above 0 at -1.
  const std::uint8_t* clearances() const { return clearance_.data() + 1; }
  std::span<const Group> in_cell(std::size_t index) const {
    return {groups_.data() + first_[index], first_[index + 1] - first_[index]};
  }

  /// All edges once, where there are so few that trying each is cheaper than looking them up; else none.
  static constexpr std::size_t kFew = 64;
  const std::vector<Edge>& few() const { return few_; }

  /// Calls visit(edge) along the ray from p towards the unit vector d, cell by cell, until the distance
  /// `*reach` is passed; visit may shorten *reach.
  template <typename Visit>
  void along(Vec2 p, Vec2 d, const double* reach, const Visit& visit) const;

 private:
  static constexpr int kFarthest = 32;
  /// An edge this near to a cell is listed in it: who goes from cell to cell may err by less.  [cells]
  static constexpr double kBorder = 1.0 / 64;

  template <typename Visit>
  void rasterise(const Edge& edge, const Visit& visit) const;

  void list(const std::vector<Edge>& edges, const Solids& solids);
  void measure_clearance();

  Torus torus_;
  geom::Box bounds_;  // of all edges, and a cell beyond
  std::size_t edge_count_ = 0;
  std::vector<std::uint32_t> first_;     // (cells + 1)
  std::vector<Group> groups_;            // by cell
  std::vector<std::uint8_t> clearance_;  // (cells x quadrants)
  std::vector<Edge> few_;                // all edges once, if there are no more than kFew
};

template <typename Visit>
void Walls::along(Vec2 p, Vec2 d, const double* reach, const Visit& visit) const {
  if (edge_count_ == 0) return;
  const double cell = torus_.cell();
  const double per_x = d.x == 0 ? 0 : 1 / d.x, per_y = d.y == 0 ? 0 : 1 / d.y;
  // On the torus a ray would go round for ever: it is followed in the bounds of the edges only.
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
    // Nothing is left in the square of `hop` cells ahead: on to where the ray leaves it.
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

}  // namespace playhouse::stage
