#pragma once

/// ShownWorlds: what viewers were shown of the world of a house, kept for some time: what a page holds must be one of
/// these instants. Thread: one for the whole house.

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <span>

#include "playhouse/replicate/prototypes.h"
#include "playhouse/replicate/snapshot.h"

namespace playhouse::house {

class ShownWorlds {
 public:
  /// Made at the same time as the feed of the servers; the world's scene must outlive it.
  explicit ShownWorlds(const world::World& world);

  /// Whenever the feed shows the world.
  void show(const world::World& world, const world::Pace& pace);
  /// The newest population for which `fits`; null: none.
  std::shared_ptr<const replicate::Layout> population(
      const std::function<bool(const replicate::Layout&)>& fits) const;
  /// The models had these states at this tick.
  bool has(std::uint64_t tick, const replicate::Layout& layout,
           std::span<const replicate::ModelState> models) const;

 private:
  replicate::Prototypes prototypes_;
  std::deque<replicate::Snapshot> snapshots_;  // newest last
};

}  // namespace playhouse::house
