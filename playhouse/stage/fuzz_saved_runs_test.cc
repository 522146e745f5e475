// What the fuzzer of saved runs starts from must have something in each column, and be runs that go on.

#include "playhouse/stage/fuzz_saved_runs.h"

#include <gtest/gtest.h>

#include "playhouse/world/columns.h"

namespace playhouse::stage {
namespace {

TEST(FuzzedSavedRuns, go_on_with_something_in_each_column) {
  for (const auto& [name, bytes] : fuzz::saved_runs()) {
    const auto run = world::decode_saved_run(world::with_head(bytes));
    ASSERT_TRUE(run) << name << ": " << run.error().text;
    config::MemoryFiles files(run->sources.files);
    const auto scene =
        scene::load_world_text(run->sources.files.at(run->sources.path), run->sources.path, files);
    ASSERT_TRUE(scene) << name;
    const auto engine = make_engine(*scene, {.seed = run->seed});
    ASSERT_TRUE(engine) << name;
    world::World& world = (*engine)->world();
    const auto loaded = world::load_state(world, run->state);
    ASSERT_TRUE(loaded) << name << ": " << loaded.error().text;
    world::each_column(
        [&](const auto& column, const auto& values) { EXPECT_FALSE(values.empty()) << column.name; }, world);
    (*engine)->step();
  }
}

}  // namespace
}  // namespace playhouse::stage
