// What the fuzzer of saved runs starts from (tests/fuzz/stage_saved_run) must be runs that go on, or it never
// comes by the first column that has changed. UPDATE_CORPUS=1 writes them anew.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/world/columns.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/radio_messages.h"
#include "playhouse/world/saving/saved_run.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::stage {
namespace {

// A model of every kind that has a table, and of every trait.
constexpr const char* kWorld = R"(
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
  lightindicator()
  imu( alwayson 1 acceleration_noise [0.01 0.001] gyro_noise [0.01 0.001] gyro_bias 0.01 )
  gps( alwayson 1 noise [2 4] drift [1 2] drift_time 600 )
  custom( alwayson 1 library "none" )
  actuator( pose [0 0 0 0] type "rotational" max_position 90 alwayson 1 model( size [0.1 0.1 0.1] ) ) )
bot( name "a" fiducial_return 1 say "hello" )
wifi( name "post" pose [1 1 1 0] )
model( name "puck" pose [0.5 0 0 0] size [0.08 0.08 0.1] color "red" gripper_return 1 obstacle_return 0 )
model( name "walls" size [4 4 1] boundary 1 noblocks 1 )
)";

const std::string kCorpus = PLAYHOUSE_SOURCE_DIR "/tests/fuzz/stage_saved_run/";

/// A run of `ticks`, in which a robot came half way and a message waits to be sent, as the fuzzer takes it:
/// without the head.
std::vector<std::byte> run_of(std::uint64_t ticks) {
  world::SavedRun run{{"tiny.world", {{"tiny.world", kWorld}}, {}}, "stage", 1, {}};
  scene::MemoryFiles files(run.sources.files);
  const auto scene = scene::load_world_text(kWorld, run.sources.path, files);
  EXPECT_TRUE(scene) << scene.error().line();
  const auto engine = make_engine(*scene, {.seed = run.seed});
  EXPECT_TRUE(engine);
  world::World& world = (*engine)->world();
  world::each_column(
      [](const auto& column, const auto& values) { EXPECT_FALSE(values.empty()) << column.name; }, world);
  for (std::uint64_t tick = 0; tick < ticks; ++tick) {
    if (2 * tick == ticks) EXPECT_TRUE(world::spawn(world, 0, {-1, 1, 0, 0}));
    (*engine)->step();
  }
  const std::uint8_t message[] = {'h', 'i'};
  EXPECT_TRUE(world::send_message(world, {0}, {}, message));
  EXPECT_TRUE(world::save_state(world, run.state));
  const std::vector<std::byte> file = encode(run);
  return {file.begin() + static_cast<std::ptrdiff_t>(world::with_head({}).size()), file.end()};
}

std::vector<std::byte> read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

TEST(SavedRunCorpus, goes_on) {
  for (const std::uint64_t ticks : {0, 20}) {
    const std::string path = fmt::format("{}every_kind_{}", kCorpus, ticks);
    const std::vector<std::byte> now = run_of(ticks);
    if (std::getenv("UPDATE_CORPUS"))
      std::ofstream(path, std::ios::binary)
          .write(reinterpret_cast<const char*>(now.data()), static_cast<std::streamsize>(now.size()));
    const auto run = world::decode_saved_run(world::with_head(read(path)));
    ASSERT_TRUE(run) << path << ": " << run.error().text;
    scene::MemoryFiles files(run->sources.files);
    const auto scene =
        scene::load_world_text(run->sources.files.at(run->sources.path), run->sources.path, files);
    ASSERT_TRUE(scene) << path;
    const auto engine = make_engine(*scene, {.seed = run->seed});
    ASSERT_TRUE(engine) << path;
    const auto loaded = world::load_state((*engine)->world(), run->state);
    EXPECT_TRUE(loaded) << path << ": " << loaded.error().text << "; UPDATE_CORPUS=1 writes it anew";
  }
}

}  // namespace
}  // namespace playhouse::stage
