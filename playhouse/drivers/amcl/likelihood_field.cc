#include "playhouse/drivers/amcl/likelihood_field.h"

#include <algorithm>
#include <cmath>

#include "playhouse/drivers/grid_map/distances.h"
#include "playhouse/geom/exponential.h"
#include "playhouse/geom/logarithm.h"

namespace playhouse::drivers {
namespace {

constexpr double kLn10 = 2.30258509299404568402;
constexpr double kFarErrors = 6;    // standard deviations from which on only bad hits count
constexpr double kToSurface = 0.5;  // cells from the centre of an occupied cell to where beams end

/// By the squared distance of a cell from an occupied one, as far as the normal distribution counts.
std::vector<float> by_squared_distance(double scale, const SensorModel& sensor) {
  const double far = kFarErrors * sensor.error / scale + kToSurface;  // cells
  const auto count = static_cast<std::size_t>(std::min(far * far, 1e7)) + 1;
  std::vector<float> values;
  for (std::size_t d2 = 0; d2 < count; ++d2) {
    const double cells = std::max(0.0, std::sqrt(static_cast<double>(d2)) - kToSurface);
    const double errors = cells * scale / sensor.error;
    const double p = (1 - sensor.bad) * geom::exp(-errors * errors / 2) + sensor.bad;
    values.push_back(static_cast<float>(kLn10 * geom::log10(p)));
  }
  return values;
}

/// Occupied cells beside others: beams end there, not within rock.
std::vector<std::uint8_t> surface_of(const GridMap& map) {
  const std::size_t width = map.info.width, height = map.info.height;
  const auto is_open = [&](std::size_t cell) { return map.cells[cell] <= 0; };
  std::vector<std::uint8_t> surface(map.cells.size());
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t cell = y * width + x;
      const bool beside = (x > 0 && is_open(cell - 1)) || (x + 1 < width && is_open(cell + 1)) ||
                          (y > 0 && is_open(cell - width)) || (y + 1 < height && is_open(cell + width));
      surface[cell] = !is_open(cell) && beside ? 1 : 0;
    }
  }
  return surface;
}

}  // namespace

LikelihoodField::LikelihoodField(const GridMap& map, const SensorModel& sensor)
    : X_WG_(map.X_WG()),
      X_GW_(geom::inverse(X_WG_)),
      cells_per_metre_(1 / static_cast<double>(map.info.scale)),
      width_(map.width()),
      height_(map.height()),
      outside_(static_cast<float>(kLn10 * geom::log10(sensor.bad))) {
  const std::vector<float> values = by_squared_distance(static_cast<double>(map.info.scale), sensor);
  for (const std::uint32_t d2 : squared_distances(map.width(), map.height(), surface_of(map)))
    cells_.push_back(d2 < values.size() ? values[d2] : outside_);
  // Maps without free cells are of walls alone.
  const bool knows_free = std::ranges::find(map.cells, std::int8_t{-1}) != map.cells.end();
  for (std::uint32_t cell = 0; cell < map.cells.size(); ++cell) {
    is_free_.push_back(map.cells[cell] < (knows_free ? 0 : 1) ? 1 : 0);
    if (is_free_.back() != 0) free_.push_back(cell);
  }
}

std::size_t LikelihoodField::cell_of(geom::Vec2 p_G) const {
  const double x = p_G.x * cells_per_metre_, y = p_G.y * cells_per_metre_;
  if (!(x >= 0 && y >= 0 && x < static_cast<double>(width_) && y < static_cast<double>(height_)))
    return cells_.size();
  return static_cast<std::size_t>(static_cast<std::int64_t>(y) * width_ + static_cast<std::int64_t>(x));
}

double LikelihoodField::log_likelihood(const geom::Pose& X_WR, std::span<const geom::Vec2> hits_R) const {
  if (hits_R.empty()) return 0;
  const geom::Pose X_GR = geom::compose(X_GW_, X_WR);
  const auto rotation = geom::Rotation::of(X_GR.a);
  double sum = 0;
  for (const geom::Vec2 hit : hits_R) {
    const std::size_t cell = cell_of(X_GR.xy() + rotation * hit);
    sum += static_cast<double>(cell < cells_.size() ? cells_[cell] : outside_);
  }
  const auto count = static_cast<double>(hits_R.size());
  return sum * std::min(1.0, kIndependent / count);
}

geom::Vec2 LikelihoodField::free_place(double share) const {
  const std::uint32_t cell = free_[static_cast<std::size_t>(share * static_cast<double>(free_.size()))];
  const geom::Vec2 middle{static_cast<double>(cell % width_) + 0.5, static_cast<double>(cell / width_) + 0.5};
  return geom::transform(X_WG_, (1 / cells_per_metre_) * middle);
}

bool LikelihoodField::is_free(geom::Vec2 p_W) const {
  const std::size_t cell = cell_at(p_W);
  return cell < is_free_.size() && is_free_[cell] != 0;
}

}  // namespace playhouse::drivers
