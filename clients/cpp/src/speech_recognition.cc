#include "playhouse_client/speech_recognition.h"

#include <utility>

#include "playhouse/wire/codec.h"

namespace playhouse::client {

namespace heard = wire::speech_recognition;

Result<SpeechRecognition> SpeechRecognition::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, heard::kCode, index, access);
  if (!device) return device.error();
  return SpeechRecognition(std::move(*device));
}

SpeechRecognition::SpeechRecognition(Device device) : device_(std::move(device)) {
  device_.keep(kWaiting);
}

std::vector<std::string> SpeechRecognition::take_texts() {
  std::vector<std::string> taken;
  for (const std::vector<std::byte>& body : device_.take_kept()) {
    const heard::Data data = *wire::decode<heard::Data>(body);  // validated on arrival
    taken.emplace_back(wire::text(data.text));
  }
  return taken;
}

}  // namespace playhouse::client
