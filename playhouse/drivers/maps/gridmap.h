#pragma once

/// The .cfg driver "gridmap": a map of what the ranges of a robot have hit and passed, by its odometry.
///
/// In: poses, and scans of sonars, a laser or a ranger, each beam a line.
///
/// Out: a balance for each cell: a beam that ends there adds 3, one that passes takes 1. A cell is occupied above 0, free
/// below, and unknown at 0.
///
/// Cost: 5 ns for each cell that a beam passes.

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/algorithm/recent_poses.h"
#include "playhouse/drivers/algorithm/scan_reader.h"
#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/grid_map/grid_map.h"
#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {

struct GridMapOptions {
  int width = 1000, height = 1000;  // cells
  int start_x = 0, start_y = 0;     // cells; from the middle of the map to where the odometry has its origin
  double scale = 0.05;              // m, of a cell
  double farthest = 1;              // m; longer ranges are left out
};

Result<GridMapOptions> grid_map_options(SectionFields fields);

/// The balance of each cell. W is the frame of the map, whose origin is in its middle.
class BeamMap {
 public:
  explicit BeamMap(const GridMapOptions& options);

  /// A beam from one point to another, where it ends at an obstacle.
  void add(geom::Vec2 from, geom::Vec2 to);
  void clear();
  GridMap map() const;

 private:
  std::int8_t* cell(std::int64_t column, std::int64_t row);

  wire::map::Info info_;
  std::vector<std::int8_t> balance_;
};

/// Uses the odometry and the device of scans.
class GridMapper final : public Algorithm {
 public:
  GridMapper(Shell& shell, const GridMapOptions& options, ScanInterface scans);

  void opened() override;
  void closed() override;
  void take_news(std::vector<device::Publication>& more) override;
  void rewound(const Moment& moment) override;

 private:
  static constexpr std::size_t kOdometry = 0, kScans = 1;  // used devices

  void add(const RangeScan& scan, const geom::Pose& X_WR);

  const GridMapOptions options_;
  device::Subscription& states_;
  ScanReader scans_;

  std::mutex mutex_;  // guards what follows
  RecentPoses poses_;
  BeamMap beams_;
};

extern const DriverDefinition kGridMapDriver;

}  // namespace playhouse::drivers
