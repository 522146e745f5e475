#pragma once

/// Outlines of models' bodies, from which hulls and triangles are made.
///
/// In: rows of Solids that belong to one model after the other.
/// Out: the rows of each body; its outlines.
/// Cost: the rows, and the vertices of outlines.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/bodies/bodies.h"
#include "playhouse/geom/orientation.h"

namespace playhouse::arena {

/// Calls visit(body) for each body, a run of these rows
/// of one model (see Solids::body), that is visible to `by`.
template <typename Visit>
void each_body(const bodies::Solids& solids, bodies::SolidRows rows, bodies::SeenBy by, const Visit& visit) {
  each_run(rows, solids.body, [&](bodies::SolidRows body) {
    if ((solids.seen_by[body.front()] & bodies::bit(by)) != 0) visit(body);
  });
}

/// The outlines of a body in F, a frame in which its
/// model is upright; the solid side is on their left. [m]
inline std::vector<std::vector<geom::Vec2>> outlines_of(const bodies::Solids& solids, bodies::SolidRows body,
                                                        const geom::Pose& X_FM) {
  const geom::Rotation turn = geom::Rotation::of(X_FM.a);
  std::vector<std::vector<geom::Vec2>> outlines;
  for (const bodies::SolidRow row : body) {
    std::vector<geom::Vec2>& outline = outlines.emplace_back();
    for (const geom::Vec2 p_M : solids.polygon_M(row)) outline.push_back(X_FM.xy() + turn * p_M);
    if (solids.hole[row] != 0) std::ranges::reverse(outline);
  }
  return outlines;
}

/// The frame F in which the body of a model is made, from its pose in R, the world or its tree: R itself, as
/// in the stage engine, or for a tilted model its own frame M, whose points are then turned.
class FrameOfBody {
 public:
  explicit FrameOfBody(const geom::SpatialPose& X_RM) : X_RM_(X_RM) {}

  geom::Pose X_FM() const { return is_tilted() ? geom::Pose{} : X_RM_.X; }
  /// From F to R.
  void turn(std::span<geom::Vec3> points) const {
    if (!is_tilted()) return;
    const geom::Pose& X = X_RM_.X;
    const geom::Quaternion q_RM = geom::orientation(X.a, X_RM_.tilt);
    for (geom::Vec3& p : points) p = geom::Vec3{X.x, X.y, X.z} + q_RM * p;
  }

 private:
  bool is_tilted() const { return X_RM_.tilt != geom::Tilt{}; }

  geom::SpatialPose X_RM_;
};

}  // namespace playhouse::arena
