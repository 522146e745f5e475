#pragma once

/// History: states of a run at instants of its last minutes, for Simulation::rewind(). An instant every
/// kHistoryPeriodSeconds, of the last kHistorySeconds, in kHistoryBytes (base/limits.h): what has no room
/// gives way so that instants lie the farther apart the longer ago they are. Recording takes a hundredth of
/// the wall time at most. Thread: tick.

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

namespace playhouse::drivers {

class History {
 public:
  /// `interval` is one tick [s], `clock` a steady one [s], `most_bytes` the limit of all states.
  History(double interval, std::function<double()> clock, std::size_t most_bytes = limits::kHistoryBytes);

  /// Takes the world's state where one is due. Call it after each tick.
  void record(const world::World& world);
  /// Takes the world's state, unless there is one of its tick.
  void take(const world::World& world);

  bool empty() const { return instants_.empty(); }
  /// The state of the instant nearest to a tick, the earlier one of two; valid until the next change. There
  /// is one.
  std::span<const std::byte> nearest(std::uint64_t tick) const;
  /// Forgets what lies after a tick: the run goes another way from there.
  void drop_after(std::uint64_t tick);
  /// Forgets everything: another run begins.
  void clear();
  /// Forgets everything, and takes nothing any more.
  void give_up(std::string why);

  /// What there is, for people; another one whenever that changes. Never null.
  std::shared_ptr<const world::Past> past();

 private:
  struct Instant {
    std::uint64_t tick = 0;
    std::vector<std::byte> state;
  };
  void make_room();
  void drop(std::size_t place);

  const std::uint64_t period_, span_;  // ticks
  const std::function<double()> clock_;
  const std::size_t most_bytes_;
  std::vector<Instant> instants_;  // by tick
  std::size_t bytes_ = 0;
  double rest_until_ = 0;  // wall clock: what the last one took, times a hundred, has passed
  std::string why_none_;   // empty: states can be taken
  bool given_up_ = false;
  std::shared_ptr<const world::Past> past_;  // null: to be made
};

}  // namespace playhouse::drivers
