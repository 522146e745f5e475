#pragma once

/// From models to rigid bodies: mass, hulls and wheels of a tree of models. World files give outlines
/// and heights; parameters that they leave open are chosen here. Frames: W world, B the tree's root.
///
/// In: the models of a tree, and their solids or meshes.
/// Out: hulls, mass, wheels and motors of a rigid body; the static solids.
/// Cost: the outlines and hulls of the tree. Once for a population, and hulls again when joints have
///   moved.

#include <cstdint>
#include <vector>

#include "playhouse/arena/physics/mesh_solids.h"
#include "playhouse/arena/physics/physics.h"
#include "playhouse/bodies/bodies.h"

namespace playhouse::arena {

/// How a tree of models is simulated.
enum class MotionType : std::uint8_t {
  kVehicle,  // a robot with wheels on the ground
  kLoose,    // dynamic body
  kGuided,   // kinematic body: moved by its actuators or library, pushes others
};

/// How tree `tree` is simulated.
MotionType motion_type_of(const world::World& world, const bodies::Trees& trees, const bodies::Solids& solids,
                          bodies::TreeRow tree);

/// Positions of a tree's joints: those of the tick, or those that the world file gives.
enum class Joints : std::uint8_t { kNow, kAtRest };

/// Hulls, which are corners alone for who draws them.
struct Hulls : ByRow<Hull, Hull> {
  operator std::vector<std::vector<Vec3>>() const { return {begin(), end()}; }
};

/// Hulls in B, and the model of each.
struct TreeHulls {
  Hulls hulls;
  ByRow<Hull, world::ModelRow> models;
};

/// The obstacles of a tree as convex hulls at these joint positions; of a vehicle only
/// above the ground clearance of its wheels. Models with a mesh have the hulls of the mesh.
TreeHulls hulls_of(const world::World& world, const bodies::Trees& trees, const bodies::Solids& solids,
                   bodies::TreeRow tree, MotionType type, Joints joints, MeshHulls& meshes);

/// The body of a tree with at least one hull. With hulls at rest it does not depend on
/// what joints did: an arm that reaches out moves no wheel, and no mass.
RigidBodyDesc plan_body(const world::World& world, const bodies::Trees& trees, bodies::TreeRow tree,
                        MotionType type, std::vector<Hull> hulls);

/// The static obstacles.
std::vector<FixedSolid> fixed_solids(const world::World& world, const bodies::Solids& solids);

}  // namespace playhouse::arena
