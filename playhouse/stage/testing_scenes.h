#pragma once

/// Scenes made in code, for the tests and the bench of this module.

#include <string>

#include "playhouse/base/rng.h"
#include "playhouse/bodies/bodies.h"
#include "playhouse/scene/generated/bodies.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::stage::testing {

using geom::Pose;
using geom::Vec2;

inline scene::Block box_block(double x, double y, double z_min, double z_max) {
  return {{{-x / 2, -y / 2}, {x / 2, -y / 2}, {x / 2, y / 2}, {-x / 2, y / 2}}, z_min, z_max};
}

/// A box of this size, standing on z = 0.
inline scene::ModelDesc box(const std::string& name, const Pose& X_WM, const geom::Size& size) {
  scene::ModelDesc model;
  model.name = model.alias = name;
  model.type = "model";
  model.X_PM = X_WM;
  model.size = size;
  model.blocks = {box_block(size.x, size.y, 0, size.z)};
  return model;
}

/// A subscribed robot with Stage's default bounds and exact odometry.
inline scene::ModelDesc robot(const std::string& name, const Pose& X_WM, const geom::Size& size,
                              scene::Drive drive = scene::Drive::kDiff) {
  scene::ModelDesc model = box(name, X_WM, size);
  model.type = "position";
  model.kind = scene::ModelKind::kPosition;
  model.alwayson = true;
  model.position.emplace();
  model.position->drive = drive;
  model.position->odom_error = geom::Twist{};
  const double turn = geom::kPi / 2;
  for (int axis = 0; axis < 4; ++axis) {
    model.position->velocity_bounds[axis] = axis < 3 ? scene::Interval{-1, 1} : scene::Interval{-turn, turn};
    model.position->acceleration_bounds[axis] = model.position->velocity_bounds[axis];
  }
  return model;
}

/// A subscribed slide from 0 to 1 m at no more than 1 m/s, a box.
inline scene::ModelDesc actuator(const std::string& name, const Pose& X_PJ, const geom::Size& size) {
  scene::ModelDesc model = box(name, X_PJ, size);
  model.type = "actuator";
  model.kind = scene::ModelKind::kActuator;
  model.alwayson = true;
  model.actuator.emplace();
  return model;
}

/// A ranger on `parent`, without a body.
inline scene::ModelDesc ranger(const std::string& name, int parent, const Pose& X_PM) {
  scene::ModelDesc model;
  model.name = model.alias = name;
  model.type = "ranger";
  model.kind = scene::ModelKind::kRanger;
  model.parent = parent;
  model.X_PM = X_PM;
  model.alwayson = true;
  return model;
}

inline scene::RangerSensorDesc sensor(const Pose& X_BS, double range_max, double fov, std::uint32_t samples) {
  scene::RangerSensorDesc desc;
  desc.X_BS = X_BS;
  desc.range_max = range_max;
  desc.fov = fov;
  desc.samples = samples;
  return desc;
}

/// The body of a Pioneer 2DX: an octagon of 0.44 x 0.38 x 0.22 m, 0.04 m behind the centre of its wheels.
inline scene::ModelDesc pioneer(const std::string& name, const Pose& X_WM) {
  scene::ModelDesc model = robot(name, X_WM, {0.44, 0.38, 0.22});
  const double x = 0.22, y = 0.19;
  model.X_MB = {-0.04, 0, 0, 0};
  model.blocks = {{{{-x, -0.47 * y},
                    {-0.6 * x, -y},
                    {0.6 * x, -y},
                    {x, -0.47 * y},
                    {x, 0.47 * y},
                    {0.6 * x, y},
                    {-0.6 * x, y},
                    {-x, 0.47 * y}},
                   0,
                   0.22}};
  model.ranger_return = 0.5;
  return model;
}

/// Sixteen sonars about the rim, below the top of the body.
inline scene::ModelDesc sonar_ring(const std::string& name, int parent) {
  scene::ModelDesc model = ranger(name, parent, {0, 0, 0.19, 0});
  for (int i = 0; i < 16; ++i) {
    const geom::SinCos sc = geom::sincos((i + 0.5) * geom::kTwoPi / 16);
    const double bearing = geom::normalize((i + 0.5) * geom::kTwoPi / 16);
    model.sensors.push_back(
        sensor({0.2 * sc.cos - 0.04, 0.15 * sc.sin, 0, bearing}, 5, geom::radians(15), 1));
  }
  return model;
}

inline scene::ModelDesc laser(const std::string& name, int parent) {
  scene::ModelDesc model = ranger(name, parent, {0, 0, 0.1, 0});
  model.sensors.push_back(sensor({}, 8, geom::kPi, 180));
  return model;
}

