#pragma once

/// Motion: moves whole trees of models. The result is that of trees moving one
/// after the other in row order. Every tree with a moving mover proposes a new
/// configuration. The proposal is refused, and the tree stalls in place, if
/// the way there hits a static solid or another tree: at its new place if it
/// is before this one in row order, at its old place if after. So no two trees
/// come to overlap, and a refused move blocks no other. A tree that overlaps
/// something already may move unless that makes the penetration deeper.
/// Proposals and their hits are found in parallel; hits that depend on earlier trees are recorded as
/// conflicts, and one sequential pass in row order resolves them. Deterministic for any number of threads.
/// Fast path: a tree with headroom (headroom.h) hits nothing, so only its root pose is proposed.
///
/// In: velocities and poses of the movers; the movable solids in an index, and the walls.
/// Out: poses of models, solids placed in W, stalls, odometry.
/// Cost: a pose for a tree with headroom. Any other has, for each substep of its way, a query of the
///   walls for each of its solids, and a test of outlines for each pair of near ones; the pass over
///   conflicts is sequential.

#include <cmath>
#include <vector>

#include "playhouse/bodies/bodies.h"
#include "playhouse/bodies/disc_index.h"
#include "playhouse/bodies/fast_bodies.h"
#include "playhouse/bodies/overlap.h"
#include "playhouse/bodies/walls.h"
#include "playhouse/stage/headroom.h"
#include "playhouse/world/workers.h"

namespace playhouse::stage {

class Motion {
 public:
  explicit Motion(unsigned workers) : sweeps_(workers) {}

  /// Sizes the buffers for these trees, which must outlive the next move().
  void populate(const bodies::Trees& trees, const bodies::Solids& solids, const world::Models& models);
  /// To be called after a tree was teleported.
  void replaced(bodies::TreeRow tree, const bodies::Solids& solids, const world::Models& models) {
    headroom_.replaced(*trees_, tree, solids, models);
  }

  /// The phase `move`. `index` has the movable solids at their present places. True if anything moved.
  bool move(world::World& world, bodies::Solids& solids, const bodies::DiscIndex& index,
            const bodies::Walls& walls, world::Workers& workers);

 private:
  /// A way blocked by one of two places of another tree: its proposal, or where it was.
  struct Conflict {
    bodies::TreeRow with;  // a proposing tree, earlier in row order
    bool if_moved;         // true: its proposal blocks; false: its old place blocks
  };
  /// Scratch buffers of one worker, for one way at a time.
  struct Sweep {
    // The configuration of a tree at a substep of its way.
    std::vector<geom::Pose> moved, X_WM;
    std::vector<geom::Rotation> rotation;
    std::vector<geom::Vec2> center, p;
    std::vector<double> z;
    std::vector<const bodies::DiscIndex::Disc*> near;  // of other trees, near the way
    // Of all ways of this tick, way by way; keeps its capacity.
    std::vector<Conflict> conflicts;
    std::size_t first_conflict = 0;  // of the present way

    /// Adds a conflict of the present way. True if both places of the other tree block it: surely refused.
    bool add(Conflict conflict);
  };
  /// The conflicts of a way: sweeps_[worker].conflicts[begin .. end).
  struct Conflicts {
    std::uint32_t worker = 0, begin = 0, end = 0;
  };
  /// A placed solid: outline and height range [m].
  struct PlacedSolid {
    bodies::Polygon outline;
    double z_min, z_max;
  };
  /// Bounding circle and height range of a configuration. [m]
  struct Circle {
    geom::Vec2 center;
    double radius, z_min, z_max;
  };
  struct Inputs {
    const world::World& world;
    const bodies::Solids& solids;
    const bodies::DiscIndex& index;
    const bodies::Walls& walls;
  };

