#pragma once

/// The 2D engine: robots that drive, collide and measure in a plane of extruded polygons. Geometry is exact:
/// bodies are polygons and bitmap contours, never a raster. Its part of the tick is in body_engine.cc and
/// motion.cc. Where it differs from Stage 4.3 is in docs/stage-compatibility.md.
///
/// In: a scene that loads.
/// Out: an engine at tick 0, which moves its world from tick to tick.
/// Cost: once, that of the population; ticks are in docs/benchmarks.md.

#include <memory>

#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/world/engine.h"

namespace playhouse::stage {

/// An engine at tick 0. The scene must outlive it. Fails on a scene that no engine can run (check_scene.h).
/// Thread: `workers` threads run inside a tick; calls come from one thread.
Result<std::unique_ptr<world::Engine>> make_engine(const scene::SceneDesc& scene,
                                                   const world::EngineOptions& options);

}  // namespace playhouse::stage
