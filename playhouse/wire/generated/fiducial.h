// Generated from interfaces/010_fiducial.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::fiducial {

inline constexpr std::uint16_t kCode = 10;

// Subtypes of messages.
inline constexpr std::uint8_t kDataScan = 1;
inline constexpr std::uint8_t kReqGetGeom = 1;
inline constexpr std::uint8_t kReqGetFov = 2;
inline constexpr std::uint8_t kReqSetFov = 3;
inline constexpr std::uint8_t kReqGetId = 7;
inline constexpr std::uint8_t kReqSetId = 8;

struct Item {
  std::int32_t id = 0;
  /// [frame X_RS]
  Pose3d pose{};
  /// [frame X_RS]
  Pose3d upose{};

  friend bool operator==(const Item&, const Item&) = default;
};

struct Data {
  std::vector<Item> fiducials{};

  friend bool operator==(const Data&, const Data&) = default;
};

struct Geom {
  /// [frame X_RS]
  Pose3d pose{};
  Bbox3d size{};
  /// [m, m]
  Bbox2d fiducial_size{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

struct Fov {
  /// [m]
  float min_range = 0;
  /// [m]
  float max_range = 0;
  /// [rad]
  float view_angle = 0;

  friend bool operator==(const Fov&, const Fov&) = default;
};

struct Id {
  std::uint32_t id = 0;

  friend bool operator==(const Id&, const Id&) = default;
};

void read(Reader& in, Item& m);
void write(Writer& out, const Item& m);
void to_json(std::string& out, const Item& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Geom& m);
void write(Writer& out, const Geom& m);
void to_json(std::string& out, const Geom& m);
void read(Reader& in, Fov& m);
void write(Writer& out, const Fov& m);
void to_json(std::string& out, const Fov& m);
void read(Reader& in, Id& m);
void write(Writer& out, const Id& m);
void to_json(std::string& out, const Id& m);

}  // namespace playhouse::wire::fiducial
