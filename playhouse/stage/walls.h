#pragma once

/// Walls: the edges of everything that stands still, in cells. Built once and again when such a thing is put
/// elsewhere. An edge is listed in every cell it touches.

#include <cstdint>
#include <vector>

#include "playhouse/stage/bodies.h"
#include "playhouse/stage/torus.h"

namespace playhouse::stage {

class Walls {
 public:
  struct Edge {
    Vec2 a, b;             // m, in W
    std::uint32_t solid;   // row of Solids
    std::uint32_t number;  // of this edge; the same in every cell that lists it
  };

  Walls() = default;
  /// Edges of the solids from solids.moving on.
  explicit Walls(const Solids& solids);

  std::size_t edge_count() const { return edge_count_; }
  const Torus& torus() const { return torus_; }

  /// Calls visit(edge) for every listing in cells that meet the box; an edge comes once per cell, and far
  /// ones may come.
  template <typename Visit>
  void near(const geom::Box& box, const Visit& visit) const {
    if (edge_count_ == 0) return;
    torus_.runs(box, [&](std::size_t first, std::size_t last) {
      for (std::uint32_t i = first_[first]; i < first_[last + 1]; ++i) visit(edges_[i]);
    });
  }

  /// How many listings near(box) would visit.
  std::size_t count_near(const geom::Box& box) const {
    std::size_t count = 0;
    if (edge_count_ == 0) return 0;
    torus_.runs(box, [&](std::size_t first, std::size_t last) { count += first_[last + 1] - first_[first]; });
    return count;
  }

  /// Calls visit(edge) along the ray from p towards the unit vector d, cell by cell, until the distance
  /// `*reach` is passed; visit may shorten *reach.
  template <typename Visit>
  void along(Vec2 p, Vec2 d, const double* reach, const Visit& visit) const;

 private:
  template <typename Visit>
  void rasterise(const Edge& edge, const Visit& visit) const;

  Torus torus_;
  std::size_t edge_count_ = 0;
  std::vector<std::uint32_t> first_;  // (cells + 1)
  std::vector<Edge> edges_;           // by cell
};

template <typename Visit>
void Walls::along(Vec2 p, Vec2 d, const double* reach, const Visit& visit) const {
  if (edge_count_ == 0) return;
  constexpr double kNever = 1e300;
  std::int64_t cx = torus_.along(p.x), cy = torus_.along(p.y);
  const double cell = torus_.cell();
  const int step_x = d.x < 0 ? -1 : 1, step_y = d.y < 0 ? -1 : 1;
  const double per_x = d.x == 0 ? kNever : cell / std::fabs(d.x),
               per_y = d.y == 0 ? kNever : cell / std::fabs(d.y);
  const double border_x = static_cast<double>(cx + (step_x > 0)) * cell;
  const double border_y = static_cast<double>(cy + (step_y > 0)) * cell;
  double t_x = d.x == 0 ? kNever : (border_x - p.x) / d.x, t_y = d.y == 0 ? kNever : (border_y - p.y) / d.y;
  double t = 0;
  while (t <= *reach) {
    const std::size_t index = torus_.index(cx, cy);
    for (std::uint32_t i = first_[index]; i < first_[index + 1]; ++i) visit(edges_[i]);
    if (t_x < t_y) {
      t = t_x;
      t_x += per_x;
      cx += step_x;
    } else {
      t = t_y;
      t_y += per_y;
      cy += step_y;
    }
  }
}

}  // namespace playhouse::stage
