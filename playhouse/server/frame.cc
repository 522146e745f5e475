#include "playhouse/server/frame.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"

namespace playhouse::server {

Frame counted(Frame frame, const FrameBytes& total) {
  constexpr std::size_t kEach = 128;  // overhead of a frame and its queue entry
  const std::size_t bytes = frame.bytes->size() + kEach;
  *total += bytes;
  const auto* raw = frame.bytes.get();
  frame.bytes = {raw, [original = std::move(frame.bytes), total, bytes](const auto*) { *total -= bytes; }};
  return frame;
}

std::vector<std::byte> numbered(std::span<const std::byte> message, std::uint32_t number) {
  std::vector<std::byte> copy(message.begin(), message.end());
  const auto head = std::span(copy).first<limits::kHeaderBytes>();
  wire::Header header = wire::decode_header(head);
  header.seq = number;
  wire::encode_header(header, head);
  return copy;
}

Frame make_frame(wire::Header header, std::span<const std::byte> body) {
  PLAYHOUSE_ASSERT(body.size() <= limits::kBodyBytes);
  header.size = static_cast<std::uint32_t>(body.size());
  auto bytes = std::make_shared<std::vector<std::byte>>(limits::kHeaderBytes + body.size());
  wire::encode_header(header,
                      std::span<std::byte, limits::kHeaderBytes>(bytes->data(), limits::kHeaderBytes));
  std::copy(body.begin(), body.end(), bytes->begin() + limits::kHeaderBytes);
  return {std::move(bytes), header.interf, header.index, header.type, header.subtype};
}

}  // namespace playhouse::server
