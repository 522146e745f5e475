#include "playhouse/drivers/isolated/plugin_frame.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <type_traits>
#include <utility>

#include "playhouse/base/limits.h"

namespace playhouse::drivers {
namespace {

constexpr std::size_t kReadBytes = 64u << 10;

/// In front of each body.
struct FrameHead {
  std::uint32_t size = 0;  // of the body
  std::uint8_t kind = 0, flag = 0, subtype = 0, unused = 0;
  std::uint32_t device = 0, unused_too = 0;
  std::uint64_t number = 0;
  double time = 0;
};
static_assert(std::is_trivially_copyable_v<FrameHead> && sizeof(FrameHead) == 32, "no padding is sent");

}  // namespace

Bytes bytes_of_text(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

std::string_view text_of(const Bytes& body) {
  return {reinterpret_cast<const char*>(body.data()), body.size()};
}

FrameOutput::FrameMark FrameOutput::offer(const PluginFrame& frame) {
  const FrameHead head{.size = static_cast<std::uint32_t>(frame.body.size()),
                       .kind = static_cast<std::uint8_t>(frame.kind),
                       .flag = frame.flag,
                       .subtype = frame.subtype,
                       .device = frame.device,
                       .number = frame.number,
                       .time = frame.time};
  const auto front = std::as_bytes(std::span(&head, 1));
  const std::lock_guard lock(mutex_);
  offered_ += front.size() + frame.body.size();
  if (is_over_) return offered_;
  const std::size_t gone = waiting_.empty() ? write(front, frame.body) : 0;
  if (gone == front.size() + frame.body.size()) return offered_;
  Bytes whole;
  whole.reserve(front.size() + frame.body.size());
  whole.assign(front.begin(), front.end());
  whole.insert(whole.end(), frame.body.begin(), frame.body.end());
  if (waiting_.empty()) at_ = gone;
  waiting_.push_back(std::move(whole));
  return offered_;
}

void FrameOutput::flush() {
  const std::lock_guard lock(mutex_);
  while (!waiting_.empty()) {
    const std::size_t gone = write(std::span(waiting_.front()).subspan(at_), {});
    if (gone == 0) return;
    at_ += gone;
    if (at_ < waiting_.front().size()) continue;
    waiting_.pop_front();
    at_ = 0;
  }
}

/// How many bytes there was room for.
std::size_t FrameOutput::write(std::span<const std::byte> first, std::span<const std::byte> second) {
  std::array<iovec, 2> parts{{{const_cast<std::byte*>(first.data()), first.size()},
                              {const_cast<std::byte*>(second.data()), second.size()}}};
  msghdr message{};
  message.msg_iov = parts.data();
  message.msg_iovlen = parts.size();
  ssize_t gone = -1;
  do gone = ::sendmsg(socket_, &message, MSG_NOSIGNAL | MSG_DONTWAIT);
  while (gone < 0 && errno == EINTR);
  if (gone < 0) is_over_ = errno != EAGAIN && errno != EWOULDBLOCK;
  const std::size_t bytes = gone > 0 ? static_cast<std::size_t>(gone) : 0;
  written_ += bytes;
  return bytes;
}

bool FrameOutput::is_waiting() const {
  const std::lock_guard lock(mutex_);
  return !is_over_ && !waiting_.empty();
}

bool FrameOutput::is_waiting(FrameMark mark) const {
  const std::lock_guard lock(mutex_);
  return !is_over_ && written_ < mark;
}

bool FrameOutput::send(const PluginFrame& frame) {
  const FrameMark mark = offer(frame);
  while (is_waiting(mark)) {
    pollfd room{socket_, POLLOUT, 0};
    ::poll(&room, 1, -1);
    flush();
  }
  const std::lock_guard lock(mutex_);
  return written_ >= mark;
}

FrameInput::ReadOutcome FrameInput::read(bool waits) {
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(std::exchange(at_, 0)));
  const std::size_t before = bytes_.size();
  bytes_.resize(before + kReadBytes);
  ssize_t got = -1;
  do got = ::recv(socket_, bytes_.data() + before, kReadBytes, waits ? 0 : MSG_DONTWAIT);
  while (got < 0 && errno == EINTR);
  const bool nothing = got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
  bytes_.resize(before + static_cast<std::size_t>(got > 0 ? got : 0));
  if (got > 0) return ReadOutcome::kSome;
  return nothing ? ReadOutcome::kNothing : ReadOutcome::kEnd;
}

Result<std::optional<PluginFrame>> FrameInput::take() {
  FrameHead head;
  if (bytes_.size() - at_ < sizeof head) return std::optional<PluginFrame>();
  std::memcpy(&head, bytes_.data() + at_, sizeof head);
  if (head.size > limits::kBodyBytes)
    return Error{"", fmt::format("a frame of {} bytes: {} at most are valid", head.size, limits::kBodyBytes)};
  if (head.kind > static_cast<std::uint8_t>(PluginFrameKind::kSay) || head.flag > 1)
    return Error{"", fmt::format("a frame of kind {}, which there is not", head.kind)};
  if (bytes_.size() - at_ - sizeof head < head.size) return std::optional<PluginFrame>();
  const auto body = bytes_.begin() + static_cast<std::ptrdiff_t>(at_ + sizeof head);
  at_ += sizeof head + head.size;
  return std::optional<PluginFrame>({.kind = static_cast<PluginFrameKind>(head.kind),
                                     .flag = head.flag == 1,
                                     .subtype = head.subtype,
                                     .device = head.device,
                                     .number = head.number,
                                     .time = head.time,
                                     .body = {body, body + static_cast<std::ptrdiff_t>(head.size)}});
}

}  // namespace playhouse::drivers
