#include "playhouse/bodies/blind_rangers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "playhouse/base/in_quotes.h"

namespace playhouse::bodies {
namespace {

constexpr std::size_t kMostRangers = 10'000;  // of a world that is looked at: more are placed by programs
constexpr double kSameHeight = 1e-4;          // m

/// The heights of a body that rangers see.
struct SeenLayer {
  double bottom = 0, top = 0;
  world::ModelRow root;
};

/// True for what the arena turns by roll or pitch: it may reach any height there.
bool may_be_tilted(const world::World& world, world::ModelRow row) {
  for (; row; row = world.models.parent[row])
    if (world.desc(row).roll != 0 || world.desc(row).pitch != 0) return true;
  return false;
}

std::vector<SeenLayer> layers_of(const world::World& world) {
  std::vector<SeenLayer> layers;
  for (const world::ModelRow row : world.models.rows()) {
    const scene::ModelDesc& desc = world.desc(row);
    if (desc.ranger_return < 0) continue;
    const double z = world.models.X_WM[row].z, z_body = z + desc.X_MB.z;
    const world::ModelRow root = world.models.root[row];
    constexpr double kAny = std::numeric_limits<double>::infinity();
    if (may_be_tilted(world, row)) layers.push_back({-kAny, kAny, root});
    for (const scene::Block& block : desc.blocks)
      layers.push_back({z_body + block.z_min, z_body + block.z_max, root});
    for (const scene::Contours& walls : desc.bitmaps)
      layers.push_back({z_body + walls.z_min, z_body + walls.z_max, root});
    if (desc.mesh) layers.push_back({z, z + desc.size.z, root});
  }
  return layers;
}

/// Whose bodies are at a height: of no tree, of one, or of several.
class TreesAtHeight {
 public:
  TreesAtHeight(const std::vector<SeenLayer>& layers, double z) {
    for (const SeenLayer& layer : layers) {
      if (z < layer.bottom || z > layer.top) continue;
      several_ |= one_ && *one_ != layer.root;
      one_ = layer.root;
    }
  }
  bool have_others_than(world::ModelRow root) const { return several_ || (one_ && *one_ != root); }

 private:
  std::optional<world::ModelRow> one_;
  bool several_ = false;
};

class HeightSearch {
 public:
  explicit HeightSearch(const world::World& world) : world_(world), layers_(layers_of(world)) {}

  bool is_blind(world::ModelRow model) {
    const scene::ModelDesc& desc = world_.desc(model);
    if (desc.sensors.empty()) return false;
    const world::ModelRow root = world_.models.root[model];
    const double z_body = world_.models.X_WM[model].z + desc.X_MB.z;
    return std::ranges::none_of(desc.sensors, [&](const scene::RangerSensorDesc& sensor) {
      return sensor.rings > 1 || at(z_body + sensor.X_BS.z + 0.5 * sensor.size.z).have_others_than(root);
    });
  }

  /// True if there is something to see, at whatever height.
  bool is_anything_beside(world::ModelRow root) const {
    return std::ranges::any_of(layers_, [root](const SeenLayer& layer) { return layer.root != root; });
  }

 private:
  const TreesAtHeight& at(double z) {
    const auto key = static_cast<std::int64_t>(std::llround(z / kSameHeight));
    if (const auto found = by_height_.find(key); found != by_height_.end()) return found->second;
    return by_height_.emplace(key, TreesAtHeight(layers_, z)).first->second;
  }

  const world::World& world_;
  const std::vector<SeenLayer> layers_;
  std::map<std::int64_t, TreesAtHeight> by_height_;
};

}  // namespace

std::vector<std::string> blind_rangers(const world::World& world) {
  if (world.rangers.size() == 0 || world.rangers.size() > kMostRangers) return {};
  HeightSearch search(world);
  std::optional<world::ModelRow> first;
  std::size_t others = 0;
  for (const world::RangerRow row : world.rangers.rows()) {
    const world::ModelRow model = world.rangers.model[row];
    if (!search.is_blind(model)) continue;
    if (first) ++others;
    if (!first) first = model;
  }
  if (!first || !search.is_anything_beside(world.models.root[*first])) return {};
  const std::string where = world.scene().at(world.where(world.models.root[*first]));
  const std::string more = others == 0 ? "" : fmt::format(" (and of {} more)", others);
  return {fmt::format("{}: nothing else reaches the height of the beams of {}{}: they see nothing", where,
                      in_quotes(world.alias(*first)), more)};
}

}  // namespace playhouse::bodies
