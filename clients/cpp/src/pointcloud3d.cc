#include "playhouse_client/pointcloud3d.h"

#include <utility>

namespace playhouse::client {

namespace cloud = wire::pointcloud3d;

Result<PointCloud3d> PointCloud3d::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, cloud::kCode, index, access);
  if (!device) return device.error();
  return PointCloud3d(std::move(*device));
}

std::vector<CloudPoint> PointCloud3d::points() const {
  std::vector<CloudPoint> points;
  const auto data = device_.latest<cloud::Data>(cloud::kDataState);
  if (!data) return points;
  points.reserve(data->points.size());
  for (const cloud::Element& each : data->points)
    points.push_back({each.point.px,
                      each.point.py,
                      each.point.pz,
                      {each.color.red, each.color.green, each.color.blue, each.color.alpha}});
  return points;
}

}  // namespace playhouse::client
