#include "playhouse/wire/header.h"

#include <bit>

#include "playhouse/wire/reader.h"

namespace playhouse::wire {

namespace {

void put(std::span<std::byte> out, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) out[i] = static_cast<std::byte>(value >> (24 - 8 * i) & 0xFF);
}

}  // namespace

std::string_view name(MessageType type) {
  switch (type) {
    case MessageType::kData:
      return "DATA";
    case MessageType::kCmd:
      return "CMD";
    case MessageType::kReq:
      return "REQ";
    case MessageType::kAck:
      return "ACK";
    case MessageType::kSynch:
      return "SYNCH";
    case MessageType::kNack:
      return "NACK";
  }
  return "?";
}

void encode_header(const Header& header, std::span<std::byte, limits::kHeaderBytes> out) {
  const auto timestamp = std::bit_cast<std::uint64_t>(header.timestamp);
  put(out.subspan(0), header.host);
  put(out.subspan(4), header.robot);
  put(out.subspan(8), header.interf);
  put(out.subspan(12), header.index);
  put(out.subspan(16), static_cast<std::uint32_t>(header.type));
  put(out.subspan(20), header.subtype);
  put(out.subspan(24), static_cast<std::uint32_t>(timestamp >> 32));
  put(out.subspan(28), static_cast<std::uint32_t>(timestamp));
  put(out.subspan(32), header.seq);
  put(out.subspan(36), header.size);
}

Header decode_header(std::span<const std::byte, limits::kHeaderBytes> bytes) {
  Reader in(bytes);
  Header header;
  std::uint8_t type = 0;
  in.read(header.host);
  in.read(header.robot);
  in.read(header.interf);
  in.read(header.index);
  in.read(type);
  in.read(header.subtype);
  in.read(header.timestamp);
  in.read(header.seq);
  in.read(header.size);
  header.type = static_cast<MessageType>(type);
  return header;
}

}  // namespace playhouse::wire
