#pragma once

/// Texts as one stream of bytes in pieces, both ends of it: pieces may be lost, doubled and come in any
/// order, texts come out once each and in order. Drawn in datagram.h. Knows no packets: who sends says which
/// pieces were lost.

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

/// Number of a packet of one end, from 1 on. Wide enough never to begin anew, at 8,000 packets a second.
using Seq = std::uint64_t;
inline constexpr Seq kSeqMost = Seq{1} << 53;

/// A text as it travels, made once for all who get it.
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
  /// Behind all that was posted. `after`: see the stream format in datagram.h.
  void post(std::shared_ptr<const PackedText> text, Seq after);

  /// What goes next, at most so many bytes: what was lost, or else what is new and within the window. Size 0:
  /// nothing.
  Piece next(std::size_t room);
  void write(const Piece& piece, Packer& pack) const;
  /// The packet of this piece did not come.
  void lost(const Piece& piece);
  /// The other end has so many bytes. False: more than were sent.
  bool taken(std::uint64_t bytes);

  std::uint64_t posted() const { return posted_; }
  std::uint64_t taken() const { return taken_; }
  std::size_t waiting() const { return static_cast<std::size_t>(posted_ - taken_); }
  /// Something could go now.
  bool ready() const;

 private:
  struct Segment {
    std::uint64_t at = 0;
    std::shared_ptr<const PackedText> bytes;
  };
  void append(std::shared_ptr<const PackedText> bytes);
  void clip_lost();

  std::deque<Segment> segments_;  // what is not taken, and no gap between them
  std::uint64_t posted_ = 0, sent_ = 0, taken_ = 0;
  std::map<std::uint64_t, std::uint64_t> lost_;  // begin and end
};

struct ReceivedText {
  Seq after = 0;
  std::string text;
};

class StreamReceiver {
 public:
  /// A text is at most so long, unpacked.
  explicit StreamReceiver(std::size_t most) : most_(most) {}

  /// Fails for what a sender never sends: beyond the window, or texts that are none.
  Result<void> take(std::uint64_t at, std::span<const std::byte> bytes);
  /// The next whole text.
  Result<std::optional<ReceivedText>> next();
  std::uint64_t taken() const { return taken_; }

 private:
  const std::size_t most_;
  std::uint64_t taken_ = 0;
  // From taken_ on, within the window: bytes, and which of them came.
  std::vector<std::byte> ahead_;
  std::vector<bool> came_;
  std::vector<std::byte> texts_;  // what came without a gap and was not asked for
  std::size_t read_ = 0;          // of them
};

}  // namespace playhouse::replicate
