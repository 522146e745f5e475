#pragma once

/// From a scene to a simulation that is ready to run: engine, controllers, pace.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/app/options.h"
#include "playhouse/base/result.h"
#include "playhouse/controllers/attach.h"
#include "playhouse/drivers/simulated/simulation.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/scene/source_text.h"
#include "playhouse/world/engine.h"

namespace playhouse::app {

/// Takes a line about something odd in a file, "file:line: text".
using Warn = std::function<void(const std::string&)>;

/// Makes an engine of some kind at tick 0. The scene must outlive it. Fails on a scene that it cannot run.
using EngineMaker = std::function<Result<std::unique_ptr<world::Engine>>(
    const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers)>;

/// The engine of this name. Fails if there is none.
Result<EngineMaker> engine_named(std::string_view name);

/// A world file as a person names it, with what its controllers make during a run; its warnings are told.
/// Fails as scene::load_world(). `sources`, if given, gets the files.
Result<scene::SceneDesc> read_scene(const std::string& path, std::vector<Error>* others,
                                    scene::SourceFiles* sources = nullptr);

/// An engine for the scene, with the controllers that its models name: what `make` makes, or else the one
/// that `running` names. The scene must outlive it. `others`, if given, gets the errors after the first.
Result<std::unique_ptr<world::Engine>> make_engine(const scene::SceneDesc& scene, const Running& running,
                                                   controllers::Libraries::Use use, const Warn& warn,
                                                   const EngineMaker& make = {},
                                                   std::vector<Error>* others = nullptr);

/// Whether the world file's quit_time ends the run.
enum class QuitTime : std::uint8_t { kHonoured, kIgnored };

/// How the run relates to the wall clock: what the command line says, else what the file says. A file that
/// wants speedup 0 (as fast as possible) runs in real time: clients could not keep up with it, and --fast
/// asks for it. A file that wants to start paused does so where somebody can resume it: where a page is
/// served. In lock-step the clients alone say how fast it goes, unless the command line gives a speed, which
/// is the fastest then.
drivers::Simulation::Options pace_of(const scene::SceneDesc& scene, const Serving& serving,
                                     const Running& running, QuitTime quit_time);

/// Robots: position models at the top of the scene.
std::size_t count_robots(const world::World& world);

}  // namespace playhouse::app
