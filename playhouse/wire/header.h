#pragma once

/// The 40-byte header of every message.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "playhouse/base/limits.h"

namespace playhouse::wire {

/// Type of a message. Other values can arrive and are invalid.
enum class MessageType : std::uint8_t { kData = 1, kCmd, kReq, kAck, kSynch, kNack };

/// "DATA", "CMD", "REQ", "ACK", "SYNCH", "NACK", or "?".
std::string_view name(MessageType type);

/// Host field in messages of a local server: 127.0.0.1 in memory order read as
/// a big-endian number, as existing clients expect (wire bytes 01 00 00 7f).
inline constexpr std::uint32_t kLocalhost = 0x0100007F;

struct Header {
  std::uint32_t host = 0;
  std::uint32_t robot = 0;   // TCP port
  std::uint16_t interf = 0;  // interface code
  std::uint16_t index = 0;
  MessageType type = MessageType::kData;
  std::uint8_t subtype = 0;
  double timestamp = 0;  // s
  std::uint32_t seq = 0;
  std::uint32_t size = 0;  // bytes of body, as claimed by the sender

  friend bool operator==(const Header&, const Header&) = default;
};

void encode_header(const Header& header, std::span<std::byte, limits::kHeaderBytes> out);

/// Never fails: only the low bits of the four small fields count. `size` is not validated here.
Header decode_header(std::span<const std::byte, limits::kHeaderBytes> bytes);

}  // namespace playhouse::wire
