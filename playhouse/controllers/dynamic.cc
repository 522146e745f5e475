#include "playhouse/controllers/dynamic.h"

#include <algorithm>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/population/population.h"

namespace playhouse::controllers {
namespace {

constexpr int kParts = 100;
constexpr double kAround = 1;  // m, to every side
constexpr std::string_view kPart = "dynamic_part";

bool is_part(const scene::ModelDesc& desc) {
  return desc.parent < 0 && desc.prototype == kPart;
}

bool runs_it(const scene::ModelDesc& desc) {
  return std::ranges::any_of(desc.ctrl, [](const std::string& line) {
    const std::size_t begin = line.find_first_not_of(' ');
    return begin != std::string::npos && line.substr(begin, line.find(' ', begin) - begin) == "dynamic";
  });
}

}  // namespace

void Dynamic::describe_parts(scene::SceneDesc& scene) {
  if (std::ranges::none_of(scene.models, runs_it) || std::ranges::any_of(scene.models, is_part)) return;
  config::MemoryFiles no_files({});
  Result<scene::SceneDesc> made = scene::load_world_text(
      R"(model( name "dynamic_part" size [0.1 0.1 0.1] color "blue" ))", scene.path, no_files);
  PLAYHOUSE_ASSERT(made && made->models.size() == 1);
  // An explicit list of trees, so that this prototype has no instance.
  if (scene.trees.empty()) scene.trees = scene::one_of_each(scene);
  scene.models.push_back(std::move(made->models.front()));
}

Result<void> Dynamic::join(world::World& world, const Post& post) {
  const std::vector<scene::ModelDesc>& descs = world.scene().models;
  const auto part = std::ranges::find_if(descs, is_part);
  if (part == descs.end()) return Error{{}, "the scene does not describe its parts"};
  part_ = static_cast<std::uint32_t>(part - descs.begin());
  model_.push_back(world.row(post.model));
  stream_.push_back({Purpose::kController, world.serial(post.model), post.order});
  done_.push_back(0);
  return {};
}

Result<void> Dynamic::add_part(world::World& world, std::size_t i, Rng& random) const {
  geom::Pose X_MP;
  X_MP.x = random.uniform(-kAround, kAround);
  X_MP.y = random.uniform(-kAround, kAround);
  X_MP.a = random.uniform(-geom::kPi, geom::kPi);
  const Result<world::ModelId> part =
      world::spawn(world, part_, geom::compose(world.models.X_WM[world.row(id(i))], X_MP));
  if (!part) return part.error();
  return world::attach(world, *part, id(i), X_MP);
}

void Dynamic::deliver(world::World& world) {
  for (const std::uint32_t i : by_id()) {
    if (std::exchange(done_[i], 1)) continue;
    Rng random(world.seed(), world.tick(), stream_[i]);
    for (int part = 0; part < kParts; ++part) {
      const Result<void> added = add_part(world, i, random);
      if (added) continue;
      log::error("controller \"dynamic\" of {} made {} parts: {}", in_quotes(world.name(world.row(id(i)))),
                 part, added.error().line());
      break;
    }
  }
}

}  // namespace playhouse::controllers
