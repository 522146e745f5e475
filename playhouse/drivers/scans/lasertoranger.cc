#include "playhouse/drivers/scans/lasertoranger.h"

#include <utility>

namespace playhouse::drivers {

namespace lsr = wire::laser;
namespace rng = wire::ranger;

namespace {

RangerReading reading_of(const lsr::Data& scan) {
  return {{scan.ranges.begin(), scan.ranges.end()}, {scan.intensity.begin(), scan.intensity.end()}};
}

/// SET_CONFIG of the ranger; a laser has no minimum range, and keeps its switch of intensities.
void set_laser(Shell& shell, const rng::Config& wanted, device::Replier replier) {
  const auto change = [wanted](lsr::Config& laser) {
    laser.min_angle = static_cast<float>(wanted.min_angle);
    laser.max_angle = static_cast<float>(wanted.max_angle);
    laser.resolution = static_cast<float>(wanted.angular_res);
    laser.max_range = static_cast<float>(wanted.max_range);
    laser.range_res = static_cast<float>(wanted.range_res);
    laser.scanning_frequency = static_cast<float>(wanted.frequency);
  };
  change_configuration<lsr::Config>(shell, 0, lsr::kReqGetConfig, lsr::kReqSetConfig, std::move(replier),
                                    change, ranger_config_of);
}

/// INTNS of the ranger.
void switch_intensities(Shell& shell, std::uint8_t state, device::Replier replier) {
  change_configuration<lsr::Config>(
      shell, 0, lsr::kReqGetConfig, lsr::kReqSetConfig, std::move(replier),
      [state](lsr::Config& laser) { laser.intensity = state; },
      [](const lsr::Config& laser) { return rng::IntnsConfig{laser.intensity}; });
}

}  // namespace

rng::Geom ranger_geom_of(const lsr::Geom& laser) {
  return {laser.pose, laser.size, {wire::Pose3d{}}, {laser.size}};
}

rng::Config ranger_config_of(const lsr::Config& laser) {
  return {laser.min_angle, laser.max_angle, laser.resolution,        0,
          laser.max_range, laser.range_res, laser.scanning_frequency};
}

std::optional<RangerReading> LaserSource::reading(const device::Publication& message) {
  if (message.subtype == lsr::kDataScan) {
    const Result<lsr::Data> scan = wire::decode<lsr::Data>(message.body);
    if (scan) return reading_of(*scan);
  } else if (message.subtype == lsr::kDataScanpose) {
    const Result<lsr::DataScanpose> posed = wire::decode<lsr::DataScanpose>(message.body);
    if (posed) return reading_of(posed->scan);
  }
  return std::nullopt;
}

void LaserSource::answer(Shell& shell) {
  convert_answers<lsr::Geom>(shell, 0, rng::kReqGetGeom, lsr::kReqGetGeom, ranger_geom_of);
  convert_answers<lsr::Config>(shell, 0, rng::kReqGetConfig, lsr::kReqGetConfig, ranger_config_of);
  pass_request(shell, rng::kReqPower, lsr::kReqPower);
  shell.on_request(rng::kReqSetConfig, [&shell](const device::Message& message, device::Replier replier) {
    if (const Result<rng::Config> wanted = wire::decode<rng::Config>(message.body))
      set_laser(shell, *wanted, std::move(replier));
  });
  shell.on_request(rng::kReqIntns, [&shell](const device::Message& message, device::Replier replier) {
    if (const Result<rng::IntnsConfig> wanted = wire::decode<rng::IntnsConfig>(message.body))
      switch_intensities(shell, wanted->state, std::move(replier));
  });
}

namespace {

constexpr DeviceText kLaserToRangerUses[] = {{"laser", {}, HowMany::kOne, "has the scans"}};

}  // namespace

constinit const DriverDefinition kLaserToRangerDriver{
    .name = "lasertoranger",
    .doc = "Shows the scans of a laser as a ranger.",
    .provides = kToRangerProvides,
    .uses = kLaserToRangerUses,
    .make = make_to_ranger<LaserSource>,
};

}  // namespace playhouse::drivers
