#pragma once

/// The .cfg driver "rangertolaser": presents a ranger device of any driver as a
/// laser, for programs without support for rangers. Each scan becomes one message
/// with its intensities; geometry and configuration are requested from the ranger.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/site.h"
#include "playhouse/wire/generated/ranger.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_ranger_to_laser(const config::CfgSection& section, Site& site);

extern const DriverDefinition kRangerToLaserDriver;

/// Uses the ranger.
class RangerToLaser final : public Algorithm {
 public:
  explicit RangerToLaser(Shell& shell);

  /// A laser exposes one sensor. Rangers outside the simulated world are not checked.
  Result<void> fits(const SiteWorld& world, device::Address ranger) const override;
  void opened() override;
  void closed() override;
  void take_news(std::vector<device::Publication>& more) override;

 private:
  /// SET_CONFIG, as a change of the ranger's configuration.
  void set_configuration(const device::Message& message, device::Replier replier);

  static constexpr std::size_t kRanger = 0;  // used device

  Shell& shell_;
  device::Subscription& ranges_;
  device::Subscription& intensities_;
  device::Subscription& configured_;  // of the first scan in another configuration

  std::mutex mutex_;                            // guards what follows
  std::optional<wire::ranger::Config> config_;  // while the laser is open
  std::uint32_t scans_ = 0;
};

}  // namespace playhouse::drivers
