#pragma once

/// Analog I/O. In Playhouse, a custom model: its readings are the inputs, its commands the outputs.

#include <cstdint>
#include <vector>

#include "playhouse/wire/generated/aio.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

class Aio {
 public:
  static Result<Aio> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// One voltage per input [V]; empty before the first data.
  std::vector<double> voltages() const;

  /// Sets one output [V]. An error, and nothing is sent, if the voltage is not finite or exceeds the range of
  /// float.
  Result<void> set(std::uint32_t output, double voltage);

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Aio(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
