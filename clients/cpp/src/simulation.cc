#include "playhouse_client/simulation.h"

#include <utility>

namespace playhouse::client {

namespace simulation = wire::simulation;

Result<Simulation> Simulation::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, simulation::kCode, index, access);
  if (!device) return device.error();
  return Simulation(std::move(*device));
}

Result<wire::Pose2d> Simulation::pose(std::string_view model) {
  simulation::Pose2dReq question;
  question.name = wire::c_string(model);
  const auto answer = device_.request<simulation::Pose2dReq>(simulation::kReqGetPose2d, question);
  if (!answer) return answer.error();
  return answer->pose;
}

Result<void> Simulation::set_pose(std::string_view model, const wire::Pose2d& pose) {
  const auto done =
      device_.request(simulation::kReqSetPose2d, simulation::Pose2dReq{wire::c_string(model), pose});
  return done ? Result<void>() : done.error();
}

Result<wire::Pose3d> Simulation::pose3d(std::string_view model) {
  simulation::Pose3dReq question;
  question.name = wire::c_string(model);
  const auto answer = device_.request<simulation::Pose3dReq>(simulation::kReqGetPose3d, question);
  if (!answer) return answer.error();
  return answer->pose;
}

Result<void> Simulation::set_pose3d(std::string_view model, const wire::Pose3d& pose) {
  simulation::Pose3dReq body;
  body.name = wire::c_string(model);
  body.pose = pose;
  const auto done = device_.request(simulation::kReqSetPose3d, body);
  return done ? Result<void>() : done.error();
}

Result<void> Simulation::pause() {
  return device_.command(simulation::kCmdPause);
}
Result<void> Simulation::reset() {
  return device_.command(simulation::kCmdReset);
}

}  // namespace playhouse::client
