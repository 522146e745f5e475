#pragma once

/// Conditions: predicates on models, compiled from the texts of a world file
/// (scene/text/condition.h). A term is tested on a model and its ancestors: it holds if it
/// holds for one of them; with != if none has the value, with < if none has as much.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/scene/text/condition.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// Whether a switchable lamp is on; none if the model has no switch.
std::optional<bool> switch_of(const World& world, ModelRow model);
/// Whether a model emits light: a switchable lamp if it is on, any other with candela > 0.
bool is_lit(const World& world, ModelRow model);

class Conditions {
 public:
  /// Compiles texts that parsed without error before. Valid until the population changes.
  Conditions(const World& world, std::span<const std::string> texts);

  bool empty() const { return conditions_.empty(); }

  /// True if any condition holds for the model in this row now. No allocation.
  bool hold(const World& world, ModelRow model) const;

 private:
  struct ResolvedTerm {
    scene::Term says;
    std::vector<std::uint8_t> named;  // of a name: 1 for models that have it                        (models)
  };
  static bool holds(const World& world, const ResolvedTerm& term, ModelRow model);
  static bool has(const World& world, const ResolvedTerm& term, ModelRow model);

  std::vector<std::vector<ResolvedTerm>> conditions_;
};

}  // namespace playhouse::world
