// Generated from interfaces/051_opaque.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Opaque bytes, defined by the driver and its clients.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::opaque {

inline constexpr std::uint16_t kCode = 51;

// Subtypes of messages.
/// Bytes from the driver.
inline constexpr std::uint8_t kDataState = 1;
/// Bytes for the driver.
inline constexpr std::uint8_t kCmdData = 1;
/// Bytes for the driver, which answers with bytes.
inline constexpr std::uint8_t kReqData = 1;

/// Subtypes under their older names.
inline constexpr std::int32_t kReq = 1;
inline constexpr std::int32_t kCmd = 1;

/// Opaque bytes.
struct Data {
  std::vector<std::uint8_t> data{};

  friend bool operator==(const Data&, const Data&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);

}  // namespace playhouse::wire::opaque
