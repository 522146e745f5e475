#include "playhouse/drivers/site.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/monotonic.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/device/device_table.h"
#include "playhouse/drivers/data_order.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {
namespace {

constexpr std::size_t kCircleShown = 8;  // devices of a cycle shown in an error

}  // namespace

Result<std::unique_ptr<SiteWorld>> Host::open_world(const std::string& path, Site&) {
  return Error{escaped(path), "there is no world here"};
}

Result<device::Address> Site::resolve(const config::DeviceAddress& address) const {
  constexpr std::string_view kOwnHosts[] = {"", "localhost", "127.0.0.1", "::1"};
  if (std::ranges::find(kOwnHosts, address.host) == std::end(kOwnHosts)) {
    return Error{"", fmt::format("{}: a device of another host is for the driver \"passthrough\" alone",
                                 in_quotes(address.text()))};
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

std::optional<device::DeviceId> Site::find(device::Address address) const {
  const auto found = devices_.find(address);
  if (found == devices_.end()) return std::nullopt;
  return found->second.id;
}

std::set<std::uint32_t> Site::ports() const {
  std::set<std::uint32_t> ports;
  for (const auto& [address, provided] : devices_)
    if (!remote_ports_.contains(address.robot)) ports.insert(address.robot);
  return ports;
}

std::set<device::Address> Site::take_remote_devices() {
  const std::set<std::uint32_t> own = ports();
  std::set<device::Address> remote;
  for (const User& user : users_)
    for (const device::Address& wanted : user.devices)
      if (!own.contains(wanted.robot)) remote.insert(wanted);
  for (const device::Address& address : remote) remote_ports_.insert(address.robot);
  return remote;
}

Result<void> Site::open_world(const std::string& path) {
  Result<std::unique_ptr<SiteWorld>> world = surroundings_.open_world(path, *this);
  if (!world) return world.error();
  world_ = std::move(*world);
  return {};
}

double Site::time() const {
  return world_ != nullptr ? world_->time() : unix_seconds();
}

/// Transitively adds the devices of drivers that require these.
void Site::add_who_requires(std::vector<device::Address>& devices) const {
  const auto has = [](std::span<const device::Address> all, device::Address address) {
    return std::ranges::find(all, address) != all.end();
  };
  for (std::size_t i = 0; i < devices.size(); ++i) {
    for (const User& user : users_) {
      if (!has(user.devices, devices[i])) continue;
      for (const device::Address& provided : user.provided)
        if (!has(devices, provided)) devices.push_back(provided);
    }
  }
}

void Site::retire(std::vector<device::Address> devices) {
  add_who_requires(devices);
  if (world_ != nullptr)
    for (const device::Address& address : devices) world_->forget(address);
  surroundings_.post([this, devices = std::move(devices)] {
    for (const device::Address& address : devices) take_out(address);
  });
}

void Site::retire_later(std::vector<device::Address> devices) {
  if (world_ == nullptr) return retire(std::move(devices));
  world_->between_ticks([this, devices = std::move(devices)] { retire(devices); });
}

/// No effect if it is gone: it may depend on two retired devices.
void Site::take_out(device::Address address) {
  const auto found = devices_.find(address);
  if (found == devices_.end()) return;
  const device::DeviceId id = found->second.id;
  devices_.erase(found);
  surroundings_.retire_device(id);
}

std::string Site::shown(device::Address address) const {
  return address.robot == default_port_ ? device::describe_on_port(address) : device::describe(address);
}

Result<void> Site::check_provided(const User& user) const {
  for (const device::Address& wanted : user.devices) {
    if (devices_.contains(wanted)) continue;
    std::vector<std::string> names;
    for (const auto& [address, provided] : devices_) names.push_back(shown(address));
    const std::vector<std::string_view> words(names.begin(), names.end());
    return Error{user.where, fmt::format("nothing provides {}{}", in_quotes(shown(wanted)),
                                         did_you_mean(shown(wanted), words))};
  }
  return {};
}

Result<std::vector<const Site::User*>> Site::in_order_of_data() const {
  std::map<const device::Driver*, std::size_t> places;
  for (std::size_t i = 0; i < users_.size(); ++i) places[users_[i].driver] = i;
  const auto provider = [&](device::Address address) { return places.find(devices_.at(address).driver); };

  std::vector<std::vector<std::size_t>> required(users_.size());
  for (std::size_t i = 0; i < users_.size(); ++i) {
    for (const device::Address& address : users_[i].devices)
      if (const auto found = provider(address); found != places.end()) required[i].push_back(found->second);
  }
  const DataOrder data = data_order(required);
  if (!data.circle.empty()) return circle_error(data.circle);
  std::vector<const User*> users;
  for (const std::size_t place : data.order) users.push_back(&users_[place]);
  return users;
}

/// Error for a cycle: each user requires a device of the next, the last one of the first.
Error Site::circle_error(std::span<const std::size_t> circle) const {
  std::vector<std::string> devices;  // which each requires of the next
  for (std::size_t i = 0; i < circle.size() && i < kCircleShown; ++i) {
    const User& next = users_[circle[(i + 1) % circle.size()]];
    for (const device::Address& address : users_[circle[i]].devices) {
      if (devices_.at(address).driver != next.driver) continue;
      devices.push_back(in_quotes(shown(address)));
      break;
    }
  }
  if (circle.size() > kCircleShown) devices.push_back("...");
  return {users_[circle.front()].where,
          fmt::format("devices require each other in a circle: {}, which requires the first",
                      fmt::join(devices, ", which requires "))};
}

Result<void> Site::keep_open(device::Driver& driver, std::vector<device::DeviceId> devices,
                             std::string name) {
  always_on_.push_back(
      std::make_unique<AlwaysOn>(surroundings_, driver, std::move(devices), std::move(name)));
  return always_on_.back()->begin();
}

Result<void> Site::finish() {
  for (const User& user : users_)
    if (const Result<void> provided = check_provided(user); !provided) return provided.error();
  const Result<std::vector<const User*>> users = in_order_of_data();
  if (!users) return users.error();
  for (const User* user : *users) {
    for (std::size_t i = 0; i < user->devices.size(); ++i) {
      const ProvidedDevice& provided = devices_.at(user->devices[i]);
      user->client->use(i, provided.id, *provided.driver);
    }
    user->client->join(data_flow_);
    if (const Result<void> connected = user->connected(); !connected) return connected.error();
  }
  return {};
}

}  // namespace playhouse::drivers
