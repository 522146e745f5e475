#pragma once

/// Complete state of a world between two ticks, including subscriptions, as far as
/// the next tick depends on it: equal bytes give equal runs. For keyframes of
/// recordings, and for nodes that join a cluster.

#include <cstdint>
#include <span>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap/mcap.h"
#include "playhouse/world/world.h"

namespace playhouse::record {

/// Appends the state to `out`: that of world/saving/state.h with its size in front, then the subscriptions
/// of each model without controllers, and of those the watchers. Fails like world::save_state().
Result<void> save_whole(const world::World& world, Bytes& out);

/// Replaces the world, like world::load_state(); adopts the saved seed if it differs.
Result<void> load_whole(world::World& world, std::span<const std::byte> state);

}  // namespace playhouse::record
