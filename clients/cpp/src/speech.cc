#include "playhouse_client/speech.h"

#include <utility>

#include "playhouse/wire/codec.h"

namespace playhouse::client {

namespace speech = wire::speech;

Result<Speech> Speech::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, speech::kCode, index, access);
  if (!device) return device.error();
  return Speech(std::move(*device));
}

Result<void> Speech::say(std::string_view text) {
  return device_.command(speech::kCmdSay, speech::Cmd{wire::c_string(text)});
}

}  // namespace playhouse::client
