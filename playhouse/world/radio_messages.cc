#include "playhouse/world/radio_messages.h"

#include <algorithm>
#include <iterator>

#include "playhouse/base/limits.h"

namespace playhouse::world {

RadioMessages outgoing_of(const Wifis& wifis, WifiRow radio) {
  return {wifis.outgoing[radio], wifis.outgoing_bytes[radio]};
}

RadioMessages incoming_of(const Wifis& wifis, WifiRow radio) {
  return {wifis.incoming[radio], wifis.incoming_bytes[radio]};
}

bool are_whole(const RadioMessages& all) {
  std::size_t bytes = 0;
  for (const RadioMessage& message : all.messages) {
    if (message.size > limits::kRadioMessageBytes) return false;
    bytes += message.size;
  }
  return bytes == all.bytes.size();
}

bool send_message(World& world, WifiRow radio, ModelId to, std::span<const std::uint8_t> bytes) {
  if (bytes.size() > limits::kRadioMessageBytes) return false;
  Wifis& wifis = world.wifis;
  if (wifis.outgoing[radio].size() >= limits::kRadioSends) {
    ++wifis.dropped[radio];
    return false;
  }
  wifis.outgoing[radio].push_back({to, static_cast<std::uint32_t>(bytes.size())});
  std::ranges::copy(bytes, std::back_inserter(wifis.outgoing_bytes[radio]));
  return true;
}

void receive_message(Wifis& wifis, WifiRow radio, ModelId from, std::span<const std::uint8_t> bytes) {
  if (wifis.incoming[radio].size() >= limits::kRadioReceives) {
    ++wifis.dropped[radio];
    return;
  }
  wifis.incoming[radio].push_back({from, static_cast<std::uint32_t>(bytes.size())});
  std::ranges::copy(bytes, std::back_inserter(wifis.incoming_bytes[radio]));
}

}  // namespace playhouse::world
