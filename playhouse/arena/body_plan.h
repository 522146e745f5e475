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
  kGuided,   // as its actuators or library say; what is in the way is pushed
};

/// Of tree `tree`.
Part part_of(const world::World& world, const stage::Trees& trees, const stage::Solids& solids,
             std::uint32_t tree);

/// Hulls in B, and the row of the model that each is of.
struct TreeHulls {
  std::vector<Hull> hulls;
  std::vector<std::uint32_t> models;
};

/// The obstacles of a tree as convex hulls, where its joints have them; of a vehicle above the clearance of
/// its wheels. Models with a mesh have those of the mesh.
TreeHulls hulls_of(const world::World& world, const stage::Trees& trees, const stage::Solids& solids,
                   std::uint32_t tree, Part part, MeshHulls& meshes);

/// The body of a tree of which hulls_of() are not empty.
BodyDesc plan_body(const world::World& world, const stage::Trees& trees, std::uint32_t tree, Part part,
                   std::vector<Hull> hulls);

/// The obstacles that stand still.
std::vector<FixedSolid> fixed_solids(const world::World& world, const stage::Solids& solids);

}  // namespace playhouse::arena
