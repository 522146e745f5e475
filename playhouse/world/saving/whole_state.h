#pragma once

/// Complete state of a world between two ticks, including subscriptions, as far as the next tick
/// depends on it: equal bytes give equal runs. For keyframes, of recordings and in memory, and for
/// nodes that join a cluster.

#include <cstddef>
#include <span>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// Appends the state to `out`: that of state.h with its size in front, then the subscriptions of each
/// model without controllers, and of those the watchers. Fails like save_state().
Result<void> save_whole(const World& world, std::vector<std::byte>& out);

/// Replaces the world, like load_state(); adopts the saved seed if it differs.
Result<void> load_whole(World& world, std::span<const std::byte> whole);

/// The state without subscriptions, for load_state(); empty if `whole` is damaged.
std::span<const std::byte> state_of(std::span<const std::byte> whole);

}  // namespace playhouse::world
