#pragma once

/// Base of devices that report ranges, as interface ranger: one scanner, or an
/// array of transducers (docs/drivers.md); a subclass for each kind of model.

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/ranging/scan.h"
#include "playhouse/bridge/settings/settings.h"
#include "playhouse/drivers/scan_settings.h"
#include "playhouse/wire/generated/ranger.h"

namespace playhouse::drivers {

class RangerDevice : public DeviceWithSettings<ScanSettings> {
 public:
  RangerDevice(run::Simulation& simulation, world::ModelRow model, wire::ranger::Geom geometry,
               const ScanSource& source);

  std::span<const Served> served() const override;
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;
  void ended(world::Journal& journal) override;

 private:
  std::span<const NamedSetting> named() const override;
  bool settle(ScanSettings& wanted) const override { return choose(source_, wanted).has_value(); }
  void settled() override;

  /// Replaces `out` by the measurements of this very tick. False if there are none.
  virtual bool read(const world::World& world, std::vector<Reading>& out) const = 0;

  void set_configuration(const wire::ranger::Config& config, device::Replier replier);
  /// What was chosen of the readings.
  void pick();

  wire::ranger::Geom geometry_;
  ScanSource source_;
  ScanChoice choice_;
  bool is_new_ = false;            // set since the last scan
  std::vector<Reading> readings_;  // reused for its capacity
};

}  // namespace playhouse::drivers
