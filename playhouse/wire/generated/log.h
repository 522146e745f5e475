// Generated from interfaces/045_log.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Writes data of devices to a file, or plays such a file back.

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
/// Asks what the device is and whether it runs.
inline constexpr std::uint8_t kReqGetState = 3;
/// Goes back to the start of the file.
inline constexpr std::uint8_t kReqSetReadRewind = 4;
/// Sets the file to write to.
inline constexpr std::uint8_t kReqSetFilename = 5;

/// Values of GetState.type.
inline constexpr std::int32_t kTypeRead = 1;
inline constexpr std::int32_t kTypeWrite = 2;

/// Whether data is written.
struct SetWriteState {
  /// 1 on, 0 off.
  std::uint8_t state = 0;

  friend bool operator==(const SetWriteState&, const SetWriteState&) = default;
};

/// Whether the file is played.
struct SetReadState {
  /// 1 on, 0 off.
  std::uint8_t state = 0;

  friend bool operator==(const SetReadState&, const SetReadState&) = default;
};

/// What the device is and does.
struct GetState {
  /// Reader or writer.
  std::uint8_t type = 0;
  /// 1 runs, 0 stands.
  std::uint8_t state = 0;

  friend bool operator==(const GetState&, const GetState&) = default;
};

/// The file to write to.
struct SetFilename {
  /// With its final NUL. (at most 256)
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
