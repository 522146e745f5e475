#pragma once

/// The message catalogue: payload of each (interface, type, subtype),
/// with type-erased operations on bodies. Constant tables; any thread.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/wire/header.h"

namespace playhouse::wire {

/// Effect of a new DATA or CMD message on a queued one of its kind.
enum class Policy : std::uint8_t {
  kNone,    // requests, replies and synchs: never replaced
  kLatest,  // the new one replaces the old one
  kQueue,   // all are delivered in order
};

struct MessageDef {
  std::uint16_t interf;  // 0 for universal requests
  MessageType type;
  std::uint8_t subtype;
  std::string_view name;     // "position2d.data.state"
  std::string_view payload;  // "position2d::Data"; "" for none
  bool has_payload;
  Policy policy;

  /// "" if the body is valid, else the error. Requests and replies may
  /// have an empty body whatever their payload, data and commands may not.
  std::string (*check)(std::span<const std::byte> body);
  /// Decodes and re-encodes: canonical pad, counts and unused
  /// bits; no trailing bytes. Empty if the body is empty or invalid.
  std::vector<std::byte> (*reencode)(std::span<const std::byte> body);
  /// Appends a JSON object with all fields by name; null without a payload or if the body is invalid.
  /// Null in a program without JSON (PLAYHOUSE_CORE).
  void (*to_json)(std::span<const std::byte> body, std::string& out);
};

struct InterfaceDef {
  std::uint16_t code;
  std::string_view name;
  std::span<const MessageDef> messages;  // sorted by (type, subtype)
};

/// Looks up a message; null if unknown. ACK and NACK share the row of their request;
/// universal requests (247..255) come first and belong to every interface, known or not.
const MessageDef* find_message(std::uint16_t interf, MessageType type, std::uint8_t subtype);

/// Null if unknown.
const InterfaceDef* find_interface(std::uint16_t code);
const InterfaceDef* find_interface(std::string_view name);

/// All interfaces, by code.
std::span<const InterfaceDef> interfaces();

/// Universal requests, by subtype.
std::span<const MessageDef> universal_messages();

}  // namespace playhouse::wire
