#pragma once

/// Values of columns in hashes: every number of a value, and serial numbers in place of ids.

#include "playhouse/base/hash.h"
#include "playhouse/world/values.h"

namespace playhouse::world {

template <typename T>
inline constexpr bool kIsRecord = requires(const T& value) {
  each_part(value, [](const auto&) {});
};

template <typename T>
void add_value(Hash& hash, const World& world, const T& value) {
  if constexpr (kIsList<T>) {
    hash.add(std::uint64_t{value.size()});
    for (const auto& element : value) add_value(hash, world, element);
  } else if constexpr (std::is_same_v<T, ModelId>) {
    hash.add(std::uint64_t{world.serial(value)});
  } else if constexpr (kIsRecord<T>) {
    each_part(value, [&](const auto& part) { add_value(hash, world, part); });
  } else {
    each_number(value, [&](auto number) {
      if constexpr (std::is_floating_point_v<decltype(number)>) {
        hash.add(number);
      } else {
        hash.add(static_cast<std::uint64_t>(number));
      }
    });
  }
}

}  // namespace playhouse::world
