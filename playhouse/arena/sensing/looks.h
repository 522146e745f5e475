#pragma once

/// Appearance of models to cameras of the arena: meshes and lights. Pure functions.
///
/// In: the description of a model, its colour and pose.
/// Out: its mesh, lights and gait.
/// Cost: the triangles of a mesh; the rest is constant.

#include <string_view>

#include "playhouse/bodies/bodies.h"
#include "playhouse/mesh/mesh.h"
#include "playhouse/render/renderer.h"

namespace playhouse::arena {

/// How a camera draws a model.
enum class Look : std::uint8_t { kSolid, kPerson, kSmoke };
Look look_of(const scene::ModelDesc& desc);

/// The surface of a model in its own frame: the mesh of its solids,
/// `rows`, white, with the shininess of its material.
mesh::Mesh mesh_of(const scene::ModelDesc& desc, const bodies::Solids& solids, bodies::SolidRows rows);

/// The surfaces of a model's look in its own frame: white ones without texture, which have the colour of the
/// model, or all others.
mesh::Mesh part_of_look(const scene::ModelDesc& desc, bool painted);

/// Linear RGB and opacity.
std::array<float, 4> light_of(const scene::Color& color);

/// What the pose of a person follows from. Frame: W.
struct Walker {
  geom::SpatialVelocity V;  // m/s, rad/s
  double heading = 0;       // rad
  double height = 0;        // m
  std::uint32_t id = 0;     // of its model
  std::string_view says;
};

/// The gait of a person at a time [s]: step frequency is constant, so stride length is
/// proportional to speed and the gait is a function of the state alone.
render::Gait gait_of(const Walker& walker, double time);

/// The center of a model's body.  [m, in M]
geom::Vec3 middle_of(const scene::ModelDesc& desc);

/// The lamp of a model at p, q in W: a point light at the center of its body.
render::Lamp lamp_of(const scene::ModelDesc& desc, const scene::Color& color, const geom::Vec3& p,
                     const geom::Quaternion& q);
/// Appends the positional lights of a mesh, for a model at p, q in W.
void add_lamps(const mesh::Mesh& mesh, const geom::Pose& X_MB, const geom::Vec3& p, const geom::Quaternion& q,
               std::vector<render::Lamp>& lamps);

/// Sun, sky and fog of a world file at a time. [s]
render::Environment surroundings_of(const scene::WorldDesc& world, double time);

}  // namespace playhouse::arena
