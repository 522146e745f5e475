#pragma once

/// DrawnRun: an offline run of a world, or of a recording, for rendering, at full speed from frame to frame.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/app/again.h"
#include "playhouse/app/commands/options.h"
#include "playhouse/app/interrupt.h"
#include "playhouse/app/pictures/renderer.h"
#include "playhouse/app/pictures/sensor_shapes.h"
#include "playhouse/run/simulation.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::app {

class DrawnRun {
 public:
  /// Activates the sensors in `seen`.
  DrawnRun(scene::SceneDesc scene, Running running, SensorShapes seen)
      : scene_(std::move(scene)), running_(std::move(running)), seen_(std::move(seen)) {}
  /// The recorded run. Its sensors measure what they measured then, seen or not.
  DrawnRun(std::unique_ptr<OpenedRecording> recording, SensorShapes seen)
      : recording_(std::move(recording)), seen_(std::move(seen)) {}
  DrawnRun(const DrawnRun&) = delete;
  DrawnRun& operator=(const DrawnRun&) = delete;

  /// Starts, or restarts, at the first tick: the same run. Fails on
  /// a scene that cannot run; `others` gets further errors.
  Result<void> begin(std::vector<Error>* others = nullptr);

  /// Advances to a tick, calling the renderer's see() as it
  /// requests. Fails if the renderer does, on a signal, and if differs().
  Result<void> advance(std::uint64_t tick, WorldRenderer& renderer, const Interrupt& interrupt);

  const world::World& world() const {
    return recording_ ? recording_->rerun->world() : simulation_->engine().world();
  }
  double interval() const { return recording_ ? recording_->scene.interval : scene_.interval; }  // s
  std::uint64_t first_tick() const { return recording_ ? recording_->rerun->first_tick() : 0; }
  /// Where a recording ends; none: a run, which has no end.
  std::optional<std::uint64_t> last_tick() const;
  /// Where the run differs from its recording; it cannot be shown from there on.
  std::optional<std::string> differs() const;
  const SensorShapes& seen() const { return seen_; }

 private:
  void step(std::uint64_t ticks);

  const scene::SceneDesc scene_;
  const Running running_;
  const std::unique_ptr<OpenedRecording> recording_;  // in place of the two above
  const SensorShapes seen_;
  std::unique_ptr<run::Simulation> simulation_;
};

}  // namespace playhouse::app
