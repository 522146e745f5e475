#pragma once

/// The event log of a world: spawns, removals, attachments, placements; one list, read by engine, viewers,
/// device table, controllers and recordings. Written by the functions of population.h and world.h.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/world/model_id.h"

namespace playhouse::world {

/// Mobility of a model. A tree with a fixed root may have movable parts.
enum class Mobility : std::uint8_t {
  kFixed,   // static: indexed once by the engine
  kLoose,   // moved by others: pucks, and models spawned at run time
  kDriven,  // a mover, or carried by one
};

struct Event {
  enum class EventKind : std::uint8_t {
    kSpawn,    // root `model` was added with all its parts
    kDespawn,  // root `model` was removed with all its parts: exactly `count` ids from its own on
    kAttach,   // `model` became a part of `other`
    kDetach,   // `model` was a part of `other` and became a root
    kPlace,    // `model` got a new pose in its parent
    kSet,      // a property of `model` was set
    kReload,  // another state of the same run was loaded: anything may be different; ids name the same models
  };
  EventKind kind;
  ModelId model, other;
  std::uint32_t count = 0;
  /// Mobility of `model` before the change; kFixed also if a part joined a fixed
  /// tree that thereby became movable, or left one that thereby became fixed again.
  Mobility mobility = Mobility::kFixed;
  friend bool operator==(const Event&, const Event&) = default;
};

/// The log. A reader keeps the number of the first entry that it has not read.
class EventLog {
 public:
  void add(const Event& event) { entries_.push_back(event); }

  /// Number of the next entry; entries are numbered from 0 over the whole run.
  std::uint64_t end() const { return first_ + entries_.size(); }
  /// The retained entries from number `from` on. The engine drops entries from before its last
  /// tick, so a reader that polls after every tick and after changes between ticks misses none.
  std::span<const Event> since(std::uint64_t from) const {
    const std::uint64_t at = from < first_ ? first_ : from;
    return std::span(entries_).subspan(static_cast<std::size_t>(at - first_));
  }
  /// Drops entries below this number.
  void drop_before(std::uint64_t number) {
    if (number <= first_) return;
    entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(number - first_));
    first_ = number;
  }

 private:
  std::uint64_t first_ = 0;
  std::vector<Event> entries_;
};

}  // namespace playhouse::world
