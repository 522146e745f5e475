#pragma once

/// The columns of the world, each listed once: name, role, member. What is done with every column goes
/// through these lists: the hashes, the count of memory, the return to the start, the tests. A column or a
/// table that is not listed does not compile.

#include <tuple>
#include <type_traits>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// What a column is to the run, and so which hash it is part of.
enum class Role : std::uint8_t {
  kFixed,   // as the scene and its controllers have it; never changes             hash
  kMotion,  // where things are and how they move; return_to_start() resets it     hash
  kMark,    // what things carry, show and say                                     hash
  kSensed,  // what sensors measured    sensed_hash, and hash where a controller reads the sensor
  kUse,     // who looks                                                           sensed_hash
};

template <typename Table, typename T>
struct Column {
  const char* name;
  Role role;
  std::vector<T> Table::*values;

  constexpr Column(const char* name, Role role, std::vector<T> Table::*values)
      : name(name), role(role), values(values) {}
};

template <typename Table>
inline constexpr auto kColumns = nullptr;

template <>
inline constexpr auto kColumns<Models> = std::tuple{
    Column{"models.X_PM", Role::kMotion, &Models::X_PM},
    Column{"models.X_WM", Role::kMotion, &Models::X_WM},
    Column{"models.parent", Role::kFixed, &Models::parent},
    Column{"models.root", Role::kFixed, &Models::root},
    Column{"models.kind", Role::kFixed, &Models::kind},
    Column{"models.part", Role::kFixed, &Models::part},
    Column{"models.subscribers", Role::kUse, &Models::subscribers},
    Column{"models.controllers", Role::kFixed, &Models::controllers},
    Column{"models.fiducial_return", Role::kMark, &Models::fiducial_return},
    Column{"models.flags", Role::kMark, &Models::flags},
    Column{"models.color", Role::kMark, &Models::color},
    Column{"models.say", Role::kMark, &Models::say},
};

template <>
inline constexpr auto kColumns<Positions> = std::tuple{
    Column{"positions.model", Role::kFixed, &Positions::model},
    Column{"positions.mode", Role::kMotion, &Positions::mode},
    Column{"positions.command", Role::kMotion, &Positions::command},
    Column{"positions.goal", Role::kMotion, &Positions::goal},
    Column{"positions.velocity", Role::kMotion, &Positions::velocity},
    Column{"positions.X_OM", Role::kMotion, &Positions::X_OM},
    Column{"positions.X_WO", Role::kMotion, &Positions::X_WO},
    Column{"positions.odom_error", Role::kFixed, &Positions::odom_error},
    Column{"positions.stall", Role::kMotion, &Positions::stall},
    Column{"positions.motor_on", Role::kMotion, &Positions::motor_on},
};

template <>
inline constexpr auto kColumns<Rangers> = std::tuple{
    Column{"rangers.model", Role::kFixed, &Rangers::model},
    Column{"rangers.first_sensor", Role::kFixed, &Rangers::first_sensor},
    Column{"rangers.sensor_count", Role::kFixed, &Rangers::sensor_count},
    Column{"rangers.measured_tick", Role::kSensed, &Rangers::measured_tick},
};

/// What sensors measured has a row per beam.
template <>
inline constexpr auto kColumns<Sensors> = std::tuple{
    Column{"sensors.ranger", Role::kFixed, &Sensors::ranger},
    Column{"sensors.first_beam", Role::kFixed, &Sensors::first_beam},
    Column{"sensors.beam_count", Role::kFixed, &Sensors::beam_count},
    Column{"sensors.ranges", Role::kSensed, &Sensors::ranges},
    Column{"sensors.intensities", Role::kSensed, &Sensors::intensities},
};

template <>
inline constexpr auto kColumns<Fiducials> = std::tuple{
    Column{"fiducials.model", Role::kFixed, &Fiducials::model},
    Column{"fiducials.hits", Role::kSensed, &Fiducials::hits},
    Column{"fiducials.measured_tick", Role::kSensed, &Fiducials::measured_tick},
};

inline constexpr std::tuple kTables{&Tables::models, &Tables::positions, &Tables::rangers, &Tables::sensors,
                                    &Tables::fiducials};
static_assert(std::apply([]<typename... Table>(Table Tables::*...) { return (sizeof(Table) + ...); },
                         kTables) == sizeof(Tables),
              "a table is not in the list");

/// Calls visit(column) for every column of one table.
template <typename Table, typename Visit>
void each_column_of(const Visit& visit) {
  static_assert(std::tuple_size_v<decltype(kColumns<Table>)> * sizeof(std::vector<int>) == sizeof(Table),
                "a column of this table is not in its list");
  std::apply([&](const auto&... column) { (visit(column), ...); }, kColumns<Table>);
}

/// Calls visit(column, values...) for every column of every table, with its values in each of the worlds
/// given.
template <typename Visit, typename... Worlds>
void each_column(const Visit& visit, Worlds&... worlds) {
  const auto each_of = [&]<typename Table>(Table Tables::*table) {
    each_column_of<Table>([&](const auto& column) { visit(column, worlds.*table.*column.values...); });
  };
  std::apply([&](auto... table) { (each_of(table), ...); }, kTables);
}

}  // namespace playhouse::world
