#pragma once

/// Supports: which bodies that move may be below a vehicle, so that its wheels stand on them.
///
/// In: boxes along W's axes that hold the bodies.
/// Out: for a box, the bodies whose boxes overlap it, in the order of their numbers.
/// Cost: set() a sort of all boxes; find() those whose low side is within kWide ahead of the box in x, and
/// all
///   that are wider than kWide.
/// Source: sweep and prune along one axis (Baraff, 1992).
///
/// Thread: find() from any number of threads at once; set() from one.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/arena/rigid_body.h"

namespace playhouse::arena {

struct Box {
  Vec3 low, high;  // m, in W
};

class Supports {
 public:
  /// `boxes` has one for each body.
  void set(std::span<const Box> boxes);
  /// Replaces `bodies` by the numbers of those that overlap the box.
  void find(const Box& box, std::vector<std::uint32_t>& bodies) const;

 private:
  struct Entry {
    Box box;
    std::uint32_t body = 0;
  };
  std::vector<Entry> narrow_;  // by the low side in x
  std::vector<Entry> wide_;
};

}  // namespace playhouse::arena
