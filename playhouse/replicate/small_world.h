#pragma once

/// SmallWorld: an in-memory world for the tests here and of the web server: a wall, robots with a laser
/// of 5 beams, two sonars and a fiducial finder each, a puck, free-standing grippers, and people.

#include <string>

#include <memory>

#include "playhouse/base/rng.h"
#include "playhouse/replicate/layout.h"
#include "playhouse/scene/generated/bodies.h"
#include "playhouse/world/world.h"

namespace playhouse::replicate {

class SmallWorld {
 public:
  explicit SmallWorld(int robots, int grippers = 0, int people = 0)
      : scene_(make_scene(robots, grippers, people)), prototypes(scene_), world(scene_, 1) {}
  SmallWorld(const SmallWorld&) = delete;
  SmallWorld& operator=(const SmallWorld&) = delete;

  /// Row of robot k, equal to its id as long as no model is removed; the wall is row 0.
  static std::uint32_t robot(int k) { return static_cast<std::uint32_t>(1 + 4 * k); }
  static world::ModelId id(int k) { return {robot(k)}; }
  /// Row of the puck in a scene without grippers and people.
  std::uint32_t puck() const { return static_cast<std::uint32_t>(scene_.models.size()) - 1; }

  std::shared_ptr<const Layout> layout(const DeviceNames& devices = {},
                                       const Layout* before = nullptr) const {
    return std::make_shared<const Layout>(world, prototypes, devices, before);
  }

  /// A synthetic tick: some robots move and turn, active
  /// sensors get new values. A function of the tick number.
  void tick() {
    ++world.tick_;
    Rng rng(world.tick_);
    for (const world::PositionRow k : world.positions.rows()) move(k, rng);
    for (float& range : world.sensors.ranges) range = static_cast<float>(6 * rng.uniform());
    for (std::uint64_t& tick : world.rangers.measured_tick) tick = world.tick_;
    for (const world::FiducialRow k : world.fiducials.rows()) see(k, rng);
    for (double& paddles : world.grippers.paddles) paddles = rng.uniform();
  }

 private:
  static scene::SceneDesc make_scene(int robots, int grippers, int people) {
    scene::SceneDesc scene;
    scene.name = "small";
    scene.window.show_data = true;
    scene::ModelDesc wall = model("wall", "model", scene::ModelKind::kPlain, -1);
    wall.bitmaps.push_back({{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}}, 0, 0.5});
    wall.gui_move = false;
    wall.gui_outline = wall.gui_grid = true;
    scene.models.push_back(wall);
    for (int k = 0; k < robots; ++k) add_robot(scene, k);
    scene::ModelDesc puck = model("puck", "model", scene::ModelKind::kPlain, -1);
    puck.blocks.push_back({{{-0.05, -0.05}, {0.05, -0.05}, {0.05, 0.05}, {-0.05, 0.05}}, 0, 0.1});
    puck.gui_move = true;
    puck.gui_nose = true;
    scene.models.push_back(puck);
    for (int k = 0; k < grippers; ++k) add_gripper(scene, k);
    for (int k = 0; k < people; ++k) add_person(scene, k);
    return scene;
  }

  static scene::ModelDesc model(std::string name, std::string type, scene::ModelKind kind,
                                std::int32_t parent) {
    scene::ModelDesc model;
    model.alias = model.name = std::move(name);
    model.type = std::move(type);
    model.kind = kind;
    model.parent = parent;
    return model;
  }

  static void add_gripper(scene::SceneDesc& scene, int k) {
    scene::ModelDesc gripper = model("g" + std::to_string(k), "gripper", scene::ModelKind::kGripper, -1);
    gripper.size = {0.2, 0.3, 0.2};
    gripper.gripper.emplace();
    scene::make_body(gripper.size, gripper);
    scene.models.push_back(gripper);
  }

  static void add_person(scene::SceneDesc& scene, int k) {
    scene::ModelDesc person = model("p" + std::to_string(k), "position", scene::ModelKind::kPosition, -1);
    person.size = {0.3, 0.5, 1.75};
    person.gui_move = true;
    person.position.emplace();
    person.position->drive = scene::Drive::kWalk;
    scene::make_body(person.size, person);
    scene.models.push_back(person);
  }

  static void add_robot(scene::SceneDesc& scene, int k) {
    const auto root = static_cast<std::int32_t>(scene.models.size());
    const std::string name = "r" + std::to_string(k);
    scene::ModelDesc robot = model(name, "position", scene::ModelKind::kPosition, -1);
    robot.alias = "position:" + std::to_string(k);
    robot.X_PM = {0.5 * k, -0.25 * k, 0, 0.1 * k};
    robot.X_MB = {-0.04, 0, 0, 0};
    robot.size = {0.44, 0.38, 0.22};
    robot.blocks.push_back({{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}}, 0, 0.22});
    robot.fiducial_return = k + 1;
    robot.gui_move = true;
    robot.position.emplace();
    scene.models.push_back(robot);

    scene::ModelDesc laser = model(name + ".laser:0", "ranger", scene::ModelKind::kRanger, root);
    scene::RangerSensorDesc scanner;
    scanner.range_max = 8;
    scanner.fov = geom::kPi;
    scanner.samples = 5;
    scanner.size = {};
    laser.sensors.push_back(scanner);
    scene.models.push_back(laser);

    scene::ModelDesc sonars = model(name + ".sonar:0", "ranger", scene::ModelKind::kRanger, root);
    sonars.sensors.resize(2);
    for (scene::RangerSensorDesc& sensor : sonars.sensors) sensor.size = {};
    sonars.sensors[1].X_BS = {0.1, 0.1, 0, 1};
    scene.models.push_back(sonars);

    scene::ModelDesc finder = model(name + ".fiducial:0", "fiducial", scene::ModelKind::kFiducial, root);
    finder.fiducial.emplace();
    scene.models.push_back(finder);
  }

  void move(world::PositionRow k, Rng& rng) {
    if (rng.uniform() < 0.3) return;
    const world::ModelRow row = world.positions.model[k];
    geom::Pose X_PM = world.models.X_PM[row];
    X_PM.x += rng.uniform() - 0.5;
    X_PM.y += rng.uniform() - 0.5;
    X_PM.a = geom::normalize(X_PM.a + rng.uniform() - 0.5);
    world::set_pose(world, row, X_PM);
    world.positions.velocity[k] = {rng.uniform(), 0, 0, rng.uniform() - 0.5};
    world.positions.X_OM[k] = X_PM;
    world.positions.stall[k] = rng.uniform() < 0.2;
    if (rng.uniform() < 0.1) world::set_color(world, row, {0, static_cast<float>(rng.uniform()), 1, 1});
  }

  void see(world::FiducialRow k, Rng& rng) {
    world.fiducials.measured_tick[k] = world.tick_;
    auto& hits = world.fiducials.hits[k];
    hits.clear();
    if (rng.uniform() < 0.5)
      hits.push_back({{robot(0)}, 1, 8 * rng.uniform(), rng.uniform(), -rng.uniform(), {}});
  }

  scene::SceneDesc scene_;

 public:
  const Prototypes prototypes;
  world::World world;
};

}  // namespace playhouse::replicate
