#include "playhouse/drivers/rangertolaser/ranger_to_laser.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "playhouse/drivers/algorithm/conversion.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/scan_settings.h"
#include "playhouse/geom/pose.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

namespace rng = wire::ranger;
namespace lsr = wire::laser;

namespace {

lsr::Config laser_config_of(const rng::Config& config) {
  return laser_config({config.min_angle, config.max_angle, config.angular_res, config.min_range,
                       config.max_range, config.range_res, config.frequency});
}

/// The scanner is the ranger's first element.
lsr::Geom laser_geom(const rng::Geom& geom) {
  lsr::Geom laser{geom.pose, geom.size};
  if (geom.element_poses.empty()) return laser;
  const wire::Pose3d& element = geom.element_poses.front();
  const geom::Pose X = geom::compose(geom::Pose{geom.pose.px, geom.pose.py, geom.pose.pz, geom.pose.pyaw},
                                     {element.px, element.py, element.pz, element.pyaw});
  laser.pose = {X.x, X.y, X.z, geom.pose.proll, geom.pose.ppitch, X.a};
  return laser;
}

/// `intensities` may be empty.
lsr::Data laser_scan(const rng::Config& config, const rng::DataRange& ranges,
                     const rng::DataIntns& intensities, std::uint32_t id) {
  lsr::Data scan;
  scan.min_angle = static_cast<float>(config.min_angle);
  scan.max_angle = static_cast<float>(config.max_angle);
  scan.resolution = static_cast<float>(config.angular_res);
  scan.max_range = static_cast<float>(config.max_range);
  scan.id = id;
  for (const double range : ranges.ranges) scan.ranges.push_back(static_cast<float>(range));
  for (const double value : intensities.intensities) {
    scan.intensity.push_back(static_cast<std::uint8_t>(value > 0 ? std::min(value, 255.0) : 0));
  }
  return scan;
}

}  // namespace

RangerToLaser::RangerToLaser(Shell& shell)
    : shell_(shell),
      ranges_(shell.client().latest(kRanger, rng::kDataRange)),
      intensities_(shell.client().latest(kRanger, rng::kDataIntns)),
      configured_(shell.client().latest(kRanger, rng::kDataRangestamped)) {
  convert_answers<rng::Geom>(shell, kRanger, lsr::kReqGetGeom, rng::kReqGetGeom, laser_geom);
  convert_answers<rng::Config>(shell, kRanger, lsr::kReqGetConfig, rng::kReqGetConfig, laser_config_of);
  shell.on_request(lsr::kReqSetConfig, [this](const device::Message& message, device::Replier replier) {
    set_configuration(message, std::move(replier));
  });
  // POWER has the same payload in both.
  shell.on_request(lsr::kReqPower, [&shell](const device::Message& message, device::Replier replier) {
    shell.client().forward(kRanger, rng::kReqPower, message.body, std::move(replier));
  });
}

Result<void> RangerToLaser::fits(const SiteWorld& world, device::Address ranger) const {
  const std::size_t sensors = world.sensors_of(ranger);
  if (sensors == 1) return {};
  return Error{{}, fmt::format("has {} sensors, and a laser shows the scan of one", sensors)};
}

/// What a laser does not tell, the minimum range, stays; so does what is 0. Intensities are a setting of the ranger.
void RangerToLaser::set_configuration(const device::Message& message, device::Replier replier) {
  const auto asked = wire::decode<lsr::Config>(message.body);
  if (!asked) return;
  const auto change = [laser = *asked](rng::Config& wanted) {
    wanted.min_angle = static_cast<double>(laser.min_angle);
    wanted.max_angle = static_cast<double>(laser.max_angle);
    if (laser.resolution != 0) wanted.angular_res = laser_resolution(laser.resolution);
    if (laser.max_range != 0) wanted.max_range = static_cast<double>(laser.max_range);
    if (laser.range_res != 0) wanted.range_res = static_cast<double>(laser.range_res);
    if (laser.scanning_frequency != 0) wanted.frequency = static_cast<double>(laser.scanning_frequency);
  };
  change_configuration<rng::Config>(shell_, kRanger, rng::kReqGetConfig, rng::kReqSetConfig,
                                    std::move(replier), change, laser_config_of);
}

void RangerToLaser::opened() {
  shell_.client().ask(kRanger, rng::kReqGetConfig, {}, [this](const AnswerBody& body) {
    const std::optional<rng::Config> config = decoded<rng::Config>(body);
    if (!config) return;
    const std::lock_guard lock(mutex_);
    config_ = *config;
  });
}

void RangerToLaser::closed() {
  const std::lock_guard lock(mutex_);
  config_.reset();
}

void RangerToLaser::take_news(std::vector<device::Publication>& more) {
  const std::optional<device::Publication> ranges = ranges_.take_latest();
  const std::optional<device::Publication> intensities = intensities_.take_latest();
  const std::optional<device::Publication> configured = configured_.take_latest();
  if (!ranges) return;
  const Result<rng::DataRange> range_values = wire::decode<rng::DataRange>(ranges->body);
  if (!range_values) return;
  rng::DataIntns intensity_values;
  if (intensities) {
    if (Result<rng::DataIntns> values = wire::decode<rng::DataIntns>(intensities->body))
      intensity_values = std::move(*values);
  }
  const std::lock_guard lock(mutex_);
  if (!config_) return;
  if (configured) {
    const auto stamped = wire::decode<rng::DataRangestamped>(configured->body);
    if (stamped && stamped->have_config != 0) config_ = stamped->config;
  }
  const lsr::Data scan = laser_scan(*config_, *range_values, intensity_values, ++scans_);
  more.push_back({shell_.device(0), lsr::kDataScan, ranges->timestamp, wire::encode(scan)});
}

namespace {

constexpr DeviceText kRangerToLaserProvides[] = {{"laser"}};
constexpr DeviceText kRangerToLaserUses[] = {{"ranger", {}, HowMany::kOne, "has one sensor"}};

}  // namespace

constinit const DriverDefinition kRangerToLaserDriver{
    .name = "rangertolaser",
    .doc = "Shows the scans of a ranger as a laser, for programs without support for rangers.",
    .provides = kRangerToLaserProvides,
    .uses = kRangerToLaserUses,
    .make = make_ranger_to_laser,
};

Result<std::unique_ptr<device::Driver>> make_ranger_to_laser(const config::CfgSection& section, Site& site) {
  return make_algorithm<RangerToLaser>(section, site, {.provides = {{"laser"}}, .uses = {{"ranger"}}});
}

}  // namespace playhouse::drivers
