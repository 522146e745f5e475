#pragma once

/// Test fixtures: bodies in ticks, without a world.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "playhouse/arena/physics/physics.h"
#include "playhouse/geom/trig.h"

namespace playhouse::arena {

inline constexpr double kG = 9.81;  // m/s^2

/// Bodies in ticks of one length, divided into steps as ArenaEngine does.
class Trial {
 public:
  explicit Trial(double tick, const ContactSurface& ground = {}, double gravity = kG)
      : physics(ground, gravity),
        tick_(tick),
        trace_(__FILE__, __LINE__, testing::Message() << "tick " << tick) {}

  RigidBodyRow add(const RigidBodyDesc& desc, const BodyState& state) {
    const RigidBodyRow body = physics.add(desc);
    physics.put(body, state, false);
    return body;
  }
  template <typename Look>
  void run(double seconds, const Look& look) {
    constexpr double kStep = 0.01;  // s, the longest
    const int steps = static_cast<int>(std::ceil(tick_ / kStep - 1e-9));
    for (int i = 0; i < std::lround(seconds / tick_); ++i) {
      physics.clear_contacts();
      for (int step = 0; step < steps; ++step) physics.step(tick_ / steps, workers_);
      look();
    }
  }
  void run(double seconds) {
    run(seconds, [] {});
  }

  Physics physics;

 private:
  double tick_;
  world::Workers workers_{1};
  testing::ScopedTrace trace_;
};

/// Height between the highest point of a fall's arc and the nearest tick, at most.
inline double missed(double tick) {
  return kG * tick * tick / 8;
}

/// A square of two triangles, tilted about y.
inline std::vector<FixedSolid> square(double half, double height, double slope) {
  FixedSolid solid;
  const geom::SinCos tilt = geom::sincos(slope);
  for (const auto& [x, y] : {std::pair(-half, -half), {half, -half}, {half, half}, {-half, half}})
    solid.triangles.p.push_back({x * tilt.cos, y, height + x * tilt.sin});
  solid.triangles.corner = {{0, 1, 2}, {0, 2, 3}};
  return {solid};
}

}  // namespace playhouse::arena
