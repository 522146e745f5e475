#pragma once

/// Serialisation of a world's state by the lists of columns: all that later
/// ticks depend on, with the memory of controllers. Not included: the scene,
/// subscriptions, derived columns. docs/saved-runs.md specifies the layout.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// Appends the state to `out`. Fails, naming the controller, if one cannot be saved,
/// and on values that load_state() would reject: a robot far outside any scene.
Result<void> save_state(const World& world, std::vector<std::byte>& out);

/// Replaces the world by the saved one, which must have the same scene, seed
/// and controllers. Models in both keep their subscribers. Adds a kReload entry
/// to the event log, which the engine processes before its next tick. Fails on
/// bytes that are not a state of this scene; the world is unusable then. Never
/// on what save_state() made of this run: a controller that rejects what it
/// remembered is ended, as one that throws elsewhere.
Result<void> load_state(World& world, std::span<const std::byte> state);

/// The same with another seed, to restart a run from a state: all
/// that derives from the seed alone is recomputed from this one.
Result<void> load_state(World& world, std::span<const std::byte> state, std::uint64_t seed);

/// The tick of a saved state; 0 if the bytes are invalid.
std::uint64_t tick_of(std::span<const std::byte> state);

/// The first difference between two worlds.
struct Difference {
  ModelId model;       // none: a global value or a controller
  std::string column;  // "positions.X_OM", "tick", "controller wander"
  std::string text() const;
  friend bool operator==(const Difference&, const Difference&) = default;
};

/// The first difference in what hash() covers, by model, then by column; none if equal.
std::optional<Difference> first_difference(const World& a, const World& b);

}  // namespace playhouse::world
