#include "playhouse/arena/sensing/lidar_echo.h"

#include <cmath>

namespace playhouse::arena {
namespace {

using geom::Vec3;

constexpr double kSkin = 1e-3;         // m, offset of a continued beam from the surface
constexpr double kSquareOn = 0.99996;  // cosine of 0.5 degrees: a specular reflection returns into the lens
constexpr double kLost = 1e-4;         // share of light below which a beam is dropped
constexpr Optics kFloor{0.24, 0, 0};   // the ground is concrete

/// Continues a beam after a reflection or a transmission.
void go_on(Beam& beam, const Met& met, bool is_mirrored) {
  const double along = dot(beam.d, met.normal);
  beam.p = beam.p + met.range * beam.d;
  if (is_mirrored) {
    beam.d = beam.d - 2 * along * met.normal;
    beam.group = RayBatch::kNobody;
    beam.p = beam.p + (along > 0 ? -kSkin : kSkin) * met.normal;
  } else {
    beam.p = beam.p + kSkin * beam.d;
  }
}

/// The first hit of a beam, including the ground.
Met first_met(const RayScene& scene, const Beam& beam) {
  RayBatch batch;
  batch.count = 1;
  batch.group = beam.group;
  batch.wants_normals = true;
  batch.p = beam.p;
  batch.set_ray(0, beam.d, static_cast<float>(beam.range_max));
  scene.cast(batch);
  const Met met{batch.range[0], batch.met[0], batch.facing[0], {batch.nx[0], batch.ny[0], batch.nz[0]}};
  const Met ground = ground_met(beam);
  return ground.range < met.range ? ground : met;
}

}  // namespace

Met ground_met(const Beam& beam) {
  const double down = -beam.d.z;
  if (!(down > 0) || beam.p.z < 0 || beam.p.z >= beam.range_max * down)
    return {beam.range_max, RayBatch::kNobody, 0, {}};
  return {beam.p.z / down, kGround, down, {0, 0, 1}};
}

Optics Surfaces::of(std::uint32_t id) const {
  if (id == kGround) return kFloor;
  Optics surface = optics[id];
  if (surface.scatters < 0) surface.scatters = scatters(world.models.color[world::ModelRow{id}]);
  surface.scatters *= world.desc({id}).ranger_return;
  return surface;
}

LightEcho echo_of(const RayScene& scene, const Surfaces& surfaces, Beam beam, Met met, double weakest) {
  double gone = 0, light = 1;
  for (int bounce = 0; met.id != RayBatch::kNobody; ++bounce) {
    const Optics surface = met_at(surfaces.of(met.id), met.facing);
    const double range = gone + met.range;
    const double returned =
        light * (surface.scatters * met.facing + (met.facing >= kSquareOn ? surface.mirrors : 0));
    const double power = echo_power(returned, range);
    if (power >= weakest) return {true, range, returned, power};
    const bool is_mirrored = surface.mirrors > surface.passes;
    const double goes_on = is_mirrored ? surface.mirrors : surface.passes;
    light *= goes_on * goes_on;  // two-way
    if (light < kLost || bounce == kBounces) break;
    go_on(beam, met, is_mirrored);
    beam.range_max -= met.range;
    gone = range;
    if (beam.range_max <= 0) break;
    met = first_met(scene, beam);
  }
  return {};
}

}  // namespace playhouse::arena
