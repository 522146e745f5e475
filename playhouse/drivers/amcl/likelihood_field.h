#pragma once

/// LikelihoodField: how well what a scanner hits fits a map.
///
/// In: the grid, and the sensor's error: a hit is normally distributed about the nearest obstacle, or,
///   with probability `bad`, anywhere (people, other robots).
///
/// Out: per cell the natural logarithm of the likelihood of a hit there.
///
/// Cost: 5 bytes per cell and some 15 ns, once; a lookup per hit and pose.
///
/// Source: S. Thrun, W. Burgard, D. Fox: "Probabilistic Robotics", 2005, section 6.4. Likelihoods of
/// a scan are raised to a power, as their section 6.3.4 advises: beams of one scan are not
/// independent of each other, and count as kIndependent of them.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/drivers/grid_map/grid_map.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

struct SensorModel {
  double error = 0.1;  // standard deviation of a hit from the obstacle [m]
  double bad = 0.1;    // probability of a hit of something that is not on the map
};

class LikelihoodField {
 public:
  static constexpr double kIndependent = 8;  // beams

  LikelihoodField(const GridMap& map, const SensorModel& sensor);

  /// Of a scan from this pose: `hits_R` in the robot's frame. [ln]
  double log_likelihood(const geom::Pose& X_WR, std::span<const geom::Vec2> hits_R) const;

  bool has_free_cells() const { return !free_.empty(); }
  /// The centre of a free cell, in W; share: which of them, 0 to less than 1.
  geom::Vec2 free_place(double share) const;
  bool is_free(geom::Vec2 p_W) const;

 private:
  /// Index of the cell with a point; none outside: cells_.size().
  std::size_t cell_of(geom::Vec2 p_G) const;
  std::size_t cell_at(geom::Vec2 p_W) const { return cell_of(geom::transform(X_GW_, p_W)); }

  const geom::Pose X_WG_, X_GW_;
  const double cells_per_metre_;
  const std::int64_t width_, height_;
  std::vector<float> cells_;  // ln
  float outside_ = 0;         // ln
  std::vector<std::uint32_t> free_;
  std::vector<std::uint8_t> is_free_;
};

}  // namespace playhouse::drivers
