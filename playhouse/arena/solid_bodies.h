#pragma once

/// Outlines of models' bodies, from which hulls and triangles are made.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/geom/orientation.h"
#include "playhouse/stage/bodies.h"

namespace playhouse::arena {

/// Calls visit(begin, end) for each body, a run of rows in [first,
/// last) of one model (see Solids::body), that `observer` sees.
template <typename Visit>
void each_body(const stage::Solids& solids, std::size_t first, std::size_t last, stage::Observer observer,
               const Visit& visit) {
  for (std::size_t begin = first; begin < last;) {
    std::size_t end = begin + 1;
    while (end < last && solids.body[end] == solids.body[begin]) ++end;
    if ((solids.seen_by[begin] & stage::bit(observer)) != 0) visit(begin, end);
    begin = end;
  }
}

/// The outlines of a body in F, a frame in which its
/// model is upright; the solid side is on their left. [m]
inline std::vector<std::vector<geom::Vec2>> outlines_of(const stage::Solids& solids, std::size_t begin,
                                                        std::size_t end, const geom::Pose& X_FM) {
  const geom::Rotation turn = geom::Rotation::of(X_FM.a);
  std::vector<std::vector<geom::Vec2>> outlines;
  for (std::size_t row = begin; row < end; ++row) {
    std::vector<geom::Vec2>& outline = outlines.emplace_back();
    for (std::uint32_t v = solids.first_vertex[row]; v + 1 < solids.first_vertex[row + 1]; ++v)
      outline.push_back(X_FM.xy() + turn * solids.p_M[v]);
    if (solids.hole[row] != 0) std::ranges::reverse(outline);
  }
  return outlines;
}

/// The frame F in which the body of a fixed model is made: the world, as in the stage engine, or for a tilted
/// model its own frame M, whose points are then turned.
class FrameOfFixed {
 public:
  FrameOfFixed(const world::Models& models, std::uint32_t model)
      : X_WM_(models.X_WM[model]), tilt_(models.tilt_WM[model]) {}

  geom::Pose X_FM() const { return is_tilted() ? geom::Pose{} : X_WM_; }
  /// From F to W.
  void turn(std::span<geom::Vec3> points) const {
    if (!is_tilted()) return;
    const geom::Quaternion q_WM = geom::orientation(X_WM_.a, tilt_);
    for (geom::Vec3& p : points) p = geom::Vec3{X_WM_.x, X_WM_.y, X_WM_.z} + q_WM * p;
  }

 private:
  bool is_tilted() const { return tilt_ != geom::Tilt{}; }

  geom::Pose X_WM_;
  geom::Tilt tilt_;
};

}  // namespace playhouse::arena
