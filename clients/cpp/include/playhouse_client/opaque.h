#pragma once

/// Byte messages: radio messages between robots for a simulated radio; driver-defined for other drivers.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/wire/generated/opaque.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

class Opaque {
 public:
  /// Capacity of the queue for take_messages(); overflow drops the oldest.
  static constexpr std::size_t kWaiting = 1024;

  static Result<Opaque> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  // Messages are arbitrary bytes, NUL included.

  /// Sends to the driver; a radio broadcasts it to all radios in range. An error, and nothing is sent, if it
  /// exceeds the protocol's limit (32 MiB).
  Result<void> send(std::string_view message);

  /// Radio only: sends to the radio of this network address; "" broadcasts. Returns once the message
  /// is queued. An error if there is no such radio, the message is too long, or the queue is full.
  Result<void> send_to(std::string_view address, std::string_view message);

  /// The messages received by Client::read() since the last call, in order.
  std::vector<std::string> take_messages();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Opaque(Device device);

  Device device_;
};

}  // namespace playhouse::client
