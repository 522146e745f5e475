#pragma once

/// Messages of bytes: of a simulated radio, those between robots; of other drivers what they make of them.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/wire/generated/opaque.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

class Opaque {
 public:
  /// Messages kept for take_messages(); of more the oldest are lost.
  static constexpr std::size_t kWaiting = 1024;

  static Result<Opaque> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  // Messages hold any bytes, NUL as well.

  /// To the driver; a radio sends it to all who hear it. An error, and nothing is sent, if it is longer than
  /// the wire takes (32 MiB).
  Result<void> send(std::string_view message);

  /// Of a radio: to the one of this network address, "" for all who hear it. Returns when it waits to be
  /// sent. An error if there is no such radio, if the message is too long, or if too many wait.
  Result<void> send_to(std::string_view address, std::string_view message);

  /// Those that Client::read() brought since the last call, in their order.
  std::vector<std::string> take_messages();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Opaque(Device device);

  Device device_;
};

}  // namespace playhouse::client
