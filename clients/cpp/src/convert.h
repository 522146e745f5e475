#pragma once

/// Conversions between the wire structs and the values of the proxies.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/wire/generated/common.h"
#include "playhouse_client/attitude.h"
#include "playhouse_client/charging.h"
#include "playhouse_client/color.h"
#include "playhouse_client/covariance.h"
#include "playhouse_client/device.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

inline Pose pose(const wire::Pose2d& p) {
  return {p.px, p.py, p.pa};
}
inline Velocity velocity(const wire::Pose2d& p) {
  return {p.px, p.py, p.pa};
}
inline Pose3d pose(const wire::Pose3d& p) {
  return {p.px, p.py, p.pz, p.proll, p.ppitch, p.pyaw};
}
inline wire::Pose2d on_wire(const Pose& p) {
  return {p.x, p.y, p.a};
}
inline wire::Pose3d on_wire(const Pose3d& p) {
  return {p.x, p.y, p.z, p.roll, p.pitch, p.yaw};
}
inline Size size(const wire::Bbox3d& s) {
  return {s.sl, s.sw, s.sh};
}
inline Pose3d pose(const wire::Point3d& p, const wire::Orientation3d& o) {
  return {p.px, p.py, p.pz, o.proll, o.ppitch, o.pyaw};
}
inline std::array<double, 3> vector(const wire::Point3d& p) {
  return {p.px, p.py, p.pz};
}
inline Attitude attitude(const wire::Orientation3d& o) {
  return {o.proll, o.ppitch, o.pyaw};
}
/// Roll, pitch and yaw.
inline std::array<double, 3> angles(const wire::Orientation3d& o) {
  return {o.proll, o.ppitch, o.pyaw};
}
inline Rgb rgb(const wire::Color& c) {
  return {c.red, c.green, c.blue};
}
inline std::array<std::uint8_t, 4> rgba(const wire::Color& c) {
  return {c.red, c.green, c.blue, c.alpha};
}
inline wire::Color on_wire(const Rgb& color) {
  constexpr std::uint8_t kOpaque = 255;
  return {kOpaque, color[0], color[1], color[2]};
}
inline Covariance covariance(const std::array<double, 6>& c) {
  return {c[0], c[1], c[2], c[3], c[4], c[5]};
}
inline std::array<double, 6> on_wire(const Covariance& c) {
  return {c.xx, c.yy, c.aa, c.xy, c.ya, c.xa};
}

/// Of 0xRRGGBB.
inline Rgb packed_rgb(std::uint32_t color) {
  const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>(color >> shift & 0xFF); };
  return {byte(16), byte(8), byte(0)};
}
Charging charging(std::int32_t state);
/// Levels in dBm are signed, all others are not.
std::int64_t level(std::int32_t value, std::uint32_t unit);
/// Of each of `count` ranges: those of the elements if there is one per range, else spread from `low` to `high`.
std::vector<double> directions(double low, double high, std::size_t count,
                               const std::vector<wire::Pose3d>& elements = {});
template <typename Range>
std::vector<double> directions(double low, double high, const std::vector<Range>& ranges,
                               const std::vector<wire::Pose3d>& elements = {}) {
  return directions(low, high, ranges.size(), elements);
}

inline std::string text_of(std::string_view raw) {
  return std::string(wire::text(raw));
}
inline std::string text_of(const std::vector<std::uint8_t>& raw) {
  return text_of(std::string(raw.begin(), raw.end()));
}

/// What `make` makes of each element.
template <typename List, typename Make>
auto each(const List& list, Make make) {
  std::vector<decltype(make(*list.begin()))> made;
  made.reserve(list.size());
  for (const auto& one : list) made.push_back(make(one));
  return made;
}

/// The bytes of a message, or an error if they exceed the protocol's limit.
Result<std::vector<std::uint8_t>> bytes_on_wire(const Device& device, std::string_view bytes);

}  // namespace playhouse::client
