#include "playhouse/arena/camera_sense.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/arena/looks.h"
#include "playhouse/base/log.h"
#include "playhouse/scene/camera.h"
#include "playhouse/stage/camera_image.h"
#include "playhouse/stage/generated/senses.h"
#include "playhouse/world/conditions.h"

namespace playhouse::arena {
namespace {

using geom::Vec3;
using scene::ImageKind;

constexpr double kNearest =
    0.01;  // m, of what is shown at all: depths are exact to a tenth of a millimetre then

render::Shows shows_of(ImageKind image) {
  switch (image) {
    case ImageKind::kDepth:
      return render::Shows::kDepth;
    case ImageKind::kSegmentation:
      return render::Shows::kSegments;
    case ImageKind::kColor:
    case ImageKind::kGray:
      break;
  }
  return render::Shows::kColor;
}

/// Pose of a model's frame in W.
struct Placed {
  Vec3 p;
  geom::Quaternion q;
};
Placed model_in_world(const world::Models& models, std::uint32_t row) {
  const geom::Pose& X_WM = models.X_WM[row];
  return {{X_WM.x, X_WM.y, X_WM.z}, geom::orientation(X_WM.a, models.tilt_WM[row])};
}

/// Calls visit(model, begin, end) for the run of solids of each model.
template <typename Visit>
void each_model(const stage::Solids& solids, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < solids.size(); begin = end) {
    while (end < solids.size() && solids.model[end] == solids.model[begin]) ++end;
    visit(solids.model[begin], begin, end);
  }
}

}  // namespace

stage::SensorTable CameraSense::table(world::World& world) const {
  return {world.cameras.model, world.cameras.measured_tick};
}

void CameraSense::populate(const world::World& world, const stage::Space& space) {
  is_stale_ = true;
  if (instead_) instead_->populate(world, space);
}

/// Makes the renderer, or the fallback.
void CameraSense::begin() {
  if (renderer_ || instead_) return;
  Result<std::unique_ptr<render::Renderer>> made = make_();
  if (made) {
    renderer_ = std::move(*made);
    log::info("cameras are rendered by {}", renderer_->name());
    return;
  }
  log::warn(
      "cameras show what those of the stage engine do, without light, tilts and people: {} "
      "(docs/arena.md, Cameras)",
      made.error().line());
  instead_ = stage::make_camera_sense(workers_);
}

void CameraSense::find_bodies(const world::World& world, const stage::Solids& solids) {
  is_stale_ = false;
  bodies_.clear();
  people_.clear();
  smokes_.clear();
  shining_.clear();
  for (std::uint32_t model = 0; model < world.models.size(); ++model) {
    const scene::ModelDesc& desc = world.desc({model});
    if (desc.lamp > 0 || (desc.mesh && !desc.mesh->lights.empty())) shining_.push_back(model);
  }
  each_model(solids, [&](std::uint32_t model, std::size_t begin, std::size_t end) {
    const scene::ModelDesc& desc = world.desc({model});
    const Look look = look_of(desc);
    if (look == Look::kPerson) return people_.push_back(model);
    if (look == Look::kSmoke) return smokes_.push_back(model);
    const auto [entry, is_new] = shape_of_.try_emplace(world.models.desc[model]);
    if (is_new) entry->second = renderer_->add_shape(mesh_of(desc, solids, begin, end));
    bodies_.push_back({model, entry->second});
  });
}

