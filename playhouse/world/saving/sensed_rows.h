#pragma once

/// Measurements of some sensors as bytes, for nodes of a cluster: the columns of Role::kSensed.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/base/packing.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// Appends the measurements of the sensors in these rows, ascending, of the table of a kind. The
/// same for the same measurements. Cost: a copy per run of consecutive rows and column of numbers.
void pack_sensed(const World& world, scene::ModelKind kind, std::span<const KindRow> rows,
                 std::vector<std::byte>& out);

/// Sets them. False, with an undefined part of them set, on bytes that pack_sensed() of these rows does not
/// append.
bool unpack_sensed(World& world, scene::ModelKind kind, std::span<const KindRow> rows, Unpacker& in);

}  // namespace playhouse::world
