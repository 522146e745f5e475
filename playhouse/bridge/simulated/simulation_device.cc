#include "playhouse/bridge/simulated/simulation_device.h"

#include <string_view>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/bridge/simulated/directory.h"
#include "playhouse/bridge/simulated/properties.h"
#include "playhouse/bridge/simulated/world_requests.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {

namespace sim = wire::simulation;
using wire::MessageType;

namespace {

constexpr std::size_t kUnknownNames = 100;  // a client may make names up for ever
constexpr std::size_t kLongestList =
    limits::kBodyBytes - 64;  // what else an answer holds has room in 64 bytes

/// What concerns the whole world is for the program's own drivers and clients with that right.
bool manages(const device::Message& message) {
  return message.caller == nullptr || message.caller->rights().manages;
}

}  // namespace

world::ModelRow SimulationDevice::find_or_warn(const world::World& world, const std::string& raw_name) {
  const std::string_view name = wire::text(raw_name);
  const world::ModelRow row = world.find(name);
  if (row || unknown_names_.size() >= kUnknownNames) return row;
  const std::string shown = in_quotes(name);  // untrusted: arbitrary length and bytes
  if (unknown_names_.insert(shown).second)
    log::warn("simulation: a client asked for model {}, which is not in this world", shown);
  return row;
}

/// Poses in requests are in the parent's frame, with z from the top of a
/// parent that stacks, as in world files. A 2D pose keeps height and tilt.
bool SimulationDevice::move(world::Journal& journal, const std::string& name, const wire::Pose2d& pose) {
  const world::World& world = journal.world();
  const world::ModelRow row = find_or_warn(world, name);
  if (!row) return false;
  const geom::Pose X_PM{pose.px, pose.py, world.models.X_PM[row].z, pose.pa};
  const bool is_moved = journal.apply(world::changes::Place{world.id(row), X_PM});
  if (is_moved) overlaps_.placed(world, row, "moved");
  return is_moved;
}

bool SimulationDevice::move(world::Journal& journal, const std::string& name, const wire::Pose3d& pose) {
  const world::World& world = journal.world();
  const world::ModelRow row = find_or_warn(world, name);
  if (!row) return false;
  const geom::Vec3 p{pose.px, pose.py, pose.pz + world.desc(row).stacked};
  const geom::SpatialPose X_PM =
      geom::spatial_pose(p, geom::RollPitchYaw{pose.proll, pose.ppitch, pose.pyaw});
  const bool is_moved = journal.apply(world::changes::PlaceIn3D{world.id(row), X_PM});
  if (is_moved) overlaps_.placed(world, row, "moved");
  return is_moved;
}

std::span<const Served> SimulationDevice::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kCmd, sim::kCmdPause},       {MessageType::kCmd, sim::kCmdReset},
      {MessageType::kCmd, sim::kCmdSave},        {MessageType::kReq, sim::kReqGetPose2d},
      {MessageType::kReq, sim::kReqSetPose2d},   {MessageType::kReq, sim::kReqGetPose3d},
      {MessageType::kReq, sim::kReqSetPose3d},   {MessageType::kReq, sim::kReqGetProperty},
      {MessageType::kReq, sim::kReqSetProperty},
  };
  return kServed;
}

/// PAUSE has no payload: it pauses a running world and resumes a paused one.
device::Taken SimulationDevice::command(const device::Message& message) {
  if (!manages(message)) return device::Taken::kRefused;
  if (message.subtype == sim::kCmdReset) return reset();
  if (message.subtype == sim::kCmdSave) return save();
  if (simulation().requests().pace().paused) {
    simulation().requests().resume();
  } else {
    simulation().requests().pause();
  }
  return device::Taken::kLatest;
}

/// Superseded resets are skipped, because a reset is expensive.
device::Taken SimulationDevice::reset() {
  const std::uint64_t number = newest_reset_ + 1;
  const bool posted = simulation().requests().post_to_all([=, this](world::Journal& journal) {
    if (number >= newest_reset_) journal.apply(world::changes::ReturnToStart{});
  });
  if (!posted) return device::Taken::kNo;
  newest_reset_ = number;
  return device::Taken::kQueued;
}

/// As with resets, superseded saves are skipped.
device::Taken SimulationDevice::save() {
  if (!devices_.saver()) {
    log::warn("simulation: a client asked to save the world, which --save-world FILE allows");
    return device::Taken::kNo;
  }
  const std::uint64_t number = newest_save_ + 1;
  const bool posted = simulation().requests().post_to_all([=, this](const world::Journal& journal) {
    if (number >= newest_save_) devices_.saver()(journal.world());
  });
  if (!posted) return device::Taken::kNo;
  newest_save_ = number;
  return device::Taken::kQueued;
}

