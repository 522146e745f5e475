#pragma once

/// Both ends of a reliable stream of texts over unreliable pieces, which may be
/// lost, duplicated and reordered; texts are delivered once and in order. Format:
/// datagram.h. Independent of packets: the sender is told which pieces were lost.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/packing.h"
#include "playhouse/base/result.h"

namespace playhouse::replicate {

/// Packet number of one end, from 1. Wide enough not to wrap at 8,000 packets a second.
using Seq = std::uint64_t;
inline constexpr Seq kSeqMost = Seq{1} << 53;

/// A text in its encoded form, shared by all recipients.
struct PackedText {
  bool packed = false;  // a zstd frame
  std::vector<std::byte> bytes;
};
std::shared_ptr<const PackedText> pack_text(std::string_view text);

struct Piece {
  std::uint64_t at = 0;
  std::uint32_t size = 0;
};

class StreamSender {
 public:
  /// Appends a text. `after`: see the stream format in datagram.h.
  void post(std::shared_ptr<const PackedText> text, Seq after);

  /// The next piece to send, at most so many bytes: lost data
  /// first, then new data within the window. Size 0: none.
  Piece next(std::size_t room);
  void write(const Piece& piece, Packer& pack) const;
  /// The packet with this piece was lost.
  void lost(const Piece& piece);
  /// The other end has received so many bytes. False: more than were sent.
  bool taken(std::uint64_t bytes);

  std::uint64_t posted() const { return posted_; }
  std::uint64_t taken() const { return taken_; }
  std::size_t waiting() const { return static_cast<std::size_t>(posted_ - taken_); }
  /// True if next() has something to send.
  bool ready() const;

 private:
  struct Segment {
    std::uint64_t at = 0;
    std::shared_ptr<const PackedText> bytes;
  };
  void append(std::shared_ptr<const PackedText> bytes);
  void clip_lost();

  std::deque<Segment> segments_;  // not yet taken, contiguous
  std::uint64_t posted_ = 0, sent_ = 0, taken_ = 0;
  std::map<std::uint64_t, std::uint64_t> lost_;  // begin and end
};

struct ReceivedText {
  Seq after = 0;
  std::string text;
};

class StreamReceiver {
 public:
  /// Limit on the unpacked length of a text.
  explicit StreamReceiver(std::size_t most) : most_(most) {}

  /// Accepts a piece. Fails on a protocol violation: beyond the window, or malformed texts.
  Result<void> take(std::uint64_t at, std::span<const std::byte> bytes);
  /// The next complete text, if any.
  Result<std::optional<ReceivedText>> next();
  std::uint64_t taken() const { return taken_; }

 private:
  const std::size_t most_;
  std::uint64_t taken_ = 0;
  // Reassembly window from taken_ on: bytes, and which were received.
  std::vector<std::byte> ahead_;
  std::vector<bool> came_;
  std::vector<std::byte> texts_;  // contiguous data, not yet read
  std::size_t read_ = 0;          // read offset
};

}  // namespace playhouse::replicate
