#include "playhouse/cluster/stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/packing.h"

namespace playhouse::cluster {
namespace {

constexpr std::size_t kHeadBytes = 5;           // size of the body and type
constexpr std::size_t kPieceBytes = 256 << 10;  // received at once
constexpr double kLookForStop = 0.05;           // s between looks at Until::stopped
constexpr Seconds kRestOfMessage{30};           // for what has begun

}  // namespace

Until until(double now, Seconds patience, std::size_t bytes, const std::atomic<bool>* stopped) {
  return {now + patience.count() + static_cast<double>(bytes) / limits::kClusterBytesPerSecond, stopped};
}

Result<MessageStream> MessageStream::connect(net::PolledNetwork& network, const std::string& host,
                                             std::uint16_t port, Seconds patience) {
  Result<std::unique_ptr<net::PolledStream>> bytes = network.connect(host, port, patience.count());
  if (!bytes) return bytes.error();
  return MessageStream(network, std::move(*bytes), SIZE_MAX);
}

/// False: the time is over.
bool MessageStream::wait_for(bool reads, bool writes, const Until& until) {
  const net::PollWish wish{bytes_.get(), reads, writes};
  for (;;) {
    const double look = until.stopped != nullptr ? network_->now() + kLookForStop : until.deadline;
    if (network_->wait({&wish, 1}, nullptr, std::min(look, until.deadline))) return true;
    if (network_->now() >= until.deadline) return false;
    if (until.stopped != nullptr && *until.stopped) return false;
  }
}

void MessageStream::queue(NodeMessageType type, std::shared_ptr<const Bytes> body) {
  Bytes head;
  Packer(head).u32(static_cast<std::uint32_t>(body->size()));
  Packer(head).u8(static_cast<std::uint8_t>(type));
  queued_.push_back(std::make_shared<const Bytes>(std::move(head)));
  if (!body->empty()) queued_.push_back(std::move(body));
}

Result<std::size_t> MessageStream::flush(std::size_t most) {
  std::size_t all = 0;
  while (!queued_.empty() && all < most) {
    const std::span<const std::byte> left = std::span(*queued_.front()).subspan(sent_);
    const std::span<const std::byte> part = left.first(std::min(left.size(), most - all));
    const Result<std::size_t> sent = bytes_->send({&part, 1});
    if (!sent) return sent.error();
    if (*sent == 0) break;
    all += *sent;
    sent_ += *sent;
    if (sent_ < queued_.front()->size()) continue;
    queued_.pop_front();
    sent_ = 0;
  }
  return all;
}

Result<void> MessageStream::send(NodeMessageType type, std::initializer_list<std::span<const std::byte>> body,
                                 Seconds patience) {
  std::size_t size = 0;
  for (const std::span<const std::byte> piece : body) size += piece.size();
  return send(type, std::span(body), until(network_->now(), patience, size));
}

Result<void> MessageStream::send(NodeMessageType type, std::span<const std::span<const std::byte>> body,
                                 Until until) {
  std::size_t size = 0;
  for (const std::span<const std::byte> piece : body) size += piece.size();
  if (size > UINT32_MAX) return Error{"", "a message is larger than 4 GiB"};
  Bytes head;
  Packer(head).u32(static_cast<std::uint32_t>(size));
  Packer(head).u8(static_cast<std::uint8_t>(type));
  std::vector<std::span<const std::byte>> parts;
  for (const auto& queued : queued_)
    parts.push_back(std::span(*queued).subspan(queued == queued_.front() ? sent_ : 0));
  parts.emplace_back(head);
  for (const std::span<const std::byte> piece : body)
    if (!piece.empty()) parts.push_back(piece);
  const Result<void> sent = send_all(parts, size, until);
  if (!sent) return sent;
  queued_.clear();
  sent_ = 0;
  return {};
}

/// None of the parts is empty. `size`: of the message, for the error.
Result<void> MessageStream::send_all(std::span<std::span<const std::byte>> parts, std::size_t size,
                                     const Until& until) {
  while (!parts.empty()) {
    const Result<std::size_t> sent = bytes_->send(parts);
    if (!sent) return sent.error();
    std::size_t left = *sent;
    for (; !parts.empty() && left >= parts.front().size(); parts = parts.subspan(1))
      left -= parts.front().size();
    if (parts.empty()) break;
    parts.front() = parts.front().subspan(left);
    if (*sent > 0) continue;
    // Receives meanwhile: the peer may wait for that before it reads.
    if (network_->now() >= until.deadline || !wait_for(has_room(), true, until))
      return Error{"", fmt::format("has not taken {} bytes in time", size)};
    if (!has_room()) continue;
    if (const Result<void> received = receive(); !received) return received;
  }
  return {};
}

Result<void> MessageStream::receive() {
  in_.erase(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(begin_));
  begin_ = 0;
  for (;;) {
    const std::size_t before = in_.size();
    in_.resize(before + kPieceBytes);
    const Result<std::size_t> got = bytes_->receive(std::span(in_).subspan(before));
    in_.resize(before + (got ? *got : 0));
    if (!got) return got.error();
    if (*got < kPieceBytes) return {};
    if (!has_room()) return {};  // next() looks at it first
  }
}

Result<std::optional<NodeMessage>> MessageStream::next() {
  const std::span<const std::byte> bytes = std::span(in_).subspan(begin_);
  if (bytes.size() < kHeadBytes) return std::optional<NodeMessage>();
  Unpacker head(bytes);
  const std::uint32_t size = head.u32();
  const std::uint8_t type = head.u8();
  if (size > limit_) return Error{"", fmt::format("sent a message of {} bytes, {} at most", size, limit_)};
  if (type < static_cast<std::uint8_t>(NodeMessageType::kHello) ||
      type > static_cast<std::uint8_t>(NodeMessageType::kEnd))
    return Error{"", "does not speak the protocol of clusters"};
  if (bytes.size() - kHeadBytes < size) return std::optional<NodeMessage>();
  begin_ += kHeadBytes + size;
  return std::optional<NodeMessage>({static_cast<NodeMessageType>(type), bytes.subspan(kHeadBytes, size)});
}

Result<NodeMessage> MessageStream::wait(std::optional<Seconds> patience) {
  constexpr double kForEver = std::numeric_limits<double>::infinity();
  Until end{patience ? until(network_->now(), *patience).deadline : kForEver};
  std::optional<double> began;
  Result<void> received;
  for (;;) {
    const Result<std::optional<NodeMessage>> message = next();
    if (!message) return message.error();
    if (*message) return **message;
    if (!received) return received.error();
    if (in_.size() > begin_) {
      if (!began) began = network_->now();
      end = until(*began, kRestOfMessage, announced());
    }
    if (network_->now() >= end.deadline || !wait_for(true, false, end)) break;
    received = receive();
  }
  return Error{"",
               began ? "sends a message too slowly" : fmt::format("is silent for {:g} s", patience->count())};
}

/// Bytes of the message that has begun, if its head has come.
std::size_t MessageStream::announced() const {
  const std::span<const std::byte> bytes = std::span(in_).subspan(begin_);
  return bytes.size() < kHeadBytes ? 0 : Unpacker(bytes).u32();
}

}  // namespace playhouse::cluster
