#pragma once

/// Rays: a batch of single rays in W, shortened as hits are found. Rays of several
/// rangers traverse the walls in one batch, which hides the latency of each step. Values.

#include "playhouse/rays/ranger_kinds.h"

namespace playhouse::rays {

struct Rays {
  static constexpr std::size_t kMost = 128;
  static constexpr std::size_t kPad = 8;  // vector loops run past the last ray
  static constexpr std::size_t kRoom = kMost + kPad;

  double px[kRoom], py[kRoom], dx[kRoom], dy[kRoom];  // m, unit vectors
  float ahead_x[kRoom], ahead_y[kRoom];               // dx, dy
  double z[kRoom], range[kRoom];                      // m; range to the nearest hit so far
  double solid[kRoom];                                // nearest hit: number_of() a row of Solids
  std::size_t beam[kMost];                            // of Scratch: where the result belongs
  /// Rays of one bundle or scan, with nearby origins.
  struct NearRays {
    geom::Vec2 about;
    std::size_t begin, end;
    double reach;          // m: how far from `about` the rays go
    world::ModelRow root;  // of the ranger's tree, which is ignored
    bool is_wall;          // of a static tree: its own edges are in the walls
    bool is_level;         // all rays are at one height
  };
  NearRays parts[kMost];
  std::size_t count = 0, part_count = 0;

  geom::Vec2 p(std::size_t k) const { return {px[k], py[k]}; }
  geom::Vec2 d(std::size_t k) const { return {dx[k], dy[k]}; }
};

}  // namespace playhouse::rays
