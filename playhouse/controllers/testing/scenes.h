#pragma once

/// Small scenes for the tests of controllers, made without files or an engine.

#include <string>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::controllers::testing {

/// `robots` robots "r0", "r1", ..., each with one ranger of these sensors and one controller line.
inline scene::SceneDesc robots(std::size_t count, const std::vector<scene::RangerSensorDesc>& sensors,
                               const std::string& ctrl) {
  scene::SceneDesc scene;
  scene.path = "test.world";
  scene.files = {"test.world"};
  for (std::size_t i = 0; i < count; ++i) {
    scene::ModelDesc robot;
    robot.name = robot.alias = "r" + std::to_string(i);
    robot.type = "position";
    robot.kind = scene::ModelKind::kPosition;
    robot.where = {0, static_cast<std::uint32_t>(i + 1)};
    robot.X_PM = {2.0 * static_cast<double>(i), 0, 0, 0};
    robot.size = {0.4, 0.4, 0.2};
    robot.position.emplace();
    robot.ctrl = {ctrl};
    scene::ModelDesc ranger;
    ranger.name = ranger.alias = robot.name + ".ranger:0";
    ranger.type = "ranger";
    ranger.kind = scene::ModelKind::kRanger;
    ranger.parent = static_cast<std::int32_t>(scene.models.size());
    ranger.sensors = sensors;
    scene.models.push_back(robot);
    scene.models.push_back(ranger);
  }
  return scene;
}

/// One scanner of `samples` beams over 180 degrees, out to 8 m.
inline std::vector<scene::RangerSensorDesc> scanner(std::uint32_t samples) {
  scene::RangerSensorDesc sensor;
  sensor.range_max = 8;
  sensor.fov = geom::kPi;
  sensor.samples = samples;
  return {sensor};
}

/// `count` single-beam sensors around the robot, the first straight ahead, out to 5 m.
inline std::vector<scene::RangerSensorDesc> ring(std::size_t count) {
  std::vector<scene::RangerSensorDesc> sensors(count);
  for (std::size_t k = 0; k < count; ++k) {
    sensors[k].X_BS.a = geom::normalize(geom::kTwoPi * static_cast<double>(k) / static_cast<double>(count));
  }
  return sensors;
}

/// Pretends that every ranger measured these beams in a new tick.
inline void measure(world::World& world, const std::vector<float>& beams) {
  ++world.tick_;
  for (const world::BeamRow beam : world.sensors.ranges.rows())
    world.sensors.ranges[beam] = beams[beam.index % beams.size()];
  for (std::uint64_t& tick : world.rangers.measured_tick) tick = world.tick_;
}

/// One decide phase with everything in one range.
inline void decide(world::World& world) {
  for (const auto& decider : world.deciders) decider->follow(world);
  for (const auto& decider : world.deciders) decider->decide(world, 0, decider->size());
  for (const auto& decider : world.deciders) decider->deliver(world);
}

}  // namespace playhouse::controllers::testing
