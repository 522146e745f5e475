#pragma once

/// What a viewer may ask for: one JSON object per message, read strictly. An unknown key, a missing one, a
/// number out of its range or a long message is refused with one line that says why. viewer/commands.toml
/// defines them, docs/viewer-commands.md lists them. Whether a model exists and may be moved or driven is for
/// the receiver to check.

#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/geom/pose.h"
#include "playhouse/replicate/generated/commands.h"

namespace playhouse::replicate {

/// In the robot's frame; all zero: let go.
inline geom::Twist velocity_of(const Drive& drive) {
  return {drive.forward, drive.sideways, 0, drive.turn};
}

inline geom::Box view_of(const Look& look) {
  return {look.x_min, look.y_min, look.x_max, look.y_max};
}

Result<Command> parse_command(std::string_view text);

}  // namespace playhouse::replicate
