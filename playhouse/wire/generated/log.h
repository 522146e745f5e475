// Generated from interfaces/045_log.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Records data of devices to a file, or plays back such a file.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::log {

inline constexpr std::uint16_t kCode = 45;

// Subtypes of messages.
/// Starts or stops writing.
inline constexpr std::uint8_t kReqSetWriteState = 1;
/// Starts or stops playing.
inline constexpr std::uint8_t kReqSetReadState = 2;
/// Requests the type and state of the device.
inline constexpr std::uint8_t kReqGetState = 3;
/// Rewinds to the start of the file.
inline constexpr std::uint8_t kReqSetReadRewind = 4;
/// Sets the file to write to.
inline constexpr std::uint8_t kReqSetFilename = 5;

/// Values of GetState.type.
inline constexpr std::int32_t kTypeRead = 1;
inline constexpr std::int32_t kTypeWrite = 2;

/// Whether data is being recorded.
struct SetWriteState {
  /// 1: on, 0: off.
  std::uint8_t state = 0;

  friend bool operator==(const SetWriteState&, const SetWriteState&) = default;
};

/// Whether the file is being played.
struct SetReadState {
  /// 1: on, 0: off.
  std::uint8_t state = 0;

  friend bool operator==(const SetReadState&, const SetReadState&) = default;
};

/// Type and state of the device.
struct GetState {
  /// Reader or writer.
  std::uint8_t type = 0;
  /// 1: running, 0: stopped.
  std::uint8_t state = 0;

  friend bool operator==(const GetState&, const GetState&) = default;
};

/// The file to write to.
struct SetFilename {
  /// NUL-terminated. (at most 256)
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
