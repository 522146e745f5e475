#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/world/changes/journal.h"

namespace playhouse::world {

/// The rate of a running simulation.
struct Pace {
  bool paused = false;
  double speed = 1;             // requested, times real time; 0: as fast as possible
  double real_time_factor = 0;  // measured over the last second
};

/// The keyframes of a run: instants with a retained state.
struct Timeline {
  std::vector<std::uint64_t> ticks;  // ascending
  std::string why_none;              // why no state can be retained, as one line; else empty
};

/// Control of a running simulation, for viewers and devices. Functions are asynchronous and thread-safe
/// unless stated otherwise: requests are executed on the tick thread before the next tick, also while paused.
class Control {
 public:
  virtual ~Control() = default;
  /// Why users may not change the world, as one line; empty: they may.
  virtual std::string why_fixed() const { return {}; }
  virtual void pause() = 0;
  virtual void resume() = 0;
  /// Runs one tick, then pauses.
  virtual void step_once() = 0;
  virtual void set_speed(double times_real_time) = 0;
  /// Sets the commanded velocity of a robot, like a client's
  /// command; the latest before a tick applies. Must be finite.
  virtual void drive(ModelId robot, const geom::Twist& velocity) = 0;
  /// `on`: leaves a model to drive() alone, for it is a person's body; commands to its devices
  /// are refused until it is called without. No effect where there are no devices.
  virtual void reserve(ModelId model, bool on) { static_cast<void>(model), static_cast<void>(on); }
  /// Executes `request` on the tick thread between two ticks: it looks at the world, and changes it
  /// by the journal alone. False, without effect, if the queue is full (limits::kRequestQueue).
  /// `robot`, if any, is the model concerned: its earlier commands are applied first.
  virtual bool post(std::function<void(Journal&)> request, ModelId robot = {}) = 0;

  /// Starts or stops retaining states; retained ones stay.
  virtual void record(bool on) = 0;
  /// The retained states. Never null.
  virtual std::shared_ptr<const Timeline> timeline() const = 0;
  /// Takes the run to a tick, past or future, to the bit, or to the one nearest to it that what is retained
  /// reaches; it continues from there. Logged as kReload. No effect without retained states.
  virtual void rewind(std::uint64_t tick) = 0;
  /// Generation count, incremented when rewind() re-creates the
  /// model: earlier subscriptions have ended then. Tick thread.
  virtual std::uint64_t generation(ModelId model) const = 0;
};

/// Handle of one subscription of a model, or of one watcher; it ends
/// with the model, even if a rewind re-creates that. Tick thread.
class Use {
 public:
  /// No effect if the model does not exist.
  void begin(Journal& journal, const Control& control, ModelId model) {
    if (!journal.apply(changes::Subscribe{model})) return;
    model_ = model;
    generation_ = control.generation(model);
    watches_ = false;
  }
  void watch(Journal& journal, const Control& control, ModelId model) {
    if (!journal.apply(changes::Watch{model})) return;
    model_ = model;
    generation_ = control.generation(model);
    watches_ = true;
  }
  /// Ends the subscription. Returns the model; none if it is gone or the use never began.
  ModelRow end(Journal& journal, const Control& control) {
    const bool is_same = generation_ && *generation_ == control.generation(model_);
    generation_.reset();
    if (!is_same) return {};
    watches_ ? journal.apply(changes::Unwatch{model_}) : journal.apply(changes::Unsubscribe{model_});
    return journal.world().row(model_);
  }

 private:
  ModelId model_;
  std::optional<std::uint64_t> generation_;  // at begin(); none: not in use
  bool watches_ = false;
};

}  // namespace playhouse::world
