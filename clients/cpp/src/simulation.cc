#include "playhouse_client/simulation.h"

#include <cmath>
#include <initializer_list>
#include <utility>

#include "convert.h"
#include "playhouse/base/in_quotes.h"

namespace playhouse::client {

namespace simulation = wire::simulation;

namespace {

/// Asks about a model: the answer, or an error that names it.
template <typename Req>
Result<Req> ask(Device& device, std::uint8_t subtype, std::string_view model, const Req& question) {
  Result<std::optional<Req>> answer = device.ask<Req>(subtype, question);
  if (!answer) return answer.error();
  if (*answer) return std::move(**answer);
  return Error{"", device.name() + " refused: it has no model " + in_quotes(model)};
}

/// Moves a model.
template <typename Req>
Result<void> move(Device& device, std::uint8_t subtype, std::string_view model, const Req& question,
                  std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    if (!std::isfinite(number))
      return Error{"", device.name() + ": a pose of " + in_quotes(model) + " takes finite numbers"};
  }
  const auto done = device.request(subtype, question);
  if (done) return {};
  return Error{done.error().where, "cannot move model " + in_quotes(model) + ": " + done.error().text};
}

}  // namespace

Result<Simulation> Simulation::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, simulation::kCode, index, access);
  if (!device) return device.error();
  return Simulation(std::move(*device));
}

Result<Pose> Simulation::pose(std::string_view model) {
  const auto answer =
      ask(device_, simulation::kReqGetPose2d, model, simulation::Pose2dReq{wire::c_string(model), {}});
  if (!answer) return answer.error();
  return client::pose(answer->pose);
}

Result<void> Simulation::set_pose(std::string_view model, const Pose& pose) {
  return move(device_, simulation::kReqSetPose2d, model,
              simulation::Pose2dReq{wire::c_string(model), on_wire(pose)}, {pose.x, pose.y, pose.a});
}

Result<Pose3d> Simulation::pose3d(std::string_view model) {
  const auto answer =
      ask(device_, simulation::kReqGetPose3d, model, simulation::Pose3dReq{wire::c_string(model), {}, 0});
  if (!answer) return answer.error();
  return client::pose(answer->pose);
}

Result<void> Simulation::set_pose3d(std::string_view model, const Pose3d& pose) {
  return move(device_, simulation::kReqSetPose3d, model,
              simulation::Pose3dReq{wire::c_string(model), on_wire(pose), 0},
              {pose.x, pose.y, pose.z, pose.roll, pose.pitch, pose.yaw});
}

Result<void> Simulation::pause() {
  return device_.command(simulation::kCmdPause);
}
Result<void> Simulation::reset() {
  return device_.command(simulation::kCmdReset);
}

}  // namespace playhouse::client
