#pragma once

/// The 40 bytes before every message body.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "playhouse/base/limits.h"

namespace playhouse::wire {

/// What a message is. Other numbers can arrive; they mean nothing.
enum class MessageType : std::uint8_t { kData = 1, kCmd, kReq, kAck, kSynch, kNack };

/// "DATA", "CMD", "REQ", "ACK", "SYNCH", "NACK", or "?".
std::string_view name(MessageType type);

/// Host number that a server on this machine puts into what it sends: 127.0.0.1 with its bytes in memory order read
/// as a big-endian number, as existing clients have always been told (wire bytes 01 00 00 7f).
inline constexpr std::uint32_t kLocalhost = 0x0100007F;

struct Header {
  std::uint32_t host = 0;
  std::uint32_t robot = 0;   // TCP port
  std::uint16_t interf = 0;  // interface code
  std::uint16_t index = 0;
  MessageType type = MessageType::kData;
  std::uint8_t subtype = 0;
  double timestamp = 0;      // s
  std::uint32_t seq = 0;
  std::uint32_t size = 0;    // bytes of body that follow, as claimed by the sender

  friend bool operator==(const Header&, const Header&) = default;
};

void encode_header(const Header& header, std::span<std::byte, limits::kHeaderBytes> out);

/// Never fails: of the four small fields only the low bits count. `size` is not checked here.
Header decode_header(std::span<const std::byte, limits::kHeaderBytes> bytes);

}  // namespace playhouse::wire
