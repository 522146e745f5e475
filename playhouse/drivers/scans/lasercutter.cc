#include "playhouse/drivers/scans/lasercutter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "playhouse/drivers/scans/laser_filter.h"

namespace playhouse::drivers {

namespace {

/// Numbers of the first beam of a scan that is in a window, and of the first one behind it.
struct BeamRange {
  std::size_t first = 0, end = 0;
};

/// Of beams from `min_angle` on, `resolution` apart. A beam on the edge is in.
BeamRange beams_within(const LaserCutter& window, double min_angle, double resolution, std::size_t count) {
  constexpr double kOnEdge = 1e-3;  // of a step, as angles of lasers are float32
  const auto most = static_cast<double>(count);
  const double first = std::ceil((window.min_angle - min_angle) / resolution - kOnEdge),
               last = std::floor((window.max_angle - min_angle) / resolution + kOnEdge);
  const auto begin = static_cast<std::size_t>(std::clamp(first, 0.0, most)),
             end = static_cast<std::size_t>(std::clamp(last + 1, 0.0, most));
  return {begin, std::max(begin, end)};
}

bool has_angles(double min_angle, double resolution) {
  return std::isfinite(min_angle) && std::isfinite(resolution) && resolution > 0;
}

}  // namespace

std::optional<wire::laser::Data> LaserCutter::scan(const wire::laser::Data& whole) const {
  const double from = whole.min_angle, step = whole.resolution;
  if (!has_angles(from, step)) return std::nullopt;
  const BeamRange kept = beams_within(*this, from, step, whole.ranges.size());
  const auto cut = [&kept](const auto& values) {
    const auto at = [&values](std::size_t i) {
      return values.begin() + static_cast<std::ptrdiff_t>(std::min(i, values.size()));
    };
    return std::decay_t<decltype(values)>(at(kept.first), at(kept.end));
  };
  const std::size_t last = std::max(kept.end, kept.first + 1) - 1;  // of no beams there is no last one
  wire::laser::Data part = whole;
  part.min_angle = static_cast<float>(from + static_cast<double>(kept.first) * step);
  part.max_angle = static_cast<float>(from + static_cast<double>(last) * step);
  part.ranges = cut(whole.ranges);
  part.intensity = cut(whole.intensity);
  return part;
}

wire::laser::Config LaserCutter::config(const wire::laser::Config& whole) const {
  const double from = whole.min_angle, step = whole.resolution, to = whole.max_angle;
  if (!has_angles(from, step) || !(to >= from) || !(to - from < 1e6 * step)) return whole;
  const auto count = static_cast<std::size_t>(std::lround((to - from) / step)) + 1;
  const BeamRange kept = beams_within(*this, from, step, count);
  const std::size_t last = std::max(kept.end, kept.first + 1) - 1;
  wire::laser::Config part = whole;
  part.min_angle = static_cast<float>(from + static_cast<double>(kept.first) * step);
  part.max_angle = static_cast<float>(from + static_cast<double>(last) * step);
  return part;
}

Result<LaserCutter> laser_cutter_options(SectionFields fields) {
  LaserCutter window;
  window.min_angle = fields.angle({"min_angle", "Beams to the right of this direction are left out."},
                                  window.min_angle, 0, SectionFields::kAnyNumber);
  window.max_angle = fields.angle({"max_angle", "Beams to the left of this direction are left out."},
                                  window.max_angle, 0, SectionFields::kAnyNumber);
  fields.expect(window.min_angle <= window.max_angle, "min_angle", "is not above max_angle");
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return window;
}

constinit const DriverDefinition kLaserCutterDriver{
    .name = "lasercutter",
    .doc = "A laser with those beams of another one that are within a window of directions.",
    .provides = kLaserFilterProvides,
    .uses = kLaserFilterUses,
    .read_options = reading<laser_cutter_options>,
    .make = make_laser_filter<laser_cutter_options, LaserCutter>,
};

}  // namespace playhouse::drivers
