// Generated from interfaces/066_coopobject.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::coopobject {

inline constexpr std::uint16_t kCode = 66;

// Subtypes of messages.
inline constexpr std::uint8_t kDataHealth = 1;
inline constexpr std::uint8_t kDataRssi = 2;
inline constexpr std::uint8_t kDataSensor = 3;
inline constexpr std::uint8_t kDataAlarm = 4;
inline constexpr std::uint8_t kDataUserdefined = 5;
inline constexpr std::uint8_t kDataRequest = 6;
inline constexpr std::uint8_t kDataCommand = 7;
inline constexpr std::uint8_t kDataPosition = 8;
inline constexpr std::uint8_t kCmdStandard = 1;
inline constexpr std::uint8_t kCmdData = 2;
inline constexpr std::uint8_t kCmdPosition = 3;
inline constexpr std::uint8_t kReqStandard = 1;

inline constexpr std::int32_t kOriginStaticbase = 0;
inline constexpr std::int32_t kOriginMobilebase = 1;
inline constexpr std::int32_t kOriginMote = 2;
inline constexpr std::int32_t kOriginRobot = 3;
inline constexpr std::int32_t kMsgNone = -1;
inline constexpr std::int32_t kMsgHealth = 0;
inline constexpr std::int32_t kMsgPosition = 1;
inline constexpr std::int32_t kMsgRssi = 2;
inline constexpr std::int32_t kMsgSensor = 3;
inline constexpr std::int32_t kMsgAlarm = 4;
inline constexpr std::int32_t kMsgRequest = 5;
inline constexpr std::int32_t kMsgCommand = 6;
inline constexpr std::int32_t kTemperature = 0;
inline constexpr std::int32_t kHumidity = 1;
inline constexpr std::int32_t kPressure = 2;
inline constexpr std::int32_t kLight1 = 3;
inline constexpr std::int32_t kLight2 = 4;
inline constexpr std::int32_t kAccelX = 5;
inline constexpr std::int32_t kAccelY = 6;
inline constexpr std::int32_t kAccelZ = 7;
inline constexpr std::int32_t kMagnetometerX = 8;
inline constexpr std::int32_t kMagnetometerY = 9;
inline constexpr std::int32_t kMagnetometerZ = 10;
inline constexpr std::int32_t kCompass = 11;
inline constexpr std::int32_t kCo = 12;
inline constexpr std::int32_t kCo2 = 13;
inline constexpr std::int32_t kH2 = 14;
inline constexpr std::int32_t kSmoke = 15;
inline constexpr std::int32_t kOptswitch = 16;

struct Header {
  std::uint8_t origin = 0;
  std::uint16_t id = 0;
  std::uint16_t parent_id = 0;

  friend bool operator==(const Header&, const Header&) = default;
};

struct Rssi {
  Header header{};
  std::uint16_t sender_id = 0;
  std::uint16_t rssi = 0;
  std::uint16_t stamp = 0;
  std::uint32_t nodeTimeHigh = 0;
  std::uint32_t nodeTimeLow = 0;
  /// [1]
  float x = 0;
  /// [1]
  float y = 0;
  /// [1]
  float z = 0;

  friend bool operator==(const Rssi&, const Rssi&) = default;
};

struct Position {
  Header header{};
  /// [1]
  float x = 0;
  /// [1]
  float y = 0;
  /// [1]
  float z = 0;
  std::uint8_t status = 0;

  friend bool operator==(const Position&, const Position&) = default;
};

struct Sensor {
  std::uint8_t type = 0;
  std::int16_t value = 0;

  friend bool operator==(const Sensor&, const Sensor&) = default;
};

struct DataSensor {
  Header header{};
  std::vector<Sensor> data{};

  friend bool operator==(const DataSensor&, const DataSensor&) = default;
};

struct DataUserdefined {
  Header header{};
  std::uint8_t type = 0;
  std::vector<std::uint8_t> data{};

  friend bool operator==(const DataUserdefined&, const DataUserdefined&) = default;
};

struct Req {
  Header header{};
  std::uint8_t request = 0;
  std::vector<std::uint8_t> parameters{};

  friend bool operator==(const Req&, const Req&) = default;
};

struct Cmd {
  Header header{};
  std::uint8_t command = 0;
  std::vector<std::uint8_t> parameters{};

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

void read(Reader& in, Header& m);
void write(Writer& out, const Header& m);
void to_json(std::string& out, const Header& m);
void read(Reader& in, Rssi& m);
void write(Writer& out, const Rssi& m);
void to_json(std::string& out, const Rssi& m);
void read(Reader& in, Position& m);
void write(Writer& out, const Position& m);
void to_json(std::string& out, const Position& m);
void read(Reader& in, Sensor& m);
void write(Writer& out, const Sensor& m);
void to_json(std::string& out, const Sensor& m);
void read(Reader& in, DataSensor& m);
void write(Writer& out, const DataSensor& m);
void to_json(std::string& out, const DataSensor& m);
void read(Reader& in, DataUserdefined& m);
void write(Writer& out, const DataUserdefined& m);
void to_json(std::string& out, const DataUserdefined& m);
void read(Reader& in, Req& m);
void write(Writer& out, const Req& m);
void to_json(std::string& out, const Req& m);
void read(Reader& in, Cmd& m);
void write(Writer& out, const Cmd& m);
void to_json(std::string& out, const Cmd& m);

}  // namespace playhouse::wire::coopobject
