#pragma once

/// What the fuzzer of saved runs starts from: runs with a model of every kind and every trait, as its inputs
/// are, without the head. They are made when it starts, as another column or kind makes others of them: one of
/// before would be refused at the first column that has changed, and the fuzzer would never come by it.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/radio_messages.h"
#include "playhouse/world/saving/saved_run.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::stage::fuzz {

/// The words are those with which columns get other values than at the start.
inline constexpr const char* kBot = R"(
interval_sim 100
define bot position( size [0.4 0.4 0.3] alwayson 1 velocity [0.3 0 0 20] joules 50 watts 3 give_watts 2
  ranger( alwayson 1 sensor( range [0 4] fov 90 samples 5 ) sensor( range [0 2] noise [0.01 0.01 3] ) )
  fiducial( alwayson 1 )
  blobfinder( alwayson 1 colors_count 1 colors ["red"] image [8 4] )
  bumper( alwayson 1 )
  gripper( pose [0.3 0 -0.3 0] alwayson 1 autosnatch 1 )
  wifi( alwayson 1 fading 2 )
  camera( alwayson 1 resolution [4 3] pantilt [10 -10] noise [0.1 0] )
  detector( alwayson 1 samples 3 rays 2 layers 2 fov_vertical 20 sees "kind=wifi" walls 1 noise [0.1 0 1] miss 0.2 )
  blinkenlight( alwayson 1 )
  imu( alwayson 1 acceleration_noise [0.01 0.001] gyro_noise [0.01 0.001] gyro_bias 0.01 )
  gps( alwayson 1 noise [2 4] drift [1 2] drift_time 600 )
  custom( alwayson 1 library "none" )
  actuator( pose [0 0 0 0] type "rotational" max_position 90 alwayson 1 model( size [0.1 0.1 0.1] ) )
)";
inline constexpr const char* kOthers = R"( )
bot( name "a" fiducial_return 1 say "hello" )
wifi( name "post" pose [1 1 1 0] )
model( name "puck" pose [0.5 0 0 0] size [0.08 0.08 0.1] color "red" rfid_tag "e200" gripper_return 1 obstacle_return 0 )
model( name "walls" size [4 4 1] boundary 1 noblocks 1 )
)";

/// The bot has one of every kind that is not named above, too.
inline std::string world_of_every_kind() {
  std::string text = kBot;
  for (const scene::Kind& kind : scene::kinds()) {
    const bool is_model = kind.entity == scene::EntityForm::kModel && kind.simulated;
    if (is_model && text.find(std::string(kind.name) + "(") == std::string::npos)
      text += "  " + std::string(kind.name) + "( alwayson 1 )\n";
  }
  return text + kOthers;
}

/// A run of `ticks`, in which a robot came half way and a message waits to be sent. `change(world)` is last.
template <typename Change>
std::vector<std::byte> saved_run(std::uint64_t ticks, const Change& change) {
  const std::string text = world_of_every_kind();
  world::SavedRun run{{"tiny.world", {{"tiny.world", text}}, {}}, "stage", 1, {}};
  config::MemoryFiles files(run.sources.files);
  const auto scene = scene::load_world_text(text, run.sources.path, files);
  PLAYHOUSE_ASSERT(scene.ok());
  const auto engine = make_engine(*scene, {.seed = run.seed});
  PLAYHOUSE_ASSERT(engine.ok());
  world::World& world = (*engine)->world();
  for (std::uint64_t tick = 0; tick < ticks; ++tick) {
    if (2 * tick == ticks) PLAYHOUSE_ASSERT(world::spawn(world, 0, {-1, 1, 0, 0}).ok());
    (*engine)->step();
  }
  const std::uint8_t message[] = {'h', 'i'};
  PLAYHOUSE_ASSERT(world::send_message(world, {0}, {}, message));
  change(world);
  PLAYHOUSE_ASSERT(world::save_state(world, run.state).ok());
  const std::vector<std::byte> file = encode(run);
  return {file.begin() + static_cast<std::ptrdiff_t>(world::with_head({}).size()), file.end()};
}

/// By name; one looks so far to the left that its sine once had no end.
inline std::map<std::string, std::vector<std::byte>> saved_runs() {
  const auto nothing = [](const world::World&) {};
  return {{"every_kind_0", saved_run(0, nothing)},
          {"every_kind_20", saved_run(20, nothing)},
          {"camera_far_round", saved_run(1, [](world::World& world) { world.cameras.pan[{0}] = 3e302; })}};
}

}  // namespace playhouse::stage::fuzz
