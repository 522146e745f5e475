#pragma once

/// SensePhase: what a kind of sensor has to say for itself in an engine with bodies in `Space`; and Senses,
/// all kinds of an engine. A new kind is a class of its own.

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "playhouse/behaviour/due_list.h"
#include "playhouse/world/workers.h"

namespace playhouse::behaviour {

template <typename Space>
class SensePhase {
 public:
  virtual ~SensePhase() = default;

  /// The table of these sensors. Valid while the population is.
  virtual SensorTable table(world::World& world) const = 0;

  /// Sizes and fills what depends on which models there are. To be called again, between two ticks, when some
  /// came or went or what stands still was put elsewhere; what is made of sensors that are alike is kept.
  virtual void populate(const world::World& world, const Space& space) = 0;

  /// Whether it has something to do in a tick in which no sensor is due.
  virtual bool has_work(const world::World& world) const { return static_cast<void>(world), false; }

  /// Measures with the sensors `due` for `tick`, the number that the state gets when it is frozen. Returns
  /// the rays cast.
  virtual std::uint64_t sense(world::World& world, const Space& space, std::span<const std::uint32_t> due,
                              std::uint64_t tick, world::Workers& workers) = 0;
};

template <typename Space>
class Senses {
 public:
  void add(std::unique_ptr<SensePhase<Space>> phase) { entries_.push_back({std::move(phase), {}}); }

  /// See SensePhase.
  void populate(world::World& world, const Space& space) {
    for (Entry& entry : entries_) {
      entry.due.populate(world, entry.phase->table(world).model);
      entry.phase->populate(world, space);
    }
  }

  /// The phase `sense`. Returns the rays cast.
  std::uint64_t sense(world::World& world, const Space& space, std::uint64_t tick, world::Workers& workers) {
    std::uint64_t rays = 0;
    for (Entry& entry : entries_) {
      const std::span<const std::uint32_t> due = entry.due.take(world, entry.phase->table(world), tick);
      if (!due.empty() || entry.phase->has_work(world))
        rays += entry.phase->sense(world, space, due, tick, workers);
    }
    return rays;
  }

 private:
  struct Entry {
    std::unique_ptr<SensePhase<Space>> phase;
    DueList due;
  };
  std::vector<Entry> entries_;
};

}  // namespace playhouse::behaviour
