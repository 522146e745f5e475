#pragma once

/// Playback: control of a replayed recording: pause, any speed,
/// seek. Other requests have no effect. Threads: as world::Control.

#include <memory>
#include <string>

#include "playhouse/record/rerun.h"
#include "playhouse/run/simulation.h"

namespace playhouse::app {

class Playback final : public world::Control {
 public:
  /// Both must outlive it; the rerun is the simulation's engine.
  Playback(run::Simulation& simulation, record::Rerun& rerun);

  /// Pauses at the end of the recording. To be called after every tick. Tick thread.
  void look_for_end();

  std::string why_fixed() const override { return "this is a recording: nothing in it can be changed"; }
  void pause() override { simulation_.requests().pause(); }
  void resume() override { simulation_.requests().resume(); }
  void step_once() override { simulation_.requests().step_once(); }
  void set_speed(double times_real_time) override { simulation_.requests().set_speed(times_real_time); }
  void drive(world::ModelId, const geom::Twist&) override {}
  /// Accepts the change and drops it.
  bool post(std::function<void(world::Journal&)>, world::ModelId) override { return true; }
  void record(bool) override {}
  std::shared_ptr<const world::Timeline> timeline() const override { return timeline_; }
  void rewind(std::uint64_t tick) override;
  std::uint64_t generation(world::ModelId) const override { return 0; }

 private:
  run::Simulation& simulation_;
  record::Rerun& rerun_;
  std::shared_ptr<const world::Timeline> timeline_;
  bool told_ = false;
};

}  // namespace playhouse::app
