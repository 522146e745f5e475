#pragma once

/// Base of devices that report ranges, as interface ranger: one scanner, or an
/// array of transducers (docs/drivers.md); a subclass for each kind of model.

#include "playhouse/drivers/generated/device_makers.h"
#include "playhouse/drivers/interfaces/ranging/scan.h"
#include "playhouse/wire/generated/ranger.h"

namespace playhouse::drivers {

class RangerDevice : public SimulatedDevice {
 public:
  RangerDevice(run::Simulation& simulation, world::ModelRow model, const wire::ranger::Geom& geometry,
               const wire::ranger::Config& configuration);

  std::span<const Served> served() const override;
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  /// Replaces `out` by the measurements of this very tick. False if there are none.
  virtual bool read(const world::World& world, std::vector<Reading>& out) const = 0;

  Bytes geometry_, configuration_;
  std::vector<Reading> readings_;  // reused for its capacity
};

/// Update rate of a model.  [Hz]
double measuring_frequency(const world::World& world, world::ModelRow model);

}  // namespace playhouse::drivers
