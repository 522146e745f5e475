#pragma once

/// What others say, as a robot hears it.

#include <cstddef>
#include <string>
#include <vector>

#include "playhouse/wire/generated/speech_recognition.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

class SpeechRecognition {
 public:
  /// Texts kept for take_texts(); of more the oldest are lost.
  static constexpr std::size_t kWaiting = 1024;

  static Result<SpeechRecognition> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// Those that Client::read() brought since the last call, in their order.
  std::vector<std::string> take_texts();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit SpeechRecognition(Device device);

  Device device_;
};

}  // namespace playhouse::client
