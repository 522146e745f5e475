#pragma once

/// Frame: an outgoing message, encoded once and
/// shared by all sessions that send it. A value.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "playhouse/net/network.h"
#include "playhouse/wire/header.h"

namespace playhouse::server {

struct Frame {
  net::SharedBytes bytes = {};  // header and body
  std::uint16_t interf = 0;
  std::uint16_t index = 0;
  wire::MessageType type = wire::MessageType::kData;
  std::uint8_t subtype = 0;

  bool is_answer() const { return type == wire::MessageType::kAck || type == wire::MessageType::kNack; }
  /// Key for replacement: equal for messages that may replace each other in a session's queue.
  std::uint64_t kind() const {
    return std::uint64_t{interf} << 32 | std::uint64_t{index} << 16 |
           std::uint64_t{static_cast<std::uint8_t>(type)} << 8 | subtype;
  }
};

/// Total bytes of a server's live frames, in queues or in
/// connections. A shared frame counts once. Owners: the
/// server and each of its frames, which may outlive it.
using FrameBytes = std::shared_ptr<std::size_t>;

/// The frame, counted in `total` during its lifetime.
Frame counted(Frame frame, const FrameBytes& total);

/// The copy of a message that has this number in `seq`.
std::vector<std::byte> numbered(std::span<const std::byte> message, std::uint32_t number);

/// Sets `header.size` from the body, at most limits::kBodyBytes (asserted).
Frame make_frame(wire::Header header, std::span<const std::byte> body);

}  // namespace playhouse::server
