#pragma once

/// History: what the last minutes of a run can be repeated from, for Simulation::rewind_to(): keyframes, and
/// the changes between the ticks. A keyframe every kHistoryPeriodSeconds, of the last kHistorySeconds; all
/// together within kHistoryBytes (base/limits.h): when full, old keyframes are thinned out, so that spacing
/// grows with age. Taking them costs at most a hundredth of wall time. Thread: tick.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/world/control.h"
#include "playhouse/world/generated/changes.h"
#include "playhouse/world/world.h"

namespace playhouse::run {

class History {
 public:
  /// A state of the run (world/saving/whole_state.h).
  struct Keyframe {
    std::uint64_t tick = 0;
    std::shared_ptr<const std::vector<std::byte>> whole;
    bool is_branch = false;  // the run went on from here after a rewind, with the users of another time
  };

  /// `interval` is one tick [s], `clock` is monotonic [s], `most_bytes` the limit on all that is kept.
  History(double interval, std::function<double()> clock, std::size_t most_bytes = limits::kHistoryBytes);

  /// Takes a keyframe if one is due. Call it after each tick.
  void record(const world::World& world);
  /// Keeps the changes that were made after the present tick, if there are keyframes, but those of drawings.
  /// After a `Load` those before it are not of this run.
  void changed(std::span<const world::Change> changes);
  /// The run goes on from this tick: what lies after it is of another run, and dropped. Call it before each
  /// tick.
  void continue_from(std::uint64_t tick);

  /// Before the run is taken back: keeps its present state as the last one, until it goes on.
  void leave(const world::World& world);
  /// The run was taken back or forth to this world. If it goes on from here, that is a keyframe.
  void arrive(const world::World& world);

  bool empty() const { return keyframes_.empty(); }
  /// The tick nearest to this one that the run can be taken to. There must be keyframes.
  std::uint64_t nearest(std::uint64_t tick) const;
  /// The last state at or before such a tick.
  const Keyframe& before(std::uint64_t tick) const;
  /// The changes made between this tick and the next, without those of drawings, packed
  /// (world/changes/packed_change.h).
  std::span<const std::byte> changes_at(std::uint64_t tick) const;

  /// Drops all: a new run begins.
  void clear();

  /// The list of keyframes for viewers; a new object after each change. Never null.
  std::shared_ptr<const world::Timeline> timeline();

 private:
  struct Changes {
    std::uint64_t tick = 0;
    std::vector<std::byte> packed;
  };
  std::optional<Keyframe> save(const world::World& world);
  void make_room();
  void drop(std::size_t place);
  void drop_first();

  const std::uint64_t period_, span_;  // ticks
  const std::function<double()> clock_;
  const std::size_t most_bytes_;
  std::vector<Keyframe> keyframes_;      // by tick, each without the changes of its tick
  std::deque<Changes> changes_;          // by tick, from the first keyframe on
  std::optional<Keyframe> present_;      // with the changes of its tick; none: the run was not taken back
  std::vector<std::byte> new_changes_;   // since the last tick
  std::optional<Keyframe> arrived_;      // where the run was taken to, and has not gone on
  std::size_t bytes_ = 0, changed_ = 0;  // of keyframes and present_, of changes_ [B]
  double rest_until_ = 0;  // wall clock: a hundred times the cost of the last keyframe has passed
  std::string why_none_;   // empty: keyframes can be taken
  std::shared_ptr<const world::Timeline> timeline_;  // null: outdated
};

}  // namespace playhouse::run
