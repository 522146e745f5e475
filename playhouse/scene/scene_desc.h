#pragma once

/// SceneDesc: what a scene file says, in SI units and radians, with every macro, include and default
/// resolved. Parsers make it, engines read it; nothing else in the tree knows what a world file looks like.
/// What single words say is in generated/kind_descs.h, made from kinds/*.toml.
/// A value type. Frames: W world, P parent model, M model pose, B body and sensor frame of a model (M moved
/// by `X_MB`, the file's `origin`), S sensor.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/geom/pose.h"
#include "playhouse/scene/generated/kind_descs.h"

namespace playhouse::mesh {
struct Mesh;
}

namespace playhouse::scene {

/// Where in the files a thing was said.
struct SourceLine {
  std::uint32_t file = 0;  // row of SceneDesc::files
  std::uint32_t line = 0;  // from 1; 0: nowhere (a default)
};

/// Metres per unit of length and radians per unit of angle of a file.
struct Units {
  double length = 1;
  double angle = geom::kPi / 180;
};

/// A word that Stage 4 reads and this build does not, and what stands behind it, as a file has them.
struct KeptWord {
  std::string key, value;
  friend bool operator==(const KeptWord&, const KeptWord&) = default;
};

/// A `block` as a file says it, before it is stretched: without z it is as high as the whole model.
struct Prism {
  std::vector<geom::Vec2> points;
  std::optional<Bounds> z;
  SourceLine where;
  /// Wherever they were said.
  friend bool operator==(const Prism& a, const Prism& b) { return a.points == b.points && a.z == b.z; }
};

/// What a file says of a body; ModelDesc::blocks and bitmaps are made of it and of the size.
struct BodyDesc {
  std::string bitmap;  // path under which it was read; empty: none
  std::string mesh;    // the same; it is all of the body
  bool noblocks = false, boundary = false;
  std::vector<Prism> prisms;
  friend bool operator==(const BodyDesc&, const BodyDesc&) = default;
};

/// A solid prism: polygon in B, counter-clockwise, extruded in z. Scaled to the model's size already.
struct Block {
  std::vector<geom::Vec2> points;  // m, in B; at least 3
  double z_min = 0, z_max = 0;     // m, relative to B
  friend bool operator==(const Block&, const Block&) = default;
};

/// A body traced from a bitmap: closed contours on pixel edges, solid to the left of each edge (outer
/// contours counter-clockwise, holes clockwise). Even-odd rule: a point is solid when an odd number of
/// contours holds it.
struct Contours {
  std::vector<std::vector<geom::Vec2>> loops;  // m, in B
  double z_min = 0, z_max = 0;                 // m, relative to B
  friend bool operator==(const Contours&, const Contours&) = default;
};

/// A description of a model: what its words say, and what the loader makes of its place in the file. Trees of
/// them are prototypes, which any number of trees share: of the top-level one, `name`, `alias`, `where`,
/// `X_PM`, `color` and `fiducial_return` are those of its first tree in the world. `X_PM.z` includes
/// `stacked`, and `update_interval` is at least a tick.
struct ModelDesc : PlainDesc, KindDescs {
  std::string name;   // token, unique in the first tree, e.g. "r0" or "r0.ranger:1"
  std::string alias;  // default token, e.g. "position:0"; equal to `name` when the file gave none
  std::string type;   // the base type as the file says it, after macros: "position", "gripper", ...
  /// Of a top-level one, what people call its like: the word of the define that made it, else `name`.
  std::string prototype;
  ModelKind kind = ModelKind::kPlain;
  std::int32_t parent = -1;  // row of SceneDesc::models, always below this row; -1: the world
  SourceLine where;

  double stacked = 0;  // m, height of the parent on top of which it stands; 0 if that does not stack
  bool stacks_children = true;
  std::vector<Block> blocks;
  /// How many of the blocks, the last, move with the state of the kind: pages draw them where they are, all
  /// else has them where they are at the start.
  std::uint32_t moving_blocks = 0;
  std::vector<Contours> bitmaps;
  /// How it looks, in B, and its body where there is more than a plane; shared by all of that file and size.
  /// Blocks are the outlines of its parts then. Null: it looks as its blocks and bitmaps.
  std::shared_ptr<const mesh::Mesh> mesh;
  BodyDesc body;  // for who writes the file again; nothing of a model made in code
  std::vector<KeptWord> kept;
};

/// A tree of models in the world: its prototype, and what it has for itself.
struct TreeDesc {
  std::uint32_t top = 0;    // row of SceneDesc::models, a top-level one
  std::string name, alias;  // tokens of the top; those of its parts follow
  SourceLine where;
  geom::Pose X_WM;
  Color color;  // of the top
  std::int32_t fiducial_return = 0;
};

struct SceneDesc : WorldDesc {
  std::string path;                // of the top-level file
  std::vector<std::string> files;  // all files read; row 0 is the top-level one
  WindowDesc window;
  Units units;                                 // of the top-level file
  std::vector<KeptWord> kept, kept_of_window;  // of the world and of the window
  /// Every description once, tree by tree: parents before children, siblings in file order.
  std::vector<ModelDesc> models;
  /// What is in the world, in file order. None, as in scenes made in code, stands for one_of_each().
  std::vector<TreeDesc> trees;
  /// Tokens of parts, by row of `trees` and place in the tree, that are not those of the prototype: later
  /// models of the same name have them.
  struct Token {
    std::string name, alias;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Token> renamed;
  std::vector<std::string> warnings;  // "file:line: text", each once

  /// "file:line" of a place in this scene.
  std::string at(SourceLine where) const {
    return where.file < files.size() ? escaped(files[where.file]) + ":" + std::to_string(where.line) : path;
  }
};

/// How many models the tree has whose top is at `row` of SceneDesc::models; 0 if there is no top.
std::uint32_t tree_size(const SceneDesc& scene, std::uint32_t row);

/// A tree of the world for each tree of descriptions, as these say.
std::vector<TreeDesc> one_of_each(const SceneDesc& scene);

/// A token of a part, name or alias, in a tree whose top is called `name` instead of `top`: what begins with
/// the top's name begins with that of this one.
std::string token_in(std::string_view token, std::string_view top, std::string_view name);

}  // namespace playhouse::scene
