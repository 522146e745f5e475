#include "playhouse_client/fiducial.h"

#include <cmath>
#include <utility>

#include "convert.h"
#include "done.h"

namespace playhouse::client {

namespace fiducial = wire::fiducial;

double Marker::distance() const {
  return std::hypot(pose.x, pose.y);
}
double Marker::bearing() const {
  return std::atan2(pose.y, pose.x);
}

Result<Fiducial> Fiducial::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, fiducial::kCode, index, access);
  if (!device) return device.error();
  return Fiducial(std::move(*device));
}

std::vector<Marker> Fiducial::markers() const {
  std::vector<Marker> markers;
  const auto data = device_.latest<fiducial::Data>(fiducial::kDataScan);
  if (!data) return markers;
  for (const fiducial::Item& item : data->fiducials) markers.push_back({item.id, pose(item.pose)});
  return markers;
}

Result<fiducial::Fov> Fiducial::field_of_view() {
  return device_.request<fiducial::Fov>(fiducial::kReqGetFov);
}

Result<void> Fiducial::set_field_of_view(const fiducial::Fov& fov) {
  return done(device_.request(fiducial::kReqSetFov, fov));
}

Result<Geometry> Fiducial::geometry() {
  const auto geom = device_.request<fiducial::Geom>(fiducial::kReqGetGeom);
  if (!geom) return geom.error();
  return Geometry{pose(geom->pose), size(geom->size)};
}

}  // namespace playhouse::client
