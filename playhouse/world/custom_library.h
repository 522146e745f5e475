#pragma once

/// What a shared library with a custom model includes: the class that it derives from, all that its hooks
/// read, and the macro that names it. docs/libraries.md shows how.
///
/// Headers are those of the program: a library reads the same columns and calls the same functions as models
/// that are built in. So it fits the program whose headers it is built with, and one that has other columns
/// or descriptions refuses it with a line.

#include <tuple>
#include <type_traits>

#include "playhouse/world/columns.h"
#include "playhouse/world/custom_kind.h"
#include "playhouse/world/surroundings.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// A number that tells programs apart in which the state or the scene is laid out in other ways.
constexpr std::uint64_t layout() {
  std::uint64_t sum = mix64(sizeof(World)) ^ sizeof(scene::SceneDesc);
  const auto add = [&sum](std::uint64_t value) { sum = mix64(sum ^ value); };
  add(sizeof(scene::ModelDesc));
  add(sizeof(CustomActor));
  add(sizeof(CustomSensor));
  const auto add_column = [&]<typename Column>(const Column& column) {
    for (const char* letter = column.name; *letter != 0; ++letter) add(static_cast<unsigned char>(*letter));
    add(sizeof(typename Column::Values::value_type));
  };
  const auto add_table = [&]<typename Table>(Table Tables::*) {
    std::apply([&](const auto&... column) { (add_column(column), ...); }, kColumns<Table>);
  };
  std::apply([&](auto... table) { (add_table(table), ...); }, kTables);
  return sum;
}

}  // namespace playhouse::world

/// Names the class that a library provides; write it once, outside any namespace.
#define PLAYHOUSE_CUSTOM_KIND(Type)                                                            \
  extern "C" __attribute__((visibility("default"))) std::uint32_t playhouse_custom_version() { \
    return ::playhouse::world::kCustomVersion;                                                 \
  }                                                                                            \
  extern "C" __attribute__((visibility("default"))) std::uint64_t playhouse_custom_layout() {  \
    return ::playhouse::world::layout();                                                       \
  }                                                                                            \
  extern "C" __attribute__((visibility("default"))) ::playhouse::world::CustomKind*            \
  playhouse_custom_make() {                                                                    \
    return new Type;                                                                           \
  }
