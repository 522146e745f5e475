#pragma once

/// History: keyframes of the last minutes of a run, for Simulation::rewind(). One
/// every kHistoryPeriodSeconds, of the last kHistorySeconds, within kHistoryBytes
/// (base/limits.h): when full, old keyframes are thinned out, so that spacing
/// grows with age. Recording takes at most a hundredth of wall time. Thread: tick.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/world/control.h"
#include "playhouse/world/world.h"

namespace playhouse::run {

class History {
 public:
  /// `interval` is one tick [s], `clock` is monotonic [s], `most_bytes` the limit on all states.
  History(double interval, std::function<double()> clock, std::size_t most_bytes = limits::kHistoryBytes);

  /// Takes a keyframe if one is due. Call it after each tick.
  void record(const world::World& world);
  /// Takes a keyframe, unless there is one of this tick.
  void take(const world::World& world);

  bool empty() const { return instants_.empty(); }
  /// The keyframe nearest to a tick, the earlier one of
  /// two. There must be one.
  std::shared_ptr<const std::vector<std::byte>> nearest(std::uint64_t tick) const;
  /// Drops keyframes after a tick, as the run continues differently from there.
  void drop_after(std::uint64_t tick);
  /// Drops all keyframes: a new run begins.
  void clear();
  /// Drops all keyframes and takes no more.
  void give_up(std::string why);

  /// The list of keyframes for viewers; a new object after each change. Never null.
  std::shared_ptr<const world::Timeline> timeline();

 private:
  struct Instant {
    std::uint64_t tick = 0;
    std::shared_ptr<const std::vector<std::byte>> state;
  };
  void make_room();
  void drop(std::size_t place);

  const std::uint64_t period_, span_;  // ticks
  const std::function<double()> clock_;
  const std::size_t most_bytes_;
  std::vector<Instant> instants_;  // by tick
  std::size_t bytes_ = 0;
  double rest_until_ = 0;  // wall clock: a hundred times the cost of the last keyframe has passed
  std::string why_none_;   // empty: keyframes can be taken
  bool given_up_ = false;
  std::shared_ptr<const world::Timeline> timeline_;  // null: outdated
};

}  // namespace playhouse::run
