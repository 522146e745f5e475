#include "playhouse/arena/engine.h"

#include "playhouse/arena/arena_engine.h"
#include "playhouse/arena/surface.h"
#include "playhouse/stage/check_scene.h"

namespace playhouse::arena {

Result<std::unique_ptr<world::Engine>> make_engine(const scene::SceneDesc& scene,
                                                   const EngineOptions& options) {
  if (const Result<void> checked = stage::check_scene(scene); !checked) return checked.error();
  const Result<Surface> ground = ground_of(scene);
  if (!ground) return ground.error();
  return std::unique_ptr<world::Engine>(
      std::make_unique<ArenaEngine>(scene, options.seed, options.workers, *ground));
}

}  // namespace playhouse::arena
