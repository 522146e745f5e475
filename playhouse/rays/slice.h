#pragma once

/// Slice: the cross-section of the world with a vertical half-plane from a
/// viewpoint: stretches of bodies, each a range of distances and a range of heights.
///
/// In: outlines of static solids along the plane and of movable ones near the viewpoint; their heights.
/// Out: stretches, with heights relative to the eye.
/// Cost: the wall cells along the plane, and the edges of nearby movable solids.
/// Source: even-odd rule over all contours of a bitmap: a line enters and leaves a body alternately; if its
///   first crossing leaves, it started inside. Crossings: ray_edge.h.

#include <cstdint>
#include <vector>

#include "playhouse/bodies/space.h"

namespace playhouse::rays {

/// An interval of the plane that is inside a body.
struct Stretch {
  double from = 0, to = 0;   // m, on the floor
  double low = 0, high = 0;  // m, from the height of the eye
  bodies::SolidRow solid;    // the first one of the body
};

/// Traces many directions from one viewpoint. Scratch buffer of one worker: keeps its capacity.
class Slicer {
 public:
  /// Sets the viewpoint: p at height z. Ignores what `by` does
  /// not see, the tree `root`, and what is beyond `reach`.
  void stand(const bodies::Space& space, geom::Vec2 p, double z, double reach, bodies::SeenByBits by,
             world::ModelRow root);

  /// Stretches along the unit vector d up to `reach`, unordered. Valid until the next call.
  const std::vector<Stretch>& along(const bodies::Space& space, geom::Vec2 d, double reach);

 private:
  /// A crossing of the ray with an edge of a body.
  struct Passage {
    bodies::SolidRow body;  // its first solid
    double t;               // m
    bool enters;
    bodies::EdgeRow wall;  // none: a movable body
  };

  void cross_walls(const bodies::Space& space, geom::Vec2 d, double reach);
  void cross_bodies(const bodies::Space& space, geom::Vec2 d, double reach);
  void cross(bodies::SolidRow body, geom::Vec2 w0, geom::Vec2 w1, bool hole, double reach, geom::Vec2 d,
             bodies::EdgeRow wall);
  void pair_crossings(const bodies::Solids& solids);
  void add(const bodies::Solids& solids, bodies::SolidRow body, double from, double to);
  bool shows(const bodies::Solids& solids, bodies::SolidRow solid) const;

  geom::Vec2 p_;
  double z_ = 0;  // m
  bodies::SeenByBits by_ = 0;
  world::ModelRow root_{0};
  std::vector<bodies::SolidRow> near_;     // movable solids
  std::vector<bodies::SolidRow> beneath_;  // static bodies that contain p, ascending
  std::vector<Passage> crossings_;
  std::vector<Stretch> stretches_;
};

}  // namespace playhouse::rays
