#pragma once

/// RangeScan: what a laser, a ranger or sonars measured at one moment, in one form for all algorithms.

#include <cstddef>
#include <limits>
#include <vector>

#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

/// One sensor on its robot.
struct ScanEye {
  geom::Pose X_RS;        // x points along its beam, or along the middle of its beams
  double half_width = 0;  // rad; of the cone of a lone beam
};

/// A laser, or a ranger that scans, is one eye with many beams. A ring is many eyes with a beam each.
struct RangeScan {
  std::vector<ScanEye> eyes;
  std::vector<float> ranges;               // m; eye by eye, the same number for each, counter-clockwise
  double first_angle = 0, angle_step = 0;  // of an eye's beams, in S [rad]
  double max_range = std::numeric_limits<double>::infinity();  // m; a beam of this length is a miss

  /// Of each eye.
  std::size_t beams() const { return eyes.empty() ? 0 : ranges.size() / eyes.size(); }
  bool is_ring() const { return beams() == 1; }
  /// In S of its eye [rad].
  double angle(std::size_t beam) const { return first_angle + static_cast<double>(beam) * angle_step; }
};

/// False if it has no beams, or its angles are invalid.
bool is_usable(const RangeScan& scan);

/// Where a beam ends that is as long as its range, in R; `i`: its place among all ranges.
geom::Vec2 end_of_beam(const RangeScan& scan, std::size_t i);

/// The sensors of a ring in these places. The width of cones is not told by any interface: each reaches half
/// way to the nearest other direction, and 15 degrees at most.
std::vector<ScanEye> ring_of(const std::vector<geom::Pose>& X_RS);

}  // namespace playhouse::drivers
