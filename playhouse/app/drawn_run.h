#pragma once

/// DrawnRun: a world that runs without anybody, as fast as it can, from picture to picture.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/app/interrupt.h"
#include "playhouse/app/options.h"
#include "playhouse/app/renderer.h"
#include "playhouse/app/sensor_shapes.h"
#include "playhouse/drivers/simulated/simulation.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::app {

class DrawnRun {
 public:
  /// The sensors of `seen` measure.
  DrawnRun(scene::SceneDesc scene, Running running, SensorShapes seen)
      : scene_(std::move(scene)), running_(std::move(running)), seen_(std::move(seen)) {}
  DrawnRun(const DrawnRun&) = delete;
  DrawnRun& operator=(const DrawnRun&) = delete;

  /// Begins at tick 0, again where it has run already: the same run. Fails on a scene that cannot run;
  /// `others` gets the errors after the first.
  Result<void> begin(std::vector<Error>* others = nullptr);

  /// On to a tick, which the renderer sees coming as it wants to. Fails where the renderer does, and when a
  /// signal came.
  Result<void> advance(std::uint64_t tick, Renderer& renderer, const Interrupt& interrupt);

  const world::World& world() const { return simulation_->engine().world(); }
  double interval() const { return scene_.interval; }  // s
  const SensorShapes& seen() const { return seen_; }

 private:
  const scene::SceneDesc scene_;
  const Running running_;
  const SensorShapes seen_;
  std::unique_ptr<drivers::Simulation> simulation_;
};

}  // namespace playhouse::app
