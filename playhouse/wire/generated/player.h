// Generated from interfaces/001_player.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The server itself: lists, opens and closes devices, and selects the delivery of data. Always open as
/// player:0.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::player {

inline constexpr std::uint16_t kCode = 1;

// Subtypes of messages.
/// Lists the devices that this connection can open.
inline constexpr std::uint8_t kReqDevlist = 1;
/// Requests the name of the driver behind a device.
inline constexpr std::uint8_t kReqDriverinfo = 2;
/// Opens or closes a device; the answer has the granted access.
inline constexpr std::uint8_t kReqDev = 3;
/// Requests one round of data, in pull mode; a synch ends the round.
inline constexpr std::uint8_t kReqData = 4;
/// Selects the delivery mode: immediately (push) or on request (pull).
inline constexpr std::uint8_t kReqDatamode = 5;
/// Sends an authentication key: a guest's token, of a run with access control (docs/guests.md); NACK if it
/// admits nobody.
inline constexpr std::uint8_t kReqAuth = 7;
/// Requests the port of a named robot; unused, answered by NACK.
inline constexpr std::uint8_t kReqNameservice = 8;
/// Adds a replace rule: which queued messages a newer one replaces.
inline constexpr std::uint8_t kReqAddReplaceRule = 10;
/// Ends a round of data; no message was dropped since the previous one.
inline constexpr std::uint8_t kSynchOk = 1;
/// Ends a round of data; the body is the number of messages dropped since the previous one.
inline constexpr std::uint8_t kSynchOverflow = 2;

/// Values of DeviceReq.access.
inline constexpr std::int32_t kOpenMode = 1;
inline constexpr std::int32_t kCloseMode = 2;
inline constexpr std::int32_t kErrorMode = 3;

/// Values of DeviceDatamodeReq.mode.
inline constexpr std::int32_t kDatamodePush = 1;
inline constexpr std::int32_t kDatamodePull = 2;

/// Values of AddReplaceRuleReq.replace.
inline constexpr std::int32_t kMsgReplaceRuleAccept = 0;
inline constexpr std::int32_t kMsgReplaceRuleReplace = 1;
inline constexpr std::int32_t kMsgReplaceRuleIgnore = 2;

/// The devices of a server.
struct DeviceDevlist {
  /// In the order of creation, without player:0. (at most 4096)
  std::vector<Devaddr> devices{};

  friend bool operator==(const DeviceDevlist&, const DeviceDevlist&) = default;
};

/// A device and the driver behind it.
struct DeviceDriverinfo {
  /// The queried device.
  Devaddr addr{};
  /// NUL-terminated; empty in the request. (at most 64)
  std::string driver_name{};

  friend bool operator==(const DeviceDriverinfo&, const DeviceDriverinfo&) = default;
};

/// Request to open or close a device, and its answer.
struct DeviceReq {
  /// The device; in the answer, completed with host and robot.
  Devaddr addr{};
  /// Requested or granted access.
  std::uint8_t access = 0;
  /// NUL-terminated; empty in the request. (at most 64)
  std::string driver_name{};

  friend bool operator==(const DeviceReq&, const DeviceReq&) = default;
};

/// A delivery mode.
struct DeviceDatamodeReq {
  /// Push or pull.
  std::uint8_t mode = 0;

  friend bool operator==(const DeviceDatamodeReq&, const DeviceDatamodeReq&) = default;
};

/// A key.
struct DeviceAuthReq {
  /// (at most 32)
  std::vector<std::uint8_t> auth_key{};

  friend bool operator==(const DeviceAuthReq&, const DeviceAuthReq&) = default;
};

/// A robot's name and its port.
struct DeviceNameserviceReq {
  /// (at most 64)
  std::vector<std::uint8_t> name{};
  /// 0 in the request.
  std::uint16_t port = 0;

  friend bool operator==(const DeviceNameserviceReq&, const DeviceNameserviceReq&) = default;
};

/// Messages to which a rule applies, and its effect; -1 matches anything.
struct AddReplaceRuleReq {
  /// Interface code, or -1.
  std::int32_t interf = 0;
  /// Device index, or -1.
  std::int32_t index = 0;
  /// Message type, or -1.
  std::int32_t type = 0;
  /// Message subtype, or -1.
  std::int32_t subtype = 0;
  /// Keep all, keep the newest, or drop.
  std::int32_t replace = 0;

  friend bool operator==(const AddReplaceRuleReq&, const AddReplaceRuleReq&) = default;
};

void read(Reader& in, DeviceDevlist& m);
void write(Writer& out, const DeviceDevlist& m);
void to_json(std::string& out, const DeviceDevlist& m);
void read(Reader& in, DeviceDriverinfo& m);
void write(Writer& out, const DeviceDriverinfo& m);
void to_json(std::string& out, const DeviceDriverinfo& m);
void read(Reader& in, DeviceReq& m);
void write(Writer& out, const DeviceReq& m);
void to_json(std::string& out, const DeviceReq& m);
void read(Reader& in, DeviceDatamodeReq& m);
void write(Writer& out, const DeviceDatamodeReq& m);
void to_json(std::string& out, const DeviceDatamodeReq& m);
void read(Reader& in, DeviceAuthReq& m);
void write(Writer& out, const DeviceAuthReq& m);
void to_json(std::string& out, const DeviceAuthReq& m);
void read(Reader& in, DeviceNameserviceReq& m);
void write(Writer& out, const DeviceNameserviceReq& m);
void to_json(std::string& out, const DeviceNameserviceReq& m);
void read(Reader& in, AddReplaceRuleReq& m);
void write(Writer& out, const AddReplaceRuleReq& m);
void to_json(std::string& out, const AddReplaceRuleReq& m);

}  // namespace playhouse::wire::player
