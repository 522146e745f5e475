#include "playhouse/drivers/always_on.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/drivers/back_off.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

AlwaysOn::AlwaysOn(Host& surroundings, device::Driver& driver, std::vector<device::DeviceId> devices,
                   std::string name)
    : surroundings_(surroundings), driver_(driver), devices_(std::move(devices)), name_(std::move(name)) {}

Result<void> AlwaysOn::begin() {
  std::vector<device::DeviceId> waiting;
  for (const device::DeviceId device : devices_) {
    if (!driver_.ready(device)) {
      waiting.push_back(device);
    } else if (const Result<void> held = surroundings_.hold(device, nullptr); !held) {
      return held;
    }
  }
  devices_ = std::move(waiting);
  prepare_all();
  return {};
}

void AlwaysOn::prepare_all() {
  for (const device::DeviceId device : std::vector(devices_))
    driver_.prepare(device, [this, device](const Result<void>& outcome) { prepared(device, outcome); });
}

/// After a loss its driver opens again what it uses of the other server.
void AlwaysOn::prepared(device::DeviceId device, const Result<void>& outcome) {
  if (std::ranges::find(devices_, device) == devices_.end()) return;  // an earlier attempt has come true
  if (!outcome) return wait(outcome.error().line());
  if (const Result<void> held = surroundings_.hold(device, nullptr); !held) return wait(held.error().line());
  std::erase(devices_, device);
  if (devices_.empty() && !told_.empty()) log::info("{} has started", name_);
}

void AlwaysOn::wait(const std::string& why) {
  if (std::exchange(told_, why) != why) log::warn("{} waits: {}", name_, why);
  if (next_attempt_) return;
  wait_ = next_wait(wait_);
  next_attempt_ = surroundings_.network().after(wait_, [this] {
    next_attempt_.reset();
    prepare_all();
  });
}

}  // namespace playhouse::drivers
