#include "playhouse/stage/engine.h"

#include <algorithm>

#include "playhouse/base/log.h"
#include "playhouse/stage/check_scene.h"
#include "playhouse/stage/stage_engine.h"

namespace playhouse::stage {
namespace {

/// Warns of scene features that cameras of this engine do not render.
void tell_of_unseen_weather(const scene::SceneDesc& scene) {
  const scene::WorldDesc none;
  const bool has_sun = scene.sun_heading != none.sun_heading || scene.sun_elevation != none.sun_elevation ||
                       scene.sun_brightness != none.sun_brightness;
  const bool has_lamps =
      std::ranges::any_of(scene.models, [](const scene::ModelDesc& model) { return model.lamp > 0; });
  if (has_sun || scene.fog > 0 || has_lamps)
    log::info(
        "{}: sun, fog and lamps have no effect: cameras of the stage engine show colors without light; "
        "--engine arena shows them",
        scene.path);
}

/// Notes once that meshes are flattened to outlines in this engine.
void tell_of_meshes(const scene::SceneDesc& scene) {
  const auto first =
      std::ranges::find_if(scene.models, [](const scene::ModelDesc& model) { return model.mesh != nullptr; });
  if (first == scene.models.end()) return;
  log::info("{}: bodies in the plane are the outlines of meshes; --engine arena has the meshes themselves",
            scene.at(first->where));
}

}  // namespace

StageEngine::StageEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers)
    : BodyEngine(scene, seed, workers), motion_(workers_.count()) {
  populate(true);
}

void StageEngine::populated(bool) {
  motion_.populate(trees_, solids_, world_.models);
}

void StageEngine::replaced(std::uint32_t tree) {
  motion_.replaced(tree, solids_, world_.models);
}

void StageEngine::move() {
  if (motion_.move(world_, solids_, index_, walls_, workers_)) index();
}

Result<std::unique_ptr<world::Engine>> make_engine(const scene::SceneDesc& scene,
                                                   const EngineOptions& options) {
  if (const Result<void> checked = check_scene(scene); !checked) return checked.error();
  tell_of_unseen_weather(scene);
  tell_of_meshes(scene);
  return std::unique_ptr<world::Engine>(std::make_unique<StageEngine>(scene, options.seed, options.workers));
}

}  // namespace playhouse::stage
