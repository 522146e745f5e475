#pragma once

/// Motion: moves whole trees of models, with the result that trees moving one after the other, in row order,
/// would have. Every tree in which something moves by itself proposes where it would be. The proposal is
/// refused, and the tree stalls and stays, if the way there meets something that stands still or another
/// tree: where that came to be in this tick if it is before this one in row order, where it was if it comes
/// after. So no two trees ever come to overlap, and a move that is refused is in nobody's way. A tree that
/// overlaps something already may move as long as it does not get deeper into it.
///
/// Proposals and what their ways meet are found on any number of workers; what depends on the moves of trees
/// before is noted as a conflict, and one pass in row order decides. Threads change no bit of the result.
/// A tree that has headroom (headroom.h) meets nothing, so nothing but its pose is proposed.

#include <cmath>
#include <vector>

#include "playhouse/stage/bodies.h"
#include "playhouse/stage/disc_index.h"
#include "playhouse/stage/headroom.h"
#include "playhouse/stage/overlap.h"
#include "playhouse/stage/walls.h"
#include "playhouse/world/workers.h"

namespace playhouse::stage {

class Motion {
 public:
  explicit Motion(unsigned workers) : sweeps_(workers) {}

  /// Makes room for these trees, which outlive the next move().
  void populate(const Trees& trees, const Solids& solids, const world::Models& models);
  /// To be called after a tree's solids were put elsewhere by others.
  void replaced(std::uint32_t tree, const Solids& solids, const world::Models& models) {
    headroom_.replaced(*trees_, tree, solids, models);
  }

  /// The phase `move`. `index` holds the moving solids where they are. True if anything moved.
  bool move(world::World& world, Solids& solids, const DiscIndex& index, const Walls& walls,
            world::Workers& workers);

 private:
  /// A way that one of two places of another tree blocks: the proposal of `with`, or where it was.
  struct Conflict {
    std::uint32_t with;  // a tree that proposes, before the one whose way it is
    bool if_moved;       // true: with's proposal blocks it; false: the place it would leave
  };
  /// What one worker needs to follow one way after the other.
  struct Sweep {
    // The shape of a tree between here and its proposal.
    std::vector<Pose> moved, X_WM;
    std::vector<Rotation> rotation;
    std::vector<Vec2> center, p;
    std::vector<double> z;
    std::vector<const DiscIndex::Disc*> near;  // of other trees, about the present shape
    // Of all ways of this tick, those of one way together; keeps its capacity from tick to tick.
    std::vector<Conflict> conflicts;
    std::size_t first_conflict = 0;  // of the present way

    /// Adds a conflict of the present way. True if both places of the other tree block it.
    bool add(Conflict conflict);
  };
  /// The conflicts of a tree's way: sweeps_[worker].conflicts[begin .. end).
  struct Conflicts {
    std::uint32_t worker = 0, begin = 0, end = 0;
  };
  /// A solid somewhere: its outline, and its heights [m].
  struct Body {
    Outline outline;
    double z_min, z_max;
  };
  /// What holds a shape. [m]
  struct Circle {
    Vec2 center;
    double radius, z_min, z_max;
  };
  struct Surroundings {
    const world::World& world;
    const Solids& solids;
    const DiscIndex& index;
    const Walls& walls;
  };

