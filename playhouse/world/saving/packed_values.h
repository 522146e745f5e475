#pragma once

/// Serialisation of the value types of columns (values.h).

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "playhouse/base/packing.h"
#include "playhouse/world/values.h"

namespace playhouse::world {

template <typename Number>
void put_number(Packer& out, Number number) {
  if constexpr (std::is_same_v<Number, double>) {
    out.f64(number);
  } else if constexpr (std::is_same_v<Number, float>) {
    out.f32(number);
  } else if constexpr (sizeof(Number) == 1) {
    out.u8(static_cast<std::uint8_t>(number));
  } else if constexpr (sizeof(Number) == 4) {
    out.u32(static_cast<std::uint32_t>(number));
  } else {
    static_assert(sizeof(Number) == 8);
    out.u64(static_cast<std::uint64_t>(number));
  }
}

template <typename Number>
void get_number(Unpacker& in, Number& number) {
  if constexpr (std::is_same_v<Number, double>) {
    number = in.f64();
  } else if constexpr (std::is_same_v<Number, float>) {
    number = in.f32();
  } else if constexpr (sizeof(Number) == 1) {
    number = static_cast<Number>(in.u8());
  } else if constexpr (sizeof(Number) == 4) {
    number = static_cast<Number>(in.u32());
  } else {
    number = static_cast<Number>(in.u64());
  }
}

/// Headings are normalised, except in scenes made in code.  [rad]
inline constexpr double kMostTurn = 1e6;

/// True for values that are safe for arithmetic.
template <typename T>
bool is_good(const T& value) {
  if constexpr (std::is_same_v<T, geom::Pose>) return is_place(value) && std::fabs(value.a) <= kMostTurn;
  if constexpr (std::is_same_v<T, geom::Tilt>) return geom::is_tilt(value);
  if constexpr (std::is_same_v<T, ControlMode>) return value <= ControlMode::kHeading;
  bool good = true;
  if constexpr (!kIsList<T>)
    each_number(value, [&](auto number) {
      if constexpr (std::is_floating_point_v<decltype(number)>) good = good && std::isfinite(number);
    });
  return good;
}

/// False: load would reject the value.
template <typename T>
bool put_value(Packer& out, const T& value) {
  bool good = is_good(value);
  if constexpr (kIsList<T>) {
    out.varint(value.size());
    for (const auto& element : value) good = put_value(out, element) && good;
  } else {
    each_number(value, [&](auto number) { put_number(out, number); });
  }
  return good;
}

/// False: truncated, or an invalid value.
template <typename T>
bool get_value(Unpacker& in, T& value) {
  if constexpr (kIsList<T>) {
    const std::uint64_t size = in.varint();
    if (!in.ok() || size > in.left()) return false;
    value.resize(static_cast<std::size_t>(size));
    for (auto& element : value)
      if (!get_value(in, element)) return false;
  } else {
    each_number(value, [&](auto& number) { get_number(in, number); });
  }
  return in.ok() && is_good(value);
}

}  // namespace playhouse::world
