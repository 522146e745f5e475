// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Motion of each kind that moves by itself, by functions of playhouse/bodies/move_NAME.h.

#include "playhouse/bodies/move_actuator.h"
#include "playhouse/bodies/move_custom.h"
#include "playhouse/bodies/move_position.h"

namespace playhouse::bodies {

/// Calls visit(functions) with the functions of a kind that moves.
template <typename Visit>
decltype(auto) with_move(scene::ModelKind kind, const Visit& visit) {
  if (kind == scene::ModelKind::kActuator) return visit(ActuatorMove{});
  if (kind == scene::ModelKind::kCustom) return visit(CustomMove{});
  return visit(PositionMove{});
}

}  // namespace playhouse::bodies
