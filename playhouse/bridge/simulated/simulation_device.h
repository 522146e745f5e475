#pragma once

/// The whole world as interface simulation: poses and properties of
/// models by name, pausing, resetting and saving (docs/drivers.md).

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "playhouse/bridge/simulated/joined_robots.h"
#include "playhouse/bridge/simulated/model_devices.h"
#include "playhouse/bridge/simulated/overlap_warnings.h"
#include "playhouse/bridge/simulated/simulated_device.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {

class SimulationDevice final : public SimulatedDevice {
 public:
  /// `port`: its own.
  SimulationDevice(ModelDevices& devices, std::uint32_t port)
      : SimulatedDevice(devices.simulation(), {}),
        devices_(devices),
        port_(port),
        joined_(devices.simulation()) {}

  std::span<const Served> served() const override;
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;

 private:
  bool is_for_members(const wire::simulation::PropertyReq& request) const;
  device::Taken reset();
  device::Taken save();
  void pose_2d(const device::Message& message, device::Replier replier);
  void pose_3d(const device::Message& message, device::Replier replier);
  void property(const device::Message& message, device::Replier replier);
  void list_models(std::uint32_t first, device::Replier replier);
  void list_devices(const wire::simulation::PropertyReq& request, device::Replier replier);

  ModelDevices& devices_;
  const std::uint32_t port_;
  JoinedRobots joined_;
  std::atomic<std::uint64_t> newest_reset_ = 0, newest_save_ = 0;  // sequence numbers of the latest requests

  // Tick thread.
  std::optional<Bytes> model_page(const world::World& world, std::uint32_t first);
  /// Cached pages of list_models() by first id, consecutive from id 0; empty until requested.
  std::map<std::uint32_t, Bytes> model_pages_;
  std::uint64_t pages_of_ = 0;  // the population they list
  world::ModelRow find_or_warn(const world::World& world, const std::string& raw_name);
  bool move(world::Journal& journal, const std::string& name, const wire::Pose2d& pose);
  bool move(world::Journal& journal, const std::string& name, const wire::Pose3d& pose);
  OverlapWarnings overlaps_;
  std::set<std::string> unknown_names_;  // already logged; at most kUnknownNames
};

}  // namespace playhouse::drivers
