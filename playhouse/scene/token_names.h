#pragma once

/// Names of the models of a world, by Stage's rules: `type:n`, `parent.type:n`, or what the file says. Parts
/// of equal trees have equal tokens behind their tops' names, so these are kept once for each prototype.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "playhouse/scene/properties.h"

namespace playhouse::scene {

class TokenNames {
 public:
  TokenNames(SceneDesc& scene, LoadState& state) : scene_(scene), state_(state) {}

  /// Adds a tree to the scene whose top is at `row` of the scene's models, and names it. `given` is its
  /// `name`, or ""; `index` counts the tops of its type. A name that is taken goes to this one, as a look-up
  /// in the original would find it, and the earlier model and its children fall back to their default names.
  void add_top(std::uint32_t row, std::string_view type, std::string_view given, int index, SourceLine where);

  /// Names a part that is about to become the last row of the scene's models: of the last tree, which
  /// is in the making. `index` counts its siblings of the same type.
  void name_part(ModelDesc& part, std::string_view given, int index);

  /// The tree in the making is as large as it will be.
  void end_tree() { open_ = kNone; }
  /// The last tree is one like that at `row`: its own rows go.
  void share(std::uint32_t row);

  /// Whether parts of the last tree have names that do not depend on its own, so that no other tree is like
  /// it.
  bool names_parts_alone() const { return names_parts_alone_; }
  /// Whether a top of that name and any parts could have names that other models have.
  bool may_clash(std::string_view given) const {
    return has_odd_ || given.find('.') != std::string_view::npos;
  }

  /// Warns, at `follow_where`, when the window follows a model that does not exist.
  void check_follow_model(SourceLine follow_where);

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  /// A model: the row of its tree, and its place there.
  using Place = std::pair<std::uint32_t, std::uint32_t>;

  /// Gives a name to a model at `where`; whoever had it falls back to another.
  void claim(const std::string& name, SourceLine where);
  void rename_top(std::uint32_t tree);
  /// A part and all inside it.
  void rename_part(Place place);
  /// Parts whose names somebody else has, of a tree that was renamed.
  void rename_clashing_parts(std::uint32_t tree);
  /// `name`, or `name~2`, `name~3` and so on.
  std::string unused(const std::string& name);
  std::optional<Place> find(std::string_view name) const;

  const ModelDesc& desc(Place place) const;
  std::string name_of(Place place) const;
  std::string alias_of(Place place) const;
  void set_tokens(Place place, std::string name, std::string alias);
  /// A token as the prototype of a tree in the making has it.
  std::string in_prototype(std::uint32_t tree, const std::string& token) const;
  void note(Place place, const std::string& name);

  SceneDesc& scene_;
  LoadState& state_;
  std::uint32_t open_ = kNone;                              // the tree that is in the making
  std::map<std::string, std::uint32_t, std::less<>> tops_;  // trees
  /// Places in trees, by row of the top and name in the prototype.
  std::map<std::pair<std::uint32_t, std::string>, std::uint32_t> parts_;
  /// Parts whose names do not begin with that of their top.
  std::map<std::string, Place, std::less<>> odd_parts_;
  bool names_parts_alone_ = false;
  bool has_odd_ = false;                 // there are such parts, or tops with names as parts have them
  std::map<std::string, int> suffixes_;  // to try next, by name
};

}  // namespace playhouse::scene
