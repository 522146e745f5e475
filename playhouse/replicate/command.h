#pragma once

/// Commands of viewers: one JSON object per message, parsed strictly. An unknown or
/// missing key, a number out of range or an overlong message is rejected with a
/// one-line reason. viewer/commands.toml defines them, docs/viewer-commands.md lists
/// them. The receiver checks whether a model exists and may be moved or driven.

#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/geom/pose.h"
#include "playhouse/replicate/generated/commands.h"

namespace playhouse::replicate {

/// In the robot's frame; all zero: releases the robot.
inline geom::Twist velocity_of(const Drive& drive) {
  return {drive.forward, drive.sideways, 0, drive.turn};
}

inline geom::Box view_of(const Look& look) {
  return {look.x_min, look.y_min, look.x_max, look.y_max};
}

Result<Command> parse_command(std::string_view text);

}  // namespace playhouse::replicate
