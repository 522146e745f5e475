#pragma once

/// SeenObstacles: what scans show that is not on the map, as further obstacles of a CostMap, which are forgotten
/// after a time.
///
/// In: scans, and the robot's pose at the time of each in the map's frame G; the time [s].
///
/// Out: the map's costs with the cells of these obstacles, and those too near to them. A beam that ends farther than
///   `tolerance` from every obstacle of the map and nearer than `range` and its own limit shows one. A cell is free
///   again as soon as all beams that cross it go on beyond it, or if no beam has ended in it for the time that it
///   lasts: `lasts`, and twice as long as before, up to kMostPatience times, if it was forgotten and found again. So
///   what stays for ever lets nobody go to and fro between two ways for ever, and what passes soon counts no more.
///
/// Cost: a scan is linear in its beams and in its sensors times the cells that are remembered, kMostRemembered at
///   most; each cell that comes or goes is linear in the cells within the safety distance. A map takes one distance
///   transform and 4 bytes per cell.
///
/// Source: none; the cells that a beam crosses are not visited, but those that are remembered asked for its beams.

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "playhouse/drivers/algorithm/scan.h"
#include "playhouse/drivers/wavefront/cost_map.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

struct SeenOptions {
  double range = 4;        // m; what is farther away is left to later scans
  double tolerance = 0.2;  // m; what is nearer to an obstacle of the map is that
  double lasts = 30;       // s
};

class SeenObstacles {
 public:
  static constexpr std::size_t kMostRemembered = 8192;  // cells; others are ignored until some are forgotten
  static constexpr double kMostPatience = 32;

  /// `options`: those by which the costs were made.
  SeenObstacles(std::shared_ptr<const CostMap> map, const PlanOptions& options, const SeenOptions& sight);

  /// Forgets what is too old by now; all, if the time went back.
  void pass_time(double time);
  /// At the time told last.
  void take(const RangeScan& scan, const geom::Pose& X_GR);

  /// Of the map with these obstacles.
  const CostMap& costs() const { return costs_; }
  /// True if they block any cell.
  bool any() const { return obstacles_ > 0; }
  bool is_obstacle(CellIndex cell) const { return any() && find(cell) != nullptr; }
  /// True of obstacles and cells too near to them.
  bool blocks(CellIndex cell) const { return near_[cell] > 0; }
  /// How many obstacles have come and gone so far.
  std::uint64_t come() const { return come_; }
  std::uint64_t gone() const { return gone_; }

 private:
  struct SeenCell {
    double time = 0;   // s; the last one
    double lasts = 0;  // s
    bool is_obstacle = true;
  };
  const SeenCell* find(CellIndex cell) const;
  void see_through(const RangeScan& scan, const geom::Pose& X_GR);
  void see(CellIndex cell);
  void block(CellIndex cell);
  void unblock(CellIndex cell);
  template <typename Change>
  void change_around(CellIndex cell, Change change);

  const std::shared_ptr<const CostMap> map_;
  const SeenOptions sight_;
  CostMap costs_;
  std::vector<bool> on_map_;         // of each cell: what is there is an obstacle of the map
  std::vector<std::uint16_t> near_;  // of each cell: obstacles that are too near to it
  std::vector<int> reach_;           // cells; of the rows 0, 1 ... away from an obstacle, how far it blocks
  std::map<CellIndex, SeenCell> seen_;  // those that were forgotten, too, until they need no patience
  std::size_t obstacles_ = 0;
  std::uint64_t come_ = 0, gone_ = 0;
  double time_ = 0;  // s
};

}  // namespace playhouse::drivers
