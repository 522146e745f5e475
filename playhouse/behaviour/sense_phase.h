#pragma once

/// SensePhase: one kind of sensor in an engine whose bodies are in
/// `Space`; and Senses, all kinds of an engine. A new kind is a new class.

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

  /// The table of these sensors. Valid until the population changes.
  virtual SensorTable table(world::World& world) const = 0;

  /// Sizes and fills what depends on the population. To be called between two ticks, again after
  /// a spawn or removal or when a static solid has moved; data shared by equal sensors is kept.
  virtual void populate(const world::World& world, const Space& space) = 0;

  /// Whether it has work even in a tick without due sensors.
  virtual bool has_work(const world::World& world) const { return static_cast<void>(world), false; }

  /// Measures with the sensors `due`; `tick` is the number that the
  /// state will have once frozen. Returns the number of rays cast.
  virtual std::uint64_t sense(world::World& world, const Space& space, std::span<const std::uint32_t> due,
                              std::uint64_t tick, world::Workers& workers) = 0;
};

template <typename Space>
class Senses {
 public:
  void add(std::unique_ptr<SensePhase<Space>> phase) { entries_.push_back({std::move(phase), {}}); }

  /// See SensePhase::populate().
  void populate(world::World& world, const Space& space) {
    for (Entry& entry : entries_) {
      entry.due.populate(world, entry.phase->table(world).model);
      entry.phase->populate(world, space);
    }
  }

  /// The phase `sense`. Returns the number of rays cast.
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
