#pragma once

/// The columns of the world, each listed once: name, role, unit, frame, writer, member;
/// those of kinds and traits are generated from kinds/*.toml (generated/table_columns.h).
/// All that is done with every column iterates these lists: insertion and removal of
/// rows, hashes, save and load, comparison, memory accounting, return to the start,
/// tests. A column or table missing from the lists does not
/// compile (columns.cc).

#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "playhouse/world/traits.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// The role of a column decides whether it is hashed, saved and reset.
enum class Role : std::uint8_t {
  kPopulation,  // which models there are, and the tree structure                                  hash, saved
  kMotion,      // poses and velocities; reset by return_to_start()                                hash, saved
  kMark,        // flags, colours, texts and other properties                                      hash, saved
  kSetting,     // limits that clients set, 0 until then             hash while it is not 0; saved
  kShown,       // for viewers alone, whatever it is the run is the same                         saved
  kSensed,      // measurements    sensed_hash, and hash if a controller subscribes the sensor; saved
  kUse,         // subscriptions: change with devices and controllers            sensed_hash
  kDerived,     // function of the population, the scene, the seed or poses; recomputed
};
inline constexpr bool is_saved(Role role) {
  return role != Role::kUse && role != Role::kDerived;
}
/// True if part of hash() regardless of subscriptions.
inline constexpr bool is_done(Role role) {
  return role == Role::kPopulation || role == Role::kMotion || role == Role::kMark || role == Role::kSetting;
}

/// Granularity of a column: one value per row, or per beam of a row.
enum class Per : std::uint8_t { kRow, kBeam };

/// The values of a column by number, whatever the table: for what is done with each column.
template <typename T>
std::vector<T>& numbered(std::vector<T>& values) {
  return values;
}
template <typename T>
const std::vector<T>& numbered(const std::vector<T>& values) {
  return values;
}
template <typename T>
SharedColumn<T>& numbered(SharedColumn<T>& values) {
  return values;
}
template <typename T>
const SharedColumn<T>& numbered(const SharedColumn<T>& values) {
  return values;
}

/// `Of` is a ByRow or a SharedByRow.
template <typename Table, typename Of>
struct Column {
  using Values = std::remove_reference_t<decltype(numbered(std::declval<Of&>()))>;
  const char* name;
  Role role;
  const char* unit;    // "" for numbers, rows and texts
  const char* frame;   // of vectors and poses: P parent, W world, M the model, O odometry; else ""
  const char* writer;  // phases and functions that write it after creation
  Of Table::*values;
  Per per = Per::kRow;

  constexpr Column(const char* name, Role role, const char* unit, const char* frame, const char* writer,
                   Of Table::*values, Per per = Per::kRow)
      : name(name), role(role), unit(unit), frame(frame), writer(writer), values(values), per(per) {}
  constexpr Values& of(Table& table) const { return numbered(table.*values); }
  constexpr const Values& of(const Table& table) const { return numbered(table.*values); }
};

template <typename Values>
inline constexpr bool kIsShared = false;
template <typename T>
inline constexpr bool kIsShared<SharedColumn<T>> = true;

/// The list of a table's columns: its name, and each(visit), which calls visit(column) for every column. A function and
/// no tuple, which takes the compiler half as long again.
template <typename Table>
struct ColumnsOf;

template <>
struct ColumnsOf<Models> {
  static constexpr const char* kTable = "models";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"models.id", Role::kPopulation, "", "", "", &Models::id});
    visit(Column{"models.desc", Role::kPopulation, "", "", "", &Models::desc});
    visit(Column{"models.parent_id", Role::kPopulation, "", "", "attach, detach", &Models::parent_id});
    visit(Column{"models.parent", Role::kDerived, "", "", "attach, detach", &Models::parent});
    visit(Column{"models.X_PM", Role::kMotion, "m, rad", "P", "move, place", &Models::X_PM});
    visit(Column{"models.X_WM", Role::kDerived, "m, rad", "W", "move, place", &Models::X_WM});
    visit(Column{"models.tilt_PM", Role::kMotion, "rad", "P", "move, place", &Models::tilt_PM});
    visit(Column{"models.tilt_WM", Role::kDerived, "rad", "W", "move, place", &Models::tilt_WM});
    visit(Column{"models.V_WM", Role::kMotion, "m/s, m/s, m/s, rad/s, rad/s, rad/s", "W", "move, place",
                 &Models::V_WM});
    visit(Column{"models.still", Role::kMotion, "ticks", "", "move, place", &Models::still});
    visit(Column{"models.root", Role::kDerived, "", "", "attach, detach", &Models::root});
    visit(Column{"models.kind", Role::kDerived, "", "", "", &Models::kind});
    visit(Column{"models.part", Role::kDerived, "", "", "", &Models::part});
    visit(Column{"models.first_child", Role::kDerived, "", "", "attach, detach", &Models::first_child});
    visit(Column{"models.next_sibling", Role::kDerived, "", "", "attach, detach", &Models::next_sibling});
    visit(Column{"models.mobility", Role::kDerived, "", "", "attach, detach", &Models::mobility});
    visit(Column{"models.subscribers", Role::kUse, "", "", "subscribe, unsubscribe", &Models::subscribers});
    visit(Column{"models.controllers", Role::kUse, "", "", "subscribe_controller", &Models::controllers});
    visit(Column{"models.watchers", Role::kUse, "", "", "watch, unwatch", &Models::watchers});
    visit(Column{"models.fiducial_return", Role::kMark, "", "", "set_fiducial_return",
                 &Models::fiducial_return});
    visit(Column{"models.flags", Role::kMark, "", "", "add_flags", &Models::flags});
    visit(Column{"models.color", Role::kMark, "", "", "set_color", &Models::color});
    visit(Column{"models.say", Role::kMark, "", "", "set_say", &Models::say});
    visit(Column{"models.drawing", Role::kShown, "", "", "draw, clear_drawing", &Models::drawing});
  }
};

}  // namespace playhouse::world

