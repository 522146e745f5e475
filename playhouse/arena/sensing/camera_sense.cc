#include "playhouse/arena/sensing/camera_sense.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/arena/sensing/looks.h"
#include "playhouse/base/log.h"
#include "playhouse/rays/camera_image.h"
#include "playhouse/scene/forms/camera.h"
#include "playhouse/senses/generated/senses.h"

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

}  // namespace

senses::SensorTable CameraSense::table(world::World& world) const {
  return {world.cameras.model, world.cameras.measured_tick};
}

void CameraSense::populate(const world::World& world, const bodies::Space& space) {
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
  instead_ = senses::make_camera_sense(workers_);
}

render::View CameraSense::view_of(const world::World& world, world::CameraRow camera) const {
  const world::ModelRow model = world.cameras.model[camera];
  const scene::ModelDesc& desc = world.desc(model);
  const scene::CameraDesc& lens = *desc.camera;
  // Values come from a loaded state, which may be corrupt.
  const auto sound = [](double angle) { return std::fabs(angle) <= 1e5 ? geom::normalize(angle) : 0; };
  const double zoom = world.cameras.zoom[camera];
  const scene::HalfImage half = half_image(lens, zoom > 0 && zoom < geom::kPi ? zoom : lens.fov_horizontal);
  const PlacedModel at = model_in_world(world.models, model);
  const Vec3 eye{desc.X_MB.x, desc.X_MB.y, desc.X_MB.z + rays::lens_height(desc)};
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
  view.hides = world.models.root[model].index;
  return view;
}

std::size_t CameraSense::add(const render::View& view) {
  views_.push_back(view);
  return views_.size() - 1;
}

/// The second lens is aside along the rows of the image, and pictures that show no depths need another one for them.
CameraSense::PicturesOfCamera CameraSense::take(const world::World& world, world::CameraRow camera) {
  const render::View left = view_of(world, camera);
  PicturesOfCamera taken{camera, add(left), rays::takes_pairs(world, camera)};
  if (!taken.is_pair) return taken;
  render::View right = left;
  right.eye = left.eye + left.q_WC * Vec3{0, -world.desc(world.cameras.model[camera]).camera->baseline, 0};
  taken.right = add(right);
  render::View depths = left;
  depths.shows = render::Shows::kDepth;
  taken.depths = left.shows == render::Shows::kDepth ? taken.picture : add(depths);
  return taken;
}

void CameraSense::expose(world::World& world, const PicturesOfCamera& taken, std::uint64_t tick) const {
  const auto seen = [&](std::size_t picture) {
    return rays::Seen{pictures_[picture].depth, pictures_[picture].sample};
  };
  rays::expose(world, taken.camera, tick, seen(taken.picture));
  if (!taken.is_pair) return rays::forget_pair(world, taken.camera);
  rays::expose_pair(world, taken.camera, tick, seen(taken.right), seen(taken.depths).far);
}

std::uint64_t CameraSense::sense(world::World& world, const bodies::Space& space,
                                 std::span<const world::KindRow> due, std::uint64_t tick,
                                 world::Workers& workers) {
  begin();
  if (instead_) return instead_->sense(world, space, due, tick, workers);
  if (std::exchange(is_stale_, false)) bodies_.find(world, space.solids, *renderer_);
  const double time = static_cast<double>(tick) * world.scene().interval;
  bodies_.place(world, time);
  views_.clear();
  taken_.clear();
  for (const world::CameraRow camera : due) taken_.push_back(take(world, camera));
  renderer_->draw(surroundings_of(world.scene(), time), bodies_.scene(), views_, pictures_);
  workers.run(due.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) expose(world, taken_[i], tick);
  });
  std::uint64_t rays = 0;
  for (const world::CameraRow camera : due)
    rays += world.cameras.pixels[camera].size() + world.cameras.right_pixels[camera].size();
  return rays;
}

std::unique_ptr<senses::SensePhase> make_camera_sense(unsigned workers) {
  return std::make_unique<CameraSense>(workers);
}

}  // namespace playhouse::arena
