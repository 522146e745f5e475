#pragma once

/// How much sections become with their macros applied, counted before any of it is made: forty lines of
/// macros that double each other must cost neither memory nor time.

#include "playhouse/scene/expand.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {

class Expansion {
 public:
  Expansion(const Document& document, const Macros& macros, const WorldLimits& limits)
      : document_(document), macros_(macros), limits_(limits) {}

  /// Counts a section at top level and all inside it. Fails as soon as a limit is passed, and on models
  /// inside each other more than limits::kEntityDepth deep.
  Result<void> add(const Section& section) { return add(section, section.where, 1); }

  struct Counts {
    std::size_t models = 0, sensors = 0, fields = 0;
    friend Counts operator+(const Counts& a, const Counts& b) {
      return {a.models + b.models, a.sensors + b.sensors, a.fields + b.fields};
    }
    friend Counts operator-(const Counts& a, const Counts& b) {
      return {a.models - b.models, a.sensors - b.sensors, a.fields - b.fields};
    }
  };
  /// Of all sections so far.
  const Counts& counts() const { return counts_; }
  bool has_room(const Counts& more) const;
  /// Counts a section again that was this much.
  void add_again(const Counts& section) { counts_ = counts_ + section; }

 private:
  Result<void> add(const Section& section, SourceLine top, int depth);

  const Document& document_;
  const Macros& macros_;
  const WorldLimits& limits_;
  Counts counts_;
};

}  // namespace playhouse::scene
