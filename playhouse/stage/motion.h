#pragma once

/// Motion: moves whole trees of models, in three steps that each may run on any number of workers. Every tree
/// that drives proposes where it would be. It stalls, and stays, if its proposal overlaps something that
/// stands still, any other tree where that is now, or the proposal of a tree before it in row order; so no
/// two trees ever come to overlap, and the order of computation does not matter. A tree that overlaps
/// something already may move as long as it does not get deeper into it.

#include <vector>

#include "playhouse/stage/bodies.h"
#include "playhouse/stage/disc_index.h"
#include "playhouse/stage/overlap.h"
#include "playhouse/stage/walls.h"
#include "playhouse/world/workers.h"

namespace playhouse::stage {

class Motion {
 public:
  Motion(const Trees& trees, const Solids& solids, const world::Models& models, unsigned workers);

  /// The phase `move`. `index` holds the moving solids where they are. True if anything moved.
  bool move(world::World& world, Solids& solids, const DiscIndex& index, const Walls& walls,
            world::Workers& workers);

 private:
  /// Shapes of one tree at a time, for the steps of one worker between here and the proposal.
  struct Sweep {
    std::vector<Pose> X_PM, X_WM;
    std::vector<Rotation> rotation;
    std::vector<Vec2> center, p;
  };
  struct Surroundings {
    const world::World& world;
    const Solids& solids;
    const DiscIndex& index;
    const Walls& walls;
  };

  void propose(const Surroundings& in, std::uint32_t tree);
  void shape_at(const Surroundings& in, std::uint32_t tree, double fraction, const TreeShape& out) const;
  unsigned steps_of(const Surroundings& in, std::uint32_t tree) const;
  bool is_blocked(const Surroundings& in, std::uint32_t tree, Sweep& sweep);
  bool meets(const Surroundings& in, std::uint32_t tree, const TreeShape& shape) const;
  bool meets_wall(const Surroundings& in, std::size_t solid, const Outline& now, const Outline& then) const;
  bool meets_other(const Surroundings& in, std::size_t solid, const Outline& now, const Outline& then,
                   std::size_t other) const;
  void commit(world::World& world, Solids& solids, std::uint32_t tree) const;
  void believe(world::World& world, std::uint32_t robot) const;
  TreeShape proposal(const Solids& solids, std::uint32_t tree);

  const Trees* trees_;
  // Rows as in Trees.
  std::vector<std::uint8_t> proposes_, stalls_;  // (trees)
  std::vector<double> reach_;                    // largest displacement of a solid's centre  [m] (trees)
  std::vector<std::uint32_t> parent_;  // local row of the parent in its tree           (models of trees)
  double reach_max_ = 0;               // m, of this tick
  // The proposals; rows as in Trees::models and Solids.
  std::vector<Pose> X_PM_, X_WM_;
  std::vector<Rotation> rotation_;
  std::vector<Vec2> center_, p_;
  std::vector<Sweep> sweeps_;  // one per worker
};

}  // namespace playhouse::stage
