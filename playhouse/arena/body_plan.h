#pragma once

/// From models to rigid bodies: what a tree of models weighs, its hulls, and the wheels of a robot. Stage's
/// files say outlines and heights; what they leave open is chosen here. Frames: W world, B the tree's top.

#include <cstdint>
#include <vector>

#include "playhouse/arena/mesh_solids.h"
#include "playhouse/arena/physics.h"
#include "playhouse/stage/bodies.h"

namespace playhouse::arena {

/// How the tree of models moves.
enum class Part : std::uint8_t {
  kVehicle,  // a robot with wheels on the ground
  kLoose,    // falls, slides, is pushed
  kGuided,   // as its actuators, library or the plane say, whatever is in the way
};

/// Of tree `tree`.
Part part_of(const world::World& world, const stage::Trees& trees, const stage::Solids& solids,
             std::uint32_t tree);

/// The obstacles of a tree as convex hulls in B, where its joints have them; of a vehicle above the clearance
/// of its wheels. Models with a mesh have those of the mesh.
std::vector<Hull> hulls_of(const world::World& world, const stage::Trees& trees, const stage::Solids& solids,
                           std::uint32_t tree, Part part, MeshHulls& meshes);

/// The body of a tree of which hulls_of() are not empty.
BodyDesc plan_body(const world::World& world, const stage::Trees& trees, std::uint32_t tree, Part part,
                   std::vector<Hull> hulls);

/// The obstacles that stand still.
std::vector<FixedSolid> fixed_solids(const world::World& world, const stage::Solids& solids);

}  // namespace playhouse::arena
