#pragma once

/// Rerun: a recorded run once more: an engine of the recorded world, its changes carried out where they were,
/// and compared with what the recording says. Thread: tick.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/record/mcap_reader.h"
#include "playhouse/world/engine.h"
#include "playhouse/world/saved_run.h"

namespace playhouse::record {

/// What a recording has for a rerun, in its order.
struct Recording {
  struct State {
    std::uint64_t tick = 0;
    std::size_t events = 0;  // that come before it
    Bytes bytes;             // whole_state.h
  };
  struct Event {
    std::uint64_t tick = 0;    // of the world when it happens
    Bytes difference;          // empty: a check
    std::uint64_t before = 0;  // hash_of() the state before the difference
    std::uint64_t hash = 0, sensed_hash = 0;
  };
  world::SavedRun start;
  std::vector<State> states;
  std::vector<Event> events;
  bool cut = false;  // the program that wrote it was killed
};

/// Fails, naming no file, on files that are no recordings of ours or have data alone.
Result<Recording> read_recording(const Source& source);

class Rerun final : public world::Engine {
 public:
  /// An engine of the recording's scene and seed, with its controllers. The recording outlives it.
  Rerun(const Recording& recording, std::unique_ptr<world::Engine> engine);

  /// The state at the start. Fails where that is none of this world.
  Result<void> begin();
  /// Carries out what happens at this tick, and does the next. Nothing at the end, and after an error.
  void step() override;
  /// The recording has nothing more.
  bool at_end() const { return event_ == recording_->events.size(); }
  /// Where the run became another one; after that nothing is compared.
  const std::optional<std::string>& differs() const { return differs_; }
  /// The world is that at a tick, from the nearest state before it on; the first or the last tick that there
  /// is instead of one beyond. Does nothing after an error.
  void seek(std::uint64_t tick);
  /// Of the recording; where the run was taken back, of its last way.
  std::uint64_t first_tick() const { return recording_->states.front().tick; }
  std::uint64_t last_tick() const;
  /// How many checks agreed.
  std::uint64_t checks() const { return checks_; }

  world::World& world() override { return engine_->world(); }
  world::Workers& workers() override { return engine_->workers(); }
  std::uint64_t rays() const override { return engine_->rays(); }

 private:
  Result<void> load(const Recording::State& state);
  void happen();
  void check(const Recording::Event& event);
  void change(const Recording::Event& event);
  void fail(const std::string& what);
  void fail_to_load(const std::string& what);

  const Recording* recording_;
  std::unique_ptr<world::Engine> engine_;
  std::size_t event_ = 0;  // the next one
  std::uint64_t checks_ = 0;
  std::optional<std::string> differs_;
};

}  // namespace playhouse::record
