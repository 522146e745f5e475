// Generated from interfaces/061_pointcloud3d.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Points in space with colors.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::pointcloud3d {

inline constexpr std::uint16_t kCode = 61;

// Subtypes of messages.
/// One cloud.
inline constexpr std::uint8_t kDataState = 1;

/// One point.
struct Element {
  /// [frame p_SP, m]
  Point3d point{};
  Color color{};

  friend bool operator==(const Element&, const Element&) = default;
};

/// One cloud.
struct Data {
  std::vector<Element> points{};

  friend bool operator==(const Data&, const Data&) = default;
};

void read(Reader& in, Element& m);
void write(Writer& out, const Element& m);
void to_json(std::string& out, const Element& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);

}  // namespace playhouse::wire::pointcloud3d
