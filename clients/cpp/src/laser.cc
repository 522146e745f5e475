#include "playhouse_client/laser.h"

#include <utility>

#include "convert.h"
#include "done.h"

namespace playhouse::client {

namespace laser = wire::laser;

Result<Laser> Laser::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, laser::kCode, index, access);
  if (!device) return device.error();
  return Laser(std::move(*device));
}

std::optional<Scan> Laser::scan() const {
  const auto data = device_.latest<laser::Data>(laser::kDataScan);
  if (!data) return std::nullopt;
  Scan scan;
  scan.ranges.assign(data->ranges.begin(), data->ranges.end());
  scan.angles = spread_angles(data->min_angle, data->max_angle, scan.ranges.size());
  scan.max_range = data->max_range;
  scan.time = device_.timestamp();
  return scan;
}

std::vector<std::uint8_t> Laser::intensities() const {
  auto data = device_.latest<laser::Data>(laser::kDataScan);
  return data ? std::move(data->intensity) : std::vector<std::uint8_t>();
}

Result<laser::Config> Laser::config() {
  return device_.request<laser::Config>(laser::kReqGetConfig);
}

Result<void> Laser::set_config(const laser::Config& config) {
  return done(device_.request(laser::kReqSetConfig, config));
}

Result<Geometry> Laser::geometry() {
  const auto geom = device_.request<laser::Geom>(laser::kReqGetGeom);
  if (!geom) return geom.error();
  return Geometry{pose(geom->pose), size(geom->size)};
}

}  // namespace playhouse::client
