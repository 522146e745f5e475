#pragma once

/// Changes as bytes, for recordings and for nodes of a cluster, and as text for people. Each begins
/// with its name, so that a reader of another version fails at what it does not know.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/packing.h"
#include "playhouse/base/result.h"
#include "playhouse/world/generated/changes.h"

namespace playhouse::world {

std::string_view name_of(const Change& change);
/// The model that it is of; none for those of the world.
ModelId model_of(const Change& change);

void pack(const Change& change, std::vector<std::byte>& out);
/// Fails on bytes that are not a change. Allocates a small multiple of their size
/// at most.
Result<Change> unpack_change(Unpacker& in);

/// Its fields without the model, as a JSON object: {"velocity": [0.5, 0, 0, 0.1]}. Models are
/// numbers of ids, a state tells its size only.
std::string fields_text(const Change& change);

}  // namespace playhouse::world
