#pragma once

/// SimulatedDriver: the driver of all devices of a simulated world. Dispatches
/// messages to devices, watches a model while its device is open, and uses it once it is commanded.

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "playhouse/bridge/simulated/model_devices.h"
#include "playhouse/bridge/simulated/simulated_device.h"
#include "playhouse/device/driver.h"

namespace playhouse::drivers {

class SimulatedDriver final : public device::Driver {
 public:
  /// `name` is reported to clients.
  SimulatedDriver(ModelDevices& devices, std::string name)
      : open_(devices.sources()), requests_(devices.simulation().requests()), name_(std::move(name)) {}

  /// Registers a device at `id`, until forget(). Io thread too.
  void add(device::DeviceId id, std::shared_ptr<SimulatedDevice> device);
  std::size_t device_count() const;  // any thread

  std::string_view name() const override { return name_; }
  Result<void> start(device::DeviceId id) override;
  void stop(device::DeviceId id) override;
  void forget(device::DeviceId id) override;
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId id, std::uint8_t type, std::uint8_t subtype) const override;
  void barrier(device::Replier replier) override;

 private:
  using Device = std::shared_ptr<SimulatedDevice>;  // shared with changes queued for the tick thread
  Device find(device::DeviceId id) const;
  void note_act(const Device& device);

  Sources& open_;  // tick thread
  run::Requests& requests_;
  std::string name_;
  mutable std::mutex mutex_;  // guards what follows
  std::map<device::DeviceId, Device> devices_;
};

}  // namespace playhouse::drivers
