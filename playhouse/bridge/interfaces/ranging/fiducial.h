#pragma once

/// Base of devices that report detected objects, as interface
/// fiducial (docs/drivers.md); a subclass for each kind of model.

#include <optional>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/settings/settings.h"
#include "playhouse/wire/generated/fiducial.h"

namespace playhouse::drivers {

struct FovSettings {
  double min_range = 0, max_range = 0;  // m
  double view_angle = 0;                // rad
};

class FiducialDevice : public DeviceWithSettings<FovSettings> {
 public:
  FiducialDevice(run::Simulation& simulation, world::ModelRow model, const FovSettings& field_of_view);

  std::span<const Served> served() const override;
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  std::span<const NamedSetting> named() const override;
  bool settle(FovSettings& wanted) const override;

  /// The detections of this very tick; none if it did not measure.
  virtual std::optional<wire::fiducial::Data> read(const world::World& world) const = 0;

  void exchange_id(const device::Message& message, device::Replier replier);

  bool is_seen(const wire::fiducial::Item& item) const;

  Bytes geometry_;
};

/// A detection; the pose is relative to the sensor.  [m, rad]
wire::fiducial::Item fiducial_item(std::int32_t id, double range, double bearing, double heading);

}  // namespace playhouse::drivers
