#include "playhouse/arena/sensing/lidar_sense.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/arena/physics/mesh_solids.h"
#include "playhouse/arena/solid_bodies.h"
#include "playhouse/base/rng.h"
#include "playhouse/senses/ranger_noise.h"

namespace playhouse::arena {
namespace {

using geom::Vec3;

constexpr float kGroundReturn = 1;  // return value of the ground
// Cosine of the largest angle of incidence with an echo off a cone's axis: smooth surfaces reflect sound
// specularly (Kuc, Siegel, "Physically based simulation model for acoustic sensor robot navigation", 1987).
constexpr float kEcho = 0.5f;

/// Appends the bodies of a model visible to rangers, in F. `rows`: its solids.
void add_bodies(Triangles& triangles, const world::World& world, const bodies::Solids& solids,
                bodies::SolidRows rows, const geom::Pose& X_FM) {
  const world::ModelRow model = solids.model[rows.front()];
  if (const mesh::Mesh* mesh = mesh_of(world, model))
    return add_surfaces(triangles, *mesh, body_in(world, model, X_FM));
  each_body(solids, rows, bodies::SeenBy::kRanger, [&](bodies::SolidRows body) {
    const std::vector<std::vector<geom::Vec2>> outlines = outlines_of(solids, body, X_FM);
    const std::vector<geom::Outline> all(outlines.begin(), outlines.end());
    add_extrusion(triangles, all, X_FM.z + solids.z_min_M[body.front()],
                  X_FM.z + solids.z_max_M[body.front()]);
  });
}

/// Calls visit(model, its rows) for each model of these solids visible to rangers.
template <typename Visit>
void each_model(const bodies::Solids& solids, bodies::SolidRows rows, const Visit& visit) {
  each_run(rows, solids.model, [&](bodies::SolidRows own) {
    bool is_seen = false;
    for (const bodies::SolidRow row : own)
      is_seen = is_seen || (solids.seen_by[row] & bodies::bit(bodies::SeenBy::kRanger)) != 0;
    if (is_seen) visit(solids.model[own.front()], own);
  });
}

}  // namespace

senses::SensorTable LidarSense::table(world::World& world) const {
  return {world.rangers.model, world.rangers.measured_tick};
}

void LidarSense::populate(const world::World& world, const bodies::Space& space) {
  populate_fixed(world, space.solids);
  populate_moving(world, space.solids);
  returns_.clear();
  optics_.clear();
  for (const world::ModelRow row : world.models.rows()) {
    returns_.push_back(static_cast<float>(world.desc(row).ranger_return));
    optics_.push_back(optics_of(world.desc(row).material));
  }
  populate_rangers(world);
}

void LidarSense::populate_rangers(const world::World& world) {
  std::size_t most = 0;
  for (const world::ModelRow model : world.rangers.model) {
    const auto [entry, is_new] = beams_.try_emplace(world.models.desc[model]);
    if (is_new) entry->second = beams_of(world.desc(model));
    most = std::max(most, entry->second.beams());
  }
  for (LidarScratch& scratch : scratch_) {
    scratch.range.resize(most);
    scratch.intensity.resize(most);
  }
}

void LidarSense::populate_fixed(const world::World& world, const bodies::Solids& solids) {
  const world::Models& models = world.models;
  std::vector<bodies::StaticModel> fixed = bodies::static_models(world);
  if (fixed == fixed_) return;
  fixed_ = std::move(fixed);
  std::vector<Triangles> triangles;
  std::vector<Owner> owners;
  each_model(solids, solids.fixed_rows(), [&](world::ModelRow model, bodies::SolidRows own) {
    const FrameOfBody frame(world::pose_in_world(models, model));
    Triangles& of_model = triangles.emplace_back();
    add_bodies(of_model, world, solids, own, frame.X_FM());
    frame.turn(of_model.p);
    owners.push_back({model.index, models.root[model].index});
  });
  scene_.set_fixed(triangles, owners);
}

void LidarSense::populate_moving(const world::World& world, const bodies::Solids& solids) {
  std::vector<RayScene::OwnedShape> instances;
  instances_.clear();
  each_model(solids, solids.moving_rows(), [&](world::ModelRow model, bodies::SolidRows own) {
    const auto [entry, is_new] = shape_of_.try_emplace(world.models.desc[model]);
    if (is_new) {
      Triangles triangles;
      add_bodies(triangles, world, solids, own, {});
      entry->second = scene_.add_shape(triangles);
    }
    instances.push_back({entry->second, {model.index, world.models.root[model].index}});
    instances_.push_back(model);
  });
  scene_.set_instances(instances);
}

void LidarSense::place(const world::Models& models) {
  for (std::uint32_t i = 0; i < instances_.size(); ++i) {
    const geom::Pose& X_WM = models.X_WM[instances_[i]];
    scene_.place(i, {X_WM.x, X_WM.y, X_WM.z}, geom::orientation(X_WM.a, models.tilt_WM[instances_[i]]));
  }
  scene_.commit();
}

const LidarBeams& LidarSense::beams(const world::World& world, world::RangerRow ranger) const {
  return beams_.at(world.models.desc[world.rangers.model[ranger]]);
}

std::uint64_t LidarSense::sense(world::World& world, const bodies::Space&,
                                std::span<const world::KindRow> due, std::uint64_t tick,
                                world::Workers& workers) {
  place(world.models);
  workers.run(due.size(), 8, [&](std::size_t begin, std::size_t end) {
    LidarScratch& scratch = scratch_[workers.current()];
    for (std::size_t i = begin; i < end; ++i) measure(world, due[i], tick, scratch);
  });
  std::uint64_t rays = 0;
  for (const world::RangerRow ranger : due) rays += beams(world, ranger).rays.size();
  return rays;
}

void LidarSense::measure(world::World& world, world::RangerRow ranger, std::uint64_t tick,
                         LidarScratch& scratch) const {
  const LidarBeams& beams = this->beams(world, ranger);
  const world::ModelRow model = world.rangers.model[ranger];
  const geom::Pose& X_WM = world.models.X_WM[model];
  const geom::Quaternion q = geom::orientation(X_WM.a, world.models.tilt_WM[model]);
  std::ranges::copy(beams.range_max, scratch.range.begin());
  std::fill_n(scratch.intensity.begin(), beams.beams(), 0.0f);
  RayBatch& batch = scratch.rays;
  const Measurement look{world, model, tick, beams};
  batch.group = world.models.root[model].index;
  batch.wants_normals = beams.is_light;
  batch.count = 0;
  for (std::size_t i = 0; i < beams.rays.size(); ++i) {
    const LidarBeams::BeamRay& ray = beams.rays[i];
    if (batch.count == RayBatch::kMost || ray.begins_fan) cast(look, scratch);
    if (batch.count == 0) batch.p = Vec3{X_WM.x, X_WM.y, X_WM.z} + q * ray.p;
    Vec3 d_M = ray.d;
    if (ray.is_turned) {
      const geom::SinCos turn = geom::sincos(senses::turn_of(world, model, tick, ray.sensor, ray.sample));
      d_M = {turn.cos * d_M.x - turn.sin * d_M.y, turn.sin * d_M.x + turn.cos * d_M.y, d_M.z};
    }
    const std::size_t k = batch.count++;
    batch.set_ray(k, q * d_M, ray.range_max);
    scratch.ray[k] = i;
  }
  cast(look, scratch);
  if (beams.is_noisy) senses::add_range_noise(world, ranger, tick, scratch.range.data(), senses::Rings::kAll);
  store(world, beams, ranger, scratch);
}

/// Casts the batch, and keeps the nearest hit of each beam.
void LidarSense::cast(const Measurement& look, LidarScratch& scratch) const {
  RayBatch& batch = scratch.rays;
  if (batch.count == 0) return;
  scene_.cast(batch);
  for (std::size_t k = 0; k < batch.count; ++k) {
    const LidarBeams::BeamRay& ray = look.beams.rays[scratch.ray[k]];
    if (look.beams.sensors[ray.sensor].weakest > 0) {
      keep_echo(look, k, scratch);
    } else {
      keep_nearest(look.beams, k, scratch);
    }
  }
  batch.count = 0;
}

void LidarSense::keep_nearest(const LidarBeams& beams, std::size_t k, LidarScratch& scratch) const {
  const RayBatch& batch = scratch.rays;
  const LidarBeams::BeamRay& ray = beams.rays[scratch.ray[k]];
  float range = batch.range[k], facing = batch.facing[k];
  float intensity = batch.met[k] == RayBatch::kNobody ? 0 : returns_[batch.met[k]];
  bool met = batch.met[k] != RayBatch::kNobody;
  const float down = -batch.dz[k];
  const auto height = static_cast<float>(batch.p.z);
  if (down > 0 && height >= 0 && height < range * down) {
    range = height / down;
    facing = down;
    intensity = kGroundReturn;
    met = true;
  }
  if (!met || (ray.is_off_axis && facing < kEcho) || range >= scratch.range[ray.beam]) return;
  scratch.range[ray.beam] = range;
  scratch.intensity[ray.beam] = intensity;
}

/// With a lidar's error model; intensities are percent of a white sheet's echo.
void LidarSense::keep_echo(const Measurement& look, std::size_t k, LidarScratch& scratch) const {
  const RayBatch& batch = scratch.rays;
  const LidarBeams::BeamRay& ray = look.beams.rays[scratch.ray[k]];
  const LidarBeams::SensorBeams& sensor = look.beams.sensors[ray.sensor];
  const Beam beam{batch.p, {batch.dx[k], batch.dy[k], batch.dz[k]}, ray.range_max, batch.group};
  Met met{batch.range[k], batch.met[k], batch.facing[k], {batch.nx[k], batch.ny[k], batch.nz[k]}};
  if (const Met ground = ground_met(beam); ground.range < met.range) met = ground;
  const LightEcho echo = echo_of(scene_, {look.world, optics_}, beam, met, sensor.weakest);
  if (!echo.is_noticed) return;
  Rng rng(look.world.seed(), look.tick,
          {Purpose::kLidarEcho, look.world.serial(look.model), ray.sensor, ray.sample});
  const double range = echo.range + sensor.noise_weak * sensor.weakest / echo.power * rng.gaussian();
  if (range >= scratch.range[ray.beam]) return;
  scratch.range[ray.beam] = range;
  scratch.intensity[ray.beam] = static_cast<float>(100 * echo.returned);
}

void LidarSense::store(world::World& world, const LidarBeams& beams, world::RangerRow ranger,
                       LidarScratch& scratch) {
  for (std::size_t k = 0; k < beams.beams(); ++k) {
    const double range = std::max(scratch.range[k], beams.range_min[k]);
    scratch.range[k] = std::min(range, beams.range_max[k]);
  }
  world::Sensors& sensors = world.sensors;
  std::vector<float>& ring_ranges = world.rangers.ring_ranges[ranger];
  std::vector<float>& ring_intensities = world.rangers.ring_intensities[ranger];
  ring_ranges.clear();
  ring_intensities.clear();
  for (std::uint32_t i = 0; i < beams.sensors.size(); ++i) {
    const LidarBeams::SensorBeams& sensor = beams.sensors[i];
    const world::BeamRow to = sensors.first_beam[world.rangers.first_sensor[ranger] + i];
    const std::size_t level = sensor.first + std::size_t{sensor.level} * sensor.samples;
    for (std::uint32_t k = 0; k < sensor.samples; ++k) {
      sensors.ranges[to + k] = static_cast<float>(scratch.range[level + k]);
      sensors.intensities[to + k] = scratch.intensity[level + k];
    }
    if (sensor.rings == 1) continue;
    const auto begin = static_cast<std::ptrdiff_t>(sensor.first);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::size_t{sensor.samples} * sensor.rings);
    ring_ranges.insert(ring_ranges.end(), scratch.range.begin() + begin, scratch.range.begin() + end);
    ring_intensities.insert(ring_intensities.end(), scratch.intensity.begin() + begin,
                            scratch.intensity.begin() + end);
  }
}

std::unique_ptr<senses::SensePhase> make_lidar_sense(unsigned workers) {
  return std::make_unique<LidarSense>(workers);
}

}  // namespace playhouse::arena
