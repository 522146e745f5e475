#pragma once

/// Meshes of models: convex hulls for physics, triangles for rays.
/// Frames: B body of the model, F any frame chosen by the caller.
///
/// In: meshes as read from their files.
/// Out: hulls and triangles.
/// Cost: hulls of movable meshes once for each mesh; those of static ones in each call.

#include <map>
#include <vector>

#include "playhouse/arena/physics/rigid_body.h"
#include "playhouse/arena/triangles.h"
#include "playhouse/world/world.h"

namespace playhouse::mesh {
struct Mesh;
}

namespace playhouse::arena {

/// The mesh of a model; null if its body is prisms.
const mesh::Mesh* mesh_of(const world::World& world, world::ModelRow model);
/// X_FB of a model that is upright in F.
geom::Pose body_in(const world::World& world, world::ModelRow model, const geom::Pose& X_FM);

/// Appends all surfaces of a mesh.
void add_surfaces(Triangles& triangles, const mesh::Mesh& mesh, const geom::Pose& X_FB);

/// Convex hulls of movable meshes, in B: from the collision shapes of
/// their files (triangle meshes as their hull);
/// without any, a hull for each part (mesh/parts.h). Cached by mesh.
class MeshHulls {
 public:
  const std::vector<Hull>& of(const mesh::Mesh& mesh);

 private:
  std::map<const mesh::Mesh*, std::vector<Hull>> known_;
};

/// A static mesh: convex hulls, and triangles for what is not convex. A flat hull is kept, not round; a line
/// or a point is left out.
struct FixedParts {
  std::vector<Hull> hulls;
  Triangles triangles;
};
FixedParts fixed_parts(const mesh::Mesh& mesh, const geom::Pose& X_FB);

/// Volume and centroid of a hull, of a round one those of its outline; volume 0 if its corners are coplanar.
struct HullContent {
  double volume = 0;  // m^3
  Vec3 center;        // m
};
HullContent hull_content(const Hull& hull);

}  // namespace playhouse::arena
