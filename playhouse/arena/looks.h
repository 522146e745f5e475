#pragma once

/// What models look like to cameras of the arena: meshes and light. Pure functions.

#include "playhouse/mesh/mesh.h"
#include "playhouse/render/renderer.h"
#include "playhouse/stage/bodies.h"

namespace playhouse::arena {

/// How a camera shows a model.
enum class Look : std::uint8_t { kSolid, kPerson, kSmoke };
Look look_of(const scene::ModelDesc& desc);

/// The surface of a model in its own frame: of its solids, the rows [begin, end), white, as what it is made
/// of shines.
mesh::Mesh mesh_of(const scene::ModelDesc& desc, const stage::Solids& solids, std::size_t begin,
                   std::size_t end);

/// Linear red, green and blue, and opacity.
std::array<float, 4> light_of(const scene::Color& color);

/// How a person walks who moves with v (in W) towards `heading`, at a time: two steps take as long at any
/// speed, so that the strides follow from the speed, and the gait from the state alone. [m/s, rad, s]
render::Gait gait_of(const geom::Vec3& v, double heading, double height, double time, std::uint32_t id);

/// The middle of the body of a model.  [m, in M]
geom::Vec3 middle_of(const scene::ModelDesc& desc);

/// The lamp that is a model at p and q in W: in the middle of its body, every way alike.
render::Lamp lamp_of(const scene::ModelDesc& desc, const scene::Color& color, const geom::Vec3& p,
                     const geom::Quaternion& q);
/// Appends the lights of a mesh that have a place, of a model at p and q in W.
void add_lamps(const mesh::Mesh& mesh, const geom::Pose& X_MB, const geom::Vec3& p, const geom::Quaternion& q,
               std::vector<render::Lamp>& lamps);

/// Sun, sky and fog, as a world file says them, at a time. [s]
render::Surroundings surroundings_of(const scene::WorldDesc& world, double time);

}  // namespace playhouse::arena
