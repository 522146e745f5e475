#include "playhouse_client/ranger.h"

#include <utility>

#include "convert.h"
#include "done.h"

namespace playhouse::client {

namespace ranger = wire::ranger;

Result<Ranger> Ranger::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, ranger::kCode, index, access);
  if (!device) return device.error();
  return prepare(std::move(*device));
}

Result<Ranger> Ranger::prepare(Device device) {
  Ranger made(std::move(device));
  if (auto config = made.device_.request<ranger::Config>(ranger::kReqGetConfig)) made.config_ = *config;
  if (auto geom = made.device_.request<ranger::Geom>(ranger::kReqGetGeom)) made.geom_ = std::move(*geom);
  if (!made.device_.connected()) return Error{"", made.device_.name() + ": the server is gone"};
  return made;
}

std::vector<double> Ranger::ranges() const {
  auto data = device_.latest<ranger::DataRange>(ranger::kDataRange);
  return data ? std::move(data->ranges) : std::vector<double>();
}

std::vector<double> Ranger::intensities() const {
  auto data = device_.latest<ranger::DataIntns>(ranger::kDataIntns);
  return data ? std::move(data->intensities) : std::vector<double>();
}

std::optional<Scan> Ranger::scan() const {
  auto data = device_.latest<ranger::DataRange>(ranger::kDataRange);
  if (!data) return std::nullopt;
  Scan scan;
  scan.ranges = std::move(data->ranges);
  scan.max_range = config_.max_range;
  scan.time = device_.timestamp();
  const auto& elements = geom_.element_poses;
  if (elements.size() > 1 && elements.size() == scan.ranges.size()) {
    for (const wire::Pose3d& element : elements) scan.angles.push_back(element.pyaw);
  } else {
    scan.angles = spread_angles(config_.min_angle, config_.max_angle, scan.ranges.size());
  }
  return scan;
}

Geometry Ranger::geometry() const {
  return {pose(geom_.pose), size(geom_.size)};
}

Result<void> Ranger::set_config(const ranger::Config& config) {
  if (const auto set = device_.request(ranger::kReqSetConfig, config); !set) return set.error();
  const auto made = device_.request<ranger::Config>(ranger::kReqGetConfig);
  if (!made) return made.error();
  config_ = *made;
  return {};
}

Result<void> Ranger::set_power(bool on) {
  return done(device_.request(ranger::kReqPower, ranger::PowerConfig{static_cast<std::uint8_t>(on)}));
}

Result<void> Ranger::set_intensities(bool on) {
  return done(device_.request(ranger::kReqIntns, ranger::IntnsConfig{static_cast<std::uint8_t>(on)}));
}

}  // namespace playhouse::client
