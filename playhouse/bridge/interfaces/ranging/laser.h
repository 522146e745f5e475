#pragma once

/// A ranger's scanner as interface laser (docs/drivers.md).

#include <deque>
#include <vector>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/ranging/scan.h"
#include "playhouse/bridge/settings/settings.h"
#include "playhouse/drivers/scan_settings.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

/// The scan, and the filters of SET_FILTER.
struct LaserSettings : ScanSettings {
  bool median = false;         // of each range and its neighbours
  double low = 0, high = 0;    // m; a range beyond them is no hit; 0 and 0: all are
  std::int32_t mean_over = 1;  // scans
};

class Laser final : public DeviceWithSettings<LaserSettings> {
 public:
  /// `model` is a ranger with a scanner (see scanner_of()).
  Laser(run::Simulation& simulation, world::ModelRow model);

  std::span<const Served> served() const override;
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  std::span<const NamedSetting> named() const override;
  bool settle(LaserSettings& wanted) const override;
  void settled() override;

  void set_configuration(const wire::laser::Config& config, device::Replier replier);
  void set_filter(const wire::laser::SetFilterConfig& filter, device::Replier replier);
  /// Fills the scan with what was chosen of the measurement.
  void pick(const Beams& measured);
  void average();

  std::uint32_t scanner_;  // index among the ranger's sensors
  ScanSource source_;
  ScanChoice choice_;
  Bytes geometry_;
  wire::laser::Data scan_;               // the latest; reused for its constant fields and capacity
  std::deque<std::vector<float>> past_;  // ranges of the scans to average, the newest last
};

}  // namespace playhouse::drivers
