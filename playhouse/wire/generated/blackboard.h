// Generated from interfaces/064_blackboard.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::blackboard {

inline constexpr std::uint16_t kCode = 64;

// Subtypes of messages.
inline constexpr std::uint8_t kDataUpdate = 1;
inline constexpr std::uint8_t kReqSubscribeToKey = 1;
inline constexpr std::uint8_t kReqUnsubscribeFromKey = 2;
inline constexpr std::uint8_t kReqSetEntry = 3;
inline constexpr std::uint8_t kReqSubscribeToGroup = 4;
inline constexpr std::uint8_t kReqUnsubscribeFromGroup = 5;
inline constexpr std::uint8_t kReqGetEntry = 6;


}  // namespace playhouse::wire::blackboard
