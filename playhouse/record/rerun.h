#pragma once

/// Rerun: replay of a recorded run: an engine of the recorded world, with the recorded
/// changes applied at their ticks, and checked against the recorded hashes. Thread: tick.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/record/mcap/mcap_reader.h"
#include "playhouse/record/mcap/packed_bytes.h"
#include "playhouse/world/engine.h"
#include "playhouse/world/saving/saved_run.h"

namespace playhouse::record {

/// The replay data of a recording, in order.
struct Recording {
  struct State {
    std::uint64_t tick = 0;
    std::size_t items = 0;  // number of items before it
    PackedBytes bytes;      // whole_state.h
  };
  /// A change, or a check.
  struct ChangeOrCheck {
    std::uint64_t tick = 0;  // of the world before it
    PackedBytes change;      // world/changes/packed_change.h; empty: a check
    std::uint64_t hash = 0, sensed_hash = 0;
  };
  world::SavedRun start;
  std::vector<State> states;
  std::vector<ChangeOrCheck> items;
  bool cut = false;  // truncated: the recording program was killed
};

/// States and changes of a recording that are kept, packed. [B]
inline constexpr std::size_t kKeptBytes = std::size_t{2} << 30;

/// Fails, without a file name, on files that are not our recordings, have no replay data, or have more than
/// `most` packed bytes of it.
Result<Recording> read_recording(const ByteSource& source, std::size_t most = kKeptBytes);

class Rerun final : public world::Engine {
 public:
  /// `engine` has the recording's scene, seed and controllers. The recording must outlive it.
  Rerun(const Recording& recording, std::unique_ptr<world::Engine> engine);

  /// Loads the initial state. Fails if it does not match the world.
  Result<void> begin();
  /// Applies the changes of this tick, then steps. No effect at the end or after an error.
  void step() override;
  /// True if nothing is left.
  bool at_end() const { return next_ == recording_->items.size(); }
  /// Where the replay diverged from the recording; no checks after that.
  const std::optional<std::string>& differs() const { return differs_; }
  /// Moves to a tick, from the nearest keyframe before it, clamped
  /// to the range of the recording. No effect after an error.
  void seek(std::uint64_t tick);
  /// Of the recording; after a rewind, of its last branch.
  std::uint64_t first_tick() const { return recording_->states.front().tick; }
  std::uint64_t last_tick() const;
  /// Number of checks passed.
  std::uint64_t checks() const { return checks_; }

  world::World& world() override { return engine_->world(); }
  world::Workers& workers() override { return engine_->workers(); }
  std::uint64_t rays() const override { return engine_->rays(); }

 private:
  Result<void> load(const Recording::State& state);
  void happen();
  void check(const Recording::ChangeOrCheck& item);
  void change(const Recording::ChangeOrCheck& item);
  void fail(const std::string& what);
  void fail_to_load(const std::string& what);

  const Recording* recording_;
  std::unique_ptr<world::Engine> engine_;
  std::size_t next_ = 0;  // item
  std::uint64_t checks_ = 0;
  std::optional<std::string> differs_;
};

}  // namespace playhouse::record
