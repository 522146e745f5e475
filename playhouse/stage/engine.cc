#include "playhouse/stage/engine.h"

#include "playhouse/bodies/check_scene.h"
#include "playhouse/stage/stage_engine.h"

namespace playhouse::stage {

StageEngine::StageEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers)
    : senses::BodyEngine(scene, seed, workers), motion_(workers_.count()) {
  populate();
}

void StageEngine::populated(bool) {
  motion_.populate(trees_, solids_, world_.models);
}

void StageEngine::replaced(bodies::TreeRow tree) {
  motion_.replaced(tree, solids_, world_.models);
}

void StageEngine::move() {
  if (motion_.move(world_, solids_, index_, walls_, workers_)) index();
}

Result<std::unique_ptr<world::Engine>> make_engine(const scene::SceneDesc& scene,
                                                   const world::EngineOptions& options) {
  if (const Result<void> checked = bodies::check_scene(scene); !checked) return checked.error();
  return std::unique_ptr<world::Engine>(std::make_unique<StageEngine>(scene, options.seed, options.workers));
}

}  // namespace playhouse::stage
