#pragma once

/// The value types of columns, decomposed into numbers in one place: hash, save, load, checks and tests
/// build on each_number(). An unsupported type does not compile; structured bindings name all members,
/// so that an added member does not compile either. Records are generated, with such an each_part().

#include <string>
#include <type_traits>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// Values of variable length: the size counts as a number, followed by the elements.
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
template <>
inline constexpr bool kIsRow<KindRow> = true;

/// Calls visit(number) for every number of a value that is no list; const if the value is.
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
