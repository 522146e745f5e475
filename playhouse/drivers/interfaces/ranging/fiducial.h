#pragma once

/// Base of devices that report detected objects, as interface
/// fiducial (docs/drivers.md); a subclass for each kind of model.

#include <optional>

#include "playhouse/drivers/generated/device_makers.h"
#include "playhouse/wire/generated/fiducial.h"

namespace playhouse::drivers {

class FiducialDevice : public SimulatedDevice {
 public:
  FiducialDevice(run::Simulation& simulation, world::ModelRow model,
                 const wire::fiducial::Fov& field_of_view);

  std::span<const Served> served() const override;
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  /// The detections of this very tick; none if it did not measure.
  virtual std::optional<wire::fiducial::Data> read(const world::World& world) const = 0;

  void exchange_id(const device::Message& message, device::Replier replier);

  Bytes geometry_, field_of_view_;
};

/// A detection; the pose is relative to the sensor.  [m, rad]
wire::fiducial::Item fiducial_item(std::int32_t id, double range, double bearing, double heading);

}  // namespace playhouse::drivers
