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
  struct Body {
    static constexpr std::uint32_t kNone = world::ModelRow::kNone;
    Part part = Part::kGuided;
    std::uint32_t number = kNone;           // in Physics; kNone: it has no collision shape
    double radius = 0;                      // m, of its corners from B's upright axis, at most
    bool has_joints = false;                // parts of it have joints
    std::vector<geom::SpatialPose> joints;  // X_PM of those parts as last given to Physics
    std::vector<std::uint32_t> models;      // model row of each hull (hulls)
  };

  void move() override;
  /// The hulls as given to Physics, without Bullet's collision margin.
  world::PhysicsShapes shapes() const override;
  void populated(bool fixed) override;
  void replaced(std::uint32_t) override {}

  Body make_body(std::uint32_t tree);
  std::span<const bodies::Mover> movers_of(std::uint32_t tree) const;
  /// Movers of the tree; the root is one only if the body is kinematic.
  std::span<const bodies::Mover> parts_of(std::uint32_t tree) const;
  void load(std::uint32_t tree);
  void load_guided(std::uint32_t tree);
  void bend(std::uint32_t tree);
  void find_blocked(unsigned steps);
  geom::Vec3 way_of(const geom::Vec3& p, const bodies::Mover& mover) const;
  bool is_blocked(const bodies::Mover& mover) const { return blocked_[&mover - trees_.movers.data()] != 0; }
  void store(std::uint32_t tree);
  bool store_state(std::uint32_t tree);
  void store_drive(std::uint32_t tree, const geom::Pose& before);
  bool store_parts(std::uint32_t tree);
  bool is_driven(std::uint32_t tree) const;

  Physics physics_;
  mutable MeshHulls mesh_hulls_;
  std::vector<Body> bodies_;            // (trees)
  std::vector<std::uint32_t> tree_of_;  // (bodies of Physics)
  bool has_parts_ = false;              // any tree has movers in the sense of parts_of()
  std::vector<std::uint8_t> blocked_;   // (trees_.movers) in this tick
};

}  // namespace playhouse::arena
