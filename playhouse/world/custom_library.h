#pragma once

/// The only header that a library with a custom model includes: the base class,
/// all that its hooks read, and the macro that exports it. docs/libraries.md is
/// a tutorial. Headers are those of the program: a library reads the same
/// columns and calls the same functions as built-in models. So it works with
/// the build whose headers it was compiled with; a program with other columns
/// or descriptions rejects it with an error message.

#include <tuple>
#include <type_traits>

#include "playhouse/world/columns.h"
#include "playhouse/world/custom_kind.h"
#include "playhouse/world/surroundings.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// ABI fingerprint: differs between builds with different layouts of the state or the scene.
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
    each_column_of<Table>(add_column);
  };
  std::apply([&](auto... table) { (add_table(table), ...); }, kTables);
  return sum;
}

}  // namespace playhouse::world

/// Exports the class that a library provides; use it once, outside any namespace.
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
