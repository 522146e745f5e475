#pragma once

/// The .cfg driver "rangertolaser": presents a ranger device of any driver as a
/// laser, for programs without support for rangers. Each scan becomes one message
/// with its intensities; geometry and configuration are requested from the ranger.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/client.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/ranger.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_ranger_to_laser(const scene::CfgSection& section, Site& site);

/// Converts a scan to the laser format. `intensities` may be empty.
wire::laser::Data laser_scan(const wire::ranger::Config& config, const wire::ranger::DataRange& ranges,
                             const wire::ranger::DataIntns& intensities, std::uint32_t id);

class RangerToLaser final : public device::Driver {
 public:
  /// Its client opens the ranger, its only device, while the laser is open.
  explicit RangerToLaser(device::Opener& opener);

  void set_laser(device::DeviceId laser) { laser_ = laser; }
  device::DeviceClient& client() { return client_; }

  std::string_view name() const override { return "rangertolaser"; }
  Result<void> start(device::DeviceId device) override;
  void stop(device::DeviceId device) override;
  void retired(device::DeviceId) override { stop(laser_); }
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const override;
  void barrier(device::Replier replier) override { client_.barrier(std::move(replier)); }

 private:
  void convert(std::vector<device::Publication>& more);

  device::DeviceClient client_;
  device::Subscription& ranges_;
  device::Subscription& intensities_;
  device::DeviceId laser_;

  std::mutex mutex_;                            // guards what follows
  std::optional<wire::ranger::Config> config_;  // while the laser is open
  std::uint32_t scans_ = 0;
};

}  // namespace playhouse::drivers
