#pragma once

/// Precomputed scans and ray bundles of each kind of ranger, independent of its pose; made once
/// and shared by all rangers with equal sensors. Frames: M the ranger's model, S one sensor.
///
/// In: descriptions of rangers; the largest radii of bodies, by size.
/// Out: their scans and bundles.
/// Cost: once for equal sensors; a table tests each ray of a bundle against 96 x 96 cells.

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "playhouse/bodies/bodies.h"

namespace playhouse::rays {

/// A sensor of many evenly spaced beams.
struct Scan {
  geom::Pose X_MS;
  double z = 0;                  // m above M
  double range_max = 0;          // m
  std::uint32_t first_beam = 0;  // of the ranger
  double fov = 0, step = 0;      // rad
  std::vector<double> x, y;      // unit vectors of the beams in S
  std::size_t count = 0;         // of beams; x and y are padded by kPad that hit nothing
  static constexpr std::size_t kPad = 8;
};

/// Points as structure of arrays, for loops that compilers vectorise.
struct Points {
  std::vector<double> x, y;
  std::size_t size() const { return x.size(); }
  void push_back(geom::Vec2 p) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  geom::Vec2 operator[](std::size_t i) const { return {x[i], y[i]}; }
};

/// Up to kRays single rays of one ranger. Grids about M, one for each size of bodies, give the rays that may
/// hit a body, by its center.
struct Bundle {
  static constexpr std::size_t kRays = 16;
  static constexpr std::size_t kCells = 96;         // cells along a side of the square within reach
  static constexpr std::size_t kSide = kCells + 2;  // with a border of empty cells
  static constexpr std::uint32_t kRow = 128;        // row stride of the grid, in cells

  Points p, d;                      // origins [m] and unit vectors in M
  std::vector<double> z;            // m above M
  std::vector<double> range_max;    // m
  std::vector<std::uint32_t> beam;  // of the ranger
  double z_min = 0, z_max = 0;      // m above M
  double reach = 0;                 // m: longest distance from M of any ray, plus kMargin
  struct Table {
    double body_radius = 0;     // m, at most
    double cell = 0, half = 0;  // m: the square is +-half about M
    // Bit k of a cell: ray k may hit a body with its center there (kSide * kRow, padded by 1).
    std::vector<std::uint16_t> meets;
  };
  std::vector<Table> tables;  // (sizes of DiscIndex)
  std::size_t rays() const { return d.size(); }
};

/// A ray with angular noise: a new direction for each measurement.
struct Jitter {
  geom::Pose X_MS;
  double z = 0, range_max = 0;
  double bearing = 0;                    // rad, without noise
  std::uint32_t beam = 0;                // of the ranger
  std::uint32_t sensor = 0, sample = 0;  // sensor of the ranger, beam of the sensor
};

struct RangerKind {
  std::vector<Scan> scans;
  std::vector<Bundle> bundles;
  std::vector<Jitter> jitters;
  std::vector<double> range_min, range_max;  // m (beams)
  bool noisy = false;                        // any sensor has range noise
  std::uint32_t beams = 0;
};

/// The kinds of all rangers of a world, past ones included.
class RangerKinds {
 public:
  std::vector<RangerKind> kinds;
  ByRow<world::RangerTable, std::uint32_t> of_ranger;  // row of kinds

  /// Assigns a kind to every ranger, making new ones as needed. `radii` are those of DiscIndex: tables are
  /// rebuilt where bodies are larger than those they were made for, or much smaller. [m]
  void populate(const world::World& world, std::span<const double> radii);

 private:
  /// Row of kinds, a new one if none matches.
  std::uint32_t find_kind(const scene::ModelDesc& desc);

  std::map<std::vector<double>, std::uint32_t> known_;  // key: all that distinguishes kinds; to its row
  std::vector<double> radii_;                           // m, for which tables were made (sizes)
};

}  // namespace playhouse::rays
