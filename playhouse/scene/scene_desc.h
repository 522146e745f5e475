#pragma once

/// SceneDesc: contents of a scene file in SI units, with macros, includes and
/// defaults resolved. Written by parsers, read by engines; no other module knows the
/// file format. Single words are in generated/kind_descs.h, made from kinds/*.toml.
/// A value type. Frames: W world, P parent model, M model pose, B body and sensor
/// frame of a model (M moved by `X_MB`, the file's `origin`), S sensor.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/config/text/source_line.h"
#include "playhouse/geom/pose.h"
#include "playhouse/mesh/placement.h"
#include "playhouse/scene/generated/kind_descs.h"

namespace playhouse::mesh {
struct Mesh;
}

namespace playhouse::scene {

/// A word of Stage 4 that this build does not support, with its value, verbatim.
struct KeptWord {
  std::string key, value;
  friend bool operator==(const KeptWord&, const KeptWord&) = default;
};

/// A `block` of a file before scaling; without z it has the height of the model.
struct Prism {
  std::vector<geom::Vec2> points;
  std::optional<Interval> z;
  config::SourceLine where;
  /// Source lines are ignored.
  friend bool operator==(const Prism& a, const Prism& b) { return a.points == b.points && a.z == b.z; }
};

/// A body as in the file; ModelDesc::blocks and bitmaps are derived from it and the size.
struct BodyDesc {
  std::string bitmap;         // resolved path; empty: none
  std::string mesh;           // likewise; replaces everything else
  mesh::Placement placement;  // of the mesh
  bool noblocks = false, boundary = false;
  std::vector<Prism> prisms;
  std::string look;  // path of a mesh for the appearance alone; placed as `mesh` would be
  friend bool operator==(const BodyDesc&, const BodyDesc&) = default;
};

/// A prism: counter-clockwise polygon in B, extruded in z, scaled to the model's size.
struct Block {
  std::vector<geom::Vec2> points;  // m, in B; at least 3
  double z_min = 0, z_max = 0;     // m, relative to B
  friend bool operator==(const Block&, const Block&) = default;
};

/// A body traced from a bitmap: closed contours on pixel
/// edges, solid on the left of each edge (outer contours
/// counter-clockwise, holes clockwise). Even-odd rule.
struct Contours {
  std::vector<std::vector<geom::Vec2>> loops;  // m, in B
  double z_min = 0, z_max = 0;                 // m, relative to B
  friend bool operator==(const Contours&, const Contours&) = default;
};

/// Description of a model: its words, and its place in the file. Trees of
/// descriptions are prototypes shared by any number of trees in the world: for a
/// root, `name`, `alias`, `where`, `X_PM`, `color` and `fiducial_return` are those of
/// the first tree. `X_PM.z` includes `stacked`; `update_interval` is at least a tick.
struct ModelDesc : PlainDesc, KindDescs {
  std::string name;   // unique token in the first tree, e.g. "r0" or "r0.ranger:1"
  std::string alias;  // default token, e.g. "position:0"; equal to `name` if none was given
  std::string type;   // base type after macro expansion: "position", "gripper", ...
  /// Of a root, its display name as a type: the macro that made it, else `name`.
  std::string prototype;
  ModelKind kind = ModelKind::kPlain;
  std::int32_t parent = -1;  // row of SceneDesc::models, below this row; -1: the world
  config::SourceLine where;

  double stacked = 0;  // m, height of the parent that it stands on; 0 if the parent does not stack
  bool stacks_children = true;
  std::vector<Block> blocks;
  /// Number of blocks, at the end of `blocks`, that move with the state of the
  /// kind: drawn in place by the page, at their initial place for everything else.
  std::uint32_t moving_blocks = 0;
  std::vector<Contours> bitmaps;
  /// Visual mesh in B, and in 3D also the body; shared by models of equal file, size and placement.
  /// Blocks are then the outlines of its parts. Null: the visual is blocks and bitmaps.
  std::shared_ptr<const mesh::Mesh> mesh;
  /// Mesh in B for pages, pictures and cameras of the arena, in place of the body, which everything else
  /// meets; its white surfaces have the color of the model. Null: none.
  std::shared_ptr<const mesh::Mesh> look;
  BodyDesc body;  // for writing the file again; empty for models made in code
  std::vector<KeptWord> kept;
};

/// An instance of a prototype in the world, with its own values.
struct TreeDesc {
  std::uint32_t top = 0;    // row of SceneDesc::models, a root
  std::string name, alias;  // tokens of the root; those of parts follow from them
  config::SourceLine where;
  geom::Pose X_WM;
  Color color;  // of the root
  std::int32_t fiducial_return = 0;
};

struct SceneDesc : WorldDesc {
  std::string path;  // of the top-level file
  /// Where libraries are looked for first: the folder of the file on disk that whoever started the program named; empty:
  /// nowhere. Never from the contents of a file or a peer, for libraries run with all rights.
  std::string library_folder;
  std::vector<std::string> files;  // all files read; row 0 is the top-level one
  WindowDesc window;
  config::Units units;                         // of the top-level file
  std::vector<KeptWord> kept, kept_of_window;  // of the world and of the window
  /// All prototypes, tree by tree: parents before children, siblings in file order.
  std::vector<ModelDesc> models;
  /// The instances, in file order. Empty, as in scenes made in code: one_of_each().
  std::vector<TreeDesc> trees;
  /// Tokens of parts that differ from the prototype's, because a later
  /// model has taken the name; by row of `trees` and place in the tree.
  struct ModelTokens {
    std::string name, alias;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, ModelTokens> renamed;
  /// The defines that `robot_types` names: rows of `models`, without what instances of the world add.
  std::map<std::string, std::uint32_t, std::less<>> robot_types;
  std::vector<std::string> warnings;  // "file:line: text", without duplicates

  /// "file:line" of a position.
  std::string at(config::SourceLine where) const {
    return where.file < files.size() ? escaped(files[where.file]) + ":" + std::to_string(where.line) : path;
  }
};

/// Number of models in the tree with its root at `row` of SceneDesc::models; 0 if that is no root.
std::uint32_t tree_size(const SceneDesc& scene, std::uint32_t row);

/// One instance for each prototype.
std::vector<TreeDesc> one_of_each(const SceneDesc& scene);

/// A part's token, name or alias, in a tree whose root is called `name`
/// instead of `top`: replaces the prefix, if it is the root's name.
std::string token_in(std::string_view token, std::string_view top, std::string_view name);

}  // namespace playhouse::scene