#include "playhouse/world/generated/table_columns.h"

namespace playhouse::world {

/// For what is done with the values of a column: compiled once for each of the three dozen types of values, and not
/// into each of the hundreds of visits.
#define PLAYHOUSE_PER_TYPE [[gnu::noinline]]

/// Calls visit(column) for every column of one table.
template <typename Table, typename Visit>
constexpr void each_column_of(const Visit& visit) {
  ColumnsOf<Table>::each(visit);
}

/// Calls visit(table) for the table of every kind; visit is generic.
template <typename Visit>
void each_kind_table(const Visit& visit) {
  std::apply([&](auto... table) { (visit(table), ...); }, kKindTables);
}

/// Calls visit(table) for the table of this kind, if any; visit is generic.
template <typename Visit>
void of_kind(scene::ModelKind kind, const Visit& visit) {
  each_kind_table([&]<typename Table>(Table Tables::*table) {
    if (kKindOf<Table> == kind) visit(table);
  });
}

/// Calls visit(table) for the table of every trait; visit is generic.
template <typename Visit>
void each_trait_table(const Visit& visit) {
  std::apply([&](auto... table) { (visit(table), ...); }, kTraitTables);
}

/// Calls visit(column, values...) for every column of every
/// table, with its values in each of the given worlds.
template <typename Visit, typename... Worlds>
void each_column(const Visit& visit, Worlds&... worlds) {
  const auto each_of = [&]<typename Table>(Table Tables::*table) {
    each_column_of<Table>([&](const auto& column) { visit(column, column.of(worlds.*table)...); });
  };
  std::apply([&](auto... table) { (each_of(table), ...); }, kTables);
}

/// Values [begin, end) of a column.
struct Range {
  std::uint32_t begin = 0, end = 0;
};

/// The range of a model's values in the columns of a table, per row or
/// per beam. The only code that knows how tables refer to each other.
template <typename Table>
Range range_of(const Tables& tables, ModelRow model, Per per) {
  const Models& models = tables.models;
  if constexpr (std::is_same_v<Table, Models>) {
    return {model.index, model.index + 1};
  } else if constexpr (std::is_same_v<decltype(kKindOf<Table>), const scene::ModelKind>) {
    const std::uint32_t part = models.part[model].index;
    return models.kind[model] == kKindOf<Table> ? Range{part, part + 1} : Range{};
  } else if constexpr (!std::is_null_pointer_v<std::remove_const_t<decltype(kHas<Table>)>>) {
    const auto row = trait_row(tables.*kTraitTable<Table>, model);
    return row ? Range{row.index, row.index + 1} : Range{};
  } else {
    static_assert(std::is_same_v<Table, Sensors>);
    if (models.kind[model] != scene::ModelKind::kRanger) return {};
    const RangerRow ranger = models.part[model];
    const SensorRow first = tables.rangers.first_sensor[ranger];
    const std::uint32_t count = tables.rangers.sensor_count[ranger];
    if (per == Per::kRow || count == 0)
      return {first.index, per == Per::kRow ? first.index + count : first.index};
    const Sensors& sensors = tables.sensors;
    const SensorRow last = first + (count - 1);
    return {sensors.first_beam[first].index, sensors.first_beam[last].index + sensors.beam_count[last]};
  }
}

/// Calls visit(column, values..., range) for every column in
/// which a model has values; ranges are those of `tables`.
template <typename Visit, typename... Worlds>
void each_value_of(const Tables& tables, ModelRow model, const Visit& visit, Worlds&... worlds) {
  const auto each_of = [&]<typename Table>(Table Tables::*table) {
    const Range rows = range_of<Table>(tables, model, Per::kRow);
    if (rows.begin == rows.end) return;
    const Range beams = range_of<Table>(tables, model, Per::kBeam);
    each_column_of<Table>([&](const auto& column) {
      visit(column, column.of(worlds.*table)..., column.per == Per::kBeam ? beams : rows);
    });
  };
  std::apply([&](auto... table) { (each_of(table), ...); }, kTables);
}

}  // namespace playhouse::world
