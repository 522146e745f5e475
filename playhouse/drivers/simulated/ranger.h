#pragma once

/// A ranger as interface ranger: one scanner, or an array of transducers (docs/drivers.md).

#include "playhouse/drivers/generated/device_makers.h"
#include "playhouse/drivers/simulated/scan.h"

namespace playhouse::drivers {

class Ranger final : public SimulatedDevice {
 public:
  /// `model` is of kind kRanger.
  Ranger(Simulation& simulation, world::ModelRow model);

  std::span<const Served> served() const override;
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  Bytes geometry_, configuration_;
  std::vector<Reading> readings_;  // kept for its memory
};

}  // namespace playhouse::drivers
