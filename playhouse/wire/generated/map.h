// Generated from interfaces/042_map.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::map {

inline constexpr std::uint16_t kCode = 42;

// Subtypes of messages.
inline constexpr std::uint8_t kDataInfo = 1;
inline constexpr std::uint8_t kReqGetInfo = 1;
inline constexpr std::uint8_t kReqGetData = 2;
inline constexpr std::uint8_t kReqGetVector = 3;

struct Info {
  /// [m/pixel]
  float scale = 0;
  /// [px]
  std::uint32_t width = 0;
  /// [px]
  std::uint32_t height = 0;
  /// [frame X_RS, m, m, rad]
  Pose2d origin{};

  friend bool operator==(const Info&, const Info&) = default;
};

struct Data {
  /// [px]
  std::uint32_t col = 0;
  /// [px]
  std::uint32_t row = 0;
  /// [px]
  std::uint32_t width = 0;
  /// [px]
  std::uint32_t height = 0;
  std::int8_t data_range = 0;
  std::vector<std::int8_t> data{};

  friend bool operator==(const Data&, const Data&) = default;
};

struct DataVector {
  /// [m]
  float minx = 0;
  /// [m]
  float maxx = 0;
  /// [m]
  float miny = 0;
  /// [m]
  float maxy = 0;
  /// [frame p_MP]
  std::vector<Segment> segments{};

  friend bool operator==(const DataVector&, const DataVector&) = default;
};

void read(Reader& in, Info& m);
void write(Writer& out, const Info& m);
void to_json(std::string& out, const Info& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, DataVector& m);
void write(Writer& out, const DataVector& m);
void to_json(std::string& out, const DataVector& m);

}  // namespace playhouse::wire::map
