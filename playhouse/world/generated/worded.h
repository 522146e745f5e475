// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// State initialised by a word of world files, and saved by it with its current value.

#include "playhouse/world/generated/tables.h"

namespace playhouse::world {

/// Gives the last row of a table what the model's words say. Tables without such columns stay as they are.
template <typename Table>
void begin_as_said(Table&, const scene::ModelDesc&) {}
inline void begin_as_said(Blinkenlights& table, const scene::ModelDesc& model) {
  if (!model.blinkenlight) return;
  table.enabled.back() = model.blinkenlight->enabled;
  table.period.back() = model.blinkenlight->period;
  table.dutycycle.back() = model.blinkenlight->dutycycle;
}
inline void begin_as_said(Actuators& table, const scene::ModelDesc& model) {
  if (!model.actuator) return;
  table.position.back() = model.actuator->start_position;
}

/// All such state of a model is what its words say.
inline bool is_as_said(const Tables& tables, std::uint32_t model, const scene::ModelDesc& said) {
  switch (said.kind) {
    case scene::ModelKind::kBlinkenlight: {
      const Blinkenlights& table = tables.blinkenlights;
      const std::uint32_t row = tables.models.part[model];
      return !said.blinkenlight || (static_cast<bool>(table.enabled[row]) == said.blinkenlight->enabled && table.period[row] == said.blinkenlight->period && table.dutycycle[row] == said.blinkenlight->dutycycle);
    }
    case scene::ModelKind::kActuator: {
      const Actuators& table = tables.actuators;
      const std::uint32_t row = tables.models.part[model];
      return !said.actuator || (table.position[row] == said.actuator->start_position);
    }
    default:
      return true;
  }
}

/// Makes a model's words say all such state as it is.
inline void say_as_is(const Tables& tables, std::uint32_t model, scene::ModelDesc& says) {
  switch (says.kind) {
    case scene::ModelKind::kBlinkenlight: {
      const Blinkenlights& table = tables.blinkenlights;
      const std::uint32_t row = tables.models.part[model];
      if (!says.blinkenlight) says.blinkenlight.emplace();
      says.blinkenlight->enabled = table.enabled[row];
      says.blinkenlight->period = table.period[row];
      says.blinkenlight->dutycycle = table.dutycycle[row];
      return;
    }
    case scene::ModelKind::kActuator: {
      const Actuators& table = tables.actuators;
      const std::uint32_t row = tables.models.part[model];
      if (!says.actuator) says.actuator.emplace();
      says.actuator->start_position = table.position[row];
      return;
    }
    default:
      return;
  }
}

}  // namespace playhouse::world
