#pragma once

/// Analog inputs and outputs; of Playhouse a custom model: its readings are inputs, its commands outputs.

#include <cstdint>
#include <vector>

#include "playhouse/wire/generated/aio.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

class Aio {
 public:
  static Result<Aio> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// One per input, in V; empty before the first data.
  std::vector<double> voltages() const;

  /// Sets one output, in V. An error if that is no finite number or more than a float holds; nothing is sent
  /// then.
  Result<void> set(std::uint32_t output, double voltage);

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Aio(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
