#pragma once

/// The catalogue: which (interface, type, subtype) carries which payload, and what can be done with a body without
/// knowing its type. Constant tables; any thread.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/wire/header.h"

namespace playhouse::wire {

/// What a new DATA or CMD message does to an older one of its kind that still waits.
enum class Policy : std::uint8_t {
  kNone,    // requests, answers and synchs: never replaced
  kLatest,  // the new one stands for the old one
  kQueue,   // every one counts: keep the order
};

struct MessageDef {
  std::uint16_t interf;      // 0 for the requests that any interface may get
  MessageType type;
  std::uint8_t subtype;
  std::string_view name;     // "position2d.data.state"
  std::string_view payload;  // "position2d::Data"; "" for none
  bool has_payload;
  Policy policy;

  /// "" if the body is acceptable, else what is wrong. A request or answer may have an empty body whatever its
  /// payload, data and commands may not.
  std::string (*check)(std::span<const std::byte> body);
  /// Decoded and encoded again: canonical padding, counts and unused bits; no bytes after the value. Empty if the
  /// body is empty or does not decode.
  std::vector<std::byte> (*reencode)(std::span<const std::byte> body);
  /// Appends a JSON object with every field by name; null if there is no payload or the body does not decode.
  void (*to_json)(std::span<const std::byte> body, std::string& out);
};

struct InterfaceDef {
  std::uint16_t code;
  std::string_view name;
  std::span<const MessageDef> messages;  // by (type, subtype)
};

/// The row of a message, or null. ACK and NACK share the row of their request; the universal requests (247..255)
/// come first and belong to every interface, known or not.
const MessageDef* find_message(std::uint16_t interf, MessageType type, std::uint8_t subtype);

/// Null if there is none.
const InterfaceDef* find_interface(std::uint16_t code);
const InterfaceDef* find_interface(std::string_view name);

/// Every interface, by code.
std::span<const InterfaceDef> interfaces();

/// The requests that any interface may get, by subtype.
std::span<const MessageDef> universal_messages();

}  // namespace playhouse::wire
