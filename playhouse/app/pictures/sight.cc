#include "playhouse/app/pictures/sight.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/scene/forms/camera.h"

namespace playhouse::app {
namespace {

using geom::Vec3;

constexpr double kFieldOfView = geom::kPi / 3;         // vertical
constexpr double kShape = 9.0 / 16;                    // height of a camera's picture by its width
constexpr double kMostPitch = 0.5 * geom::kPi - 1e-3;  // straight up and down have no heading
constexpr double kEyeHeight = 0.93;                    // of a person's height
constexpr double kOnTop = 0.05;                        // m above a robot
constexpr double kBehind = 5, kNearest = 1.5;  // of its largest extent, and m: distance to what is followed
constexpr double kAbove = 0.5;                 // of that distance: height

Result<world::ModelId> model_named(const world::World& world, const std::string& option,
                                   const std::string& name) {
  if (const world::ModelRow row = world.find(name)) return world.id(row);
  std::vector<std::string> names;
  for (const world::ModelRow row : world.models.rows())
    if (!world.models.parent[row]) names.push_back(world.name(row));
  const std::vector<std::string_view> all(names.begin(), names.end());
  return Error{option, "there is no model " + in_quotes(name) + did_you_mean(name, all)};
}

/// An eye that looks at a point.
Eye eye_towards(const Vec3& from, const Vec3& target) {
  const Vec3 way = target - from;
  const double across = std::hypot(way.x, way.y);
  const double pitch = across > 0 || way.z != 0 ? std::atan2(way.z, across) : 0;
  return {from,
          across > 0 ? std::atan2(way.y, way.x) : 0.5 * geom::kPi,
          std::clamp(pitch, -kMostPitch, kMostPitch),
          kFieldOfView,
          {}};
}

/// The middle of what the view from above shows, on the floor.
Vec3 middle_of(const world::World& world) {
  const Result<Viewport> view = view_of(world, 16);
  if (!view) return {};
  return {view->left + 0.5 * view->width / view->pixels_per_metre,
          view->top - 0.5 * view->height / view->pixels_per_metre, 0};
}

/// What a model sees: a person by the eyes, a camera by its lens, others from on top.
Eye eye_of_model(const world::World& world, world::ModelRow row) {
  const scene::ModelDesc& desc = world.desc(row);
  const geom::SpatialPose X = world::pose_in_world(world.models, row);
  const bool walks = desc.position && desc.position->drive == scene::Drive::kWalk;
  const geom::Rotation turn = geom::Rotation::of(X.X.a);
  Eye eye{{X.X.x, X.X.y, X.X.z + (walks ? kEyeHeight * desc.size.z : desc.size.z + kOnTop)},
          X.X.a,
          0,
          kFieldOfView,
          world.id(row)};
  if (!desc.camera) return eye;
  const geom::Vec2 lens = X.X.xy() + turn * desc.X_MB.xy();
  eye.p = {lens.x, lens.y, X.X.z + desc.X_MB.z + 0.5 * desc.size.z};
  eye.yaw = X.X.a + desc.X_MB.a;
  eye.fov = 2 * std::atan(half_image(*desc.camera, desc.camera->fov_horizontal).height);
  return eye;
}

}  // namespace

Result<Sight> Sight::of(const SightOptions& options, const world::World& world) {
  Sight sight;
  if (options.from) {
    sight.from_ = From::kPlace;
    sight.place_ = *options.from;
    sight.target_ = options.look_at;
  }
  const bool follows = !options.follow.empty();
  if (!follows && options.first_person.empty()) return sight;
  if (!options.from) sight.from_ = follows ? From::kBehind : From::kModel;
  const Result<world::ModelId> model = follows ? model_named(world, "--follow", options.follow)
                                               : model_named(world, "--first-person", options.first_person);
  if (!model) return model.error();
  sight.model_ = *model;
  return sight;
}

Result<Viewport> Sight::at(const world::World& world, int width) {
  if (from_ == From::kAbove) return view_of(world, width);
  if (!last_ || !model_ || world.row(*model_)) last_ = eye_of(world);
  Viewport view;
  view.width = width;
  view.height = std::max(1, static_cast<int>(std::lround(width * kShape)));
  view.eye = last_;
  return view;
}

Eye Sight::eye_of(const world::World& world) const {
  if (!model_) return eye_towards(place_, target_.value_or(middle_of(world)));
  const world::ModelRow row = world.row(*model_);
  if (from_ == From::kModel) return eye_of_model(world, row);
  const scene::ModelDesc& desc = world.desc(row);
  const geom::Pose X = world::pose_in_world(world.models, row).X;
  const Vec3 middle{X.x, X.y, X.z + 0.5 * desc.size.z};
  if (from_ == From::kPlace) return eye_towards(place_, middle);
  const double far = std::max(kNearest, kBehind * std::max({desc.size.x, desc.size.y, desc.size.z}));
  return eye_towards(middle + Vec3{-far * std::cos(X.a), -far * std::sin(X.a), kAbove * far}, middle);
}

}  // namespace playhouse::app
