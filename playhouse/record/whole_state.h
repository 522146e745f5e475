#pragma once

/// A world between two ticks as bytes, with who subscribes and who watches, on which the next tick depends
/// as well: what follows from the same bytes is the same run. And what changes between two ticks, as the
/// difference of two such states: whoever asked for the change and whatever it was, this is all that it did.

#include <cstdint>
#include <span>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap.h"
#include "playhouse/world/world.h"

namespace playhouse::record {

/// Appends the state to `out`: that of world/state.h with its size in front, then of each model the
/// subscribers that are no controllers, and of these those who watch. Fails as world::save_state().
Result<void> save_whole(const world::World& world, Bytes& out);

/// Makes the world the one that was saved, as world::load_state(); with another seed where that has one.
Result<void> load_whole(world::World& world, std::span<const std::byte> state);

/// What makes `after` of `before`: the bytes that are others, where both are of one size, else all.
Bytes difference(std::span<const std::byte> before, std::span<const std::byte> after);

/// `after` of difference(), from `before` alone. Fails on bytes that are no difference of such a state.
Result<Bytes> patched(std::span<const std::byte> before, std::span<const std::byte> difference);

/// Tells states apart.
std::uint64_t hash_of(std::span<const std::byte> state);

}  // namespace playhouse::record
