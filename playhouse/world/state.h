#pragma once

/// The whole state of a world as bytes, made and read by the lists of columns: what a later tick depends on,
/// with what controllers remember. Not in it: the scene, who looks, and what follows from the rest.
/// docs/saved-runs.md draws the layout.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// Appends the state to `out`. Fails, with the controller's name, where one cannot say what it remembers, and
/// on values that could not be read again: a robot that has left every scene behind.
Result<void> save_state(const World& world, std::vector<std::byte>& out);

/// Makes the world the one that was saved: one of the same scene and seed, with the same controllers. Models
/// that are in both keep their subscribers. Leaves a kReload entry in the list of changes, which the engine
/// reads before its next tick. Fails, and the world is of no use then, on bytes that are no state of this
/// scene.
Result<void> load_state(World& world, std::span<const std::byte> state);

/// The same with another seed from then on, for a state from which a run begins again: what follows from the
/// seed alone follows from this one.
Result<void> load_state(World& world, std::span<const std::byte> state, std::uint64_t seed);

/// Where two worlds differ.
struct Difference {
  ModelId model;       // none: the worlds as wholes, or a controller
  std::string column;  // "positions.X_OM", "tick", "controller wander"
  std::string text() const;
  friend bool operator==(const Difference&, const Difference&) = default;
};

/// The first difference in what hash() sees, by models and then by columns; none if there is no difference.
std::optional<Difference> first_difference(const World& a, const World& b);

}  // namespace playhouse::world
