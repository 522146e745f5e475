#pragma once

/// What a viewer may ask for: one JSON object per message, read strictly. An unknown key, a missing one, a
/// number out of its range or a long message is refused with one line that says why. docs/viewer-protocol.md
/// lists them.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "playhouse/base/result.h"
#include "playhouse/geom/pose.h"
#include "playhouse/world/model_id.h"

namespace playhouse::replicate {

struct Pause {};
struct Resume {};
struct Step {};
struct SetSpeed {
  double times_real_time = 1;  // 0: as fast as possible
};
struct Rewind {
  std::uint64_t tick = 0;  // the instant nearest to it is meant
};
struct Drag {
  world::ModelId model;  // the receiver checks that it exists and may be dragged
  double x = 0, y = 0;   // m, W
  double a = 0;          // rad
};
/// Velocities of one robot's wheels, which hold for limits::kViewerDriveSeconds unless renewed.
struct Drive {
  world::ModelId model;     // the receiver checks that it exists and has wheels
  geom::Twist velocity;     // m/s, rad/s in the robot's frame; all zero: let go
  std::uint32_t input = 0;  // the viewer's number for it, which is told back once it counts; 0: none
};
/// Another tree like the one that this model is in, standing free at x, y, a.
struct Copy {
  world::ModelId model;
  double x = 0, y = 0;  // m, W
  double a = 0;         // rad
};
/// A new tree of the scene's robots (replicate::addable()).
struct Add {
  std::uint32_t robot = 0;  // place in that list
  double x = 0, y = 0;      // m, W
  double a = 0;             // rad
};
/// A body of the viewer's own: a person of the scene's, who goes when the viewer does.
struct Join {
  std::string name;
  double x = 0, y = 0;  // m, W
  double a = 0;         // rad
};
/// What the viewer's body says from now on; empty: nothing.
struct Say {
  std::string text;
};
/// Takes the tree that this model is in out of the world.
struct Remove {
  world::ModelId model;
};
/// Whether this viewer is heard when it says something.
struct Mute {
  std::uint32_t viewer = 0;
  bool on = true;
};
/// Sends this viewer out, who may not come again.
struct Kick {
  std::uint32_t viewer = 0;
};
/// Sends the world as it stands, as a world file, to this viewer.
struct Save {};
/// Tells this viewer what physics takes bodies for.
struct ShowPhysics {};
struct Select {
  std::optional<world::ModelId> model;  // none: nothing is selected any more
};
struct Look {
  geom::Box view;        // m, W
  bool sensors = false;  // show the sensors of every robot in view
};
struct Acknowledge {
  std::uint32_t frame = 0;
};

using Command = std::variant<Pause, Resume, Step, SetSpeed, Rewind, Drag, Drive, Copy, Add, Join, Say, Remove,
                             Mute, Kick, Save, ShowPhysics, Select, Look, Acknowledge>;

inline constexpr double kSpeedMost = 1000;               // times real time
inline constexpr double kTickMost = 9007199254740992.0;  // whole numbers are exact up to here
inline constexpr double kPlaceMost = 1e6;                // m, of a coordinate from a viewer
inline constexpr double kDriveMost = 100;                // m/s or rad/s, of a velocity from a viewer

Result<Command> parse_command(std::string_view text);

}  // namespace playhouse::replicate
