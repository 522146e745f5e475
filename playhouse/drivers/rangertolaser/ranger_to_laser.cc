#include "playhouse/drivers/rangertolaser/ranger_to_laser.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/drivers/section_devices.h"
#include "playhouse/geom/pose.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {

namespace rng = wire::ranger;
namespace lsr = wire::laser;

namespace {

constexpr std::size_t kRanger = 0;  // index among the client's devices
constexpr std::uint8_t kReq = static_cast<std::uint8_t>(wire::MessageType::kReq);

lsr::Config laser_config(const rng::Config& config) {
  lsr::Config laser;
  laser.min_angle = static_cast<float>(config.min_angle);
  laser.max_angle = static_cast<float>(config.max_angle);
  laser.resolution = static_cast<float>(config.angular_res);
  laser.max_range = static_cast<float>(config.max_range);
  laser.range_res = static_cast<float>(config.range_res);
  laser.intensity = 1;
  laser.scanning_frequency = static_cast<float>(config.frequency);
  return laser;
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

/// Converts the reply of a ranger's request to that of the laser's.
template <typename From, typename Convert>
void convert_answer(device::Replier& replier, const std::optional<std::vector<std::byte>>& body,
                    Convert convert) {
  if (!body) return replier.nack();
  const Result<From> value = wire::decode<From>(*body);
  if (!value) return replier.nack();
  replier.ack(wire::encode(convert(*value)));
}

/// A laser exposes one sensor. Rangers outside the simulated world are not checked.
Result<void> check_sensors(const Site& site, const std::string& where, device::Address ranger) {
  const world::World& world = site.simulation()->world();
  const world::ModelRow model = world.row(site.model_devices()->directory().model_of(ranger));
  const std::size_t sensors = model ? world.desc(model).sensors.size() : 1;
  if (sensors == 1) return {};
  return Error{where, fmt::format("{} has {} sensors, and a laser shows the scan of one",
                                  in_quotes(site.shown(ranger)), sensors)};
}

}  // namespace

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

RangerToLaser::RangerToLaser(device::Opener& opener)
    : client_(opener, *this, 1),
      ranges_(client_.latest(kRanger, rng::kDataRange)),
      intensities_(client_.latest(kRanger, rng::kDataIntns)) {
  client_.when_news([this](std::vector<device::Publication>& more) { convert(more); });
}

Result<void> RangerToLaser::start(device::DeviceId) {
  if (const Result<void> opened = client_.open(); !opened) return opened;
  client_.ask(kRanger, rng::kReqGetConfig, {}, [this](const std::optional<std::vector<std::byte>>& body) {
    const Result<rng::Config> config = wire::decode<rng::Config>(body.value_or(std::vector<std::byte>()));
    if (!config) return;
    const std::lock_guard lock(mutex_);
    config_ = *config;
  });
  return {};
}

void RangerToLaser::stop(device::DeviceId) {
  client_.close();
  const std::lock_guard lock(mutex_);
  config_.reset();
}

void RangerToLaser::request(const device::Message& message, device::Replier replier) {
  if (!capable(message.device, message.type, message.subtype)) return;
  auto shared = std::make_shared<device::Replier>(std::move(replier));  // std::function must be copyable
  switch (message.subtype) {
    case lsr::kReqGetGeom:
      client_.ask(kRanger, rng::kReqGetGeom, {}, [shared](const std::optional<std::vector<std::byte>>& body) {
        convert_answer<rng::Geom>(*shared, body, laser_geom);
      });
      return;
    case lsr::kReqGetConfig:
      client_.ask(kRanger, rng::kReqGetConfig, {},
                  [shared](const std::optional<std::vector<std::byte>>& body) {
                    convert_answer<rng::Config>(*shared, body, laser_config);
                  });
      return;
    default:  // POWER, with the same payload in both
      client_.forward(kRanger, rng::kReqPower, message.body, std::move(*shared));
  }
}

bool RangerToLaser::capable(device::DeviceId, std::uint8_t type, std::uint8_t subtype) const {
  return type == kReq &&
         (subtype == lsr::kReqGetGeom || subtype == lsr::kReqGetConfig || subtype == lsr::kReqPower);
}

void RangerToLaser::convert(std::vector<device::Publication>& more) {
  const std::optional<device::Publication> ranges = ranges_.take_latest();
  const std::optional<device::Publication> intensities = intensities_.take_latest();
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
  const lsr::Data scan = laser_scan(*config_, *range_values, intensity_values, ++scans_);
  more.push_back({laser_, lsr::kDataScan, ranges->timestamp, wire::encode(scan)});
}

Result<std::unique_ptr<device::Driver>> make_ranger_to_laser(const scene::CfgSection& section, Site& site) {
  const auto provided = section_devices(section, site, "provides", {"laser"});
  if (!provided) return provided.error();
  const auto required = section_devices(section, site, "requires", {"ranger"});
  if (!required) return required.error();

  auto driver = std::make_unique<RangerToLaser>(site.surroundings());
  const device::Address laser = provided->front(), ranger = required->front();
  const Result<device::DeviceId> id = site.add_device(laser, *driver);
  if (!id) return Error{section.at("provides"), id.error().text};
  driver->set_laser(*id);
  const auto connected = [&site, where = section.at("requires"), laser, ranger]() -> Result<void> {
    if (site.simulation() == nullptr) return {};
    if (const Result<void> checked = check_sensors(site, where, ranger); !checked) return checked;
    Directory& directory = site.model_devices()->directory();
    directory.add(directory.model_of(ranger), laser);
    return {};
  };
  site.add_user({driver.get(), &driver->client(), *provided, *required, section.at("requires"), connected});
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
