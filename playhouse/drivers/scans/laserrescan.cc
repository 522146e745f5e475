#include "playhouse/drivers/scans/laserrescan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "playhouse/drivers/scans/laser_filter.h"

namespace playhouse::drivers {

std::optional<wire::laser::Data> LaserRescan::scan(const wire::laser::Data& source) const {
  constexpr double kOnBeam = 1e-3;  // of a step, as angles of lasers are float32
  const double from = source.min_angle, source_step = source.resolution;
  if (!std::isfinite(from) || !std::isfinite(source_step) || source_step <= 0) return std::nullopt;
  wire::laser::Data made;
  made.min_angle = static_cast<float>(min_angle);
  made.max_angle = static_cast<float>(max_angle);
  made.resolution = static_cast<float>(step());
  made.max_range = source.max_range;
  made.id = source.id;
  const bool has_intensity = !source.intensity.empty() && source.intensity.size() == source.ranges.size();
  for (int i = 0; i < beams; ++i) {
    const double place = (min_angle + i * step() - from) / source_step;  // among the beams of the source
    const double last = static_cast<double>(source.ranges.size()) - 1;
    if (!(place >= -kOnBeam && place <= last + kOnBeam)) {
      made.ranges.push_back(source.max_range);
      if (has_intensity) made.intensity.push_back(0);
      continue;
    }
    const double right = std::floor(std::clamp(place + kOnBeam, 0.0, last));
    const auto beam = static_cast<std::size_t>(right);
    const auto part = static_cast<float>(std::max(place - right, 0.0));
    const bool is_on_beam = place - right <= kOnBeam;
    made.ranges.push_back(is_on_beam
                              ? source.ranges[beam]
                              : source.ranges[beam] + part * (source.ranges[beam + 1] - source.ranges[beam]));
    if (has_intensity)
      made.intensity.push_back(source.intensity[part > 0.5f && !is_on_beam ? beam + 1 : beam]);
  }
  return made;
}

wire::laser::Config LaserRescan::config(const wire::laser::Config& source) const {
  wire::laser::Config made = source;
  made.min_angle = static_cast<float>(min_angle);
  made.max_angle = static_cast<float>(max_angle);
  made.resolution = static_cast<float>(step());
  return made;
}

Result<LaserRescan> laser_rescan_options(SectionFields fields) {
  LaserRescan options;
  options.min_angle = fields.angle({"min_angle", "Direction of the first beam."}, options.min_angle, 0,
                                   SectionFields::kAnyNumber);
  options.max_angle = fields.angle({"max_angle", "Direction of the last beam."}, options.max_angle, 0,
                                   SectionFields::kAnyNumber);
  options.beams = fields.integer({"scan_count", "How many beams, evenly spaced."}, options.beams, 1, 100000);
  fields.expect(options.min_angle <= options.max_angle, "min_angle", "is not above max_angle");
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

constinit const DriverDefinition kLaserRescanDriver{
    .name = "laserrescan",
    .doc = "A laser with the scans of another one at other directions, interpolated.",
    .provides = kLaserFilterProvides,
    .uses = kLaserFilterUses,
    .read_options = reading<laser_rescan_options>,
    .make = make_laser_filter<laser_rescan_options, LaserRescan>,
};

}  // namespace playhouse::drivers
