#pragma once

/// The types of values that columns have, each taken apart in one place: hash, save, load, checks and tests
/// follow from each_number(). A type that is not here does not compile; bindings name all parts of a value,
/// so that one more part does not compile either. Records are generated, with an each_part() that does so.

#include <string>
#include <type_traits>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// Values of any length: their size is a number as well, then come their elements.
template <typename T>
inline constexpr bool kIsList = false;
template <>
inline constexpr bool kIsList<std::string> = true;
template <typename T>
inline constexpr bool kIsList<std::vector<T>> = true;

template <typename T>
inline constexpr bool kIsRow = false;
template <typename Table>
inline constexpr bool kIsRow<Row<Table>> = true;

/// Calls visit(number) for every number of a value that is no list, const as the value is.
template <typename V, typename Visit>
void each_number(V& value, const Visit& visit) {
  using T = std::remove_const_t<V>;
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    visit(value);
  } else if constexpr (std::is_same_v<T, ModelId>) {
    auto& [number] = value;
    visit(number);
  } else if constexpr (kIsRow<T>) {
    auto& [index] = value;
    visit(index);
  } else if constexpr (std::is_same_v<T, geom::Pose> || std::is_same_v<T, geom::Twist>) {
    auto& [x, y, z, a] = value;
    visit(x), visit(y), visit(z), visit(a);
  } else if constexpr (std::is_same_v<T, geom::Tilt>) {
    auto& [x, y] = value;
    visit(x), visit(y);
  } else if constexpr (std::is_same_v<T, geom::Size> || std::is_same_v<T, geom::Vec3>) {
    auto& [x, y, z] = value;
    visit(x), visit(y), visit(z);
  } else if constexpr (std::is_same_v<T, geom::SpatialVelocity>) {
    auto& [v, w] = value;
    each_number(v, visit), each_number(w, visit);
  } else if constexpr (std::is_same_v<T, scene::Color>) {
    auto& [r, g, b, a] = value;
    visit(r), visit(g), visit(b), visit(a);
  } else {
    // A record of kinds/*.toml.
    each_part(value, [&](auto& part) { each_number(part, visit); });
  }
}

}  // namespace playhouse::world
