#pragma once

/// Speech output of a robot.

#include <string_view>

#include "playhouse/wire/generated/speech.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

class Speech {
 public:
  static Result<Speech> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// Replaces the current text; "" clears it.
  Result<void> say(std::string_view text);

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Speech(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
