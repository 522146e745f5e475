// Generated from interfaces/042_map.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Grid and vector maps.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::map {

inline constexpr std::uint16_t kCode = 42;

// Subtypes of messages.
/// Size and scale of the map, sent on change.
inline constexpr std::uint8_t kDataInfo = 1;
/// Requests the size and scale of the map.
inline constexpr std::uint8_t kReqGetInfo = 1;
/// Requests a rectangle of cells; the answer's cells are compressed with zlib.
inline constexpr std::uint8_t kReqGetData = 2;
/// Requests the map as lines.
inline constexpr std::uint8_t kReqGetVector = 3;

/// Size, scale and origin of the map.
struct Info {
  /// Cell size. [m/pixel]
  float scale = 0;
  /// [px]
  std::uint32_t width = 0;
  /// [px]
  std::uint32_t height = 0;
  /// Of the lower left corner of cell (0, 0). [frame X_WM, m, m, rad]
  Pose2d origin{};

  friend bool operator==(const Info&, const Info&) = default;
};

/// A rectangle of cells.
struct Data {
  /// First column, from the left. [px]
  std::uint32_t col = 0;
  /// First row, from the bottom. [px]
  std::uint32_t row = 0;
  /// [px]
  std::uint32_t width = 0;
  /// [px]
  std::uint32_t height = 0;
  /// Value of a cell that is certainly occupied; its negative: certainly free, 0: unknown.
  std::int8_t data_range = 0;
  /// Rows, concatenated; compressed with zlib in an answer, empty in a request.
  std::vector<std::int8_t> data{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// The map as line segments, and its extent.
struct DataVector {
  /// [m]
  float minx = 0;
  /// [m]
  float maxx = 0;
  /// [m]
  float miny = 0;
  /// [m]
  float maxy = 0;
  /// One per line. [frame p_MP, m]
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
