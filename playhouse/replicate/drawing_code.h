#pragma once

/// Drawings in packets (delta.h).

#include <optional>
#include <span>
#include <vector>

#include "playhouse/base/packing.h"
#include "playhouse/replicate/snapshot.h"

namespace playhouse::replicate {

/// A drawing of whole shapes, as runs of one color.
void write_drawing(std::span<const SentCorner> drawing, Packer& pack);

/// None: it is cut short, or has a shape of no or too many corners. Its memory follows the bytes.
std::optional<std::vector<SentCorner>> read_drawing(Unpacker& in);

}  // namespace playhouse::replicate