void SimulationDevice::request(const device::Message& message, device::Replier replier) {
  const bool sets_pose = message.subtype == sim::kReqSetPose2d || message.subtype == sim::kReqSetPose3d;
  if (sets_pose && !manages(message)) return;
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
    answer_by(std::move(replier), [this, r = *request](world::Journal& journal) -> std::optional<Bytes> {
      if (!move(journal, r.name, r.pose)) return std::nullopt;
      return Bytes();
    });
    return;
  }
  ask_world(std::move(replier),
            [this, r = *request](const world::World& world) mutable -> std::optional<Bytes> {
              const world::ModelRow row = find_or_warn(world, r.name);
              if (!row) return std::nullopt;
              r.pose = pose2d(world.models.X_PM[row]);
              return wire::encode(r);
            });
}

void SimulationDevice::pose_3d(const device::Message& message, device::Replier replier) {
  const auto request = wire::decode<sim::Pose3dReq>(message.body);
  if (!request) return;
  if (message.subtype == sim::kReqSetPose3d) {
    answer_by(std::move(replier), [this, r = *request](world::Journal& journal) -> std::optional<Bytes> {
      if (!move(journal, r.name, r.pose)) return std::nullopt;
      return Bytes();
    });
    return;
  }
  ask_world(std::move(replier),
            [this, r = *request](const world::World& world) mutable -> std::optional<Bytes> {
              const world::ModelRow row = find_or_warn(world, r.name);
              if (!row) return std::nullopt;
              r.pose = pose3d(world::pose_in_parent(world.models, row));
              r.pose.pz -= world.desc(row).stacked;
              r.simtime = world.time() * 1e6;  // microseconds, as in Stage
              return wire::encode(r);
            });
}

void SimulationDevice::property(const device::Message& message, device::Replier replier) {
  const auto request = wire::decode<sim::PropertyReq>(message.body);
  if (!request) return;
  if (message.subtype == sim::kReqSetProperty) {
    if (wire::text(request->prop) == "robot")
      return joined_.join(*request, message.caller, std::move(replier));
    if (!manages(message) && !is_for_members(*request)) {
      sim::PropertyReq why = *request;
      why.value = wire::c_string("only a guest who is admin may do that");
      return replier.nack(wire::encode(why));
    }
    if (ask_for_world(simulation(), *request, message.caller, replier, overlaps_)) return;
    answer_by(std::move(replier), [r = *request](world::Journal& journal) -> std::optional<Bytes> {
      if (!set_property(journal, wire::text(r.name), wire::text(r.prop), r.value)) return std::nullopt;
      return Bytes();
    });
    return;
  }
  if (wire::text(request->name).empty() && wire::text(request->prop) == "models") {
    list_models(request->index, std::move(replier));
    return;
  }
  if (wire::text(request->prop) == "devices") return list_devices(*request, std::move(replier));
  ask_world(std::move(replier), [r = *request](const world::World& world) mutable -> std::optional<Bytes> {
    std::optional<std::string> value = get_property(world, wire::text(r.name), wire::text(r.prop));
    if (!value) return std::nullopt;
    r.value = std::move(*value);
    return wire::encode(r);
  });
}

/// In lock-step whoever drives joins and steps: the world waits for all of them.
bool SimulationDevice::is_for_members(const sim::PropertyReq& request) const {
  const std::string_view property = wire::text(request.prop);
  return simulation().lock_step() != nullptr && (property == "join" || property == "step");
}

/// Devices of a model and its parts.
void SimulationDevice::list_devices(const sim::PropertyReq& request, device::Replier replier) {
  ask_world(std::move(replier),
            [this, r = request](const world::World& world) mutable -> std::optional<Bytes> {
              const world::ModelRow row = find_or_warn(world, r.name);
              if (!row) return std::nullopt;
              r.value = wire::c_string(devices_below(world, devices_.directory(), row, port_));
              return wire::encode(r);
            });
}

void SimulationDevice::list_models(std::uint32_t first, device::Replier replier) {
  ask_world(std::move(replier),
            [this, first](const world::World& world) { return model_page(world, first); });
}

/// Cached pages of the model list, until the population changes.
std::optional<Bytes> SimulationDevice::model_page(const world::World& world, std::uint32_t first) {
  if (pages_of_ != world.population()) model_pages_.clear();
  pages_of_ = world.population();
  const auto kept = model_pages_.find(first);
  if (kept != model_pages_.end() && !kept->second.empty()) return kept->second;
  ModelList list = drivers::list_models(world, devices_.directory(), first);
  if (list.text.size() > kLongestList) return std::nullopt;  // a single name is as long as a message
  Bytes page = wire::encode(
      sim::PropertyReq{wire::c_string(""), wire::c_string("models"), list.next, std::move(list.text)});
  if (first == 0 || kept != model_pages_.end()) {
    model_pages_[first] = page;
    if (list.next > 0) model_pages_.try_emplace(list.next);
  }
  return page;
}

}  // namespace playhouse::drivers
