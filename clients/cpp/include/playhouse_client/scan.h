#pragma once

#include <cstddef>
#include <vector>

#include "playhouse_client/pose.h"

namespace playhouse::client {

/// Ranges (m) and their directions (rad, counter-clockwise from the sensor's x axis), element by element, in
/// the order of measurement.
struct Scan {
  std::vector<double> ranges;
  std::vector<double> angles;
  double max_range = 0;  // m
  double time = 0;       // the server's, of the measurement [s]

  /// The shortest range between two directions; max_range if there is no measurement.
  double nearest(double low, double high) const;

  /// End points of the beams, in the sensor's frame.
  std::vector<Point> points() const;
};

/// `count` angles evenly spaced from `low` to `high`.
std::vector<double> spread_angles(double low, double high, std::size_t count);

}  // namespace playhouse::client
