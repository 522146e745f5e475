#include "playhouse/arena/engine.h"

#include <fmt/format.h>

#include "playhouse/arena/arena_engine.h"
#include "playhouse/arena/surface.h"
#include "playhouse/bodies/check_scene.h"

namespace playhouse::arena {

namespace {

constexpr double kLongestTick = 10;  // s: thousands of physics steps, not interruptible

}  // namespace

Result<std::unique_ptr<world::Engine>> make_engine(const scene::SceneDesc& scene,
                                                   const world::EngineOptions& options) {
  if (const Result<void> checked = bodies::check_scene(scene); !checked) return checked.error();
  if (scene.interval > kLongestTick)
    return Error{scene.path,
                 fmt::format("interval_sim {:g} is too long for physics, which takes at most {:g}",
                             1e3 * scene.interval, 1e3 * kLongestTick)};
  return std::unique_ptr<world::Engine>(
      std::make_unique<ArenaEngine>(scene, options.seed, options.workers, ground_of(scene)));
}

}  // namespace playhouse::arena
