/// Any bytes as a world file, with an include and two bitmaps in memory: loads or fails with a text, never
/// more.

#include <cstdint>
#include <cstdlib>

#include "playhouse/scene/world_loader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace playhouse::scene;
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  // Bytes after a NUL are the bitmap "data".
  const std::size_t split = std::min(text.find('\0'), text.size());
  MemoryFiles files({{"w/map.inc", "define wall model ( color \"gray30\" boundary 1 bitmap \"plan\" )\n"},
                     {"w/self.inc", "include \"self.inc\""},
                     {"w/plan", "P1 4 3 1111 1001 1101"},
                     {"w/data", split < size ? text.substr(split + 1) : ""}});
  const WorldLimits limits{
      .models = 2000, .fields = 100000, .pixels = 1 << 16, .corners = 1 << 18, .beams = 1 << 20};
  const auto scene = load_world_text(text.substr(0, split), "w/t.world", files, limits);
  if (!scene && scene.error().text.empty()) std::abort();
  if (scene) {
    for (const TreeDesc& tree : scene->trees)
      if (tree.name.empty() || tree_size(*scene, tree.top) == 0) std::abort();
    for (std::size_t row = 0; row < scene->models.size(); ++row) {
      const ModelDesc& model = scene->models[row];
      if (model.name.empty() || model.parent >= static_cast<std::int32_t>(row)) std::abort();
      for (const Block& block : model.blocks) {
        if (block.points.size() < 3 || !(block.z_min <= block.z_max)) std::abort();
      }
    }
  }
  return 0;
}
