#pragma once

/// ArenaEngine: rigid-body dynamics of models and wheeled robots. Rangers and
/// cameras work in 3D (lidar_sense.h, camera_sense.h); the other senses are those
/// of the stage engine, on extruded outlines at heights. Thread: the tick thread.
///
/// In: the state before the phase `move`: poses, tilts, velocities and commands of trees.
/// Out: the state after it.
/// Cost: that of Physics::step(); for a tree whose joints have moved, also new hulls.

#include <vector>

#include "playhouse/arena/body_plan.h"
#include "playhouse/arena/physics/mesh_solids.h"
#include "playhouse/arena/physics/physics.h"
#include "playhouse/senses/body_engine.h"

namespace playhouse::arena {

class ArenaEngine final : public senses::BodyEngine {
 public:
  ArenaEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers,
              const ContactSurface& ground);

 private:
  /// The rigid body of a tree of models.
  struct TreeBody {
    MotionType motion = MotionType::kGuided;
    RigidBodyRow row;                       // in Physics; none: it has no collision shape
    double radius = 0;                      // m, of its corners from B's upright axis, at most
    bool has_joints = false;                // parts of it have joints
    std::vector<geom::SpatialPose> joints;  // X_PM of those parts as last given to Physics
    ByRow<Hull, world::ModelRow> models;    // model row of each hull
  };

  void move() override;
  /// The hulls as given to Physics, without Bullet's collision margin.
  world::PhysicsShapes shapes() const override;
  void populated(bool fixed) override;
  void replaced(bodies::TreeRow) override {}

  TreeBody make_body(bodies::TreeRow tree);
  /// Movers of the tree; the root is one only if the body is kinematic.
  std::span<const bodies::Mover> parts_of(bodies::TreeRow tree) const;
  void load(bodies::TreeRow tree);
  void load_guided(bodies::TreeRow tree);
  void bend(bodies::TreeRow tree);
  void find_blocked(unsigned steps);
  geom::Vec3 way_of(const geom::Vec3& p, const bodies::Mover& mover) const;
  bool is_blocked(const bodies::Mover& mover) const { return blocked_[trees_.row_of(mover)] != 0; }
  void store(bodies::TreeRow tree);
  bool store_state(bodies::TreeRow tree);
  void store_drive(bodies::TreeRow tree, const geom::Pose& before);
  bool store_parts(bodies::TreeRow tree);
  bool is_driven(bodies::TreeRow tree) const;

  Physics physics_;
  mutable MeshHulls mesh_hulls_;
  ByRow<bodies::Trees, TreeBody> bodies_;
  ByRow<RigidBody, bodies::TreeRow> tree_of_;
  bool has_parts_ = false;                      // any tree has movers in the sense of parts_of()
  ByRow<bodies::Mover, std::uint8_t> blocked_;  // in this tick
};

}  // namespace playhouse::arena
