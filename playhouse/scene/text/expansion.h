#pragma once

/// Size of sections after macro expansion, computed without
/// expanding: protects against exponential growth from nested macros.

#include <vector>

#include "playhouse/config/text/expand.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {

class Expansion {
 public:
  Expansion(const config::Document& document, const config::Macros& macros, const WorldLimits& limits)
      : document_(document), macros_(macros), limits_(limits) {}

  /// Adds a top-level section with its contents. Fails as soon as a limit
  /// is exceeded, or on models nested deeper than limits::kEntityDepth.
  Result<void> add(const config::Section& section) { return add(section, section.where, 1); }

  struct Counts {
    std::size_t models = 0, sensors = 0, fields = 0;
    friend Counts operator+(const Counts& a, const Counts& b) {
      return {a.models + b.models, a.sensors + b.sensors, a.fields + b.fields};
    }
    friend Counts operator-(const Counts& a, const Counts& b) {
      return {a.models - b.models, a.sensors - b.sensors, a.fields - b.fields};
    }
  };
  /// Sum over all sections so far.
  const Counts& counts() const { return counts_; }
  bool has_room(const Counts& more) const;
  /// Adds a repeated section of known size.
  void add_again(const Counts& section) { counts_ = counts_ + section; }

 private:
  Result<void> add(const config::Section& section, config::SourceLine top, int depth);
  /// Fails if one of the sections around this one is the same: its macro holds itself.
  Result<void> check_cycle(const config::Section& section) const;

  const config::Document& document_;
  const config::Macros& macros_;
  const WorldLimits& limits_;
  std::vector<const config::Section*> around_;  // the section that is added, outermost first
  Counts counts_;
};

}  // namespace playhouse::scene
