#pragma once

/// Headroom: how far a tree may go before anything could touch it, measured seldom and used up tick by tick.
/// While some is left its motion cannot be blocked, whatever the outlines are.
///
/// In: the ways of trees in each tick; where solids are, when headroom is measured.
/// Out: the trees that meet nothing in this tick. It says so only of trees that are free; which others it
///   recognises depends on when it measured, and no result does.
/// Cost: a subtraction for each tree that moves; a look into the index and the walls where headroom ran out.

#include <cstdint>
#include <vector>

#include "playhouse/stage/bodies.h"
#include "playhouse/stage/disc_index.h"
#include "playhouse/stage/walls.h"

namespace playhouse::stage {

class Headroom {
 public:
  void populate(const Trees& trees, const Solids& solids, const world::Models& models);
  /// A tree was put elsewhere: nobody's headroom is known any more.
  void replaced(const Trees& trees, std::uint32_t tree, const Solids& solids, const world::Models& models);

  /// The tree moves as a whole, by its top: only such a tree has headroom.
  bool is_rigid(std::uint32_t tree) const { return rigid_[tree] != 0; }
  /// No centre of its solids is further from the origin of its top. [m]
  double arm(std::uint32_t tree) const { return arm_[tree]; }

  /// A tick begins in which no centre of a solid moves by more than `others`. [m]
  void begin(double others);
  /// Uses up what a rigid tree needs whose top goes `way` in this tick. True if there was so much: it meets
  /// nothing, and nothing comes to where it was or will be.  [m]
  bool spend(std::uint32_t tree, double way) {
    until_[tree] -= way;
    return until_[tree] > drift_;
  }
  /// Measures the headroom of a tree as this tick began, for spend() to be asked again. `index` has the
  /// solids that can move where they were then, the top of the tree was at p.
  void measure(std::uint32_t tree, Vec2 p, double way, const Solids& solids, const DiscIndex& index,
               const Walls& walls);

 private:
  void measure_shape(const Trees& trees, std::uint32_t tree, const Solids& solids,
                     const world::Models& models);

  std::vector<std::uint8_t> rigid_;   // (trees)
  std::vector<double> arm_, radius_;  // about the top's origin: centres, and all that blocks [m] (trees)
  std::vector<std::uint32_t> root_;   // (trees)
  std::vector<double> until_;         // value of drift_ at which there is none left  [m] (trees)
  double drift_ = 0, others_ = 0;     // m: what others can have come nearer since the run began, and now
  bool walls_block_ = false;          // something that stands still is in the way of motion
};

}  // namespace playhouse::stage
