#pragma once

/// A ranger's array of transducers as interface sonar (docs/drivers.md).

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/ranging/scan.h"
#include "playhouse/bridge/settings/device_with_power.h"

namespace playhouse::drivers {

class Sonar final : public DeviceWithPower {
 public:
  /// `model` is of kind kRanger.
  Sonar(run::Simulation& simulation, world::ModelRow model);

  std::span<const Served> served() const override;
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  Bytes geometry_;
  std::vector<Reading> readings_;  // reused for its capacity
};

}  // namespace playhouse::drivers
