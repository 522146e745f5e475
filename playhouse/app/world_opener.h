#pragma once

/// From a scene to a simulation ready to run: engine, controllers, pace.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/app/commands/options.h"
#include "playhouse/base/result.h"
#include "playhouse/config/text/source_text.h"
#include "playhouse/controllers/attach.h"
#include "playhouse/run/simulation.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/world/engine.h"

namespace playhouse::app {

/// Handler of a warning about a file, "file:line: text".
using Warn = std::function<void(const std::string&)>;

/// Factory of an engine at tick 0. The scene must outlive it. Fails on a scene that the engine cannot run.
using EngineMaker = std::function<Result<std::unique_ptr<world::Engine>>(
    const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers)>;

/// The factory of this name. Fails if there is none.
Result<EngineMaker> engine_named(std::string_view name);

/// Reads a world file named by a user, with what its controllers may spawn; logs
/// warnings. Fails like scene::load_world(). `sources`, if given, gets the files.
Result<scene::SceneDesc> read_scene(const std::string& path, std::vector<Error>* others,
                                    config::SourceFiles* sources = nullptr);

/// The scene of files in memory, as of a saved run, with what its controllers may spawn. Its libraries are
/// looked for beside `file`, which is the one that a person named; nullopt: it came from a peer. Fails like
/// read_scene().
Result<scene::SceneDesc> scene_of(const config::SourceFiles& sources, const std::optional<std::string>& file,
                                  std::vector<Error>* others);

/// Makes an engine with the controllers that models name: by `make`, otherwise the one
/// named in `running`. The scene must outlive it. `others`, if given, gets further errors.
Result<std::unique_ptr<world::Engine>> make_engine(const scene::SceneDesc& scene, const Running& running,
                                                   controllers::Libraries::LibraryUse use, const Warn& warn,
                                                   const EngineMaker& make = {},
                                                   std::vector<Error>* others = nullptr);

/// Whether quit_time of the world file ends the run.
enum class QuitTime : std::uint8_t { kHonoured, kIgnored };

/// Pace of the run: command line first, then the file. A file with
/// speedup 0 (as fast as possible) runs in real time, since clients
/// could not keep up; use --fast for that. A file with paused starts
/// paused only if there is a page to resume it. In lock-step the
/// clients set the pace; a speed on the command line is an upper bound.
run::Simulation::SimulationOptions pace_of(const scene::SceneDesc& scene, const Serving& serving,
                                           const Running& running, QuitTime quit_time);

/// The number of robots: root position models.
std::size_t count_robots(const world::World& world);

}  // namespace playhouse::app
