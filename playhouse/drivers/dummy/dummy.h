#pragma once

/// The .cfg driver "dummy": devices of any interface whose data are made up, for tests of programs that need
/// a device and no robot. All that an interface defines is sent, taken and answered.
///
/// In: interfaces, rate and seed of the section.
///
/// Out: plausible.h, every DATA message of an open device `rate` times a second; the number of a message counts
/// from the opening.
///
/// Threads: start, stop, forget and the timers on the io thread, the others on any.

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "playhouse/base/packing.h"
#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/dummy/plausible.h"
#include "playhouse/drivers/site.h"
#include "playhouse/net/network.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_dummy(const config::CfgSection& section, Site& site);

extern const DriverDefinition kDummyDriver;

class Dummy final : public device::Driver {
 public:
  /// `period`: seconds between two messages.
  Dummy(Site& site, double period, std::uint64_t seed) : site_(site), period_(period), seed_(seed) {}

  Result<void> add(device::Address address);

  std::string_view name() const override { return "dummy"; }
  Result<void> start(device::DeviceId id) override;
  void stop(device::DeviceId id) override { open_.erase(id); }
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId id, std::uint8_t type, std::uint8_t subtype) const override;
  void forget(device::DeviceId id) override;

 private:
  struct DummyDevice {
    std::uint16_t interf;
    Plausible values;
    std::map<std::string_view, Bytes> set;                             // by payload: the newest
    std::map<std::pair<std::uint8_t, std::string>, Bytes> properties;  // by their request and key
    std::size_t set_bytes = 0;                                         // of both
  };
  struct Open {
    std::uint64_t number = 0;  // of the next message
    double due = 0;            // s of the network
    std::unique_ptr<net::Timer> timer;
  };

  std::optional<Bytes> answer(DummyDevice& device, const wire::MessageDef& known,
                              std::span<const std::byte> body);
  const wire::MessageDef* definition(device::DeviceId id, std::uint8_t type, std::uint8_t subtype) const;
  void send(device::DeviceId id);

  Site& site_;
  const double period_;
  const std::uint64_t seed_;
  std::map<device::DeviceId, Open> open_;
  mutable std::mutex mutex_;  // guards what clients have set, and which devices there are for other threads
  std::map<device::DeviceId, DummyDevice> devices_;
};

}  // namespace playhouse::drivers
