#pragma once

/// Changes of who is in a world and of what is put where, as entries of one list that the engine, viewers,
/// the device table, controllers and recordings read. The functions of population.h and world.h add to it.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/world/model_id.h"

namespace playhouse::world {

/// How a model comes to move. A tree of which the top is fixed may hold others that are not.
enum class Mobility : std::uint8_t {
  kFixed,   // stands still; the engine indexes it once
  kLoose,   // is moved by others: pucks, and what came during the run
  kDriven,  // moves by itself, or is carried by what does
};

struct Change {
  enum class Kind : std::uint8_t {
    kSpawn,    // `model`, a top, came with all inside it
    kDespawn,  // `model`, a top, went with all inside it: `count` ids from its own on, and no others
    kAttach,   // `model` is part of `other` from now on
    kDetach,   // `model` was part of `other` and is a top now
    kPlace,    // `model` was put elsewhere in its parent
    kSet,      // a property of `model` was set
    kReload,  // another state of the same run was loaded: anything may be another, but ids name whom they did
  };
  Kind kind;
  ModelId model, other;
  std::uint32_t count = 0;
  /// Of `model` as it was when it changed; kFixed also where a part came to what stands still, which it no
  /// longer does, or went from what does so again.
  Mobility mobility = Mobility::kFixed;
  friend bool operator==(const Change&, const Change&) = default;
};

/// The list. Readers keep the number of the next entry they have not read.
class ChangeList {
 public:
  void add(const Change& change) { entries_.push_back(change); }

  /// Number of the next entry that will be added; entries count from 0 for the life of a run.
  std::uint64_t end() const { return first_ + entries_.size(); }
  /// Entries from number `from` on that are still kept. The engine drops what was there before its last tick,
  /// so a reader that looks after every tick and after changes between ticks misses none.
  std::span<const Change> since(std::uint64_t from) const {
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
  std::vector<Change> entries_;
};

}  // namespace playhouse::world
