#pragma once

/// RangerSense: the phase that fills the scans of rangers that are subscribed and due. Every beam
/// gets the exact distance to the nearest outline at its height. Three methods: scans project bodies
/// onto beams, bundles find candidates in a table by the body's place, both traverse the wall grid.

#include <span>
#include <vector>

#include "playhouse/stage/bundle.h"
#include "playhouse/stage/generated/senses.h"

namespace playhouse::stage {

class RangerSense final : public SensePhase {
 public:
  explicit RangerSense(unsigned workers);

  SensorTable table(world::World& world) const override;
  void populate(const world::World& world, const Space& space) override;
  std::uint64_t sense(world::World& world, const Space& space, std::span<const std::uint32_t> due,
                      std::uint64_t tick, world::Workers& workers) override;

 private:
  /// Scratch buffers of one worker.
  struct Scratch {
    std::vector<double> range, solid;    // m and number_of() the solid hit: beams of a batch of rangers
    std::vector<double> beam_x, beam_y;  // unit vectors of a scan in W
    std::size_t first_beam = 0;          // of the current ranger
    Rays rays;                           // of the bundles of several rangers, waiting for their hits
    Pairs pairs;                         // not resolved yet
    // Nearby movable solids: centers relative to the ranger in W, then in its own axes; places in the index.
    std::vector<double> x, y, distance, bearing, radius;  // m, m, m, rad, m
    std::vector<DiscIndex::Run> runs;                     // of the index, near the ranger
    std::vector<std::uint32_t> place, order, cell;
    std::vector<std::int32_t> ring, first, last;  // the last two: beams
    std::vector<std::uint16_t> met_by;            // bit k: ray k of a bundle may hit it
    std::vector<std::uint64_t> stamp;             // last scan that visited a wall edge (edges)
    std::uint64_t scans = 0;

    void make_room(std::size_t beams, const Space& space);
    std::size_t sort_by_distance(std::size_t count, double reach);
  };
  struct View;

  std::size_t beams(std::uint32_t ranger) const { return kinds_.kinds[kinds_.of_ranger[ranger]].beams; }
  void measure_batch(world::World& world, const Space& space, std::span<const std::uint32_t> rangers,
                     std::uint64_t tick, Scratch& scratch) const;
  void measure(world::World& world, const Space& space, std::uint32_t ranger, std::uint64_t tick,
               Scratch& scratch) const;
  void finish(world::World& world, std::uint32_t ranger, std::uint64_t tick, Scratch& scratch) const;

  static void run_scan(const Space& space, const View& view, const Scan& scan, Scratch& scratch);
  static void scan_bodies(const Space& space, const Pose& X_WS, Rotation rotation, double z, const View& view,
                          const Scan& scan, Scratch& scratch);
  static void scan_walls(const Space& space, const Pose& X_WS, Rotation rotation, double z, const View& view,
                         const Scan& scan, Scratch& scratch);
  static void run_bundle(const Space& space, const View& view, const Bundle& bundle, Scratch& scratch);
  static void meet_few_walls(const Space& space, const Rays::Part& part, Rays& rays);
  static void meet_walls_alone(const Space& space, const Rays::Part& part, Rays& rays);
  static bool can_march(const Walls& walls, const Rays::Part& part);
  static void finish_rays(const Space& space, Scratch& scratch);
  static void run_jitter(const Space& space, const View& view, const Jitter& jitter, double bearing,
                         Scratch& scratch);

  RangerKinds kinds_;
  std::vector<float> returns_;         // return value of a beam that hit a solid (solids); of a miss first
  std::vector<std::uint8_t> is_wall_;  // 1: of a static tree (models)
  std::size_t scratch_beams_ = 0;      // capacity of a Scratch in beams
  std::vector<Scratch> scratch_;       // one per worker
};

/// The pose of a ranger, and what is invisible to it.
struct RangerSense::View {
  static constexpr Observers kBy = bit(Observer::kRanger);

  Pose X_WM;
  Rotation rotation;  // of X_WM
  std::uint32_t root;
  bool is_wall;  // of a static tree: its own edges are in the walls

  static bool sees(const Solids& solids, std::size_t row, std::uint32_t root, double z) {
    return solids.root[row] != root && (solids.seen_by[row] & kBy) != 0 && at_height(solids, row, z);
  }
  bool sees(const Solids& solids, std::size_t row, double z) const { return sees(solids, row, root, z); }
  bool sees(const DiscIndex::Disc& disc) const { return disc.root != root && (disc.seen_by & kBy) != 0; }
};

}  // namespace playhouse::stage
