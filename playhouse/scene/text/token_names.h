#pragma once

/// Names of models by Stage's rules: `type:n`, `parent.type:n`, or as given in the
/// file. Tokens of parts follow from the root's and are stored once per prototype.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "playhouse/scene/properties.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

class TokenNames {
 public:
  TokenNames(SceneDesc& scene, LoadState& state) : scene_(scene), state_(state) {}

  /// Adds a tree with its root at `row` of the scene's models, and names it. `given` is its `name`,
  /// or ""; `index` counts roots of its type. A name in use moves to this model, as a look-up in the
  /// original would find it; the earlier model and its children fall back to their default names.
  void add_top(std::uint32_t row, std::string_view type, std::string_view given, int index,
               config::SourceLine where);

  /// Names a part about to be appended to the scene's models, in the tree
  /// under construction. `index` counts its siblings of the same type.
  void name_part(ModelDesc& part, std::string_view given, int index);

  /// The tree under construction is complete.
  void end_tree() { open_ = kNone; }
  /// The last tree equals that at `row`: removes its own rows.
  void share(std::uint32_t row);

  /// True if parts of the last tree have names independent
  /// of the root's, so that it cannot be shared.
  bool names_parts_alone() const { return names_parts_alone_; }
  /// True if a root of that name or its parts could clash with names of other models.
  bool may_clash(std::string_view given) const {
    return has_odd_ || given.find('.') != std::string_view::npos;
  }

  /// Warns, at `follow_where`, if the window follows a model that does not exist.
  void check_follow_model(config::SourceLine follow_where);

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  /// A model: row of its tree, and offset in it.
  using TreePlace = std::pair<std::uint32_t, std::uint32_t>;

  /// Assigns a name to a model at `where`; its previous owner falls back to another name.
  void claim(const std::string& name, config::SourceLine where);
  void rename_top(std::uint32_t tree);
  /// A part and everything inside it.
  void rename_part(TreePlace place);
  /// Renames parts of a renamed tree whose names are in use.
  void rename_clashing_parts(std::uint32_t tree);
  /// `name`, or the first free of `name~2`, `name~3`, ...
  std::string unused(const std::string& name);
  std::optional<TreePlace> find(std::string_view name) const;

  const ModelDesc& desc(TreePlace place) const;
  std::string name_of(TreePlace place) const;
  std::string alias_of(TreePlace place) const;
  void set_tokens(TreePlace place, std::string name, std::string alias);
  /// The token in the prototype of the tree under construction.
  std::string in_prototype(std::uint32_t tree, const std::string& token) const;
  void note(TreePlace place, const std::string& name);

  SceneDesc& scene_;
  LoadState& state_;
  std::uint32_t open_ = kNone;                              // the tree under construction
  std::map<std::string, std::uint32_t, std::less<>> tops_;  // roots, by name: rows of trees
  /// Offsets in trees, by row of the root and name in the prototype.
  std::map<std::pair<std::uint32_t, std::string>, std::uint32_t> parts_;
  /// Parts whose names do not start with their root's.
  std::map<std::string, TreePlace, std::less<>> odd_parts_;
  bool names_parts_alone_ = false;
  bool has_odd_ = false;                 // such parts exist, or roots named like parts
  std::map<std::string, int> suffixes_;  // next suffix to try, by name
};

}  // namespace playhouse::scene