  void add_parents(std::span<const std::uint32_t> rows, const world::Models& models, std::uint32_t tree);
  std::span<const Mover> movers_of(std::uint32_t tree) const {
    const std::uint32_t first = trees_->first_mover[tree];
    return {trees_->movers.data() + first, trees_->first_mover[tree + 1] - first};
  }
  void propose(const Surroundings& in, std::uint32_t tree, Sweep& sweep);
  TreeShape propose_shape(const Surroundings& in, std::uint32_t tree, Sweep& sweep);
  void propose_rest(const Surroundings& in, std::uint32_t tree, Sweep& sweep);
  void shape_at(const Surroundings& in, std::uint32_t tree, double fraction, const TreeShape& out) const;
  unsigned steps_of(const Surroundings& in, std::uint32_t tree) const;
  void follow(const Surroundings& in, std::uint32_t tree, std::uint32_t worker);
  bool is_blocked(const Surroundings& in, std::uint32_t tree, Sweep& sweep);
  void gather(const Surroundings& in, std::uint32_t tree, const Circle& all, Sweep& sweep) const;
  Circle circle_about(const Solids& solids, std::uint32_t tree, const TreeShape& shape) const;
  bool meets(const Surroundings& in, std::uint32_t tree, const TreeShape& shape, Sweep& sweep) const;
  bool meets_wall(const Surroundings& in, std::size_t solid, const Body& now, const Body& then) const;
  bool meets_inside(const Surroundings& in, std::size_t solid, const Body& now, const Body& then) const;
  bool meets_other(const Surroundings& in, std::size_t solid, const Body& now, const Body& then,
                   std::size_t other, Sweep& sweep) const;
  /// A solid where it is, and where its tree's proposal has it.
  static Body body_now(const Solids& solids, std::size_t row);
  Body proposed(const Solids& solids, std::size_t row) const;
  /// How far the proposal of a tree that lifts has a solid above or below where it is. [m]
  double rise_of(const Solids& solids, std::size_t row) const {
    return std::fabs(z_[place_of(row)] + solids.z_min_M[row] - solids.z_min[row]);
  }
  void decide();
  void commit(world::World& world, Solids& solids, std::uint32_t tree) const;
  void put(world::Models& models, Solids& solids, std::uint32_t tree) const;
  /// The proposal's own memory, with the sweep's for what can be computed again.
  TreeShape proposal(const Solids& solids, std::uint32_t tree, Sweep& sweep);

  /// Row in its tree of the parent of a model, the tree's `place`-th.
  std::uint32_t parent_of(const world::Models& models, std::uint32_t tree, std::uint32_t model,
                          std::size_t place) const {
    const std::uint32_t first = first_parent_[tree];
    return first == world::ModelRow::kNone ? models.parent[model] - trees_->root[tree]
                                           : parent_[first + place];
  }
  /// Where the proposal of a moving solid and of its vertices begins.
  std::size_t place_of(std::size_t solid) const { return solid - fixed_; }
  std::size_t vertex_of(const Solids& solids, std::size_t solid) const {
    return solids.first_vertex[solid] - fixed_vertices_;
  }

  const Trees* trees_ = nullptr;
  Headroom headroom_;
  std::size_t fixed_ = 0, fixed_vertices_ = 0;  // of Solids, before those that can move
  // Rows as in Trees.
  std::vector<std::uint8_t> proposes_, stalls_;  // (trees)
  std::vector<std::uint8_t> free_;               // 1: it has headroom, so its proposal is a pose  (trees)
  std::vector<std::uint8_t> lifts_;              // the proposal changes heights (trees)
  std::vector<Conflicts> conflicts_;             // (trees)
  std::vector<double> way_;                      // displacement of the top of a rigid tree  [m] (trees)
  std::vector<double> reach_;                    // no centre of a solid is displaced by more  [m] (trees)
  // Row in its tree of a model's parent, for trees whose models are no run of rows: others were attached to
  // them. For a run it follows from the model's row.
  std::vector<std::uint32_t> first_parent_;  // of parent_, or Row::kNone for a run                (trees)
  std::vector<std::uint32_t> parent_;        // (models of such trees)
  double reach_max_ = 0, rise_max_ = 0;      // m, of this tick: what a proposal is away, and above or below
  // The proposals; rows as in Trees::movers, in Trees, and in Solids from the first that can move on.
  std::vector<Pose> moved_;         // X_PM of those that move by themselves
  std::vector<Rotation> rotation_;  // of the top
  std::vector<Vec2> center_, p_;
  std::vector<double> z_;      // of the solid's model in W, where the tree lifts
  std::vector<Sweep> sweeps_;  // one per worker
};

}  // namespace playhouse::stage
