// Generated from viewer/commands.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Commands of a page to the program; units and ranges are in docs/viewer-commands.md.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "playhouse/world/model_id.h"

namespace playhouse::replicate {

/// Acknowledges packets up to this one.
struct Acknowledge {
  std::uint32_t frame = 0;
};

/// Visible region, in the world's frame; whether to send sensor data of all robots in it.
struct Look {
  double x_min = 0;
  double y_min = 0;
  double x_max = 0;
  double y_max = 0;
  bool sensors = false;
};

/// Selects the robot of this model; null clears the selection.
struct Select {
  std::optional<world::ModelId> model;
};

/// Requests the collision shapes of the bodies; refused while a reply, or a saved world, is in transit to
/// this viewer.
struct ShowPhysics {};

/// Velocity command for this model, in the robot's frame, [m/s, rad/s]. It expires after 0.5 s of wall time
/// (kViewerDriveSeconds) unless repeated; all zero: stop now. The newest command of all viewers and clients
/// applies. For an input above 0 the program reports the tick from which it applies (for prediction). With
/// the right to join only: the viewer's own body.
struct Drive {
  world::ModelId model;
  double forward = 0;
  double sideways = 0;
  double turn = 0;
  std::uint32_t input = 0;
};

/// Spawns a body for the viewer: a person like the first addable model that walks, with this name (a number
/// is appended if it is taken). It replaces the viewer's previous body and is removed when the viewer
/// disconnects. Refused in worlds without people, and within a second of the last time.
struct Join {
  std::string name;
  double x = 0;
  double y = 0;
  double a = 0;
};

/// Sets the text that this body says; "": none.
struct Say {
  std::string text;
};

/// Pauses the run, for everyone.
struct Pause {};

/// Resumes the run, for everyone.
struct Resume {};

/// Runs one tick, then pauses.
struct Step {};

/// Sets the speed of the run, for everyone; 0: as fast as possible.
struct SetSpeed {
  double times_real_time = 1;
};

/// Rewinds the run, for everyone, to this tick, or the nearest one that is kept, and continues from there;
/// refused if nothing is kept.
struct Rewind {
  std::uint64_t tick = 0;
};

/// Moves a movable top-level model to this pose.
struct Drag {
  world::ModelId model;
  double x = 0;
  double y = 0;
  double a = 0;
};

/// Spawns a tree like the addable model at this index; a number is appended to its name.
struct Add {
  std::uint32_t robot = 0;
  double x = 0;
  double y = 0;
  double a = 0;
};

/// Spawns a copy of this model's tree at this pose, as a top-level model.
struct Copy {
  world::ModelId model;
  double x = 0;
  double y = 0;
  double a = 0;
};

/// Removes this model's tree from the world. Viewers with the right to join may remove their own body.
struct Remove {
  world::ModelId model;
};

/// Mutes or unmutes this viewer: its speech is refused.
struct Mute {
  std::uint32_t viewer = 0;
  bool on = false;
};

/// Disconnects and bans this viewer.
struct Kick {
  std::uint32_t viewer = 0;
};

/// Requests the current world as a world file; refused while one is in transit to this viewer.
struct Save {};

using Command =
    std::variant<Acknowledge, Look, Select, ShowPhysics, Drive, Join, Say, Pause, Resume, Step, SetSpeed, Rewind, Drag, Add, Copy, Remove, Mute, Kick, Save>;

/// Required right of a command.
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
