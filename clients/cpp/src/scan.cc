#include "playhouse_client/scan.h"

#include <algorithm>
#include <cmath>

namespace playhouse::client {

double Scan::nearest(double low, double high) const {
  double found = max_range;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (low <= angles[i] && angles[i] <= high) found = std::min(found, ranges[i]);
  }
  return found;
}

std::vector<Point> Scan::points() const {
  std::vector<Point> ends;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    ends.push_back({ranges[i] * std::cos(angles[i]), ranges[i] * std::sin(angles[i])});
  }
  return ends;
}

std::vector<double> spread_angles(double low, double high, std::size_t count) {
  const double step = count > 1 ? (high - low) / static_cast<double>(count - 1) : 0.0;
  std::vector<double> angles;
  for (std::size_t i = 0; i < count; ++i) angles.push_back(low + static_cast<double>(i) * step);
  return angles;
}

}  // namespace playhouse::client
