#include "playhouse_client/sonar.h"

#include <utility>

#include "convert.h"
#include "done.h"

namespace playhouse::client {

namespace sonar = wire::sonar;

Result<Sonar> Sonar::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, sonar::kCode, index, access);
  if (!device) return device.error();
  return Sonar(std::move(*device));
}

std::vector<double> Sonar::ranges() const {
  const auto data = device_.latest<sonar::Data>(sonar::kDataRanges);
  return data ? std::vector<double>(data->ranges.begin(), data->ranges.end()) : std::vector<double>();
}

Result<std::vector<Pose3d>> Sonar::poses() {
  const auto geom = device_.request<sonar::Geom>(sonar::kReqGetGeom);
  if (!geom) return geom.error();
  std::vector<Pose3d> poses;
  for (const wire::Pose3d& element : geom->poses) poses.push_back(pose(element));
  return poses;
}

Result<void> Sonar::set_power(bool on) {
  return done(device_.request(sonar::kReqPower, sonar::PowerConfig{static_cast<std::uint8_t>(on)}));
}

}  // namespace playhouse::client
