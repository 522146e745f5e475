#pragma once

/// Selection: which models' data a recording has, besides the poses of all: `--record-only` of
/// docs/recording.md. Value.

#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::record {

class Selection {
 public:
  /// Everything.
  Selection() = default;

  /// Of entries between commas: KIND, KIND@NAME, @NAME; `poses` alone: nothing besides those. A name is that
  /// of a model, which stands for all that is in it. Fails on kinds that there are none of.
  static Result<Selection> parse(std::string_view text);

  /// Whether what a kind or a trait ("position", "pack") tells of a model is recorded.
  bool has(const world::World& world, world::ModelRow model, std::string_view kind) const;

  /// Names that no model has.
  std::vector<std::string> unknown_names(const world::World& world) const;

 private:
  struct Entry {
    std::string kind;  // empty: all
    std::string name;  // empty: all
  };
  bool everything_ = true;
  std::vector<Entry> entries_;
};

}  // namespace playhouse::record
