#include "playhouse_client/gripper.h"

#include <utility>

#include "convert.h"

namespace playhouse::client {

namespace gripper = wire::gripper;

Result<Gripper> Gripper::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, gripper::kCode, index, access);
  if (!device) return device.error();
  return Gripper(std::move(*device));
}

std::optional<GripperState> Gripper::state() const {
  const auto data = device_.latest<gripper::Data>(gripper::kDataState);
  if (!data) return std::nullopt;
  return GripperState{data->state == gripper::kStateOpen, data->state == gripper::kStateClosed,
                      data->state == gripper::kStateMoving, data->beams, device_.timestamp()};
}

Result<void> Gripper::open_fingers() {
  return device_.command(gripper::kCmdOpen);
}
Result<void> Gripper::close_fingers() {
  return device_.command(gripper::kCmdClose);
}
Result<void> Gripper::stop() {
  return device_.command(gripper::kCmdStop);
}

Result<GripperGeometry> Gripper::geometry() {
  const auto geom = device_.request<gripper::Geom>(gripper::kReqGetGeom);
  if (!geom) return geom.error();
  return GripperGeometry{pose(geom->pose), size(geom->outer_size), size(geom->inner_size), geom->num_beams};
}

}  // namespace playhouse::client
