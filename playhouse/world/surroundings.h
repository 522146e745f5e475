#pragma once

/// Surroundings: queries of the space around a place, independent of the engine, for sensors of shared
/// libraries (custom_kind.h). Thread: any worker, in the phase `sense` of the engine that provides it.

#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/world/models.h"

namespace playhouse::world {

/// Result of a ray cast.
struct RayEnd {
  double range = 0;  // m; the ray's length if it missed
  ModelRow model;    // whose body was hit, or none
};

class Surroundings {
 public:
  virtual ~Surroundings() = default;

  /// The first body visible to rangers on the horizontal ray from X_WS along
  /// its heading. Bodies in the tree of `own`, which may be none, are ignored.
  virtual RayEnd cast(const geom::Pose& X_WS, double range, ModelRow own) const = 0;

  /// Replaces `found` by all models whose frame origin is within `radius` of p_W in 3D, ascending by row.
  virtual void near(const geom::Pose& p_W, double radius, std::vector<ModelRow>& found) const = 0;

  /// Number of static bodies that the segment enters, at the
  /// height of its start; each contour of a bitmap counts.
  virtual int walls_between(const geom::Pose& from_W, const geom::Pose& to_W) const = 0;
};

}  // namespace playhouse::world
