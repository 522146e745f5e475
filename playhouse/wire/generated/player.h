// Generated from interfaces/001_player.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The server itself: what devices there are, opening and closing them, and how data is delivered. Always
/// open as player:0.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::player {

inline constexpr std::uint16_t kCode = 1;

// Subtypes of messages.
/// Lists the devices that this connection can open.
inline constexpr std::uint8_t kReqDevlist = 1;
/// Tells the name of the driver behind a device.
inline constexpr std::uint8_t kReqDriverinfo = 2;
/// Opens or closes a device; the answer says which access was granted.
inline constexpr std::uint8_t kReqDev = 3;
/// Asks for one round of data, in pull mode; a synch ends the round.
inline constexpr std::uint8_t kReqData = 4;
/// Chooses between data as it comes (push) and data on request (pull).
inline constexpr std::uint8_t kReqDatamode = 5;
/// Offers a key; not in use, answered by NACK.
inline constexpr std::uint8_t kReqAuth = 7;
/// Asks which port a named robot has; not in use, answered by NACK.
inline constexpr std::uint8_t kReqNameservice = 8;
/// Adds a rule that says which waiting messages a newer one replaces.
inline constexpr std::uint8_t kReqAddReplaceRule = 10;
/// Ends a round of data; nothing was dropped since the last one.
inline constexpr std::uint8_t kSynchOk = 1;
/// Ends a round of data; messages were dropped since the last one, the body says how many.
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
  /// In the order of their creation; player:0 is not among them. (at most 4096)
  std::vector<Devaddr> devices{};

  friend bool operator==(const DeviceDevlist&, const DeviceDevlist&) = default;
};

/// A device and the driver behind it.
struct DeviceDriverinfo {
  /// The device asked about.
  Devaddr addr{};
  /// With its final NUL; empty in the question. (at most 64)
  std::string driver_name{};

  friend bool operator==(const DeviceDriverinfo&, const DeviceDriverinfo&) = default;
};

/// A wish to open or close a device, and its answer.
struct DeviceReq {
  /// The device; in the answer, completed with host and robot.
  Devaddr addr{};
  /// Wanted or granted access.
  std::uint8_t access = 0;
  /// With its final NUL; empty in the question. (at most 64)
  std::string driver_name{};

  friend bool operator==(const DeviceReq&, const DeviceReq&) = default;
};

/// A way of delivery.
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
  /// 0 in the question.
  std::uint16_t port = 0;

  friend bool operator==(const DeviceNameserviceReq&, const DeviceNameserviceReq&) = default;
};

/// Which messages a rule is for, and what it does; -1 matches anything.
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
