#include "playhouse/drivers/relay/relay.h"

#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {

device::Taken Relay::command(const device::Message& message) {
  if (message.subtype != wire::opaque::kCmdData) return device::Taken::kNo;
  site_.data_flow().publish({{message.device, wire::opaque::kDataState, site_.time(),
                              std::vector<std::byte>(message.body.begin(), message.body.end())}});
  return device::Taken::kQueued;
}

namespace {

constexpr DeviceText kRelayProvides[] = {{"opaque", {}, HowMany::kAny, "each for those who have it open"}};

}  // namespace

constinit const DriverDefinition kRelayDriver{
    .name = "relay",
    .doc = "Passes the bytes of each command on, as data, to all who have the device open.",
    .provides = kRelayProvides,
    .make = make_relay,
};

Result<std::unique_ptr<device::Driver>> make_relay(const config::CfgSection& section, Site& site) {
  auto driver = std::make_unique<Relay>(site);
  for (const config::DeviceAddress& provided : section.addresses("provides")) {
    const Result<device::Address> address = site.resolve(provided);
    if (!address) return Error{section.at("provides"), address.error().text};
    if (address->interf != wire::opaque::kCode)
      return Error{section.at("provides"),
                   in_quotes(provided.text()) + ": driver \"relay\" provides devices of opaque alone"};
    if (const Result<device::DeviceId> id = site.add_device(*address, *driver); !id)
      return Error{section.at("provides"), id.error().text};
  }
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
