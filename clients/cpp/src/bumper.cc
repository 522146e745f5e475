#include "playhouse_client/bumper.h"

#include <utility>

#include "convert.h"

namespace playhouse::client {

namespace bumper = wire::bumper;

Result<Bumper> Bumper::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, bumper::kCode, index, access);
  if (!device) return device.error();
  return Bumper(std::move(*device));
}

std::vector<bool> Bumper::pressed() const {
  std::vector<bool> pressed;
  const auto data = device_.latest<bumper::Data>(bumper::kDataState);
  if (!data) return pressed;
  for (const std::uint8_t state : data->bumpers) pressed.push_back(state != 0);
  return pressed;
}

Result<std::vector<Face>> Bumper::faces() {
  const auto geom = device_.request<bumper::Geom>(bumper::kReqGetGeom);
  if (!geom) return geom.error();
  std::vector<Face> faces;
  for (const bumper::Define& one : geom->bumper_def)
    faces.push_back({pose(one.pose), one.length, one.radius});
  return faces;
}

}  // namespace playhouse::client
