// Generated from interfaces/023_wifi.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// State of wireless network links.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::wifi {

inline constexpr std::uint16_t kCode = 23;

// Subtypes of messages.
/// Every link and the state of the card.
inline constexpr std::uint8_t kDataState = 1;
/// Requests the card's own address.
inline constexpr std::uint8_t kReqMac = 1;
/// Starts monitoring the links to an address.
inline constexpr std::uint8_t kReqIwspyAdd = 2;
/// Stops monitoring the links to an address.
inline constexpr std::uint8_t kReqIwspyDel = 3;
/// Sends a packet to an address to measure its link.
inline constexpr std::uint8_t kReqIwspyPing = 4;

/// Values of Data.qual_type: unit of link quality.
inline constexpr std::int32_t kQualDbm = 1;
inline constexpr std::int32_t kQualRel = 2;
inline constexpr std::int32_t kQualUnknown = 3;

/// Values of Data.mode and Link.mode.
inline constexpr std::int32_t kModeUnknown = 0;
inline constexpr std::int32_t kModeAuto = 1;
inline constexpr std::int32_t kModeAdhoc = 2;
inline constexpr std::int32_t kModeInfra = 3;
inline constexpr std::int32_t kModeMaster = 4;
inline constexpr std::int32_t kModeRepeat = 5;
inline constexpr std::int32_t kModeSecond = 6;

/// One link.
struct Link {
  /// Hardware address, as a string. (at most 32)
  std::vector<std::uint8_t> mac{};
  /// Network address, as a string. (at most 32)
  std::vector<std::uint8_t> ip{};
  /// Name of the network, as a string. (at most 32)
  std::vector<std::uint8_t> essid{};
  /// Role in the network.
  std::uint32_t mode = 0;
  /// [MHz]
  std::uint32_t freq = 0;
  /// 0: open, else encrypted.
  std::uint32_t encrypt = 0;
  /// Quality, up to Data.maxqual.
  std::uint32_t qual = 0;
  /// Signal, up to Data.maxlevel.
  std::int32_t level = 0;
  /// Noise, up to Data.maxnoise.
  std::int32_t noise = 0;

  friend bool operator==(const Link&, const Link&) = default;
};

/// Every link and the state of the card.
struct Data {
  std::vector<Link> links{};
  /// Estimated throughput of the card. [bit/s]
  std::uint32_t throughput = 0;
  /// Configured bit rate of the card. [bit/s]
  std::uint32_t bitrate = 0;
  /// Role in the network.
  std::uint32_t mode = 0;
  /// Unit of quality, level and noise.
  std::uint32_t qual_type = 0;
  /// Maximum reported quality.
  std::uint32_t maxqual = 0;
  /// Maximum reported signal level.
  std::int32_t maxlevel = 0;
  /// Maximum reported noise level.
  std::int32_t maxnoise = 0;
  /// Hardware address of the access point, as a string. (32 bytes; zeros fill a shorter text)
  std::string ap{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// The card's own address.
struct MacReq {
  /// Hardware address, as a string. (at most 32)
  std::vector<std::uint8_t> mac{};

  friend bool operator==(const MacReq&, const MacReq&) = default;
};

/// The address of a station.
struct IwspyAddrReq {
  /// Hardware address, as a string. (32 bytes; zeros fill a shorter text)
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
