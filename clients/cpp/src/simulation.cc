#include "playhouse_client/simulation.h"

#include <bit>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "convert.h"
#include "done.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/wire/codec.h"
#include "session.h"

namespace playhouse::client {

namespace simulation = wire::simulation;

namespace {

/// Sends a request about a model; a refusal becomes an error that names the model.
template <typename Req>
Result<Req> ask(Device& device, std::uint8_t subtype, std::string_view model, const Req& question) {
  Result<std::optional<Req>> answer = device.ask<Req>(subtype, question);
  if (!answer) return answer.error();
  if (*answer) return std::move(**answer);
  return Error{"", device.name() + " refused: it has no model " + in_quotes(model)};
}

/// Sets the pose of a model.
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

/// The value's bytes, little-endian.
template <typename... Numbers>
std::string raw(Numbers... numbers) {
  static_assert(std::endian::native == std::endian::little, "property values travel in a PC's byte order");
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
  return bytes;
}

constexpr Seconds kForEver{1e9};

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
Result<void> Simulation::save() {
  return device_.command(simulation::kCmdSave);
}

Seconds Simulation::patience() const {
  return device_.session_->timeout();
}

/// Sets a property whose acknowledgement means completion, and returns the answer's text. A refusal is an
/// error with the server's reason.
Result<std::string> Simulation::ask_world(std::string_view name, std::string_view property, std::string value,
                                          Seconds patience) {
  if (const Result<void> fit = device_.usable(); !fit) return fit.error();
  const simulation::PropertyReq question{wire::c_string(name), wire::c_string(property), 0, std::move(value)};
  Session& session = *device_.session_;
  const auto answer = session.exchange(device_.interf(), device_.index(), simulation::kReqSetProperty,
                                       wire::encode(question), deadline_after(patience));
  if (!answer) return answer.error();
  const auto body = wire::decode<simulation::PropertyReq>(answer->body);
  const std::string said = body ? std::string(wire::text(body->value)) : "";
  if (answer->header.type == wire::MessageType::kAck) return said;
  return Error{device_.name(), std::string(property) +
                                   " was refused: " + (said.empty() ? "the server does not do that" : said)};
}

Result<void> Simulation::join(std::string_view name) {
  return done(ask_world("", "join", wire::c_string(name), patience()));
}

Result<void> Simulation::step(std::uint32_t ticks) {
  return step(ticks, kForEver);
}

Result<void> Simulation::step(std::uint32_t ticks, Seconds patience) {
  const auto done = ask_world("", "step", raw(ticks), patience);
  if (!done) return done.error();
  device_.session_->deliver_pushed();
  return {};
}

Result<void> Simulation::reset(std::uint64_t seed) {
  const auto done = ask_world("", "reset", raw(seed), patience());
  if (!done) return done.error();
  device_.session_->forget_run();
  return {};
}

Result<std::string> Simulation::spawn(std::string_view like, const Pose& pose, std::string_view name) {
  if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.a))
    return Error{"", device_.name() + ": a pose takes finite numbers"};
  return ask_world(like, "spawn",
                   raw(pose.x, pose.y, pose.a) + (name.empty() ? std::string() : wire::c_string(name)),
                   patience());
}

Result<void> Simulation::remove(std::string_view name) {
  return done(ask_world(name, "remove", {}, patience()));
}

}  // namespace playhouse::client
