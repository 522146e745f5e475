/// Any bytes as a world file, with an include and two bitmaps in memory: loads or fails with a text, never
/// more. What loads is written, and is read back the same.

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "playhouse/scene/testing_same_scene.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/scene/write_world.h"

namespace {

using namespace playhouse::scene;

SceneDesc read_back(const SceneDesc& scene, playhouse::config::FileReader& files, const std::string& text) {
  const auto again = load_world_text(text, scene.path, files);
  if (again) return *again;
  std::fprintf(stderr, "%s\n%s\n", again.error().line().c_str(), text.c_str());
  std::abort();
}

void expect_same(const std::string& what, const std::string& text) {
  if (what.empty()) return;
  std::fprintf(stderr, "%s\n%s\n", what.c_str(), text.c_str());
  std::abort();
}

void check_written(const SceneDesc& scene, playhouse::config::FileReader& files) {
  const auto text = write_world(scene, scene.path);
  if (!text) return expect_same(text.error().text.empty() ? "no text" : "", "");
  const SceneDesc again = read_back(scene, files, *text);
  const std::string what = difference(scene, again);
  // A heading of many turns may have no number near zero that says the same to the last bit.
  if (what.find("words of ") == std::string::npos) expect_same(what, *text);
  const auto second = write_world(again, scene.path);
  expect_same(second ? "" : "not written then", *text);
  const SceneDesc third = read_back(again, files, *second);
  expect_same(difference(again, third), *text);
  // Trees with parts that lost a name of their own to later ones are alike only once they are read again:
  // then one macro may make them.
  const auto settled = scene.renamed.empty() ? second : write_world(third, scene.path);
  expect_same(
      settled && *settled == (scene.renamed.empty() ? *text : *second) ? "" : "written otherwise then",
      *text);
  for (const std::string& warning : again.warnings)
    expect_same(warning.find("of older versions: ") == std::string::npos ? "" : warning, *text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  // Bytes after a NUL are the bitmap "data".
  const std::size_t split = std::min(text.find('\0'), text.size());
  playhouse::config::MemoryFiles files(
      {{"w/map.inc", "define wall model ( color \"gray30\" boundary 1 bitmap \"plan\" )\n"},
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
    check_written(*scene, files);
  }
  return 0;
}
