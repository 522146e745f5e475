#include "playhouse/bridge/simulated/simulated_driver.h"

#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/bridge/settings/device_properties.h"

namespace playhouse::drivers {

void SimulatedDriver::add(device::DeviceId id, Device device) {
  device->set_id(id);
  const std::lock_guard lock(mutex_);
  devices_[id] = std::move(device);
}

void SimulatedDriver::forget(device::DeviceId id) {
  const std::lock_guard lock(mutex_);
  devices_.erase(id);
}

std::size_t SimulatedDriver::device_count() const {
  const std::lock_guard lock(mutex_);
  return devices_.size();
}

/// None once it has retired: a driver that uses it may not have been notified yet.
SimulatedDriver::Device SimulatedDriver::find(device::DeviceId id) const {
  const std::lock_guard lock(mutex_);
  const auto found = devices_.find(id);
  return found == devices_.end() ? nullptr : found->second;
}

Result<void> SimulatedDriver::start(device::DeviceId id) {
  const Device device = find(id);
  PLAYHOUSE_ASSERT(device != nullptr);
  const auto begin = [device, &open = open_](world::Journal& journal) {
    open.add(device);
    device->begin(journal);
  };
  // Opening a device at the end of a run is no error: the client is notified of the end next.
  if (!requests_.post(begin, device->robot()) && !requests_.closed())
    return Error{"", "too many requests are waiting for the tick"};
  return {};
}

void SimulatedDriver::stop(device::DeviceId id) {
  const Device device = find(id);
  PLAYHOUSE_ASSERT(device != nullptr);
  device->forget_acts();
  requests_.post_always(
      [device, &open = open_](world::Journal& journal) {
        open.remove(*device);
        device->end(journal);
      },
      device->robot());
}

device::Taken SimulatedDriver::command(const device::Message& message) {
  const Device device = find(message.device);
  if (device == nullptr || !device->serves(message.type, message.subtype)) return device::Taken::kNo;
  if (requests_.is_reserved(device->model())) return device::Taken::kRefused;
  const device::Taken taken = device->command(message);
  if (taken != device::Taken::kNo && device->commands_act()) note_act(device);
  return taken;
}

void SimulatedDriver::note_act(const Device& device) {
  if (device->is_first_act())
    requests_.post_always([device](world::Journal& journal) { device->use(journal); }, device->robot());
}

void SimulatedDriver::request(const device::Message& message, device::Replier replier) {
  const Device device = find(message.device);
  if (device == nullptr) return;
  if (is_property_request(message.type, message.subtype))
    return answer_property_request(device, message, std::move(replier));
  if (!device->serves(message.type, message.subtype)) return;
  if (device->acts(message.subtype) && requests_.is_reserved(device->model())) return;
  if (device->acts(message.subtype)) note_act(device);
  device->request(message, std::move(replier));
}

bool SimulatedDriver::capable(device::DeviceId id, std::uint8_t type, std::uint8_t subtype) const {
  const Device device = find(id);
  if (device == nullptr) return false;
  return is_property_request(type, subtype) ? device->model().valid() : device->serves(type, subtype);
}

void SimulatedDriver::barrier(device::Replier replier) {
  auto shared = std::make_shared<device::Replier>(std::move(replier));  // std::function must be copyable
  requests_.post_always([shared](world::Journal&) { shared->ack(); }, {});
}

}  // namespace playhouse::drivers
