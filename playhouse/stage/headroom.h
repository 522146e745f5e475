#pragma once

/// Headroom: a bound on how far a tree can move before anything could touch it, measured rarely and consumed
/// tick by tick. While it lasts, the tree's motion needs no collision test, whatever the outlines are.
///
/// In: the displacements of trees in each tick; the places of solids when headroom is measured.
/// Out: the trees that certainly hit nothing in this tick. Conservative: which free trees are recognised
///   depends on when headroom was measured, but results of the simulation do not.
/// Cost: a subtraction per moving tree; a query of the index and the walls when headroom is used up.

#include <cstdint>
#include <vector>

#include "playhouse/bodies/bodies.h"
#include "playhouse/bodies/disc_index.h"
#include "playhouse/bodies/fast_bodies.h"
#include "playhouse/bodies/walls.h"

namespace playhouse::stage {

class Headroom {
 public:
  void populate(const bodies::Trees& trees, const bodies::Solids& solids, const world::Models& models);
  /// A tree was teleported: invalidates the headroom of all trees.
  void replaced(const bodies::Trees& trees, bodies::TreeRow tree, const bodies::Solids& solids,
                const world::Models& models);

  /// True if the tree moves as one rigid body, by its root: only such a tree has headroom.
  bool is_rigid(bodies::TreeRow tree) const { return rigid_[tree] != 0; }
  /// Upper bound on the distance from the origin of the root to the center of any solid. [m]
  double arm(bodies::TreeRow tree) const { return arm_[tree]; }

  /// Begins a tick in which no center of a solid moves by more than `others`, except those of
  /// fast bodies, which every tree has to avoid(). [m]
  void begin(double others);
  /// Lowers the headroom of a tree to what the fast bodies of this tick leave; p is the root's position at
  /// its start. Again after measure().
  void avoid(bodies::TreeRow tree, geom::Vec2 p, const bodies::FastBodies& fast);
  /// Consumes the headroom of a rigid tree whose root is displaced by `way` in this tick.
  /// True if enough was left: nothing can touch it at its old place or its new one. [m]
  bool spend(bodies::TreeRow tree, double way) {
    until_[tree] -= way;
    return until_[tree] > drift_;
  }
  /// Measures the headroom of a tree at the start of this tick, for another spend().
  /// `index` has the movable solids at that time; p is the root's position then.
  void measure(bodies::TreeRow tree, geom::Vec2 p, double way, const bodies::Solids& solids,
               const bodies::DiscIndex& index, const bodies::Walls& walls);

 private:
  void measure_shape(const bodies::Trees& trees, bodies::TreeRow tree, const bodies::Solids& solids,
                     const world::Models& models);

  ByRow<bodies::Trees, std::uint8_t> rigid_;
  ByRow<bodies::Trees, double> arm_,
      radius_;  // bounds about the root's origin: of centers, of all that blocks [m]
  ByRow<bodies::Trees, world::ModelRow> root_;
  ByRow<bodies::Trees, double> until_;  // value of drift_ at which it is used up  [m]
  double drift_ = 0, others_ = 0;       // m: approach of others at most, since the start and in this tick
  bool walls_block_ = false;            // some static solid is an obstacle
};

}  // namespace playhouse::stage
