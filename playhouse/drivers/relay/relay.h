#pragma once

/// The .cfg driver "relay": passes the bytes of each command of interface opaque on to
/// everybody who has the device open, the sender included, for programs that talk to each other. Each device
/// of a section is a circle of its own.

#include <memory>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_relay(const config::CfgSection& section, Site& site);

extern const DriverDefinition kRelayDriver;

class Relay final : public device::Driver {
 public:
  explicit Relay(Site& site) : site_(site) {}

  std::string_view name() const override { return "relay"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message& message) override;
  void request(const device::Message&, device::Replier) override {}
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return false; }

 private:
  Site& site_;
};

}  // namespace playhouse::drivers
