#pragma once

/// What tells which things it sees and where, as interface fiducial (docs/drivers.md). A kind of model that
/// does has a subclass.

#include <optional>

#include "playhouse/drivers/generated/device_makers.h"
#include "playhouse/wire/generated/fiducial.h"

namespace playhouse::drivers {

class FiducialDevice : public SimulatedDevice {
 public:
  FiducialDevice(Simulation& simulation, world::ModelRow model, const wire::fiducial::Fov& field_of_view);

  std::span<const Served> served() const override;
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  /// What was seen in this very tick; none where it did not look.
  virtual std::optional<wire::fiducial::Data> read(const world::World& world) const = 0;

  void exchange_id(const device::Message& message, device::Replier replier);

  Bytes geometry_, field_of_view_;
};

/// A thing in view, from the pose of what sees it.  [m, rad]
wire::fiducial::Item fiducial_item(std::int32_t id, double range, double bearing, double heading);

}  // namespace playhouse::drivers
