// Generated from interfaces/001_player.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::player {

inline constexpr std::uint16_t kCode = 1;

// Subtypes of messages.
inline constexpr std::uint8_t kReqDevlist = 1;
inline constexpr std::uint8_t kReqDriverinfo = 2;
inline constexpr std::uint8_t kReqDev = 3;
inline constexpr std::uint8_t kReqData = 4;
inline constexpr std::uint8_t kReqDatamode = 5;
inline constexpr std::uint8_t kReqAuth = 7;
inline constexpr std::uint8_t kReqNameservice = 8;
inline constexpr std::uint8_t kReqAddReplaceRule = 10;
inline constexpr std::uint8_t kSynchOk = 1;
inline constexpr std::uint8_t kSynchOverflow = 2;

inline constexpr std::int32_t kOpenMode = 1;
inline constexpr std::int32_t kCloseMode = 2;
inline constexpr std::int32_t kErrorMode = 3;
inline constexpr std::int32_t kDatamodePush = 1;
inline constexpr std::int32_t kDatamodePull = 2;

inline constexpr std::int32_t kMsgReplaceRuleAccept = 0;
inline constexpr std::int32_t kMsgReplaceRuleReplace = 1;
inline constexpr std::int32_t kMsgReplaceRuleIgnore = 2;

struct DeviceDevlist {
  /// (at most 4096)
  std::vector<Devaddr> devices{};

  friend bool operator==(const DeviceDevlist&, const DeviceDevlist&) = default;
};

struct DeviceDriverinfo {
  Devaddr addr{};
  /// (at most 64)
  std::string driver_name{};

  friend bool operator==(const DeviceDriverinfo&, const DeviceDriverinfo&) = default;
};

struct DeviceReq {
  Devaddr addr{};
  std::uint8_t access = 0;
  /// (at most 64)
  std::string driver_name{};

  friend bool operator==(const DeviceReq&, const DeviceReq&) = default;
};

struct DeviceDatamodeReq {
  std::uint8_t mode = 0;

  friend bool operator==(const DeviceDatamodeReq&, const DeviceDatamodeReq&) = default;
};

struct DeviceAuthReq {
  /// (at most 32)
  std::vector<std::uint8_t> auth_key{};

  friend bool operator==(const DeviceAuthReq&, const DeviceAuthReq&) = default;
};

struct DeviceNameserviceReq {
  /// (at most 64)
  std::vector<std::uint8_t> name{};
  std::uint16_t port = 0;

  friend bool operator==(const DeviceNameserviceReq&, const DeviceNameserviceReq&) = default;
};

struct AddReplaceRuleReq {
  std::int32_t interf = 0;
  std::int32_t index = 0;
  std::int32_t type = 0;
  std::int32_t subtype = 0;
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
