#pragma once

/// The 3D engine: scenes, devices and columns of the stage engine
/// with rigid-body dynamics. Differences are listed in docs/arena.md.
///
/// In: a scene that loads.
/// Out: an engine at tick 0, which moves its world from tick to tick.
/// Cost: once, that of the population; ticks are in docs/benchmarks.md.

#include <memory>

#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/world/engine.h"

namespace playhouse::arena {

/// An engine at tick 0. The scene must outlive it. Fails as stage::make_engine().
Result<std::unique_ptr<world::Engine>> make_engine(const scene::SceneDesc& scene,
                                                   const world::EngineOptions& options);

}  // namespace playhouse::arena
