#pragma once

/// Conditions: which models are as a world file wants them (scene/condition.h). A term speaks of a model and
/// of all that it is part of: it holds if one of them is as it says; with != if none has the value, with < if
/// none has as much.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/scene/condition.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// Whether a lamp that can be switched is on; none for what has no switch.
std::optional<bool> switch_of(const World& world, std::uint32_t model);
/// Whether a model gives light: a lamp that can be switched, while it is on; any other that has candela.
bool is_lit(const World& world, std::uint32_t model);

class Conditions {
 public:
  /// Texts that were read without an error before. Valid as long as the population is.
  Conditions(const World& world, std::span<const std::string> texts);

  bool empty() const { return conditions_.empty(); }

  /// Whether one of them holds for the model in this row, at this moment. Allocates nothing.
  bool hold(const World& world, std::uint32_t model) const;

 private:
  struct Term {
    scene::Term says;
    std::vector<std::uint8_t> named;  // of a name: whether it is the model's                  (models)
  };
  static bool holds(const World& world, const Term& term, std::uint32_t model);
  static bool has(const World& world, const Term& term, std::uint32_t model);

  std::vector<std::vector<Term>> conditions_;
};

}  // namespace playhouse::world
