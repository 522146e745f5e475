#include "playhouse/device/device_table.h"

#include <fmt/format.h>

#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"
#include "playhouse/wire/messages.h"

namespace playhouse::device {
namespace {

constexpr std::uint16_t kPlayerInterface = 1;

std::string describe(Address address) {
  const wire::InterfaceDef* interf = wire::find_interface(address.interf);
  return interf ? fmt::format("{}:{}:{}", address.robot, interf->name, address.index)
                : fmt::format("{}:{}:{}", address.robot, address.interf, address.index);
}

}  // namespace

DeviceTable::~DeviceTable() {
  ending_ = true;
  for (std::uint32_t row = 0; row < entries_.size(); ++row) {
    if (entries_[row].users > 0) entries_[row].driver->stop(DeviceId{row}, {});
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

const DeviceTable::Entry& DeviceTable::operator[](DeviceId id) const {
  PLAYHOUSE_ASSERT(id.row < entries_.size());
  return entries_[id.row];
}

std::span<const DeviceId> DeviceTable::devices_of(std::uint32_t robot) const {
  const auto found = by_robot_.find(robot);
  return found == by_robot_.end() ? std::span<const DeviceId>() : found->second;
}

Result<void> DeviceTable::open(DeviceId id, Receipt receipt) {
  PLAYHOUSE_ASSERT(id.row < entries_.size());
  Entry& entry = entries_[id.row];
  if (entry.users == 0) {
    if (Result<void> started = entry.driver->start(id, std::move(receipt)); !started) return started;
  }
  ++entry.users;
  return {};
}

void DeviceTable::close(DeviceId id, Receipt receipt) {
  if (ending_) return;
  PLAYHOUSE_ASSERT(id.row < entries_.size() && entries_[id.row].users > 0);
  Entry& entry = entries_[id.row];
  if (--entry.users == 0) entry.driver->stop(id, std::move(receipt));
}

}  // namespace playhouse::device
