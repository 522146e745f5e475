#pragma once

/// Supports: broad phase for wheels: the movable bodies that may be below a vehicle.
///
/// In: axis-aligned bounding boxes in W.
/// Out: for a box, the bodies whose boxes overlap it, in ascending order.
/// Cost: set() sorts all boxes; find() visits
///   those whose low side is within kWide of the
///   box in x, and all boxes wider than kWide.
/// Source: sweep and prune along one axis (Baraff, 1992).
///
/// Thread: find() from any number of threads at once; set() from one.

#include <cstdint>
#include <vector>

#include "playhouse/arena/physics/rigid_body.h"

namespace playhouse::arena {

struct Aabb {
  Vec3 low, high;  // m, in W
};

class Supports {
 public:
  void set(const ByRow<RigidBody, Aabb>& boxes);
  /// Replaces `bodies` by the bodies whose boxes overlap `box`.
  void find(const Aabb& box, std::vector<RigidBodyRow>& bodies) const;

 private:
  struct BodyBox {
    Aabb box;
    RigidBodyRow body;
  };
  std::vector<BodyBox> narrow_;  // sorted by the low side in x
  std::vector<BodyBox> wide_;
};

}  // namespace playhouse::arena
