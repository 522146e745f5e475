#pragma once

/// What rangers are, apart from where: the scans and ray bundles of each kind of ranger, made once and shared
/// by all rangers that are alike. Frames: M the ranger's model, S one sensor.

#include <cstdint>
#include <map>
#include <vector>

#include "playhouse/stage/bodies.h"

namespace playhouse::stage {

/// A sensor of many beams, evenly spread.
struct Scan {
  Pose X_MS;
  double z = 0;                  // m above M
  double range_max = 0;          // m
  std::uint32_t first_beam = 0;  // of the ranger
  double fov = 0, step = 0;      // rad
  std::vector<double> x, y;      // unit vectors of the beams in S
  std::size_t beams() const { return x.size(); }
};

/// Up to 64 single rays of one ranger, looked at together.
struct Bundle {
  static constexpr std::size_t kRays = 64;
  static constexpr std::size_t kCells = 48;  // each way, of `meets`

  std::vector<Vec2> p, d;            // origins [m] and unit vectors in M
  std::vector<double> z;             // m above M
  std::vector<double> range_max;     // m
  std::vector<std::uint32_t> beam;   // of the ranger
  double z_min = 0, z_max = 0;       // m above M
  double reach = 0;                  // m from M that any ray gets
  double cell = 0, half = 0;         // m: `meets` covers the square +-half about M
  std::vector<std::uint64_t> meets;  // bit k of a cell: ray k may meet a body whose centre is there
  std::size_t rays() const { return d.size(); }
};

/// A ray that is turned at random each time it is cast.
struct Jitter {
  Pose X_MS;
  double z = 0, range_max = 0;
  double bearing = 0, spread = 0;  // rad: turned by up to +-spread
  std::uint32_t beam = 0, sensor = 0;
};

struct RangerKind {
  std::vector<Scan> scans;
  std::vector<Bundle> bundles;
  std::vector<Jitter> jitters;
  std::uint32_t beams = 0;
};

/// Kinds of all rangers of a world.
struct RangerKinds {
  std::vector<RangerKind> kinds;
  std::vector<std::uint32_t> of_ranger;  // row of kinds (rangers)
};

/// `body_radius` is the largest radius of a body that moves. [m]
RangerKinds make_ranger_kinds(const world::World& world, double body_radius);

}  // namespace playhouse::stage
