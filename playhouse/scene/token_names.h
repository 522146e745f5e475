#pragma once

/// Names of the models of a world, by Stage's rules: `type:n`, `parent.type:n`, or what the file says.

#include <map>
#include <string>
#include <string_view>

#include "playhouse/scene/properties.h"

namespace playhouse::scene {

class TokenNames {
 public:
  TokenNames(SceneDesc& scene, LoadState& state) : scene_(scene), state_(state) {}

  /// Names the model that is about to become the last row of the scene. `given` is its `name`, or ""; `index`
  /// counts its siblings of the same type. A name that is taken goes to this model, as a look-up in the
  /// original would find it, and the earlier model and its children fall back to their default names.
  void name(ModelDesc& model, std::string_view given, int index);

  /// Warns, at `follow_where`, when the window follows a model that does not exist.
  void check_follow_model(SourceLine follow_where);

 private:
  void rename_subtree(std::size_t row);
  /// `name`, or `name~2`, `name~3` and so on.
  std::string unused(const std::string& name);

  SceneDesc& scene_;
  LoadState& state_;
  std::map<std::string, std::size_t> rows_;
  std::map<std::string, int> suffixes_;  // to try next, by name
};

}  // namespace playhouse::scene
