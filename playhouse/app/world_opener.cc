#include "playhouse/app/world_opener.h"

#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "playhouse/arena/engine.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/base/program_folder.h"
#include "playhouse/bodies/check_scene.h"
#include "playhouse/custom_kinds/custom_kinds.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"

namespace playhouse::app {

Result<scene::SceneDesc> read_scene(const std::string& path, std::vector<Error>* others,
                                    config::SourceFiles* sources) {
  Result<scene::SceneDesc> scene = scene::load_world(path, config::NamedBy::kPerson, others, sources);
  if (!scene) return scene;
  for (const std::string& warning : scene->warnings) warn(warning);
  controllers::describe_for(*scene);
  return scene;
}

Result<scene::SceneDesc> scene_of(const config::SourceFiles& sources, const std::optional<std::string>& file,
                                  std::vector<Error>* others) {
  config::MemoryFiles files(sources.files, sources.search_path);
  Result<scene::SceneDesc> scene =
      scene::load_world_text(sources.files.at(sources.path), sources.path, files, {}, others);
  if (!scene) return Error{{}, "its scene cannot be read: " + scene.error().line()};
  if (file) scene->library_folder = config::containing_folder(*file);
  controllers::describe_for(*scene);
  return scene;
}

Result<EngineMaker> engine_named(std::string_view name) {
  if (name == kStage)
    return EngineMaker([](const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers) {
      return stage::make_engine(scene, {.seed = seed, .workers = workers});
    });
  if (name == kArena)
    return EngineMaker([](const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers) {
      return arena::make_engine(scene, {.seed = seed, .workers = workers});
    });
  return Error{"", "there is no engine " + in_quotes(name) + did_you_mean(name, kEngines)};
}

Result<std::unique_ptr<world::Engine>> make_engine(const scene::SceneDesc& scene, const Running& running,
                                                   controllers::Libraries::LibraryUse use, const Warn& warn,
                                                   const EngineMaker& make, std::vector<Error>* others) {
  for (const std::string& library : running.allowed_libraries)
    if (std::error_code ignored; !std::filesystem::exists(library, ignored))
      return Error{escaped(library), "--allow-library: there is no such file"};
  const Result<EngineMaker> maker = make ? make : engine_named(running.engine);
  if (!maker) return maker.error();
  Result<std::unique_ptr<world::Engine>> engine = (*maker)(scene, running.seed, running.workers);
  if (!engine) return engine;
  for (const std::string& warning : bodies::oddities_of(scene)) warn(warning);
  if (!make && running.engine == kStage)
    for (const std::string& warning : bodies::left_out_in_the_plane(scene)) warn(warning);
  const libraries::Libraries allowed{
      .folders = libraries::library_folders(scene.library_folder, "STAGEPATH", program_folder()),
      .allowed = {running.allowed_libraries.begin(), running.allowed_libraries.end()},
      .use = use};
  world::World& world = (*engine)->world();
  const auto custom = custom_kinds::attach_custom_kinds(world, allowed);
  if (!custom) return custom.error();
  for (const std::string& warning : *custom) warn(warning);
  const auto controllers = controllers::attach(world, allowed, others);
  if (!controllers) return controllers.error();
  for (const std::string& warning : *controllers) warn(warning);
  return engine;
}

run::Simulation::SimulationOptions pace_of(const scene::SceneDesc& scene, const Serving& serving,
                                           const Running& running, QuitTime quit_time) {
  constexpr double kForever = std::numeric_limits<double>::infinity();
  const double file_end =
      quit_time == QuitTime::kHonoured && scene.quit_time > 0 ? scene.quit_time : kForever;
  run::Simulation::SimulationOptions options;
  options.speed = running.speed.value_or(scene.speedup > 0 ? scene.speedup : 1.0);
  if (running.lock_step) {
    options.speed = running.speed.value_or(0);
    options.lock_step = {.members = running.lock_step->clients,
                         .names = running.lock_step->names,
                         .timeout = running.lock_step_timeout};
  }
  options.paused = running.paused || (scene.paused && serving.web.has_value());
  options.duration = running.duration.value_or(file_end);
  return options;
}

std::size_t count_robots(const world::World& world) {
  std::size_t robots = 0;
  for (const world::ModelRow model : world.positions.model) robots += world.models.root[model] == model;
  return robots;
}

}  // namespace playhouse::app
