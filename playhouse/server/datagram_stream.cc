#include "playhouse/server/datagram_stream.h"

#include <algorithm>

#include "playhouse/base/limits.h"
#include "playhouse/wire/header.h"

namespace playhouse::server {
namespace {

enum class Begins : std::uint8_t { kMessage, kUnfinished, kNoMessage };

struct First {
  Begins what = Begins::kUnfinished;
  wire::Header header;
  std::size_t bytes = 0;  // of the whole message
};

First first_of(std::span<const std::byte> bytes) {
  if (bytes.size() < limits::kHeaderBytes) return {};
  First first;
  first.header = wire::decode_header(bytes.first<limits::kHeaderBytes>());
  first.bytes = limits::kHeaderBytes + first.header.size;
  if (wire::name(first.header.type) == "?" || first.header.size > limits::kBodyBytes) {
    first.what = Begins::kNoMessage;
  } else if (first.bytes <= bytes.size()) {
    first.what = Begins::kMessage;
  }
  return first;
}

/// Bytes of the whole messages at the front.
std::size_t whole_bytes(std::span<const std::byte> bytes) {
  std::size_t count = 0;
  for (First first = first_of(bytes); first.what == Begins::kMessage; first = first_of(bytes.subspan(count)))
    count += first.bytes;
  return count;
}

}  // namespace

DatagramStream::TakenMessages DatagramStream::take(std::span<const std::byte> datagram) {
  TakenMessages taken;
  if (whole_bytes(datagram) == datagram.size()) {
    taken.dropped = !unfinished_.empty();
    unfinished_ = {};
    pass(datagram, taken);
    return taken;
  }
  unfinished_.insert(unfinished_.end(), datagram.begin(), datagram.end());
  const std::size_t whole = whole_bytes(unfinished_);
  pass(std::span(unfinished_).first(whole), taken);
  unfinished_ = {unfinished_.begin() + static_cast<std::ptrdiff_t>(whole), unfinished_.end()};
  const bool is_hopeless = first_of(unfinished_).what == Begins::kNoMessage;
  if (is_hopeless || unfinished_.size() > limits::kDatagramWaitingBytes) {
    taken.dropped = true;
    unfinished_ = {};
  }
  return taken;
}

void DatagramStream::pass(std::span<const std::byte> messages, TakenMessages& taken) {
  while (!messages.empty()) {
    const First first = first_of(messages);
    if (first.header.type == wire::MessageType::kCmd && is_late(first.header.seq)) {
      ++taken.late;
    } else {
      const auto message = messages.first(first.bytes);
      taken.messages.insert(taken.messages.end(), message.begin(), message.end());
      taken.commands |= first.header.type == wire::MessageType::kCmd;
    }
    messages = messages.subspan(first.bytes);
  }
}

/// Numbers wrap (RFC 1982). A client that does not number its commands sends 0.
bool DatagramStream::is_late(std::uint32_t number) {
  if (number == 0) return false;
  if (newest_ != 0 && static_cast<std::int32_t>(number - newest_) < 0) return true;
  newest_ = number;
  return false;
}

}  // namespace playhouse::server
