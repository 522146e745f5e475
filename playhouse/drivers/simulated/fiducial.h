#pragma once

/// A fiducial finder as interface fiducial (docs/drivers.md).

#include "playhouse/drivers/generated/device_makers.h"

namespace playhouse::drivers {

class Fiducial final : public SimulatedDevice {
 public:
  /// `model` is of kind kFiducial.
  Fiducial(Simulation& simulation, world::ModelRow model);

  std::span<const Served> served() const override;
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  void exchange_id(const device::Message& message, device::Replier replier);

  Bytes geometry_, field_of_view_;
};

}  // namespace playhouse::drivers
