#include "playhouse/drivers/relay/relay.h"

#include <vector>

#include "playhouse/drivers/section_devices.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {

device::Taken Relay::command(const device::Message& message) {
  if (message.subtype != wire::opaque::kCmdData) return device::Taken::kNo;
  site_.data_flow().publish({{device_, wire::opaque::kDataState, site_.time(),
                              std::vector<std::byte>(message.body.begin(), message.body.end())}});
  return device::Taken::kQueued;
}

Result<std::unique_ptr<device::Driver>> make_relay(const scene::CfgSection& section, Site& site) {
  const auto provided = section_devices(section, site, "provides", {"opaque"});
  if (!provided) return provided.error();
  auto driver = std::make_unique<Relay>(site);
  const Result<device::DeviceId> id = site.add_device(provided->front(), *driver);
  if (!id) return Error{section.at("provides"), id.error().text};
  driver->set_device(*id);
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
