#pragma once

/// Complete state of a world between two ticks, including subscriptions, as far as
/// the next tick depends on it: equal bytes give equal runs. Changes between ticks
/// are recorded as the difference of two such states, whatever their origin and kind.

#include <cstdint>
#include <span>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap.h"
#include "playhouse/world/world.h"

namespace playhouse::record {

/// Appends the state to `out`: that of world/saving/state.h with its size in front, then the subscriptions
/// of each model without controllers, and of those the watchers. Fails like world::save_state().
Result<void> save_whole(const world::World& world, Bytes& out);

/// Replaces the world, like world::load_state(); adopts the saved seed if it differs.
Result<void> load_whole(world::World& world, std::span<const std::byte> state);

/// Delta from `before` to `after`: changed bytes if the sizes are equal, otherwise all.
Bytes difference(std::span<const std::byte> before, std::span<const std::byte> after);

/// Applies a difference(). Fails on bytes that are not a difference to this state.
Result<Bytes> patched(std::span<const std::byte> before, std::span<const std::byte> difference);

/// Tells states apart.
std::uint64_t hash_of(std::span<const std::byte> state);

}  // namespace playhouse::record
