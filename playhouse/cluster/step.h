#pragma once

/// Step: what the head tells a node before each tick.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/world/division.h"

namespace playhouse::cluster {

struct Step {
  world::Share share;  // of this node
  bool check = false;  // its Share has the hashes of its world
  /// The world (world/saving/whole_state.h), for a node that joins, after a load, and in place of many changes.
  std::span<const std::byte> state;
  std::span<const std::byte> changes;  // since the last tick, in order (world/changes/packed_change.h)
};

/// Appends the body of a message kStep.
void encode(const Step& step, std::vector<std::byte>& out);

/// Refers to the bytes. Fails if they are no step.
Result<Step> decode_step(std::span<const std::byte> bytes);

/// The hashes of a world at a check.
struct Hashes {
  std::uint64_t done = 0, sensed = 0;
  friend bool operator==(const Hashes&, const Hashes&) = default;
};

}  // namespace playhouse::cluster
