#include "playhouse/arena/sensing/drawn_bodies.h"

#include <utility>

#include "playhouse/arena/sensing/looks.h"
#include "playhouse/rays/camera_image.h"
#include "playhouse/world/conditions.h"

namespace playhouse::arena {
namespace {

using geom::Vec3;

}  // namespace

PlacedModel model_in_world(const world::Models& models, world::ModelRow row) {
  const geom::Pose& X_WM = models.X_WM[row];
  return {{X_WM.x, X_WM.y, X_WM.z}, geom::orientation(X_WM.a, models.tilt_WM[row])};
}

void DrawnBodies::find(const world::World& world, const bodies::Solids& solids, render::Renderer& renderer) {
  bodies_.clear();
  people_.clear();
  smokes_.clear();
  shining_.clear();
  for (const world::ModelRow model : world.models.rows()) {
    const scene::ModelDesc& desc = world.desc(model);
    if (desc.lamp > 0 || (desc.mesh && !desc.mesh->lights.empty())) shining_.push_back(model);
  }
  each_run(solids.rows(), solids.model, [&](bodies::SolidRows rows) {
    const world::ModelRow model = solids.model[rows.front()];
    const scene::ModelDesc& desc = world.desc(model);
    const Look look = look_of(desc);
    if (look == Look::kPerson) return people_.push_back(model);
    if (look == Look::kSmoke) return smokes_.push_back(model);
    add_body(world, model, solids, rows, renderer);
  });
  // Sensors and other models that have a look and no body.
  for (const world::ModelRow model : world.models.rows()) {
    const scene::ModelDesc& desc = world.desc(model);
    if (desc.look && desc.blocks.empty() && desc.bitmaps.empty()) add_body(world, model, {}, {}, renderer);
  }
}

void DrawnBodies::add_body(const world::World& world, world::ModelRow model, const bodies::Solids& solids,
                           bodies::SolidRows rows, render::Renderer& renderer) {
  const auto [entry, is_new] = shapes_of_.try_emplace(world.models.desc[model]);
  if (is_new) add_shapes(world.desc(model), solids, rows, renderer, entry->second);
  for (const DrawnShape& each : entry->second) bodies_.push_back({model, each.shape, each.is_tinted});
}

void DrawnBodies::add_shapes(const scene::ModelDesc& desc, const bodies::Solids& solids,
                             bodies::SolidRows rows, render::Renderer& renderer,
                             std::vector<DrawnShape>& shapes) const {
  if (!desc.look) return shapes.push_back({renderer.add_shape(mesh_of(desc, solids, rows)), !desc.mesh});
  for (const bool painted : {true, false}) {
    const mesh::Mesh part = part_of_look(desc, painted);
    if (!part.surfaces.empty()) shapes.push_back({renderer.add_shape(part), painted});
  }
}

void DrawnBodies::place(const world::World& world, double time) {
  place_bodies(world);
  place_people(world, time);
  place_smoke(world);
  place_lamps(world);
}

void DrawnBodies::place_bodies(const world::World& world) {
  const world::Models& models = world.models;
  instances_.clear();
  for (const DrawnModel& body : bodies_) {
    const std::array<float, 4> color = light_of(models.color[body.model]);
    const std::array<float, 4> tint = body.is_tinted ? color : std::array<float, 4>{1, 1, 1, 1};
    // A transparent look is so as a whole.
    if (!((world.desc(body.model).look ? color : tint)[3] > 0)) continue;
    const PlacedModel at = model_in_world(models, body.model);
    instances_.push_back({body.shape, at.p, at.q, tint, rays::segment_of(models.id[body.model]),
                          models.root[body.model].index, world::is_lit(world, body.model) ? 1.0f : 0.0f});
  }
}

void DrawnBodies::place_people(const world::World& world, double time) {
  const world::Models& models = world.models;
  figures_.clear();
  for (const world::ModelRow model : people_) {
    const std::array<float, 4> clothes = light_of(models.color[model]);
    if (!(clothes[3] > 0)) continue;
    const scene::ModelDesc& desc = world.desc(model);
    const PlacedModel at = model_in_world(models, model);
    const double heading = models.X_WM[model].a + desc.X_MB.a, height = desc.size.z;
    const std::uint32_t id = models.id[model].value;
    figures_.push_back({at.p + at.q * Vec3{desc.X_MB.x, desc.X_MB.y, desc.X_MB.z},
                        heading,
                        height,
                        gait_of({models.V_WM[model], heading, height, id, models.say[model]}, time),
                        {clothes[0], clothes[1], clothes[2]},
                        rays::segment_of(models.id[model]),
                        models.root[model].index});
  }
}

void DrawnBodies::place_smoke(const world::World& world) {
  const world::Models& models = world.models;
  clouds_.clear();
  for (const world::ModelRow model : smokes_) {
    const std::array<float, 4> tint = light_of(models.color[model]);
    if (!(tint[3] > 0)) continue;
    const scene::ModelDesc& desc = world.desc(model);
    const PlacedModel at = model_in_world(models, model);
    clouds_.push_back({at.p + at.q * middle_of(desc),
                       at.q * geom::orientation(desc.X_MB.a, {}),
                       {0.5 * desc.size.x, 0.5 * desc.size.y, 0.5 * desc.size.z},
                       tint,
                       models.root[model].index});
  }
}

void DrawnBodies::place_lamps(const world::World& world) {
  lamps_.clear();
  for (const world::ModelRow model : shining_) {
    if (!world::switch_of(world, model).value_or(true)) continue;
    const scene::ModelDesc& desc = world.desc(model);
    const PlacedModel at = model_in_world(world.models, model);
    if (desc.lamp > 0) lamps_.push_back(lamp_of(desc, world.models.color[model], at.p, at.q));
    if (desc.mesh) add_lamps(*desc.mesh, desc.X_MB, at.p, at.q, lamps_);
  }
}

}  // namespace playhouse::arena
