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
  std::size_t count = 0;         // of beams; x and y have kSpare that meet nothing behind them
  static constexpr std::size_t kSpare = 8;
};

/// Numbers of equal rows, for loops that the compiler turns into vector instructions.
struct Points {
  std::vector<double> x, y;
  std::size_t size() const { return x.size(); }
  void push_back(Vec2 p) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  Vec2 operator[](std::size_t i) const { return {x[i], y[i]}; }
};

/// Up to kRays single rays of one ranger, looked at together.
struct Bundle {
  static constexpr std::size_t kRays = 16;
  static constexpr std::size_t kCells = 96;         // each way, of the square that matters
  static constexpr std::size_t kSide = kCells + 2;  // with a rim of empty cells about it
  static constexpr std::uint32_t kRow = 128;        // cells from one row to the next

  Points p, d;                      // origins [m] and unit vectors in M
  std::vector<double> z;            // m above M
  std::vector<double> range_max;    // m
  std::vector<std::uint32_t> beam;  // of the ranger
  double z_min = 0, z_max = 0;      // m above M
  double reach = 0;                 // m from M that any ray gets, and kMargin
  double cell = 0, half = 0;        // m: the square is +-half about M
  std::vector<std::uint16_t>
      meets;  // bit k of a cell: ray k may meet a body whose centre is there (kSide * kRow and one to read)
  std::size_t rays() const { return d.size(); }
};

/// A ray that is turned at random each time it is cast.
struct Jitter {
  Pose X_MS;
  double z = 0, range_max = 0;
  double bearing = 0;                    // rad, before it is turned
  std::uint32_t beam = 0;                // of the ranger
  std::uint32_t sensor = 0, sample = 0;  // which sensor of the ranger, and which of its beams
};

struct RangerKind {
  std::vector<Scan> scans;
  std::vector<Bundle> bundles;
  std::vector<Jitter> jitters;
  std::vector<double> range_min, range_max;  // m (beams)
  bool noisy = false;                        // any sensor has noise along its beams
  std::uint32_t beams = 0;
};

/// Kinds of all rangers of a world, and of those that it had.
class RangerKinds {
 public:
  std::vector<RangerKind> kinds;
  std::vector<std::uint32_t> of_ranger;  // row of kinds (rangers)

  /// Finds the kind of every ranger; makes those that are new. `body_radius` is the largest radius of a body
  /// that moves: tables are made again if it is larger than what they are good for.  [m]
  void populate(const world::World& world, double body_radius);

 private:
  /// Row of kinds, of a new one if there is none like it.
  std::uint32_t find_kind(const scene::ModelDesc& desc);

  std::map<std::vector<double>, std::uint32_t> known_;  // by what makes rangers alike: row of kinds
  double body_radius_ = 0;                              // m, for which the tables are good
};

}  // namespace playhouse::stage
