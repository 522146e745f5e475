#pragma once

/// The .cfg driver "health", in Player "statgrabdriver": how busy this machine is.
///
/// In: /proc/stat and /proc/meminfo. Out: STATE of interface health, each `interval` of the network's clock while
/// the device is open.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/health/machine_load.h"
#include "playhouse/drivers/site.h"
#include "playhouse/net/network.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_health(const config::CfgSection& section, Site& site);

extern const DriverDefinition kHealthDriver;

class Health final : public device::Driver {
 public:
  /// Contents of a file.
  using ReadFile = std::function<Result<std::string>(const std::string& path)>;

  /// `name`: what the file calls the driver; `interval` [s].
  Health(Site& site, std::string name, double interval, ReadFile read_file);

  void set_device(device::DeviceId device) { device_ = device; }

  std::string_view name() const override { return name_; }
  Result<void> start(device::DeviceId) override;
  void stop(device::DeviceId) override { timer_.reset(); }
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  void request(const device::Message&, device::Replier) override {}
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return false; }

 private:
  void wait();
  /// None, with one line in the log, if the kernel does not tell.
  std::optional<CpuTimes> cpu_times();
  void publish();
  void log_once(const Error& error);

  Site& site_;
  const std::string name_;
  const double interval_;
  const ReadFile read_file_;
  device::DeviceId device_;
  std::unique_ptr<net::Timer> timer_;  // while the device is open
  std::optional<CpuTimes> before_;
  bool logged_ = false;
};

}  // namespace playhouse::drivers
