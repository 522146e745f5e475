#pragma once

/// Speech input of a robot: the texts it hears from others.

#include <cstddef>
#include <string>
#include <vector>

#include "playhouse/wire/generated/speech_recognition.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

class SpeechRecognition {
 public:
  /// Capacity of the queue for take_texts(); overflow drops the oldest.
  static constexpr std::size_t kWaiting = 1024;

  static Result<SpeechRecognition> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The texts received by Client::read() since the last call, in order.
  std::vector<std::string> take_texts();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit SpeechRecognition(Device device);

  Device device_;
};

}  // namespace playhouse::client
