#include "playhouse/bodies/check_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "playhouse/scene/forms/charge.h"
#include "playhouse/scene/generated/engine_words.h"
#include "playhouse/scene/generated/read_kinds.h"

namespace playhouse::bodies {
namespace {

constexpr double kWidestFov = 1e3;  // rad

bool finite(const geom::Pose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.z) && std::isfinite(pose.a);
}

bool finite(std::span<const geom::Vec2> points) {
  for (const geom::Vec2 p : points)
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return false;
  return true;
}

bool finite(const scene::ModelDesc& model) {
  if (!finite(model.X_PM) || !finite(model.X_MB)) return false;
  for (const scene::Block& block : model.blocks)
    if (!finite(block.points)) return false;
  for (const scene::Contours& bitmap : model.bitmaps)
    for (const std::vector<geom::Vec2>& loop : bitmap.loops)
      if (!finite(loop)) return false;
  return true;
}

bool is_sound(const scene::ActuatorDesc& actuator) {
  constexpr double kFarthest = 1e9;  // m or rad, the limit of poses
  for (const double value : {actuator.axis_x, actuator.axis_y, actuator.axis_z, actuator.max_speed})
    if (!std::isfinite(value)) return false;
  return actuator.max_speed >= 0 && -kFarthest <= actuator.min_position &&
         actuator.min_position <= actuator.start_position &&
         actuator.start_position <= actuator.max_position && actuator.max_position <= kFarthest;
}

Result<void> check_model(const scene::SceneDesc& scene, const scene::ModelDesc& model) {
  const auto fault = [&](const std::string& text) {
    return Error{scene.at(model.where), "model " + model.name + text};
  };
  if (!finite(model)) return fault(" has a pose or a point that is not a finite number");
  for (const double value : {model.mass, model.watts, model.give_watts, model.take_watts})
    if (!(value >= 0) || !std::isfinite(value))
      return fault(" has an invalid mass or power: finite numbers from 0 are valid");
  const scene::Charge charge = scene::charge_of(model);
  if (!std::isfinite(charge.stored) || !std::isfinite(charge.capacity) || charge.capacity < charge.stored)
    return fault(" has an invalid battery: its charge must be at most its capacity");
  if (!scene::is_described(model.kind, model)) return fault(" lacks the description of its kind");
  for (const scene::RangerSensorDesc& sensor : model.sensors) {
    if (sensor.samples == 0) return fault(" has a sensor without samples");
    if (!finite(sensor.X_BS)) return fault(" has a sensor with a pose that is not a finite number");
    if (!std::isfinite(sensor.range_max) || sensor.range_max < 0)
      return fault(
          fmt::format(" has a sensor with a range of {} m; it must not be negative", sensor.range_max));
    if (!(sensor.fov >= 0) || sensor.fov > kWidestFov)
      return fault(
          fmt::format(" has a sensor with a fov of {} rad; it must be from 0 to {}", sensor.fov, kWidestFov));
  }
  if (model.actuator && !is_sound(*model.actuator))
    return fault(" has an invalid axis, speed, ends or start: the start must be between the ends");
  if (!model.position) return {};
  for (int axis = 0; axis < 4; ++axis)
    if (!(model.position->velocity_bounds[axis].min <= model.position->velocity_bounds[axis].max) ||
        !(model.position->acceleration_bounds[axis].min <= model.position->acceleration_bounds[axis].max))
      return fault(" has bounds whose lower end is above the upper one");
  return {};
}

}  // namespace

Result<void> check_scene(const scene::SceneDesc& scene) {
  if (!(scene.interval > 0) || !std::isfinite(scene.interval))
    return Error{scene.path, "the interval of a tick must be above 0"};
  for (const scene::ModelDesc& model : scene.models)
    if (const Result<void> checked = check_model(scene, model); !checked) return checked;
  for (const scene::TreeDesc& tree : scene.trees)
    if (!finite(tree.X_WM))
      return Error{scene.at(tree.where), "model " + tree.name + " has a pose that is not a finite number"};
  return {};
}

/// Warns of empty worlds, and of floorplans with obstacle_return 0, which robots drive through; map.inc of
/// Stage has that.
std::vector<std::string> oddities_of(const scene::SceneDesc& scene) {
  if (scene.models.empty()) return {scene.at({0, 1}) + ": there is no model in it: the world is empty"};
  bool robots = false;
  for (const scene::ModelDesc& model : scene.models) robots |= model.kind == scene::ModelKind::kPosition;
  for (const scene::ModelDesc& model : scene.models) {
    if (!robots || model.obstacle_return || model.bitmaps.empty()) continue;
    return {scene.at(model.where) + ": model " + model.name +
            " has obstacle_return 0: robots drive through it"};
  }
  return {};
}

std::vector<std::string> left_out_in_the_plane(const scene::SceneDesc& scene) {
  std::set<std::string_view> words;
  add_arena_words(scene, words);
  const scene::ModelDesc* first = nullptr;
  for (const scene::ModelDesc& model : scene.models) {
    const std::size_t before = words.size();
    add_arena_words(static_cast<const scene::PlainDesc&>(model), words);
    add_arena_words(static_cast<const scene::KindDescs&>(model), words);
    if (model.mesh) words.insert("mesh");
    if (!first && words.size() > before) first = &model;
  }
  // In this engine detectors see materials and lamps, and imus measure gravity.
  for (const scene::ModelDesc& model : scene.models) {
    if (model.detector) words.erase("material"), words.erase("lamp");
    if (model.kind == scene::ModelKind::kImu) words.erase("gravity");
  }
  if (words.empty()) return {};
  return {fmt::format(
      "{}: {} {} full effect with --engine arena only: the stage engine is a plane without physics "
      "and light",
      first ? scene.at(first->where) : scene.path, fmt::join(words, ", "),
      words.size() == 1 ? "has its" : "have their")};
}

}  // namespace playhouse::bodies
