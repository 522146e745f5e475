#include "playhouse/arena/engine.h"

#include "playhouse/arena/arena_engine.h"
#include "playhouse/stage/check_scene.h"

namespace playhouse::arena {

Result<std::unique_ptr<world::Engine>> make_engine(const scene::SceneDesc& scene,
                                                   const EngineOptions& options) {
  if (const Result<void> checked = stage::check_scene(scene); !checked) return checked.error();
  return std::unique_ptr<world::Engine>(std::make_unique<ArenaEngine>(scene, options.seed, options.workers));
}

}  // namespace playhouse::arena
