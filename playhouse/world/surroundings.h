#pragma once

/// Surroundings: what is around a place, whatever engine has the bodies: what sensors of shared libraries see
/// (custom_kind.h). Thread: any worker, in the phase `sense` of the engine that gives it.

#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/world/models.h"

namespace playhouse::world {

/// Where a ray ends.
struct RayEnd {
  double range = 0;  // m; that of the ray if it met nothing
  ModelRow model;    // whose body it met, or none
};

class Surroundings {
 public:
  virtual ~Surroundings() = default;

  /// The first body on the level line from X_WS along its heading, of those that rangers see. Bodies of the
  /// tree of `own`, which may be none, are passed through.
  virtual RayEnd cast(const geom::Pose& X_WS, double range, ModelRow own) const = 0;

  /// Replaces `found` by all models whose own frame is within `radius` of p_W in space, ascending by row.
  virtual void near(const geom::Pose& p_W, double radius, std::vector<ModelRow>& found) const = 0;

  /// How many bodies that stand still the straight line from one place to the other enters, at the height of
  /// the first; a bitmap's contour counts each time.
  virtual int walls_between(const geom::Pose& from_W, const geom::Pose& to_W) const = 0;
};

}  // namespace playhouse::world
