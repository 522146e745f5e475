#pragma once

/// ModelDevices: the devices of a world's models as followers of its run: which device is of which model
/// (directory), which are open, and their data after each tick. Thread: tick, unless stated otherwise.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "playhouse/bridge/simulated/directory.h"
#include "playhouse/bridge/simulated/sources.h"
#include "playhouse/device/data_flow.h"
#include "playhouse/run/simulation.h"

namespace playhouse::drivers {

class ModelDevices final : public run::Follower {
 public:
  /// Follows the run of `simulation`; data go to `publisher`. All outlive the run.
  ModelDevices(run::Simulation& simulation, device::Publisher& publisher);

  run::Simulation& simulation() const { return simulation_; }
  Directory& directory() { return directory_; }
  const Directory& directory() const { return directory_; }
  /// The open devices, which publish after each tick.
  Sources& sources() { return sources_; }
  const Sources& sources() const { return sources_; }

  /// Handles a client's request to save the world. Before the run. Default: none, requests have
  /// no effect; which file a client may write, if any, is the operator's decision.
  using Saver = std::function<void(const world::World&)>;
  void save_by(Saver saver) { saver_ = std::move(saver); }
  const Saver& saver() const { return saver_; }  // any thread

  void happened(const world::World& world, const world::Event& event) override;
  void ticked(const world::World& world) override;
  std::optional<run::Work> work(const world::World& world, const world::Pace& pace) override;

 private:
  void publish();

  run::Simulation& simulation_;
  device::Publisher& publisher_;
  Directory directory_;
  Sources sources_;
  Saver saver_;
  bool is_due_ = false;  // many devices have data of the last tick
  std::vector<device::Publication> batch_;
};

}  // namespace playhouse::drivers
