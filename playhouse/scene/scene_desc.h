#pragma once

/// SceneDesc: what a scene file says, in SI units and radians, with every macro, include and default
/// resolved. Parsers make it, engines read it; nothing else in the tree knows what a world file looks like.
/// A value type. Frames: W world, P parent model, M model pose, B body and sensor frame of a model (M moved
/// by `X_MB`, the file's `origin`), S sensor.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/geom/pose.h"

namespace playhouse::scene {

/// Where in the files a thing was said.
struct SourceLine {
  std::uint32_t file = 0;  // row of SceneDesc::files
  std::uint32_t line = 0;  // from 1; 0: nowhere (a default)
};

struct Color {
  float r = 1, g = 0, b = 0, a = 1;  // 0..1
  friend bool operator==(const Color&, const Color&) = default;
};

/// The kinds of model this build simulates; any other kind of the file loads as kPlain with one warning.
enum class ModelKind : std::uint8_t { kPlain, kPosition, kRanger, kFiducial };

/// A solid prism: polygon in B, counter-clockwise, extruded in z. Scaled to the model's size already.
struct Block {
  std::vector<geom::Vec2> points;  // m, in B; at least 3
  double z_min = 0, z_max = 0;     // m, relative to B
};

/// A body traced from a bitmap: closed contours on pixel edges, solid to the left of each edge (outer
/// contours counter-clockwise, holes clockwise). Even-odd rule: a point is solid when an odd number of
/// contours holds it.
struct Contours {
  std::vector<std::vector<geom::Vec2>> loops;  // m, in B
  double z_min = 0, z_max = 0;                 // m, relative to B
};

enum class Drive : std::uint8_t { kDiff, kOmni, kCar };
enum class Localization : std::uint8_t { kGps, kOdometry };

struct Bounds {
  double min = 0, max = 0;
};

struct PositionDesc {
  Drive drive = Drive::kDiff;
  Localization localization = Localization::kGps;
  std::optional<geom::Pose> localization_origin;  // in W; none: the start pose
  geom::Twist velocity;                           // initial
  Bounds velocity_bounds[4];                      // x, y, z [m/s], heading [rad/s]
  Bounds acceleration_bounds[4];                  // x, y, z [m/s^2], heading [rad/s^2]
  double wheelbase = 1.0;                         // m
  std::optional<geom::Twist> odom_error;  // fraction per axis (x, y, z, heading); none: drawn per robot
};

/// One transducer or scanner of a ranger.
struct RangerSensorDesc {
  geom::Pose X_BS;            // sensor in the ranger's body frame
  geom::Size size;            // m, for drawing; rays start size.z / 2 above X_BS
  double range_min = 0;       // m
  double range_max = 5;       // m
  double fov = 0.1;           // rad; beams from -fov/2 to +fov/2, first is rightmost; one sample looks ahead
  std::uint32_t samples = 1;  // at least 1
  double noise_constant = 0;  // m (see docs/stage-compatibility.md)
  double noise_proportional = 0;  // fraction of the range
  double noise_angular = 0;       // rad
  Color color{0, 0, 1, 0.15f};
};

struct FiducialDesc {
  double range_min = 0;     // m
  double range_max = 8;     // m
  double range_max_id = 5;  // m
  double fov = geom::kPi;   // rad
  bool ignore_zloc = false;
};

struct ModelDesc {
  std::string name;   // unique token, e.g. "r0" or "r0.ranger:1"
  std::string alias;  // default token, e.g. "position:0"; equal to `name` when the file gave none
  std::string type;   // the base type as the file says it, after macros: "position", "gripper", ...
  ModelKind kind = ModelKind::kPlain;
  std::int32_t parent = -1;  // row of SceneDesc::models, always below this row; -1: the world
  SourceLine where;

  geom::Pose X_PM;     // pose in the parent; z includes `stacked`
  double stacked = 0;  // m, height of the parent on top of which it stands; 0 if that does not stack
  geom::Pose X_MB;     // origin
  geom::Size size;     // m, bounding box of the body
  Color color;
  std::vector<Block> blocks;
  std::vector<Contours> bitmaps;

  bool obstacle_return = true;
  double ranger_return = 1.0;  // below 0: rangers do not see it; else the intensity they report
  int fiducial_return = 0;     // 0: no finder sees it
  int fiducial_key = 0;
  bool gripper_return = false;
  double mass = 0;               // kg
  double update_interval = 0.1;  // s
  bool alwayson = false;
  bool gui_move = false;
  std::string say;
  int trail_length = 20;
  std::vector<std::string> ctrl;  // "wander", "lib arg1 arg2", ...

  std::optional<PositionDesc> position;   // kind kPosition
  std::vector<RangerSensorDesc> sensors;  // kind kRanger
  std::optional<FiducialDesc> fiducial;   // kind kFiducial
};

/// How a person wants to look at the scene (the file's `window`).
struct WindowDesc {
  geom::Vec2 center;          // m
  double scale = 0;           // pixels per metre; 0: fit the scene
  double pitch = 0, yaw = 0;  // rad
  bool show_data = false;
  std::string follow_model;
};

struct SceneDesc {
  std::string name;
  std::string path;                // of the top-level file
  std::vector<std::string> files;  // all files read; row 0 is the top-level one
  double interval = 0.1;           // s, one tick
  double resolution = 0.02;        // m, of the file's raster; our geometry is exact, devices report it
  double quit_time = 0;            // s; 0: never
  double speedup = 1;              // times real time; <= 0: as fast as possible
  bool paused = false;
  WindowDesc window;
  std::vector<ModelDesc> models;      // parents before children, siblings in file order
  std::vector<std::string> warnings;  // "file:line: text", each once

  /// "file:line" of a place in this scene.
  std::string at(SourceLine where) const {
    return where.file < files.size() ? escaped(files[where.file]) + ":" + std::to_string(where.line) : path;
  }
};

}  // namespace playhouse::scene
