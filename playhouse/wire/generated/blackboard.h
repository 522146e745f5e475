// Generated from interfaces/064_blackboard.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Named values shared by clients.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::blackboard {

inline constexpr std::uint16_t kCode = 64;

// Subtypes of messages.
/// A subscribed entry has changed.
inline constexpr std::uint8_t kDataUpdate = 1;
/// Subscribes to one entry; the answer has its value.
inline constexpr std::uint8_t kReqSubscribeToKey = 1;
/// Unsubscribes one entry.
inline constexpr std::uint8_t kReqUnsubscribeFromKey = 2;
/// Sets an entry.
inline constexpr std::uint8_t kReqSetEntry = 3;
/// Subscribes to all entries of a group.
inline constexpr std::uint8_t kReqSubscribeToGroup = 4;
/// Unsubscribes a group.
inline constexpr std::uint8_t kReqUnsubscribeFromGroup = 5;
/// Requests an entry once.
inline constexpr std::uint8_t kReqGetEntry = 6;


}  // namespace playhouse::wire::blackboard
