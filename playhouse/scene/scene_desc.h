#pragma once

/// SceneDesc: what a scene file says, in SI units and radians, with every macro, include and default
/// resolved. Parsers make it, engines read it; nothing else in the tree knows what a world file looks like.
/// What single words say is in generated/kind_descs.h, made from kinds/*.toml.
/// A value type. Frames: W world, P parent model, M model pose, B body and sensor frame of a model (M moved
/// by `X_MB`, the file's `origin`), S sensor.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/geom/pose.h"
#include "playhouse/scene/generated/kind_descs.h"

namespace playhouse::scene {

/// Where in the files a thing was said.
struct SourceLine {
  std::uint32_t file = 0;  // row of SceneDesc::files
  std::uint32_t line = 0;  // from 1; 0: nowhere (a default)
};

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

/// A model: what its words say, and what the loader makes of its place in the file. `X_PM.z` includes
/// `stacked`, and `update_interval` is at least a tick.
struct ModelDesc : PlainDesc, KindDescs {
  std::string name;   // unique token, e.g. "r0" or "r0.ranger:1"
  std::string alias;  // default token, e.g. "position:0"; equal to `name` when the file gave none
  std::string type;   // the base type as the file says it, after macros: "position", "gripper", ...
  ModelKind kind = ModelKind::kPlain;
  std::int32_t parent = -1;  // row of SceneDesc::models, always below this row; -1: the world
  SourceLine where;

  double stacked = 0;  // m, height of the parent on top of which it stands; 0 if that does not stack
  std::vector<Block> blocks;
  std::vector<Contours> bitmaps;
};

struct SceneDesc : WorldDesc {
  std::string path;                // of the top-level file
  std::vector<std::string> files;  // all files read; row 0 is the top-level one
  WindowDesc window;
  std::vector<ModelDesc> models;      // parents before children, siblings in file order
  std::vector<std::string> warnings;  // "file:line: text", each once

  /// "file:line" of a place in this scene.
  std::string at(SourceLine where) const {
    return where.file < files.size() ? escaped(files[where.file]) + ":" + std::to_string(where.line) : path;
  }
};

}  // namespace playhouse::scene
