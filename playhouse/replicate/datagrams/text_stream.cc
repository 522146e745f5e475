#include "playhouse/replicate/datagrams/text_stream.h"

#include <zstd.h>

#include <algorithm>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"

namespace playhouse::replicate {
namespace {

constexpr std::size_t kWorthPacking = 256;
constexpr int kPackLevel = 3;
constexpr std::size_t kTextHeadBytes = 16;  // upper bound of a text's header

Error bad(std::string what) {
  return {"", std::move(what)};
}

Result<std::string> unpack(std::span<const std::byte> bytes, std::size_t most) {
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR || size > most)
    return bad("a text does not unpack");
  std::string text(static_cast<std::size_t>(size), '\0');
  const std::size_t got = ZSTD_decompress(text.data(), text.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(got) != 0 || got != size) return bad("a text does not unpack");
  return text;
}

}  // namespace

std::shared_ptr<const PackedText> pack_text(std::string_view text) {
  auto made = std::make_shared<PackedText>();
  const auto plain = std::as_bytes(std::span(text));
  if (text.size() >= kWorthPacking) {
    made->bytes.resize(ZSTD_compressBound(text.size()));
    const std::size_t size =
        ZSTD_compress(made->bytes.data(), made->bytes.size(), text.data(), text.size(), kPackLevel);
    made->packed = ZSTD_isError(size) == 0 && size < text.size();
    if (made->packed) made->bytes.resize(size);
  }
  if (!made->packed) made->bytes.assign(plain.begin(), plain.end());
  return made;
}

void StreamSender::post(std::shared_ptr<const PackedText> text, Seq after) {
  auto head = std::make_shared<PackedText>();
  Packer pack(head->bytes);
  pack.u8(text->packed ? 1 : 0);
  pack.varint(after);
  pack.varint(text->bytes.size());
  append(std::move(head));
  append(std::move(text));
}

void StreamSender::append(std::shared_ptr<const PackedText> bytes) {
  const std::size_t size = bytes->bytes.size();
  if (size == 0) return;
  segments_.push_back({posted_, std::move(bytes)});
  posted_ += size;
}

bool StreamSender::ready() const {
  return !lost_.empty() || (sent_ < posted_ && sent_ < taken_ + limits::kStreamWindowBytes);
}

Piece StreamSender::next(std::size_t room) {
  if (room == 0 || !ready()) return {};
  if (!lost_.empty()) {
    const auto [begin, end] = *lost_.begin();
    lost_.erase(lost_.begin());
    const std::uint64_t size = std::min<std::uint64_t>(room, end - begin);
    if (begin + size < end) lost_.emplace(begin + size, end);
    return {begin, static_cast<std::uint32_t>(size)};
  }
  const std::uint64_t end = std::min(posted_, taken_ + limits::kStreamWindowBytes);
  const std::uint64_t size = std::min<std::uint64_t>(room, end - sent_);
  return {std::exchange(sent_, sent_ + size), static_cast<std::uint32_t>(size)};
}

void StreamSender::write(const Piece& piece, Packer& pack) const {
  std::uint64_t at = piece.at;
  const std::uint64_t end = piece.at + piece.size;
  auto segment = std::ranges::upper_bound(segments_, at, {}, &Segment::at);
  PLAYHOUSE_ASSERT(segment != segments_.begin());
  for (--segment; at < end; ++segment) {
    const auto& bytes = segment->bytes->bytes;
    const std::uint64_t stop = std::min(end, segment->at + bytes.size());
    for (; at < stop; ++at) pack.u8(std::to_integer<std::uint8_t>(bytes[at - segment->at]));
  }
}

void StreamSender::lost(const Piece& piece) {
  if (piece.size == 0) return;
  std::uint64_t& end = lost_[piece.at];
  end = std::max(end, piece.at + piece.size);
  clip_lost();
}

bool StreamSender::taken(std::uint64_t bytes) {
  if (bytes > sent_) return false;
  if (bytes <= taken_) return true;
  taken_ = bytes;
  while (!segments_.empty() && segments_.front().at + segments_.front().bytes->bytes.size() <= taken_)
    segments_.pop_front();
  clip_lost();
  return true;
}

void StreamSender::clip_lost() {
  while (!lost_.empty() && lost_.begin()->first < taken_) {
    const std::uint64_t end = lost_.begin()->second;
    lost_.erase(lost_.begin());
    if (end <= taken_) continue;
    std::uint64_t& other = lost_[taken_];
    other = std::max(other, end);
  }
}

Result<void> StreamReceiver::take(std::uint64_t at, std::span<const std::byte> bytes) {
  const std::uint64_t end = at + bytes.size();
  if (end < at || end > taken_ + limits::kStreamWindowBytes)
    return bad("a piece of text is out of its window");
  if (end <= taken_) return {};
  if (at < taken_) {
    bytes = bytes.subspan(static_cast<std::size_t>(taken_ - at));
    at = taken_;
  }
  const auto first = static_cast<std::ptrdiff_t>(at - taken_);
  const std::size_t size = static_cast<std::size_t>(end - taken_);
  if (ahead_.size() < size) {
    ahead_.resize(size);
    came_.resize(size);
  }
  std::ranges::copy(bytes, ahead_.begin() + first);
  std::fill_n(came_.begin() + first, bytes.size(), true);
  const auto whole = std::ranges::find(came_, false) - came_.begin();
  texts_.insert(texts_.end(), ahead_.begin(), ahead_.begin() + whole);
  ahead_.erase(ahead_.begin(), ahead_.begin() + whole);
  came_.erase(came_.begin(), came_.begin() + whole);
  taken_ += static_cast<std::uint64_t>(whole);
  return {};
}

Result<std::optional<ReceivedText>> StreamReceiver::next() {
  const auto rest = std::span(texts_).subspan(read_);
  Unpacker in(rest);
  const std::uint8_t packed = in.u8();
  const std::uint64_t after = in.varint();
  const std::uint64_t size = in.varint();
  if (!in.ok()) {
    if (rest.size() >= kTextHeadBytes + 8) return bad("a text has no head");
    return std::optional<ReceivedText>();
  }
  if (packed > 1 || after > kSeqMost || size > most_) return bad("a text is invalid, or too long");
  if (in.left() < size) return std::optional<ReceivedText>();
  const auto bytes = rest.subspan(rest.size() - in.left(), static_cast<std::size_t>(size));
  Result<std::string> text = packed == 1
                                 ? unpack(bytes, most_)
                                 : std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (!text) return text.error();
  read_ += rest.size() - in.left() + bytes.size();
  if (read_ == texts_.size() || read_ > limits::kStreamWindowBytes) {
    texts_.erase(texts_.begin(), texts_.begin() + static_cast<std::ptrdiff_t>(read_));
    read_ = 0;
  }
  return std::optional(ReceivedText{after, std::move(*text)});
}

}  // namespace playhouse::replicate
