#include "playhouse/device/device_table.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"
#include "playhouse/wire/messages.h"

namespace playhouse::device {
namespace {

constexpr std::uint16_t kPlayerInterface = 1;

}  // namespace

std::string describe(Address address) {
  const wire::InterfaceDef* interf = wire::find_interface(address.interf);
  return interf ? fmt::format("{}:{}:{}", address.robot, interf->name, address.index)
                : fmt::format("{}:{}:{}", address.robot, address.interf, address.index);
}

DeviceTable::~DeviceTable() {
  ending_ = true;
  for (std::uint32_t row = 0; row < entries_.size(); ++row) {
    if (entries_[row].users > 0) entries_[row].driver->stop(DeviceId{row});
  }
}

Result<DeviceId> DeviceTable::add(Address address, Driver& driver) {
  if (address.interf == kPlayerInterface) return Error{describe(address), "is the server itself"};
  if (driver.name().size() >= limits::kDriverNameBytes) {
    return Error{std::string(driver.name()),
                 fmt::format("a driver name has less than {} bytes", limits::kDriverNameBytes)};
  }
  const DeviceId id{static_cast<std::uint32_t>(entries_.size())};
  if (!by_address_.emplace(address, id).second)
    return Error{describe(address), "there is such a device already"};
  entries_.push_back({address, &driver, 0});
  by_robot_[address.robot].push_back(id);
  return id;
}

DeviceId DeviceTable::find(Address address) const {
  const auto found = by_address_.find(address);
  return found == by_address_.end() ? DeviceId{} : found->second;
}

std::string DeviceTable::why_missing(Address address) const {
  std::optional<Address> nearest = nearest_on(address.robot, address);
  for (auto port = by_robot_.begin(); !nearest && port != by_robot_.end(); ++port)
    nearest = nearest_on(port->first, address);
  return nearest ? "no such device, the nearest is " + describe(*nearest)
                 : "no such device, and none of its interface";
}

// The device of the wanted interface whose index differs the least.
std::optional<Address> DeviceTable::nearest_on(std::uint32_t robot, Address wanted) const {
  const auto fits = [&](Address address) {
    return address.robot == robot && address.interf == wanted.interf;
  };
  const auto above = by_address_.lower_bound({robot, wanted.interf, wanted.index});
  std::optional<Address> nearest;
  if (above != by_address_.end() && fits(above->first)) nearest = above->first;
  if (above == by_address_.begin()) return nearest;
  const Address below = std::prev(above)->first;
  if (fits(below) && (!nearest || wanted.index - below.index <= nearest->index - wanted.index))
    nearest = below;
  return nearest;
}

const DeviceTable::Entry& DeviceTable::operator[](DeviceId id) const {
  PLAYHOUSE_ASSERT(id.row < entries_.size());
  return entries_[id.row];
}

std::span<const DeviceId> DeviceTable::devices_of(std::uint32_t robot) const {
  const auto found = by_robot_.find(robot);
  return found == by_robot_.end() ? std::span<const DeviceId>() : found->second;
}

Result<void> DeviceTable::open(DeviceId id) {
  PLAYHOUSE_ASSERT(id.row < entries_.size());
  Entry& entry = entries_[id.row];
  if (entry.users == 0) {
    if (Result<void> started = entry.driver->start(id); !started) return started;
  }
  ++entry.users;
  return {};
}

void DeviceTable::close(DeviceId id) {
  if (ending_) return;
  PLAYHOUSE_ASSERT(id.row < entries_.size() && entries_[id.row].users > 0);
  Entry& entry = entries_[id.row];
  if (--entry.users == 0) entry.driver->stop(id);
}

}  // namespace playhouse::device
