// Generated from interfaces/055_graphics2d.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Draws 2D shapes for display.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::graphics2d {

inline constexpr std::uint16_t kCode = 55;

// Subtypes of messages.
/// Removes all drawn shapes.
inline constexpr std::uint8_t kCmdClear = 1;
/// Draws points.
inline constexpr std::uint8_t kCmdPoints = 2;
/// Draws a line through points.
inline constexpr std::uint8_t kCmdPolyline = 3;
/// Draws a polygon.
inline constexpr std::uint8_t kCmdPolygon = 4;
/// Draws a line for each pair of points.
inline constexpr std::uint8_t kCmdMultiline = 5;

/// Points.
struct CmdPoints {
  /// [frame p_SP, m]
  std::vector<Point2d> points{};
  Color color{};

  friend bool operator==(const CmdPoints&, const CmdPoints&) = default;
};

/// A line through points.
struct CmdPolyline {
  /// [frame p_SP, m]
  std::vector<Point2d> points{};
  Color color{};

  friend bool operator==(const CmdPolyline&, const CmdPolyline&) = default;
};

/// A polygon.
struct CmdPolygon {
  /// Vertices. [frame p_SP, m]
  std::vector<Point2d> points{};
  /// Outline color.
  Color color{};
  /// Fill color.
  Color fill_color{};
  /// 1: filled.
  std::uint8_t filled = 0;

  friend bool operator==(const CmdPolygon&, const CmdPolygon&) = default;
};

/// Lines, each between two points.
struct CmdMultiline {
  /// Start and end of each line, alternating. [frame p_SP, m]
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
