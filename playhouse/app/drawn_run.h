#pragma once

/// DrawnRun: an offline run of a world for rendering, at full speed from frame to frame.

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
  /// Activates the sensors in `seen`.
  DrawnRun(scene::SceneDesc scene, Running running, SensorShapes seen)
      : scene_(std::move(scene)), running_(std::move(running)), seen_(std::move(seen)) {}
  DrawnRun(const DrawnRun&) = delete;
  DrawnRun& operator=(const DrawnRun&) = delete;

  /// Starts, or restarts, at tick 0: the same run. Fails on
  /// a scene that cannot run; `others` gets further errors.
  Result<void> begin(std::vector<Error>* others = nullptr);

  /// Advances to a tick, calling the renderer's see() as it
  /// requests. Fails if the renderer does, and on a signal.
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
