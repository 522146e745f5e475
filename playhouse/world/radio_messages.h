#pragma once

/// Messages between radios: outgoing messages are queued in columns, the bytes
/// of all of them and a list of lengths, until the next tick delivers them.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// A queue: messages in order, and their concatenated bytes.
struct RadioMessages {
  const std::vector<RadioMessage>& messages;
  const std::vector<std::uint8_t>& bytes;
};
RadioMessages outgoing_of(const Wifis& wifis, WifiRow radio);
RadioMessages incoming_of(const Wifis& wifis, WifiRow radio);

/// True if the lengths add up to the bytes, and no message is too long.
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

/// Queues a message for the next tick: to one radio, or broadcast if `to` is
/// none. False, without effect, if it is longer than limits::kRadioMessageBytes
/// or if limits::kRadioSends are queued already, which is counted.
bool send_message(World& world, WifiRow radio, ModelId to, std::span<const std::uint8_t> bytes);

/// Appends a received message. Beyond limits::kRadioReceives per tick it is
/// dropped and counted. Allocates until the lists have reached their size.
void receive_message(Wifis& wifis, WifiRow radio, ModelId from, std::span<const std::uint8_t> bytes);

}  // namespace playhouse::world
