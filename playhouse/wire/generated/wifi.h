// Generated from interfaces/023_wifi.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::wifi {

inline constexpr std::uint16_t kCode = 23;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kReqMac = 1;
inline constexpr std::uint8_t kReqIwspyAdd = 2;
inline constexpr std::uint8_t kReqIwspyDel = 3;
inline constexpr std::uint8_t kReqIwspyPing = 4;

inline constexpr std::int32_t kQualDbm = 1;
inline constexpr std::int32_t kQualRel = 2;
inline constexpr std::int32_t kQualUnknown = 3;
inline constexpr std::int32_t kModeUnknown = 0;
inline constexpr std::int32_t kModeAuto = 1;
inline constexpr std::int32_t kModeAdhoc = 2;
inline constexpr std::int32_t kModeInfra = 3;
inline constexpr std::int32_t kModeMaster = 4;
inline constexpr std::int32_t kModeRepeat = 5;
inline constexpr std::int32_t kModeSecond = 6;

struct Link {
  /// (at most 32)
  std::vector<std::uint8_t> mac{};
  /// (at most 32)
  std::vector<std::uint8_t> ip{};
  /// (at most 32)
  std::vector<std::uint8_t> essid{};
  std::uint32_t mode = 0;
  /// [MHz]
  std::uint32_t freq = 0;
  std::uint32_t encrypt = 0;
  std::uint32_t qual = 0;
  std::uint32_t level = 0;
  std::uint32_t noise = 0;

  friend bool operator==(const Link&, const Link&) = default;
};

struct Data {
  std::vector<Link> links{};
  std::uint32_t throughput = 0;
  std::uint32_t bitrate = 0;
  std::uint32_t mode = 0;
  std::uint32_t qual_type = 0;
  std::uint32_t maxqual = 0;
  std::uint32_t maxlevel = 0;
  std::uint32_t maxnoise = 0;
  /// (32 bytes; zeros fill a shorter text)
  std::string ap{};

  friend bool operator==(const Data&, const Data&) = default;
};

struct MacReq {
  /// (at most 32)
  std::vector<std::uint8_t> mac{};

  friend bool operator==(const MacReq&, const MacReq&) = default;
};

struct IwspyAddrReq {
  /// (32 bytes; zeros fill a shorter text)
  std::string address{};

  friend bool operator==(const IwspyAddrReq&, const IwspyAddrReq&) = default;
};

void read(Reader& in, Link& m);
void write(Writer& out, const Link& m);
void to_json(std::string& out, const Link& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, MacReq& m);
void write(Writer& out, const MacReq& m);
void to_json(std::string& out, const MacReq& m);
void read(Reader& in, IwspyAddrReq& m);
void write(Writer& out, const IwspyAddrReq& m);
void to_json(std::string& out, const IwspyAddrReq& m);

}  // namespace playhouse::wire::wifi
