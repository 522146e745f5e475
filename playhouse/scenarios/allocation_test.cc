/// A tick allocates nothing once it has run for a while: all memory that the allocator of the C library hands
/// out is counted, whichever thread asks for it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <string>
#include <vector>

#include "playhouse/scenarios/scenario.h"
#include "playhouse/scenarios/testing_simulation.h"
#include "playhouse/stage/testing_scenes.h"
#include "playhouse/world/radio_messages.h"

namespace {

std::atomic<std::size_t> allocations = 0;

}  // namespace

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PLAYHOUSE_SANITIZER_ALLOCATES
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PLAYHOUSE_SANITIZER_ALLOCATES
#endif
#endif

#ifdef PLAYHOUSE_SANITIZER_ALLOCATES

// As in <sanitizer/allocator_interface.h>, which gcc does not have.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void*, std::size_t),
                                                         void (*)(const volatile void*));

namespace {

const int hooks = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { ++allocations; }, [](const volatile void*) {});

}  // namespace

#else

// glibc's functions under the names that stay when a program has its own.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  ++allocations;
  return __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  *memory = memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
}

#endif

namespace playhouse::scenarios {
namespace {

using testing::load;
using testing::ScenarioRun;

/// Ticks after which scratch memory has its size, and those that are counted.
constexpr int kWarmUp = 150, kCounted = 50;

std::size_t allocations_of(ScenarioRun& run) {
  world::World& world = run.world();
  for (const world::ModelRow row : world.models.rows()) world::subscribe(world, row);
  run.step(kWarmUp);
  const std::size_t before = allocations;
  run.step(kCounted);
  return allocations - before;
}

TEST(Allocation, is_counted_here) {
  const std::size_t before = allocations;
  const std::string text(1000, 'x');
  EXPECT_STRNE(text.c_str(), "");
  EXPECT_GE(allocations - before, 1u);
}

TEST(Allocation, there_is_none_in_the_ticks_of_any_scenario) {
  for (const unsigned workers : {1u, 2u, 4u}) {
    for (const Scenario& scenario : kScenarios) {
      ScenarioRun run(make(scenario.name, 30), workers);
      EXPECT_EQ(allocations_of(run), 0u) << scenario.name << ", " << workers << " workers";
    }
  }
}

TEST(Allocation, there_is_none_in_the_ticks_of_our_worlds) {
  for (const unsigned workers : {1u, 4u}) {
    for (const char* file : {"worlds/simple.world", "worlds/cave.world", "worlds/fiducial.world",
                             "examples/controller/shy.world"}) {
      ScenarioRun run(load(file), workers);
      EXPECT_EQ(allocations_of(run), 0u) << file << ", " << workers << " workers";
    }
  }
}

/// Every kind of sensor with every kind of noise, every controller, bodies that are not convex, and grippers
/// that snatch at robots, which they cannot take up.
Result<scene::SceneDesc> everything() {
  std::string text = R"(
    interval_sim 100
    define robot position( size [0.3 0.3 0.2] localization "odom" fiducial_return 5 gripper_return 1
      gripper( pose [0.2 0 -0.2 0] autosnatch 1 )
      block( points 5 point[0] [0 0] point[1] [3 0] point[2] [3 3] point[3] [1.5 1] point[4] [0 3] z [0 1] )
      ranger( ctrl "lasernoise" sensor( range [0.1 8] fov 270 samples 61 noise [0.01 0.02 0] ) )
      ranger( sensor( range [0 5] fov 20 samples 9 noise [0 0.01 0.05] ) sensor( pose [0 0 0 90] range [0 5] fov 10 ) )
      ranger( sensor( pose [0 0 0 -40] range [0 5] fov 10 samples 3 ) sensor( pose [0 0 0 40] range [0 5] ) )
      fiducial( range_max 5 range_max_id 3 fov 200 ) )
    model( name "walls" size [8 8 1] boundary 1 noblocks 1 )
    model( name "depot" pose [3.5 3.5 0 0] size [0.2 0.2 0.2] fiducial_return 9 )
    robot( name "stuck" pose [4 0 0 0] velocity [0.3 0 0 0.1] )
  )";
  const char* controllers[] = {"wander", "expand_swarm", "expand_pioneer", "shy 0.3", "pioneer_flocking"};
  for (int k = 0; k < 36; ++k)
    text += fmt::format("robot( pose [{} {} 0 {}] ctrl \"{}\" )\n", -2.5 + k % 6, -2.5 + k / 6, 77 * k % 360,
                        controllers[k % 5]);
  config::MemoryFiles none({});
  Result<scene::SceneDesc> scene = scene::load_world_text(text, "everything.world", none);
  if (!scene) return scene;
  for (scene::ModelDesc& model : scene->models)
    if (model.name == "depot") model.ctrl = {"source 3000000", "sink"};
  return scene;
}

TEST(Allocation, there_is_none_with_every_sensor_and_controller) {
  for (const unsigned workers : {1u, 4u}) {
    ScenarioRun run(everything(), workers);
    run.world().models.flags[run.world().find("depot")] = 2000000;
    EXPECT_EQ(allocations_of(run), 0u) << workers << " workers";
    EXPECT_GT(std::ranges::count_if(run.world().grippers.paddles, [](double closed) { return closed > 0; }),
              0);
    EXPECT_GT(run.world().models.say[run.world().find("depot")].size(), 15u)
        << "more than a short string holds";
  }
}

TEST(Allocation, there_is_none_with_cameras_bumpers_and_detectors) {
  std::string text = "model( name \"walls\" size [6 6 1] boundary 1 noblocks 1 )\n";
  for (int k = 0; k < 6; ++k)
    text += fmt::format(R"(position( pose [{} {} 0 {}] size [0.3 0.3 0.2] ctrl "wander"
  ranger( sensor( range [0 5] fov 180 samples 20 ) ) bumper( ) blobfinder( image [32 8] )
  camera( resolution [16 12] ) camera( resolution [8 6] pantilt [0 -10] image "depth" )
  detector( samples 5 rays 3 layers 2 fov_vertical 20 sees ["kind=position speed>0.01" "name=walls"] walls 1
    noise [0.1 0 1] miss 0.1 ) )
)",
                        k % 3 - 1, k / 3 - 1, 60 * k);
  config::MemoryFiles none({});
  // One worker: of several, one that had little to do so far may see more than ever in a late tick.
  ScenarioRun run(scene::load_world_text(text, "cameras.world", none), 1);
  EXPECT_EQ(allocations_of(run), 0u);
  EXPECT_GT(run.world().detectors.measured_tick[{0}], 0u);
}