/// A gripper of the usual size with a body of its own, on `parent` or, with -1, at the top.
inline void add_gripper(scene::SceneDesc& scene, const std::string& name, int parent, const Pose& X_PM) {
  scene::ModelDesc& model = scene.models.emplace_back();
  model.name = model.alias = name;
  model.type = "gripper";
  model.kind = scene::ModelKind::kGripper;
  model.parent = parent;
  model.X_PM = X_PM;
  model.size = {0.2, 0.3, 0.2};
  model.alwayson = true;
  model.gripper.emplace();
  scene::make_body(model.size, model);
}

/// An object for grippers, 0.08 m wide; no obstacle, so robots drive through it.
inline scene::ModelDesc puck(const Pose& X_WM) {
  scene::ModelDesc model = box("puck", X_WM, {0.08, 0.08, 0.1});
  model.gripper_return = true;
  model.obstacle_return = false;
  return model;
}

/// Four walls about a square with this side, their inner faces on its border.
inline void add_arena(scene::SceneDesc& scene, double side) {
  const double at = side / 2 + 0.05, length = side + 0.2;
  scene.models.push_back(box("east", {at, 0, 0, 0}, {0.1, length, 1}));
  scene.models.push_back(box("west", {-at, 0, 0, 0}, {0.1, length, 1}));
  scene.models.push_back(box("north", {0, at, 0, 0}, {length, 0.1, 1}));
  scene.models.push_back(box("south", {0, -at, 0, 0}, {length, 0.1, 1}));
}

enum class Sensing { kNone, kSonar, kLaser };

/// Pioneers at random headings on a jittered square lattice, 0.39 per
/// square metre, between four walls. Each keeps driving along its own arc.
inline scene::SceneDesc crowd(std::size_t robots, Sensing sensing) {
  scene::SceneDesc scene;
  scene.name = "crowd";
  std::size_t per_row = 1;
  while (per_row * per_row < robots) ++per_row;
  const double spacing = 1.6012815380508714;  // 1 / sqrt(0.39)
  const double side = spacing * static_cast<double>(per_row);
  add_arena(scene, side);
  for (std::size_t i = 0; i < robots; ++i) {
    Rng rng(1, 0, {Purpose::kTestScene, static_cast<std::uint32_t>(i)});
    const double x = (static_cast<double>(i % per_row) + 0.5) * spacing - side / 2 + rng.uniform(-0.5, 0.5);
    const double y = (static_cast<double>(i / per_row) + 0.5) * spacing - side / 2 + rng.uniform(-0.5, 0.5);
    const int parent = static_cast<int>(scene.models.size());
    const std::string name = "r" + std::to_string(i);
    scene.models.push_back(pioneer(name, {x, y, 0, rng.uniform(-3, 3)}));
    scene.models.back().position->velocity = {0.3, 0, 0, rng.uniform(-0.5, 0.5)};
    if (sensing == Sensing::kSonar) scene.models.push_back(sonar_ring(name + ".ranger:0", parent));
    if (sensing == Sensing::kLaser) scene.models.push_back(laser(name + ".ranger:0", parent));
  }
  return scene;
}

/// Boxes without initial overlap, 3.7 per square metre, on slow arcs,
/// so that a tick is one substep: dense traffic with constant blocking.
inline scene::SceneDesc throng(std::size_t robots, std::uint64_t seed) {
  scene::SceneDesc scene;
  scene.name = "throng";
  std::size_t per_row = 1;
  while (per_row * per_row < robots) ++per_row;
  const double spacing = 0.52, side = spacing * static_cast<double>(per_row);
  add_arena(scene, side);
  for (std::size_t i = 0; i < robots; ++i) {
    Rng rng(seed, 0, {Purpose::kTestScene, static_cast<std::uint32_t>(i)});
    const double x = (static_cast<double>(i % per_row) + 0.5) * spacing - side / 2 + rng.uniform(-0.04, 0.04);
    const double y = (static_cast<double>(i / per_row) + 0.5) * spacing - side / 2 + rng.uniform(-0.04, 0.04);
    const geom::Size size{rng.uniform(0.2, 0.3), rng.uniform(0.2, 0.3), 0.2};
    scene.models.push_back(robot("r" + std::to_string(i), {x, y, 0, rng.uniform(-3, 3)}, size));
    scene.models.back().position->velocity = {rng.uniform(-0.5, 0.5), 0, 0, rng.uniform(-1, 1)};
  }
  return scene;
}

/// The solids of a world as the engine makes them.
inline bodies::Solids make_solids(const world::World& world, bodies::Trees& trees) {
  bodies::Shapes shapes(world.scene());
  bodies::Solids solids = make_fixed_solids(world, shapes);
  replace_moving_solids(solids, world, shapes, trees);
  return solids;
}

}  // namespace playhouse::stage::testing
