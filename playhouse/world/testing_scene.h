#pragma once

/// A scene for tests of worlds.

#include "playhouse/scene/scene_desc.h"

namespace playhouse::world::testing {

/// A robot "r" at (1, 2, 90 degrees) with a two-beam ranger 0.1 m ahead of it, and a box "box".
inline scene::SceneDesc small_scene() {
  scene::SceneDesc scene;
  scene::ModelDesc robot;
  robot.name = "r";
  robot.alias = "position:0";
  robot.kind = scene::ModelKind::kPosition;
  robot.X_PM = {1, 2, 0, geom::kPi / 2};
  robot.position.emplace();
  scene::ModelDesc ranger;
  ranger.name = "r.ranger:0";
  ranger.alias = ranger.name;
  ranger.kind = scene::ModelKind::kRanger;
  ranger.parent = 0;
  ranger.X_PM = {0.1, 0, 0.2, 0};
  ranger.sensors.resize(1);
  ranger.sensors[0].samples = 2;
  scene::ModelDesc box;
  box.name = "box";
  box.alias = "model:1";
  scene.models = {robot, ranger, box};
  return scene;
}

}  // namespace playhouse::world::testing
