// Generated from interfaces/055_graphics2d.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::graphics2d {

inline constexpr std::uint16_t kCode = 55;

// Subtypes of messages.
inline constexpr std::uint8_t kCmdClear = 1;
inline constexpr std::uint8_t kCmdPoints = 2;
inline constexpr std::uint8_t kCmdPolyline = 3;
inline constexpr std::uint8_t kCmdPolygon = 4;
inline constexpr std::uint8_t kCmdMultiline = 5;

struct CmdPoints {
  /// [frame p_WP]
  std::vector<Point2d> points{};
  Color color{};

  friend bool operator==(const CmdPoints&, const CmdPoints&) = default;
};

struct CmdPolyline {
  /// [frame p_WP]
  std::vector<Point2d> points{};
  Color color{};

  friend bool operator==(const CmdPolyline&, const CmdPolyline&) = default;
};

struct CmdPolygon {
  /// [frame p_WP]
  std::vector<Point2d> points{};
  Color color{};
  Color fill_color{};
  std::uint8_t filled = 0;

  friend bool operator==(const CmdPolygon&, const CmdPolygon&) = default;
};

struct CmdMultiline {
  /// [frame p_WP]
  std::vector<Point2d> points{};
  Color color{};

  friend bool operator==(const CmdMultiline&, const CmdMultiline&) = default;
};

void read(Reader& in, CmdPoints& m);
void write(Writer& out, const CmdPoints& m);
void to_json(std::string& out, const CmdPoints& m);
void read(Reader& in, CmdPolyline& m);
void write(Writer& out, const CmdPolyline& m);
void to_json(std::string& out, const CmdPolyline& m);
void read(Reader& in, CmdPolygon& m);
void write(Writer& out, const CmdPolygon& m);
void to_json(std::string& out, const CmdPolygon& m);
void read(Reader& in, CmdMultiline& m);
void write(Writer& out, const CmdMultiline& m);
void to_json(std::string& out, const CmdMultiline& m);

}  // namespace playhouse::wire::graphics2d
