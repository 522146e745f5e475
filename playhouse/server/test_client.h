#pragma once

/// Client side of the protocol over the simulated network, for tests of this module.

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/packing.h"
#include "playhouse/net/simulated.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/header.h"

namespace playhouse::server {

struct Received {
  wire::Header header;
  Bytes body;
};

inline Bytes message(wire::MessageType type, std::uint16_t interf, std::uint16_t index, std::uint8_t subtype,
                     const Bytes& body = {}, std::uint32_t seq = 0) {
  wire::Header header;
  header.interf = interf;
  header.index = index;
  header.type = type;
  header.subtype = subtype;
  header.seq = seq;
  header.size = static_cast<std::uint32_t>(body.size());
  Bytes bytes(limits::kHeaderBytes);
  wire::encode_header(header, std::span<std::byte, limits::kHeaderBytes>(bytes.data(), limits::kHeaderBytes));
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

inline Bytes player_request(std::uint8_t subtype, const Bytes& body = {}, std::uint32_t seq = 0) {
  return message(wire::MessageType::kReq, wire::player::kCode, 0, subtype, body, seq);
}

inline Bytes open_request(std::uint16_t interf, std::uint16_t index, std::uint8_t access = 1) {
  return player_request(wire::player::kReqDev,
                        wire::encode(wire::player::DeviceReq{{0, 0, interf, index}, access, ""}));
}

inline Bytes mode_request(std::uint8_t mode) {
  return player_request(wire::player::kReqDatamode, wire::encode(wire::player::DeviceDatamodeReq{mode}));
}

inline Bytes rule_request(std::int32_t interf, std::int32_t type, std::int32_t replace) {
  return player_request(wire::player::kReqAddReplaceRule,
                        wire::encode(wire::player::AddReplaceRuleReq{interf, -1, type, -1, replace}));
}

inline std::uint8_t access_of(const Received& reply) {
  const auto body = wire::decode<wire::player::DeviceReq>(reply.body);
  return body ? body->access : 0;
}

/// Splits complete messages off the front of `bytes`.
inline std::vector<Received> cut_messages(Bytes& bytes) {
  std::vector<Received> result;
  std::size_t at = 0;
  while (bytes.size() - at >= limits::kHeaderBytes) {
    const auto rest = std::span(std::as_const(bytes)).subspan(at);
    const wire::Header header = wire::decode_header(rest.first<limits::kHeaderBytes>());
    if (rest.size() - limits::kHeaderBytes < header.size) break;
    const auto body = rest.subspan(limits::kHeaderBytes, header.size);
    result.push_back({header, Bytes(body.begin(), body.end())});
    at += limits::kHeaderBytes + header.size;
  }
  bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
  return result;
}

class TestClient {
 public:
  TestClient(net::SimulatedNetwork& network, std::uint16_t port)
      : network_(network), peer(network.connect(port)) {
    network_.run();
    bytes_ = peer.take();
    banner =
        std::string(reinterpret_cast<const char*>(bytes_.data()), std::min<std::size_t>(bytes_.size(), 32));
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(banner.size()));
  }

  void send(const Bytes& bytes) { peer.send(bytes); }
  /// Runs the network and returns the messages received.
  std::vector<Received> read() {
    network_.run();
    const Bytes more = peer.take();
    bytes_.insert(bytes_.end(), more.begin(), more.end());
    return cut_messages(bytes_);
  }
  std::vector<Received> ask(const Bytes& bytes) {
    send(bytes);
    return read();
  }

 private:
  net::SimulatedNetwork& network_;
  Bytes bytes_;

 public:
  net::SimulatedPeer peer;
  std::string banner;
};

/// Compact text of messages, "ACK 3"; data includes its interface.
inline std::string outline(const std::vector<Received>& messages) {
  std::string text;
  for (const Received& received : messages) {
    if (!text.empty()) text += ", ";
    text += std::string(wire::name(received.header.type)) + " " + std::to_string(received.header.subtype);
    if (received.header.type == wire::MessageType::kData)
      text += " of " + std::to_string(received.header.interf);
  }
  return text;
}

}  // namespace playhouse::server
