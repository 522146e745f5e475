#include "playhouse/server/device_uses.h"

#include <algorithm>
#include <utility>

namespace playhouse::server {

void DeviceUses::close(device::DeviceId device, std::uint32_t session) {
  const auto found = uses_.find(device);
  if (found == uses_.end()) return;
  found->second.sessions.erase(session);
  drop_if_unused(found);
}

void DeviceUses::answer(device::DeviceId device, std::uint64_t ticket) {
  const auto found = uses_.find(device);
  if (found == uses_.end()) return;
  found->second.tickets.erase(ticket);
  drop_if_unused(found);
}

void DeviceUses::release(device::DeviceId device, device::Driver& holder) {
  const auto found = uses_.find(device);
  if (found == uses_.end()) return;
  std::vector<device::Driver*>& holders = found->second.holders;
  if (const auto hold = std::ranges::find(holders, &holder); hold != holders.end()) holders.erase(hold);
  drop_if_unused(found);
}

DeviceUses::DeviceUse DeviceUses::take(device::DeviceId device) {
  auto node = uses_.extract(device);
  return node.empty() ? DeviceUse() : std::move(node.mapped());
}

void DeviceUses::drop_if_unused(Uses::iterator place) {
  const DeviceUse& use = place->second;
  if (use.sessions.empty() && use.tickets.empty() && use.holders.empty()) uses_.erase(place);
}

}  // namespace playhouse::server
