#pragma once

/// Rays: single rays of bundles in W, while they get shorter. Those of several rangers go through the walls
/// together, or each step would wait for the one before.

#include "playhouse/stage/ranger_kinds.h"

namespace playhouse::stage {

struct Rays {
  static constexpr std::size_t kMost = 128;
  static constexpr std::size_t kSpare = 8;  // what is behind the last ray is worked on with it
  static constexpr std::size_t kRoom = kMost + kSpare;

  double px[kRoom], py[kRoom], dx[kRoom], dy[kRoom];  // m, unit vectors
  float ahead_x[kRoom], ahead_y[kRoom];               // dx, dy
  double z[kRoom], range[kRoom];                      // m
  double solid[kRoom];                                // what they meet there: number_of() a row of Solids
  std::size_t beam[kMost];                            // of Scratch, where they come from
  /// Rays of one bundle, which start near a place.
  struct Part {
    Vec2 about;
    std::size_t begin, end;
  };
  Part parts[kMost];
  std::size_t count = 0, part_count = 0;

  Vec2 p(std::size_t k) const { return {px[k], py[k]}; }
  Vec2 d(std::size_t k) const { return {dx[k], dy[k]}; }
};

}  // namespace playhouse::stage
