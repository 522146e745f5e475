#pragma once

/// Selection: which models' data are recorded besides all
/// poses: `--record-only` of docs/recording.md. Value.

#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::record {

/// What models say, as a kind of data.
inline constexpr std::string_view kSpeechWord = "speech";

class Selection {
 public:
  /// Selects everything.
  Selection() = default;

  /// Parses comma-separated entries: KIND, KIND@NAME, @NAME; only `poses`: no
  /// data. A name selects a model and all its parts. Fails on unknown kinds.
  static Result<Selection> parse(std::string_view text);

  /// True if data of a kind or a trait ("position", "pack", "speech") of a model are selected.
  bool has(const world::World& world, world::ModelRow model, std::string_view kind) const;

  /// Names that match no model.
  std::vector<std::string> unknown_names(const world::World& world) const;

 private:
  struct Selector {
    std::string kind;  // empty: all
    std::string name;  // empty: all
  };
  bool everything_ = true;
  std::vector<Selector> entries_;
};

}  // namespace playhouse::record
