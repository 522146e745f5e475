#include "playhouse/drivers/site.h"

#include <fmt/format.h>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {

Result<device::Address> Site::resolve(const scene::DeviceAddress& address) const {
  if (!address.host.empty() && address.host != "localhost" && address.host != "127.0.0.1") {
    return Error{"",
                 fmt::format("{}: devices of other hosts are not available yet", in_quotes(address.text()))};
  }
  const wire::InterfaceDef* interf = wire::find_interface(address.interf);
  if (interf == nullptr) {
    std::vector<std::string_view> names;
    for (const wire::InterfaceDef& known : wire::interfaces()) names.push_back(known.name);
    return Error{"", fmt::format("{}: there is no interface {}{}", in_quotes(address.text()),
                                 in_quotes(address.interf), did_you_mean(address.interf, names))};
  }
  return device::Address{address.port.value_or(default_port_), interf->code, address.index};
}

Result<device::DeviceId> Site::add_device(device::Address address, device::Driver& driver) {
  Result<device::DeviceId> id = surroundings_.add_device(address, driver);
  if (id) devices_[address] = {*id, &driver};
  return id;
}

std::optional<Site::Neighbour> Site::find(device::Address address) const {
  const auto found = devices_.find(address);
  if (found == devices_.end()) return std::nullopt;
  return found->second;
}

std::set<std::uint32_t> Site::ports() const {
  std::set<std::uint32_t> ports;
  for (const auto& [address, neighbour] : devices_) ports.insert(address.robot);
  return ports;
}

Result<void> Site::open_world(const std::string& path) {
  Result<std::unique_ptr<Simulation>> simulation = surroundings_.open_world(path);
  if (!simulation) return simulation.error();
  simulation_ = std::move(*simulation);
  simulation_->publish_to(tap_);
  return {};
}

Result<void> Site::finish() {
  for (const auto& task : std::exchange(later_, {})) {
    if (const Result<void> done = task(); !done) return done.error();
  }
  return {};
}

}  // namespace playhouse::drivers