  void add_parents(std::span<const world::ModelRow> rows, const world::Models& models, bodies::TreeRow tree);
  void propose(const Inputs& in, bodies::TreeRow tree, Sweep& sweep);
  bodies::TreeShape propose_shape(const Inputs& in, bodies::TreeRow tree, Sweep& sweep);
  void propose_rest(const Inputs& in, bodies::TreeRow tree, Sweep& sweep);
  void shape_at(const Inputs& in, bodies::TreeRow tree, double fraction, const bodies::TreeShape& out) const;
  unsigned steps_of(const Inputs& in, bodies::TreeRow tree) const;
  void follow(const Inputs& in, bodies::TreeRow tree, std::uint32_t worker);
  bool is_blocked(const Inputs& in, bodies::TreeRow tree, Sweep& sweep);
  void gather(const Inputs& in, bodies::TreeRow tree, const Circle& all, Sweep& sweep) const;
  Circle circle_about(const bodies::Solids& solids, bodies::TreeRow tree,
                      const bodies::TreeShape& shape) const;
  bool meets(const Inputs& in, bodies::TreeRow tree, const bodies::TreeShape& shape, Sweep& sweep) const;
  bool meets_wall(const Inputs& in, bodies::SolidRow solid, const PlacedSolid& now,
                  const PlacedSolid& then) const;
  bool meets_inside(const Inputs& in, bodies::SolidRow solid, const PlacedSolid& now,
                    const PlacedSolid& then) const;
  bool meets_other(const Inputs& in, bodies::SolidRow solid, const PlacedSolid& now, const PlacedSolid& then,
                   bodies::SolidRow other, Sweep& sweep) const;
  /// A solid at its present place, and as its tree proposes it.
  static PlacedSolid solid_now(const bodies::Solids& solids, bodies::SolidRow row);
  PlacedSolid proposed(const bodies::Solids& solids, bodies::SolidRow row) const;
  /// By how much a proposal that changes heights raises or lowers a solid. [m]
  double rise_of(const bodies::Solids& solids, bodies::SolidRow row) const {
    return std::fabs(z_[place_of(row)] + solids.z_min_M[row] - solids.z_min[row]);
  }
  void decide();
  void commit(world::World& world, bodies::Solids& solids, bodies::TreeRow tree) const;
  void put(world::Models& models, bodies::Solids& solids, bodies::TreeRow tree) const;
  /// A view of the proposal: its own buffers, and the sweep's for what can be recomputed.
  bodies::TreeShape proposal(const bodies::Solids& solids, bodies::TreeRow tree, Sweep& sweep);

  /// Row in its tree of the parent of a model, which is the tree's `place`-th.
  std::uint32_t parent_of(const world::Models& models, bodies::TreeRow tree, world::ModelRow model,
                          std::size_t place) const {
    const std::uint32_t first = first_parent_[tree];
    return first == world::ModelRow::kNone ? models.parent[model] - trees_->root[tree]
                                           : parent_[first + place];
  }
  /// Where the proposal of a movable solid, and of its vertices, begins.
  std::size_t place_of(bodies::SolidRow solid) const { return solid - first_moving_; }
  std::size_t vertex_of(const bodies::Solids& solids, bodies::SolidRow solid) const {
    return solids.first_vertex[solid] - first_moving_vertex_;
  }

  const bodies::Trees* trees_ = nullptr;
  Headroom headroom_;
  bodies::FastBodies fast_;
  // As in Solids.
  bodies::SolidRow first_moving_;
  bodies::VertexRow first_moving_vertex_;
  // Rows as in Trees.
  template <typename Value>
  using ByTree = ByRow<bodies::Trees, Value>;
  ByTree<std::uint8_t> proposes_, stalls_;
  ByTree<std::uint8_t> free_;   // 1: has headroom, so only a root pose is proposed
  ByTree<std::uint8_t> lifts_;  // the proposal changes heights
  ByTree<Conflicts> conflicts_;
  ByTree<double> way_;    // displacement of the root of a rigid tree  [m]
  ByTree<double> reach_;  // bound on the displacement of centers  [m]
  // Row in its tree of a model's parent, for trees whose models are not consecutive rows
  // because others were attached to them. For consecutive rows it follows from the model's row.
  ByTree<std::uint32_t> first_parent_;  // of parent_, or Row::kNone for a run
  std::vector<std::uint32_t> parent_;   // (models of such trees)
  double rise_max_ = 0;                 // m, bound for this tick: rise or drop
  // The proposals; rows as in Trees::movers, in Trees, and in Solids counted from the first movable one.
  ByRow<bodies::Mover, geom::Pose> moved_;  // X_PM
  ByTree<geom::Rotation> rotation_;         // of the root
  std::vector<geom::Vec2> center_, p_;
  std::vector<double> z_;      // of the solid's model in W, if the tree lifts
  std::vector<Sweep> sweeps_;  // one per worker
};

}  // namespace playhouse::stage
