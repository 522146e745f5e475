// Generated from interfaces/058_graphics3d.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Draws 3D shapes for display.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::graphics3d {

inline constexpr std::uint16_t kCode = 58;

// Subtypes of messages.
/// Removes all drawn shapes.
inline constexpr std::uint8_t kCmdClear = 1;
/// Draws points, lines or faces.
inline constexpr std::uint8_t kCmdDraw = 2;
/// Translates the coordinate frame of subsequent drawing.
inline constexpr std::uint8_t kCmdTranslate = 3;
/// Rotates the coordinate frame of subsequent drawing.
inline constexpr std::uint8_t kCmdRotate = 4;
/// Pushes the current coordinate frame.
inline constexpr std::uint8_t kCmdPush = 5;
/// Pops the pushed coordinate frame.
inline constexpr std::uint8_t kCmdPop = 6;

/// Values of CmdDraw.draw_mode: primitives made from the points.
inline constexpr std::int32_t kDrawPoints = 0;
inline constexpr std::int32_t kDrawLines = 1;
inline constexpr std::int32_t kDrawLineStrip = 2;
inline constexpr std::int32_t kDrawLineLoop = 3;
inline constexpr std::int32_t kDrawTriangles = 4;
inline constexpr std::int32_t kDrawTriangleStrip = 5;
inline constexpr std::int32_t kDrawTriangleFan = 6;
inline constexpr std::int32_t kDrawQuads = 7;
inline constexpr std::int32_t kDrawQuadStrip = 8;
inline constexpr std::int32_t kDrawPolygon = 9;

/// Points, lines or faces.
struct CmdDraw {
  std::uint32_t draw_mode = 0;
  /// [frame p_SP, m]
  std::vector<Point3d> points{};
  Color color{};

  friend bool operator==(const CmdDraw&, const CmdDraw&) = default;
};

/// A translation of the coordinate frame.
struct CmdTranslate {
  /// [m]
  double x = 0;
  /// [m]
  double y = 0;
  /// [m]
  double z = 0;

  friend bool operator==(const CmdTranslate&, const CmdTranslate&) = default;
};

/// A rotation of the coordinate frame.
struct CmdRotate {
  /// Angle about the vector (x, y, z). [rad]
  double a = 0;
  /// [1]
  double x = 0;
  /// [1]
  double y = 0;
  /// [1]
  double z = 0;

  friend bool operator==(const CmdRotate&, const CmdRotate&) = default;
};

void read(Reader& in, CmdDraw& m);
void write(Writer& out, const CmdDraw& m);
void to_json(std::string& out, const CmdDraw& m);
void read(Reader& in, CmdTranslate& m);
void write(Writer& out, const CmdTranslate& m);
void to_json(std::string& out, const CmdTranslate& m);
void read(Reader& in, CmdRotate& m);
void write(Writer& out, const CmdRotate& m);
void to_json(std::string& out, const CmdRotate& m);

}  // namespace playhouse::wire::graphics3d
