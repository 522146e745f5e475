#pragma once

/// Messages between radios: what somebody has a radio send waits in columns, as bytes of all messages and a
/// list of how long each is, until the next tick carries it to those who hear it.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// Messages [in order], and the bytes of all of them.
struct RadioMessages {
  const std::vector<RadioMessage>& messages;
  const std::vector<std::uint8_t>& bytes;
};
RadioMessages outgoing_of(const Wifis& wifis, WifiRow radio);
RadioMessages incoming_of(const Wifis& wifis, WifiRow radio);

/// Whether the bytes are those of the messages, and no message is too long.
bool are_whole(const RadioMessages& messages);

/// Calls visit(message, bytes) for each.
template <typename Visit>
void each_message(const RadioMessages& all, const Visit& visit) {
  std::size_t begin = 0;
  for (const RadioMessage& message : all.messages) {
    visit(message, std::span(all.bytes).subspan(begin, message.size));
    begin += message.size;
  }
}

/// Has the radio send a message in the next tick: to one other, or, with none, to all who hear it. False, and
/// nothing is sent, if it is longer than limits::kRadioMessageBytes or, which is counted, if
/// limits::kRadioSends wait already.
bool send_message(World& world, WifiRow radio, ModelId to, std::span<const std::uint8_t> bytes);

/// The radio has received a message. At limits::kRadioReceives in a tick it is dropped, and counted.
/// Allocates until its lists have their size.
void receive_message(Wifis& wifis, WifiRow radio, ModelId from, std::span<const std::uint8_t> bytes);

}  // namespace playhouse::world
