#include "playhouse/device/device_table.h"

#include <fmt/format.h>

#include <algorithm>
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
  return fmt::format("{}:{}", address.robot, describe_on_port(address));
}

std::string describe_on_port(Address address) {
  const wire::InterfaceDef* interf = wire::find_interface(address.interf);
  return interf ? fmt::format("{}:{}", interf->name, address.index)
                : fmt::format("{}:{}", address.interf, address.index);
}

void DeviceTable::end() {
  if (std::exchange(ending_, true)) return;
  for (const auto& [robot, ids] : by_robot_) {
    for (const DeviceId id : ids) {
      if (const ServedDevice& entry = (*this)[id]; entry.users > 0) entry.driver->stop(id);
    }
  }
}

Result<DeviceId> DeviceTable::add(Address address, Driver& driver) {
  if (address.interf == kPlayerInterface) return Error{describe(address), "is the server itself"};
  if (driver.name().size() >= limits::kDriverNameBytes) {
    return Error{std::string(driver.name()),
                 fmt::format("a driver name has less than {} bytes", limits::kDriverNameBytes)};
  }
  const DeviceId id{next_row_};
  if (!id.valid()) return Error{describe(address), "there have been too many devices"};
  if (!by_address_.emplace(address, id).second)
    return Error{describe(address), "there is such a device already"};
  ++next_row_;
  entries_[id] = {address, &driver, 0};
  by_robot_[address.robot].push_back(id);
  return id;
}

// forget() comes last: the driver may query the table, which must not have the device any more.
void DeviceTable::retire(DeviceId id) {
  const auto found = entries_.find(id);
  PLAYHOUSE_ASSERT(found != entries_.end());
  const ServedDevice entry = found->second;
  entries_.erase(found);
  by_address_.erase(entry.address);
  const auto of_robot = by_robot_.find(entry.address.robot);
  std::vector<DeviceId>& ids = of_robot->second;
  ids.erase(std::lower_bound(ids.begin(), ids.end(), id));
  if (ids.empty()) by_robot_.erase(of_robot);
  if (entry.users > 0) entry.driver->stop(id);
  entry.driver->forget(id);
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

// The device of the wanted interface with the nearest index.
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

const DeviceTable::ServedDevice& DeviceTable::operator[](DeviceId id) const {
  const auto found = entries_.find(id);
  PLAYHOUSE_ASSERT(found != entries_.end());
  return found->second;
}

std::span<const DeviceId> DeviceTable::devices_of(std::uint32_t robot) const {
  const auto found = by_robot_.find(robot);
  return found == by_robot_.end() ? std::span<const DeviceId>() : found->second;
}

Result<void> DeviceTable::open(DeviceId id) {
  const auto found = entries_.find(id);
  PLAYHOUSE_ASSERT(found != entries_.end());
  ServedDevice& entry = found->second;
  if (entry.users == 0) {
    if (Result<void> started = entry.driver->start(id); !started) return started;
  }
  ++entry.users;
  return {};
}

void DeviceTable::close(DeviceId id) {
  if (ending_) return;
  const auto found = entries_.find(id);
  PLAYHOUSE_ASSERT(found != entries_.end() && found->second.users > 0);
  ServedDevice& entry = found->second;
  if (--entry.users == 0) entry.driver->stop(id);
}

}  // namespace playhouse::device
