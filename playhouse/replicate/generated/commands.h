// Generated from viewer/commands.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// What a page may ask of the program; docs/viewer-commands.md has the units and ranges.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "playhouse/world/model_id.h"

namespace playhouse::replicate {

/// Packets up to this one were taken in.
struct Acknowledge {
  std::uint32_t frame = 0;
};

/// What is on the screen, in the world's frame; whether to send the sensors of all robots there.
struct Look {
  double x_min = 0;
  double y_min = 0;
  double x_max = 0;
  double y_max = 0;
  bool sensors = false;
};

/// The robot of this model is selected, or null: none any more.
struct Select {
  std::optional<world::ModelId> model;
};

/// Asks what physics takes bodies for; refused while that or a world is on its way to this viewer.
struct ShowPhysics {};

/// Velocities of the wheels of this model, in the robot's frame, [m/s, rad/s]. They hold for 0.5 s of wall
/// time (kViewerDriveSeconds), so send them again before; all zero: stop now. The newest of all viewers' and
/// clients' commands counts. With an input above 0 the viewer is told from which tick on it counts. Who joins
/// drives the own body.
struct Drive {
  world::ModelId model;
  double forward = 0;
  double sideways = 0;
  double turn = 0;
  std::uint32_t input = 0;
};

/// A body of the viewer's own: a person like the first addable one that walks, called so (a number behind
/// where somebody is already), in place of the one it had; it goes when the viewer does. Refused in worlds
/// without people.
struct Join {
  std::string name;
  double x = 0;
  double y = 0;
  double a = 0;
};

/// What that body says from now on; "": nothing.
struct Say {
  std::string text;
};

/// Time stands still, for everyone.
struct Pause {};

/// Time goes on, for everyone.
struct Resume {};

/// One tick, then a pause.
struct Step {};

/// How fast time goes, for everyone; 0: as fast as possible.
struct SetSpeed {
  double times_real_time = 1;
};

/// For everyone: the state of the recorded instant nearest to this tick, from which the run goes on; refused
/// while there is none.
struct Rewind {
  std::uint64_t tick = 0;
};

/// Puts a movable model of the top level there.
struct Drag {
  world::ModelId model;
  double x = 0;
  double y = 0;
  double a = 0;
};

/// A new tree like the addable one of this place in the list; its name is that one's with a number behind it.
struct Add {
  std::uint32_t robot = 0;
  double x = 0;
  double y = 0;
  double a = 0;
};

/// A new tree like the one that this model is in, standing free there.
struct Copy {
  world::ModelId model;
  double x = 0;
  double y = 0;
  double a = 0;
};

/// Takes the tree that this model is in out of the world. Who joins may do so with the own body.
struct Remove {
  world::ModelId model;
};

/// What this viewer says is refused from now on, or no longer.
struct Mute {
  std::uint32_t viewer = 0;
  bool on = false;
};

/// Sends this viewer out, who may not come again.
struct Kick {
  std::uint32_t viewer = 0;
};

/// Asks for the world as it stands, as a world file; refused while one is on its way to this viewer.
struct Save {};

using Command =
    std::variant<Acknowledge, Look, Select, ShowPhysics, Drive, Join, Say, Pause, Resume, Step, SetSpeed, Rewind, Drag, Add, Copy, Remove, Mute, Kick, Save>;

/// Whose a command is: everybody's, or of those who have a right.
enum class May : std::uint8_t { kAnybody, kDrives, kJoins, kManages };

constexpr May who_may(const Command& command) {
  constexpr May kMay[] = {
      May::kAnybody,  // Acknowledge
      May::kAnybody,  // Look
      May::kAnybody,  // Select
      May::kAnybody,  // ShowPhysics
      May::kDrives,  // Drive
      May::kJoins,  // Join
      May::kJoins,  // Say
      May::kManages,  // Pause
      May::kManages,  // Resume
      May::kManages,  // Step
      May::kManages,  // SetSpeed
      May::kManages,  // Rewind
      May::kManages,  // Drag
      May::kManages,  // Add
      May::kManages,  // Copy
      May::kManages,  // Remove
      May::kManages,  // Mute
      May::kManages,  // Kick
      May::kManages,  // Save
  };
  return kMay[command.index()];
}

}  // namespace playhouse::replicate
