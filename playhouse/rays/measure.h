#pragma once

/// The rays of rangers, cast into the plane: scans project bodies onto beams (scan.h), bundles find
/// candidates in a table by the body's place (bundle.h), and both traverse the grid of walls (march.h).
///
/// In: the space of the tick, the view of a ranger and one of its scans or bundles.
/// Out: nearest hit of each beam, in the range and solid of the scratch from first_beam on.
/// Cost: a scan grows with bodies in reach, a bundle with candidates of its table; both with cells of wall.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/bodies/space.h"
#include "playhouse/rays/bundle.h"
#include "playhouse/rays/scan.h"

namespace playhouse::rays {

/// The pose of a ranger, and what is invisible to it.
struct RangerView {
  static constexpr bodies::SeenByBits kBy = bit(bodies::SeenBy::kRanger);

  geom::Pose X_WM;
  geom::Rotation rotation;  // of X_WM
  world::ModelRow root;
  bool is_wall;  // of a static tree: its own edges are in the walls

  static bool sees(const bodies::Solids& solids, bodies::SolidRow row, world::ModelRow root, double z) {
    return solids.root[row] != root && (solids.seen_by[row] & kBy) != 0 && at_height(solids, row, z);
  }
  bool sees(const bodies::Solids& solids, bodies::SolidRow row, double z) const {
    return sees(solids, row, root, z);
  }
  bool sees(const bodies::DiscIndex::Disc& disc) const {
    return disc.root != root && (disc.seen_by & kBy) != 0;
  }
};

/// Scratch buffers of one worker.
struct Scratch {
  std::vector<double> range, solid;    // m and number_of() the solid hit: beams of a batch of rangers
  std::vector<double> beam_x, beam_y;  // unit vectors of a scan in W
  std::size_t first_beam = 0;          // of the current ranger
  Rays rays;                           // of the bundles of several rangers, waiting for their hits
  Pairs pairs;                         // not resolved yet
  // Nearby movable solids: centers relative to the ranger in W, then in its own axes; places in the index.
  std::vector<double> x, y, distance, bearing, radius;  // m, m, m, rad, m
  std::vector<bodies::DiscIndex::Run> runs;             // of the index, near the ranger
  std::vector<std::uint32_t> place, order, cell;
  std::vector<std::int32_t> ring, first, last;    // the last two: beams
  std::vector<std::uint16_t> met_by;              // bit k: ray k of a bundle may hit it
  ByRow<bodies::WallEdges, std::uint64_t> stamp;  // last scan that visited an edge
  std::uint64_t scans = 0;

  /// For so many beams of a batch, and the bodies and walls of the space.
  void make_room(std::size_t beams, const bodies::Space& space);
};

/// The beams of a scan.
void run_scan(const bodies::Space& space, const RangerView& view, const Scan& scan, Scratch& scratch);

/// The rays of a bundle. Their hits may wait in the scratch for those of other bundles: finish_rays().
void run_bundle(const bodies::Space& space, const RangerView& view, const Bundle& bundle, Scratch& scratch);

/// Writes the hits of all bundles that wait.
void finish_rays(const bodies::Space& space, Scratch& scratch);

/// True if the rays of a part can traverse the grid of walls together: march().
bool can_march(const bodies::Walls& walls, const Rays::NearRays& part);

/// Traces the rays of a part through the walls one by one, if they cannot march.
void meet_walls_alone(const bodies::Space& space, const Rays::NearRays& part, Rays& rays);

}  // namespace playhouse::rays
