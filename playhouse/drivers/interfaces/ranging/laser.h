#pragma once

/// A ranger's scanner as interface laser (docs/drivers.md).

#include "playhouse/drivers/generated/device_makers.h"
#include "playhouse/drivers/interfaces/ranging/scan.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

class Laser final : public SimulatedDevice {
 public:
  /// `model` is a ranger with a scanner (see scanner_of()).
  Laser(run::Simulation& simulation, world::ModelRow model);

  std::span<const Served> served() const override;
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  std::uint32_t scanner_;  // index among the ranger's sensors
  const scene::RangerSensorDesc& sensor_;
  Bytes geometry_, configuration_;
  wire::laser::Data scan_;  // the latest; reused for its constant fields and capacity
};

}  // namespace playhouse::drivers
