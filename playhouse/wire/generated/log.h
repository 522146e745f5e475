// Generated from interfaces/045_log.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::log {

inline constexpr std::uint16_t kCode = 45;

// Subtypes of messages.
inline constexpr std::uint8_t kReqSetWriteState = 1;
inline constexpr std::uint8_t kReqSetReadState = 2;
inline constexpr std::uint8_t kReqGetState = 3;
inline constexpr std::uint8_t kReqSetReadRewind = 4;
inline constexpr std::uint8_t kReqSetFilename = 5;

inline constexpr std::int32_t kTypeRead = 1;
inline constexpr std::int32_t kTypeWrite = 2;

struct SetWriteState {
  std::uint8_t state = 0;

  friend bool operator==(const SetWriteState&, const SetWriteState&) = default;
};

struct SetReadState {
  std::uint8_t state = 0;

  friend bool operator==(const SetReadState&, const SetReadState&) = default;
};

struct GetState {
  std::uint8_t type = 0;
  std::uint8_t state = 0;

  friend bool operator==(const GetState&, const GetState&) = default;
};

struct SetFilename {
  /// (at most 256)
  std::string filename{};

  friend bool operator==(const SetFilename&, const SetFilename&) = default;
};

void read(Reader& in, SetWriteState& m);
void write(Writer& out, const SetWriteState& m);
void to_json(std::string& out, const SetWriteState& m);
void read(Reader& in, SetReadState& m);
void write(Writer& out, const SetReadState& m);
void to_json(std::string& out, const SetReadState& m);
void read(Reader& in, GetState& m);
void write(Writer& out, const GetState& m);
void to_json(std::string& out, const GetState& m);
void read(Reader& in, SetFilename& m);
void write(Writer& out, const SetFilename& m);
void to_json(std::string& out, const SetFilename& m);

}  // namespace playhouse::wire::log