TEST(Allocation, there_is_none_where_radios_carry_messages) {
  std::string text;
  for (int k = 0; k < 24; ++k)
    text += fmt::format("wifi( pose [{} {} 0 0] model \"raytrace\" fading 1 loss 5 )\n", k % 8, k / 8);
  text += "model( size [0.1 4 1] pose [2.5 2 0 0] )";
  config::MemoryFiles none({});
  const std::vector<std::uint8_t> message(100);
  for (const unsigned workers : {1u, 4u}) {
    ScenarioRun run(scene::load_world_text(text, "radios.world", none), workers);
    world::World& world = run.world();
    for (const world::ModelRow radio : world.wifis.model) world::subscribe(world, radio);
    std::size_t in_ticks = 0;
    for (int tick = 0; tick < kWarmUp + kCounted; ++tick) {
      for (const world::WifiRow radio : world.wifis.rows()) world::send_message(world, {radio}, {}, message);
      const std::size_t before = allocations;
      run.step();
      if (tick >= kWarmUp) in_ticks += allocations - before;
    }
    EXPECT_EQ(in_ticks, 0u) << workers << " workers";
    EXPECT_GT(world.wifis.incoming[{0}].size(), 10u);
  }
}

TEST(Allocation, there_is_none_where_robots_are_in_each_others_way) {
  for (const unsigned workers : {1u, 4u}) {
    scene::SceneDesc scene = stage::testing::throng(100, 1);
    for (scene::ModelDesc& model : scene.models)  // a corner of each body is cut out
      if (model.position) model.blocks[0].points.push_back({0, 0});
    ScenarioRun run(std::move(scene), workers);
    EXPECT_EQ(allocations_of(run), 0u) << workers << " workers";
  }
}

}  // namespace
}  // namespace playhouse::scenarios
