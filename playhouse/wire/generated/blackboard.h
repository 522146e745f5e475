// Generated from interfaces/064_blackboard.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Named values that clients share.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::blackboard {

inline constexpr std::uint16_t kCode = 64;

// Subtypes of messages.
/// An entry that the client follows has changed.
inline constexpr std::uint8_t kDataUpdate = 1;
/// Follows one entry; the answer holds its value.
inline constexpr std::uint8_t kReqSubscribeToKey = 1;
/// Stops following one entry.
inline constexpr std::uint8_t kReqUnsubscribeFromKey = 2;
/// Sets an entry.
inline constexpr std::uint8_t kReqSetEntry = 3;
/// Follows every entry of a group.
inline constexpr std::uint8_t kReqSubscribeToGroup = 4;
/// Stops following a group.
inline constexpr std::uint8_t kReqUnsubscribeFromGroup = 5;
/// Asks for an entry once.
inline constexpr std::uint8_t kReqGetEntry = 6;


}  // namespace playhouse::wire::blackboard
