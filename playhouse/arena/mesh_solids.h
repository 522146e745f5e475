#pragma once

/// Meshes of models as solids for physics and as triangles for rays. Frames: B body of the model, F whatever
/// has it.

#include <map>
#include <vector>

#include "playhouse/arena/rigid_body.h"
#include "playhouse/arena/triangles.h"
#include "playhouse/world/world.h"

namespace playhouse::mesh {
struct Mesh;
}

namespace playhouse::arena {

/// The mesh of a model; null where its body is prisms.
const mesh::Mesh* mesh_of(const world::World& world, std::uint32_t model);
/// Where a model's body is in F, in which it stands upright.
geom::Pose body_in(const world::World& world, std::uint32_t model, const geom::Pose& X_FM);

/// Adds all surfaces of a mesh.
void add_surfaces(Triangles& triangles, const mesh::Mesh& mesh, const geom::Pose& X_FB);

/// Convex solids of meshes that move, in B: the shapes that their files have for physics, round ones as
/// polyhedra and triangles as the hull of them; without any a hull for each part (mesh/parts.h). Each mesh is
/// looked at once.
class MeshHulls {
 public:
  const std::vector<Hull>& of(const mesh::Mesh& mesh);

 private:
  std::map<const mesh::Mesh*, std::vector<Hull>> known_;
};

/// What stands still of a mesh: convex solids, and triangles of what is not convex.
struct FixedParts {
  std::vector<Hull> hulls;
  Triangles triangles;
};
FixedParts fixed_parts(const mesh::Mesh& mesh, const geom::Pose& X_FB);

/// Volume and centre of the convex hull of some points; no volume where they are in one plane.
struct HullContent {
  double volume = 0;  // m^3
  Vec3 center;        // m
};
HullContent hull_content(const Hull& hull);

}  // namespace playhouse::arena
