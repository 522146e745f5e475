#pragma once

/// What a robot says.

#include <string_view>

#include "playhouse/wire/generated/speech.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

class Speech {
 public:
  static Result<Speech> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// In place of what it said; "" says nothing.
  Result<void> say(std::string_view text);

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Speech(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
