// Any bytes are a saved run that goes on, or are refused: with the head that fits them, so that what is
// behind it is looked at.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>

#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/fuzz_saved_runs.h"
#include "playhouse/world/saving/saved_run.h"
#include "playhouse/world/saving/state.h"

namespace {

using namespace playhouse;

/// Small, so that a run takes milliseconds.
constexpr scene::WorldLimits kLimits{.models = 64,
                                     .fields = 1 << 12,
                                     .pixels = 1 << 12,
                                     .bitmap_bytes = 1 << 14,
                                     .corners = 1 << 10,
                                     .beams = 1 << 10,
                                     .sensors = 64,
                                     .text_bytes = 1 << 14};

void go_on(const world::SavedRun& run) {
  config::MemoryFiles files(run.sources.files, run.sources.search_path);
  const auto scene =
      scene::load_world_text(run.sources.files.at(run.sources.path), run.sources.path, files, kLimits);
  if (!scene) return;
  const auto engine = stage::make_engine(*scene, {.seed = run.seed});
  if (!engine) return;
  world::World& world = (*engine)->world();
  const Result<void> loaded = world::load_state(world, run.state);
  PLAYHOUSE_ASSERT(loaded.ok() || !loaded.error().text.empty());
  if (!loaded || world.models.size() > 4 * kLimits.models) return;
  std::vector<std::byte> again;
  PLAYHOUSE_ASSERT(world::save_state(world, again).ok() && again == run.state);
  for (int tick = 0; tick < 2; ++tick) (*engine)->step();
}

}  // namespace

/// Writes what it starts from to the last folder that it is given.
extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  const std::filesystem::path folder = (*arguments)[*count - 1];
  if (!std::filesystem::is_directory(folder)) return 0;
  for (const auto& [name, bytes] : stage::fuzz::saved_runs())
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const Result<world::SavedRun> run =
      world::decode_saved_run(world::with_head(std::as_bytes(std::span(bytes, size))));
  if (run) go_on(*run);
  return 0;
}
