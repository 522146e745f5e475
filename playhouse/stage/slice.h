#pragma once

/// Slice: what a vertical plane cuts out of the world on one side of a place: stretches of bodies, each from
/// a distance to a distance and from a height to a height.
///
/// In: outlines of what stands still along the plane, and of what moves near the place; their heights.
/// Out: stretches, at heights from that of the eye.
/// Cost: the cells of the walls along the plane, and the edges of what moves nearby.
/// Source: a line enters and leaves a body by turns (even-odd rule, over all contours of a bitmap); where the
///   first edge that it crosses is one by which it leaves, it began inside. Crossings: ray_edge.h.

#include <cstdint>
#include <vector>

#include "playhouse/stage/space.h"

namespace playhouse::stage {

/// Where the plane is in a body.
struct Stretch {
  double from = 0, to = 0;   // m, on the floor
  double low = 0, high = 0;  // m, from the height of the eye
  std::uint32_t solid = 0;   // row of Solids
};

/// Looks from one place in many directions. Scratch memory of one worker: keeps its capacity.
class Slicer {
 public:
  /// From p, at the height z; nothing that `by` does not see, nor of the tree `root`, and not farther than
  /// `reach`.
  void stand(const Space& space, Vec2 p, double z, double reach, Observers by, std::uint32_t root);

  /// Stretches along the unit vector d up to `reach`, in no order. Valid until the next call.
  const std::vector<Stretch>& along(const Space& space, Vec2 d, double reach);

 private:
  /// An edge of a body on the way.
  struct Crossing {
    std::uint32_t body;  // the first solid of it
    double t;            // m
    bool enters;
    std::uint32_t number;  // of the edge, to tell the same one in two cells
  };

  void cross_walls(const Space& space, Vec2 d, double reach);
  void cross_bodies(const Space& space, Vec2 d, double reach);
  void cross(std::uint32_t body, Vec2 w0, Vec2 w1, bool hole, double reach, Vec2 d, std::uint32_t number);
  void pair_crossings(const Solids& solids);
  void add(const Solids& solids, std::uint32_t body, double from, double to);
  bool shows(const Solids& solids, std::uint32_t solid) const;

  Vec2 p_;
  double z_ = 0;  // m
  Observers by_ = 0;
  std::uint32_t root_ = 0;
  std::vector<std::uint32_t> near_;     // solids that move
  std::vector<std::uint32_t> beneath_;  // bodies that stand still and hold p, ascending
  std::vector<Crossing> crossings_;
  std::vector<Stretch> stretches_;
};

}  // namespace playhouse::stage
