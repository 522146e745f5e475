#include "playhouse_client/fiducial.h"

#include <utility>

namespace playhouse::client {

namespace fiducial = wire::fiducial;

Result<Fiducial> Fiducial::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, fiducial::kCode, index, access);
  if (!device) return device.error();
  return Fiducial(std::move(*device));
}

std::vector<fiducial::Item> Fiducial::markers() const {
  auto data = device_.latest<fiducial::Data>(fiducial::kDataScan);
  return data ? std::move(data->fiducials) : std::vector<fiducial::Item>();
}

Result<fiducial::Fov> Fiducial::field_of_view() {
  return device_.request<fiducial::Fov>(fiducial::kReqGetFov);
}

Result<void> Fiducial::set_field_of_view(const fiducial::Fov& fov) {
  const auto done = device_.request(fiducial::kReqSetFov, fov);
  return done ? Result<void>() : done.error();
}

Result<fiducial::Geom> Fiducial::geometry() {
  return device_.request<fiducial::Geom>(fiducial::kReqGetGeom);
}

}  // namespace playhouse::client
