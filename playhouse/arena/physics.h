#pragma once

/// Physics: rigid bodies with contacts, by Bullet in double precision, and wheels, by a solver of our own
/// (wheels.h). A step depends on nothing but the states of the bodies: what Bullet remembers of contacts is
/// dropped by forget(), so that a run that goes on from saved states goes on to the bit. Frames: W world,
/// B body. One thread at a time; step() has workers of its own.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "playhouse/arena/rigid_body.h"
#include "playhouse/arena/triangles.h"
#include "playhouse/world/workers.h"

namespace playhouse::arena {

/// What stands still: a convex solid, or a surface of triangles where the hull has no corners.
struct FixedSolid {
  Hull hull;  // in W
  Surface surface;
  double heading = 0;     // rad, of the x along which the surface has its share
  Triangles triangles{};  // in W
};

/// Where a body is within another one.
struct Press {
  std::uint32_t body = 0;
  std::size_t hull = 0;  // of the body
  Vec3 p;                // in W
  Vec3 out;              // unit vector out of the body, in W
  double depth = 0;      // m
};

class Physics {
 public:
  /// `gravity` in m/s^2, downwards.
  explicit Physics(const Surface& ground = {}, double gravity = 9.81);
  ~Physics();
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  /// Replaces what stands still by the ground, the plane z = 0, and these.
  void set_fixed(std::span<const FixedSolid> solids);
  /// A body that moves, at rest at the origin; bodies are numbered from 0.
  std::uint32_t add(const BodyDesc& desc);
  /// Removes all bodies that move.
  void clear();
  std::size_t size() const;

  /// Its solids are elsewhere in B: it has joints.
  void set_hulls(std::uint32_t body, std::span<const Hull> hulls);
  BodyState state(std::uint32_t body) const;
  /// A body that rests does not move until another one touches it.
  void put(std::uint32_t body, const BodyState& state, bool rests);
  bool rests(std::uint32_t body) const;
  /// False where what moves by itself has woken it since put(), for what it rests on may be about to go, and
  /// of a vehicle whose wheels are pressed into the ground, for whatever did so may have gone.
  bool may_rest(std::uint32_t body) const;
  /// What the wheels of a vehicle are to do: velocity of B, in B.  [m/s, rad/s]
  void drive(std::uint32_t body, const geom::Twist& velocity);

  /// Drops what earlier steps left behind for the next: contacts with their impulses.
  void forget();
  /// `dt` seconds of motion. The result does not depend on the number of workers.
  void step(double dt, world::Workers& workers);
  /// After a step: where bodies are deeper than `depth` within others. Of two that nothing pushes neither is
  /// told.
  std::vector<Press> presses(double depth) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::arena
