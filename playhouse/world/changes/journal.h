#pragma once

/// Journal: the one way to change a running world between two ticks. It applies changes
/// and keeps them in order for those who follow the run: recordings, other machines.
/// Thread: the tick thread, between steps.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/world/generated/changes.h"
#include "playhouse/world/population/population.h"

namespace playhouse::world {

class Journal {
 public:
  explicit Journal(World& world) : world_(world) {}

  const World& world() const { return world_; }

  /// Applies a change: false or a reason, and no effect and no entry, if it cannot be (generated/changes.h).
  template <typename Made>
  auto apply(Made change) -> decltype(changes::apply(std::declval<World&>(), change)) {
    auto result = changes::apply(world_, change);
    if (result) entries_.emplace_back(std::move(change));
    return result;
  }
  bool apply(const Change& change);

  /// Somebody hears utterances from now on, or no longer: no part of the state, and no change.
  void listen() { ++world_.utterances.listeners; }
  void stop_listening() { --world_.utterances.listeners; }

  // Those of the world, with ids above all that were ever given in this run.
  Result<ModelId> spawn(std::uint32_t prototype, const geom::Pose& X_WM, std::string name = {});
  Result<ModelId> spawn_copy(ModelId of, const geom::Pose& X_WM, std::string name = {});
  Result<void> despawn(ModelId model) { return apply(changes::Despawn{{model}}); }
  /// Replaces the state; later models get ids that no model had before.
  Result<void> load(std::shared_ptr<const std::vector<std::byte>> state, std::uint64_t seed);

  /// What was applied since clear(), in order.
  std::span<const Change> entries() const { return entries_; }
  void clear() { entries_.clear(); }

 private:
  World& world_;
  std::vector<Change> entries_;
  std::uint32_t ids_given_ = 0;  // ids used before a state was loaded
};

}  // namespace playhouse::world
