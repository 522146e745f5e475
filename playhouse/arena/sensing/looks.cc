#include "playhouse/arena/sensing/looks.h"

#include <algorithm>
#include <cmath>

#include "playhouse/arena/solid_bodies.h"
#include "playhouse/arena/triangles.h"
#include "playhouse/mesh/import/painted.h"
#include "playhouse/scene/forms/daylight.h"
#include "playhouse/scene/forms/materials.h"
#include "playhouse/world/generated/gestures.h"

namespace playhouse::arena {
namespace {

using geom::Vec3;

constexpr double kStridesPerSecond = 0.95;  // gait cycles per second, walking; Whittle: 0.85 to 1.1
constexpr double kRunsPerSecond = 1.4;      // running
constexpr double kRunning = 2.2;            // m/s, from walking to running
constexpr double kStanding = 0.02;          // m/s, below: standing
constexpr double kTurning = 0.2;            // rad/s, from standing to stepping in place
constexpr double kMostCandela = 1e9;        // upper bound, to fit a float

mesh::Material mesh_material_of(const scene::ModelDesc& desc) {
  const scene::NamedMaterial known = scene::material_of(desc);
  mesh::Material material;
  material.metallic = known.metallic;
  material.roughness = known.roughness;
  return material;
}

std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Flat shading: corners have the normal of their triangle.
mesh::Surface surface_of(const Triangles& triangles) {
  mesh::Surface surface;
  surface.normal.resize(triangles.p.size(), {0, 0, 1});
  for (const Vec3& p : triangles.p) surface.p.push_back(floats(p));
  for (const auto& corner : triangles.corner) {
    const Vec3 &a = triangles.p[corner[0]], &b = triangles.p[corner[1]], &c = triangles.p[corner[2]];
    const Vec3 n = cross(b - a, c - a);
    const double length = std::sqrt(dot(n, n));
    if (!(length > 0)) continue;
    for (const std::uint32_t i : corner) surface.normal[i] = floats((1 / length) * n);
    surface.corners.push_back(corner);
  }
  return surface;
}

}  // namespace

Look look_of(const scene::ModelDesc& desc) {
  if (scene::is_smoke(desc)) return Look::kSmoke;
  const bool walks = desc.kind == scene::ModelKind::kPosition && desc.position &&
                     desc.position->drive == scene::Drive::kWalk;
  return walks && desc.size.z > 0 ? Look::kPerson : Look::kSolid;
}

namespace {

/// A mesh transformed from B to M.
mesh::Mesh mesh_in_model(const mesh::Mesh& of_body, const geom::Pose& X_MB) {
  mesh::Mesh mesh = of_body;
  const geom::Quaternion q = geom::orientation(X_MB.a, {});
  const geom::Vec3 p_MB{X_MB.x, X_MB.y, X_MB.z};
  const auto moved = [&](std::array<float, 3>& v, const geom::Vec3& by) {
    const geom::Vec3 p = q * geom::Vec3{v[0], v[1], v[2]} + by;
    v = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  };
  for (mesh::Surface& surface : mesh.surfaces) {
    for (auto& p : surface.p) moved(p, p_MB);
    for (auto& normal : surface.normal) moved(normal, {});
  }
  return mesh;
}

}  // namespace

mesh::Mesh mesh_of(const scene::ModelDesc& desc, const bodies::Solids& solids, bodies::SolidRows rows) {
  if (desc.mesh) return mesh_in_model(*desc.mesh, desc.X_MB);
  Triangles triangles;
  each_body(solids, rows, bodies::SeenBy::kImage, [&](bodies::SolidRows body) {
    const std::vector<std::vector<geom::Vec2>> outlines = outlines_of(solids, body, {});
    const std::vector<geom::Outline> all(outlines.begin(), outlines.end());
    add_extrusion(triangles, all, solids.z_min_M[body.front()], solids.z_max_M[body.front()]);
  });
  mesh::Mesh mesh;
  mesh.materials.push_back(mesh_material_of(desc));
  mesh.surfaces.push_back(surface_of(triangles));
  return mesh;
}

mesh::Mesh part_of_look(const scene::ModelDesc& desc, bool painted) {
  mesh::Mesh part = *desc.look;
  std::erase_if(part.surfaces, [&](const mesh::Surface& surface) {
    return mesh::is_painted(desc.look->materials[surface.material]) != painted;
  });
  return mesh_in_model(part, desc.X_MB);
}

Vec3 middle_of(const scene::ModelDesc& desc) {
  return {desc.X_MB.x, desc.X_MB.y, desc.X_MB.z + 0.5 * desc.size.z};
}

render::Lamp lamp_of(const scene::ModelDesc& desc, const scene::Color& color, const geom::Vec3& p,
                     const geom::Quaternion& q) {
  const std::array<float, 4> light = light_of(color);
  const auto candela = static_cast<float>(std::min(desc.lamp, kMostCandela));
  render::Lamp lamp;
  lamp.p = p + q * middle_of(desc);
  lamp.light = {candela * light[0], candela * light[1], candela * light[2]};
  return lamp;
}

void add_lamps(const mesh::Mesh& mesh, const geom::Pose& X_MB, const geom::Vec3& p, const geom::Quaternion& q,
               std::vector<render::Lamp>& lamps) {
  const geom::Quaternion q_WB = q * geom::orientation(X_MB.a, {});
  for (const mesh::Light& light : mesh.lights) {
    if (light.kind == mesh::LightKind::kDirection) continue;
    render::Lamp lamp;
    lamp.p = p + q * Vec3{X_MB.x, X_MB.y, X_MB.z} + q_WB * light.p;
    lamp.light = light.color;
    if (light.kind == mesh::LightKind::kSpot) {
      lamp.way = q_WB * light.d;
      lamp.inner = static_cast<float>(geom::sincos(light.inner).cos);
      lamp.outer = static_cast<float>(geom::sincos(light.outer).cos);
    }
    lamps.push_back(lamp);
  }
}

std::array<float, 4> light_of(const scene::Color& color) {
  return {render::linear(color.r), render::linear(color.g), render::linear(color.b), color.a};
}

render::Gait gait_of(const Walker& walker, double time) {
  const Vec3& v = walker.V.v;
  const double speed = std::sqrt(v.x * v.x + v.y * v.y);
  const bool walks = speed >= kStanding && walker.height > 0;
  render::Gait gait;
  gait.waves = walker.says == world::kWave;
  gait.turns = !walks && std::fabs(walker.V.w.z) >= kTurning;
  // Phase offsets by id, so that people do not move in step.
  const double offset = 0.618 * (walker.id % 1024);
  gait.age = time + 10 * offset;
  const double per_second = speed > kRunning ? kRunsPerSecond : kStridesPerSecond;
  if (walks || gait.turns) gait.phase = 2 * geom::kPi * std::fmod(time * per_second + offset, 1.0);
  if (!walks) return gait;
  const geom::Rotation turn = geom::Rotation::of(walker.heading);
  const double way = v.x * turn.c + v.y * turn.s < 0 ? -1 : 1;
  gait.stride = way * speed / per_second / walker.height;
  return gait;
}

render::Environment surroundings_of(const scene::WorldDesc& world, double time) {
  const scene::Daylight daylight = scene::daylight_of(world);
  render::Environment around;
  around.to_sun = daylight.to_sun;
  around.sun = daylight.sun;
  around.ambient = daylight.ambient;
  around.white_lux = daylight.white_lux;
  const auto rgb = [&](double r, double g, double b, float share) {
    const std::array<float, 4> light =
        light_of({static_cast<float>(r), static_cast<float>(g), static_cast<float>(b), 1});
    return render::Rgb{share * light[0], share * light[1], share * light[2]};
  };
  around.sky = rgb(world.sky_red, world.sky_green, world.sky_blue, daylight.day);
  around.fog = rgb(world.fog_red, world.fog_green, world.fog_blue, daylight.day);
  const auto channel = [](int shift) { return (scene::kFloorColor >> shift & 0xff) / 255.0; };
  around.floor = rgb(channel(16), channel(8), channel(0), 1);
  around.visibility = world.fog;
  around.seconds = time;
  return around;
}

}  // namespace playhouse::arena
