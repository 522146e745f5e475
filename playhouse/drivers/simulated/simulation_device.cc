#include "playhouse/drivers/simulated/simulation_device.h"

#include <string_view>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/drivers/simulated/properties.h"
#include "playhouse/drivers/simulated/shapes.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {

namespace sim = wire::simulation;
using wire::MessageType;

namespace {

constexpr std::size_t kUnknownNames = 100;  // a client may make names up for ever

}  // namespace

world::ModelRow SimulationDevice::find_or_warn(const world::World& world, const std::string& raw_name) {
  const std::string_view name = wire::text(raw_name);
  const world::ModelRow row = world.find(name);
  if (row || unknown_names_.size() >= kUnknownNames) return row;
  const std::string shown = in_quotes(name);  // what a client makes up is of any length and any bytes
  if (unknown_names_.insert(shown).second)
    log::warn("simulation: a client asked for model {}, which is not in this world", shown);
  return row;
}

/// Poses in requests are in the parent's frame. Without a z the model keeps its height.
bool SimulationDevice::move(world::World& world, const std::string& name, geom::Vec2 p,
                            std::optional<double> z, double a) {
  const world::ModelRow row = find_or_warn(world, name);
  if (!row) return false;
  return world::set_pose(world, row, {p.x, p.y, z.value_or(world.models.X_PM[row.index].z), a});
}

std::span<const Served> SimulationDevice::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kCmd, sim::kCmdPause},       {MessageType::kCmd, sim::kCmdReset},
      {MessageType::kReq, sim::kReqGetPose2d},   {MessageType::kReq, sim::kReqSetPose2d},
      {MessageType::kReq, sim::kReqGetPose3d},   {MessageType::kReq, sim::kReqSetPose3d},
      {MessageType::kReq, sim::kReqGetProperty}, {MessageType::kReq, sim::kReqSetProperty},
  };
  return kServed;
}

/// PAUSE has no payload: it pauses a running world and resumes a paused one.
bool SimulationDevice::command(const device::Message& message) {
  if (message.subtype == sim::kCmdReset) return reset(message.receipt());
  if (simulation().pace().paused) {
    simulation().resume();
  } else {
    simulation().pause();
  }
  return true;
}

/// One that a newer one follows before it is carried out would be for nothing, and it is dear.
bool SimulationDevice::reset(device::Receipt receipt) {
  const std::uint64_t number = newest_reset_ + 1;
  const bool posted = simulation().post_to_all([=, this, receipt = std::move(receipt)](world::World& world) {
    if (number >= newest_reset_) world::return_to_start(world);
  });
  if (posted) newest_reset_ = number;
  return posted;
}

void SimulationDevice::request(const device::Message& message, device::Replier replier) {
  switch (message.subtype) {
    case sim::kReqGetPose2d:
    case sim::kReqSetPose2d:
      pose_2d(message, std::move(replier));
      return;
    case sim::kReqGetPose3d:
    case sim::kReqSetPose3d:
      pose_3d(message, std::move(replier));
      return;
    case sim::kReqGetProperty:
    case sim::kReqSetProperty:
      property(message, std::move(replier));
      return;
    default:
      return;
  }
}

void SimulationDevice::pose_2d(const device::Message& message, device::Replier replier) {
  const auto request = wire::decode<sim::Pose2dReq>(message.body);
  if (!request) return;
  if (message.subtype == sim::kReqSetPose2d) {
    ask_world(std::move(replier), [this, r = *request](world::World& world) -> std::optional<Bytes> {
      if (!move(world, r.name, {r.pose.px, r.pose.py}, std::nullopt, r.pose.pa)) return std::nullopt;
      return Bytes();
    });
    return;
  }
  ask_world(std::move(replier), [this, r = *request](world::World& world) mutable -> std::optional<Bytes> {
    const world::ModelRow row = find_or_warn(world, r.name);
    if (!row) return std::nullopt;
    r.pose = pose2d(world.models.X_PM[row.index]);
    return wire::encode(r);
  });
}

void SimulationDevice::pose_3d(const device::Message& message, device::Replier replier) {
  const auto request = wire::decode<sim::Pose3dReq>(message.body);
  if (!request) return;
  if (message.subtype == sim::kReqSetPose3d) {
    ask_world(std::move(replier), [this, r = *request](world::World& world) -> std::optional<Bytes> {
      if (!move(world, r.name, {r.pose.px, r.pose.py}, r.pose.pz, r.pose.pyaw)) return std::nullopt;
      return Bytes();
    });
    return;
  }
  ask_world(std::move(replier), [this, r = *request](world::World& world) mutable -> std::optional<Bytes> {
    const world::ModelRow row = find_or_warn(world, r.name);
    if (!row) return std::nullopt;
    r.pose = pose3d(world.models.X_PM[row.index]);
    r.simtime = world.time() * 1e6;  // Stage's clients know microseconds here
    return wire::encode(r);
  });
}

void SimulationDevice::property(const device::Message& message, device::Replier replier) {
  const auto request = wire::decode<sim::PropertyReq>(message.body);
  if (!request) return;
  if (message.subtype == sim::kReqSetProperty) {
    ask_world(std::move(replier), [r = *request](world::World& world) -> std::optional<Bytes> {
      if (!set_property(world, wire::text(r.name), wire::text(r.prop), r.value)) return std::nullopt;
      return Bytes();
    });
    return;
  }
  ask_world(std::move(replier), [r = *request](world::World& world) mutable -> std::optional<Bytes> {
    std::optional<std::string> value = get_property(world, wire::text(r.name), wire::text(r.prop));
    if (!value) return std::nullopt;
    r.value = std::move(*value);
    return wire::encode(r);
  });
}

}  // namespace playhouse::drivers