void CameraSense::place_bodies(const world::World& world, double time) {
  const world::Models& models = world.models;
  instances_.clear();
  figures_.clear();
  clouds_.clear();
  for (const Body& body : bodies_) {
    // A mesh has its own colours.
    const std::array<float, 4> tint =
        world.desc({body.model}).mesh ? std::array<float, 4>{1, 1, 1, 1} : light_of(models.color[body.model]);
    if (!(tint[3] > 0)) continue;
    const Placed at = model_in_world(models, body.model);
    instances_.push_back({body.shape, at.p, at.q, tint, stage::segment_of(models.id[body.model]),
                          models.root[body.model], world::is_lit(world, body.model) ? 1.0f : 0.0f});
  }
  for (const std::uint32_t model : people_) {
    const std::array<float, 4> clothes = light_of(models.color[model]);
    if (!(clothes[3] > 0)) continue;
    const scene::ModelDesc& desc = world.desc({model});
    const Placed at = model_in_world(models, model);
    const double heading = models.X_WM[model].a + desc.X_MB.a, height = desc.size.z;
    const std::uint32_t id = models.id[model].value;
    figures_.push_back({at.p + at.q * Vec3{desc.X_MB.x, desc.X_MB.y, desc.X_MB.z},
                        heading,
                        height,
                        gait_of({models.V_WM[model], heading, height, id, models.say[model]}, time),
                        {clothes[0], clothes[1], clothes[2]},
                        stage::segment_of(models.id[model]),
                        models.root[model]});
  }
  for (const std::uint32_t model : smokes_) {
    const std::array<float, 4> tint = light_of(models.color[model]);
    if (!(tint[3] > 0)) continue;
    const scene::ModelDesc& desc = world.desc({model});
    const Placed at = model_in_world(models, model);
    clouds_.push_back({at.p + at.q * middle_of(desc),
                       at.q * geom::orientation(desc.X_MB.a, {}),
                       {0.5 * desc.size.x, 0.5 * desc.size.y, 0.5 * desc.size.z},
                       tint,
                       models.root[model]});
  }
}

void CameraSense::place_lamps(const world::World& world) {
  lamps_.clear();
  for (const std::uint32_t model : shining_) {
    if (!world::switch_of(world, model).value_or(true)) continue;
    const scene::ModelDesc& desc = world.desc({model});
    const Placed at = model_in_world(world.models, model);
    if (desc.lamp > 0) lamps_.push_back(lamp_of(desc, world.models.color[model], at.p, at.q));
    if (desc.mesh) add_lamps(*desc.mesh, desc.X_MB, at.p, at.q, lamps_);
  }
}

render::View CameraSense::view_of(const world::World& world, std::uint32_t camera) const {
  const std::uint32_t model = world.cameras.model[camera].index;
  const scene::ModelDesc& desc = world.desc({model});
  const scene::CameraDesc& lens = *desc.camera;
  // Values come from a loaded state, which may be corrupt.
  const auto sound = [](double angle) { return std::fabs(angle) <= 1e5 ? geom::normalize(angle) : 0; };
  const double zoom = world.cameras.zoom[camera];
  const scene::HalfImage half = half_image(lens, zoom > 0 && zoom < geom::kPi ? zoom : lens.fov_horizontal);
  const Placed at = model_in_world(world.models, model);
  const Vec3 eye{desc.X_MB.x, desc.X_MB.y, desc.X_MB.z + stage::lens_height(desc)};
  render::View view;
  view.shows = shows_of(lens.image);
  view.eye = at.p + at.q * eye;
  view.q_WC = at.q * geom::orientation(desc.X_MB.a + sound(world.cameras.pan[camera]),
                                       {0, -sound(world.cameras.tilt[camera])});
  view.half_width = half.width;
  view.half_height = half.height;
  view.near = std::max(lens.range_min, kNearest);
  view.far = std::max(lens.range_max, view.near + kNearest);
  view.width = static_cast<std::uint32_t>(lens.width);
  view.height = static_cast<std::uint32_t>(lens.height);
  view.hides = world.models.root[model];
  return view;
}

std::uint64_t CameraSense::sense(world::World& world, const stage::Space& space,
                                 std::span<const std::uint32_t> due, std::uint64_t tick,
                                 world::Workers& workers) {
  begin();
  if (instead_) return instead_->sense(world, space, due, tick, workers);
  if (is_stale_) find_bodies(world, space.solids);
  const double time = static_cast<double>(tick) * world.scene().interval;
  place_bodies(world, time);
  place_lamps(world);
  views_.clear();
  for (const std::uint32_t camera : due) views_.push_back(view_of(world, camera));
  renderer_->draw(surroundings_of(world.scene(), time), {instances_, figures_, clouds_, lamps_}, views_,
                  pictures_);
  workers.run(due.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      stage::expose(world, due[i], tick, {pictures_[i].depth, pictures_[i].sample});
  });
  std::uint64_t rays = 0;
  for (const std::uint32_t camera : due) rays += world.cameras.pixels[camera].size();
  return rays;
}

std::unique_ptr<stage::SensePhase> make_camera_sense(unsigned workers) {
  return std::make_unique<CameraSense>(workers);
}

}  // namespace playhouse::arena
