#include "playhouse/arena/looks.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "playhouse/arena/solid_bodies.h"
#include "playhouse/arena/triangles.h"
#include "playhouse/stage/camera_image.h"

namespace playhouse::arena {
namespace {

using geom::Vec3;

constexpr double kStridesPerSecond = 0.95;  // of who walks; Whittle, "Gait Analysis", gives 0.85 to 1.1
constexpr double kRunsPerSecond = 1.4;      // of who runs
constexpr double kRunning = 2.2;            // m/s
constexpr double kStanding = 0.02;          // m/s
constexpr float kSunlight = 0.72f, kDaylight = 0.42f, kNight = 0.05f;  // see render::Surroundings
constexpr double kMostCandela = 1e9;  // beyond any lighthouse; more would be no float
constexpr double kTwilight = 0.35;    // sine of the elevation of a sun that is up altogether

struct Shine {
  std::string_view material;
  float metallic, roughness;
};
constexpr std::array kShines = {
    Shine{"steel", 0.85f, 0.35f}, Shine{"glass", 0, 0.05f},   Shine{"ice", 0, 0.12f},
    Shine{"plastic", 0, 0.4f},    Shine{"wood", 0, 0.7f},     Shine{"rubber", 0, 0.85f},
    Shine{"concrete", 0, 0.95f},  Shine{"asphalt", 0, 0.95f}, Shine{"carpet", 0, 1},
};
constexpr Shine kUnknown{"", 0, 0.6f};

mesh::Material material_of(const scene::ModelDesc& desc) {
  Shine shine = kUnknown;
  for (const Shine& known : kShines)
    if (known.material == desc.material) shine = known;
  mesh::Material material;
  material.metallic = shine.metallic;
  material.roughness = shine.roughness;
  return material;
}

std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Flat faces: each corner has the normal of the triangle that it is a corner of.
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
  if (desc.material == "smoke") return Look::kSmoke;
  const bool walks = desc.kind == scene::ModelKind::kPosition && desc.position &&
                     desc.position->drive == scene::Drive::kWalk;
  return walks && desc.size.z > 0 ? Look::kPerson : Look::kSolid;
}

namespace {

/// The mesh of a file, from B to M.
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

mesh::Mesh mesh_of(const scene::ModelDesc& desc, const stage::Solids& solids, std::size_t begin,
                   std::size_t end) {
  if (desc.mesh) return mesh_in_model(*desc.mesh, desc.X_MB);
  Triangles triangles;
  each_body(solids, begin, end, stage::Observer::kImage, [&](std::size_t first, std::size_t last) {
    const std::vector<std::vector<geom::Vec2>> outlines = outlines_of(solids, first, last, {});
    const std::vector<geom::Outline> all(outlines.begin(), outlines.end());
    add_extrusion(triangles, all, solids.z_min_M[first], solids.z_max_M[first]);
  });
  mesh::Mesh mesh;
  mesh.materials.push_back(material_of(desc));
  mesh.surfaces.push_back(surface_of(triangles));
  return mesh;
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

render::Gait gait_of(const Vec3& v, double heading, double height, double time, std::uint32_t id) {
  const double speed = std::sqrt(v.x * v.x + v.y * v.y);
  render::Gait gait;
  if (!(speed >= kStanding) || !(height > 0)) return gait;
  const geom::Rotation turn = geom::Rotation::of(heading);
  const double per_second = speed > kRunning ? kRunsPerSecond : kStridesPerSecond;
  const double way = v.x * turn.c + v.y * turn.s < 0 ? -1 : 1;
  gait.stride = way * speed / per_second / height;
  // People who come along together are not in step.
  gait.phase = 2 * geom::kPi * std::fmod(time * per_second + 0.618 * (id % 1024), 1.0);
  return gait;
}

render::Surroundings surroundings_of(const scene::WorldDesc& world, double time) {
  render::Surroundings around;
  const geom::SinCos heading = geom::sincos(world.sun_heading), up = geom::sincos(world.sun_elevation);
  around.to_sun = {up.cos * heading.cos, up.cos * heading.sin, up.sin};
  around.sun = kSunlight * static_cast<float>(std::clamp(world.sun_brightness, 0.0, 100.0));
  const auto day = static_cast<float>(std::clamp(up.sin / kTwilight, 0.0, 1.0));
  around.ambient = kNight + (kDaylight - kNight) * day;
  const auto rgb = [&](double r, double g, double b, float share) {
    const std::array<float, 4> light =
        light_of({static_cast<float>(r), static_cast<float>(g), static_cast<float>(b), 1});
    return render::Rgb{share * light[0], share * light[1], share * light[2]};
  };
  const float of_day = around.ambient / kDaylight;
  around.sky = rgb(world.sky_red, world.sky_green, world.sky_blue, of_day);
  around.fog = rgb(world.fog_red, world.fog_green, world.fog_blue, of_day);
  const auto channel = [](int shift) { return (stage::kFloorColor >> shift & 0xff) / 255.0; };
  around.floor = rgb(channel(16), channel(8), channel(0), 1);
  around.visibility = world.fog;
  around.seconds = time;
  return around;
}

}  // namespace playhouse::arena
