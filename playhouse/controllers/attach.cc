#include "playhouse/controllers/attach.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/controllers/diffusion.h"
#include "playhouse/controllers/dynamic.h"
#include "playhouse/controllers/expand.h"
#include "playhouse/controllers/fasr.h"
#include "playhouse/controllers/lasernoise.h"
#include "playhouse/controllers/loaded.h"
#include "playhouse/controllers/patrol.h"
#include "playhouse/controllers/rasterize.h"
#include "playhouse/controllers/source_sink.h"
#include "playhouse/controllers/wander.h"

namespace playhouse::controllers {
namespace {

/// A built-in controller and the factory of its batch.
struct BuiltIn {
  std::string_view name;
  std::unique_ptr<Batch> (*make)(std::string name);
};

template <typename Made>
std::unique_ptr<Batch> make(std::string) {
  return std::make_unique<Made>();
}
template <Fasr::Arguments kArguments>
std::unique_ptr<Batch> make_fasr(std::string name) {
  return std::make_unique<Fasr>(std::move(name), kArguments);
}
template <const ExpandConfig& kConfig>
std::unique_ptr<Batch> make_expand(std::string name) {
  return std::make_unique<Expand>(std::move(name), kConfig);
}
std::unique_ptr<Batch> make_diffusion(std::string name) {
  return std::make_unique<Diffusion>(std::move(name));
}
std::unique_ptr<Batch> make_wander(std::string name) {
  return std::make_unique<Wander>(std::move(name));
}

constexpr auto kBuiltIns = std::to_array<BuiltIn>({
    {"wander", make_wander},
    {"wander_accel", make_wander},
    {"fasr", make_fasr<Fasr::Arguments::kEnds>},
    {"fasr_plan", make_fasr<Fasr::Arguments::kEnds>},
    {"fasr2", make_fasr<Fasr::Arguments::kTasks>},
    {"expand_swarm", make_expand<kExpandSwarm>},
    {"expand_pioneer", make_expand<kExpandPioneer>},
    {"pioneer_flocking", make_expand<kPioneerFlocking>},
    {"diffusion", make_diffusion},
    {"patrol", make<Patrol>},
    {"source", make<Source>},
    {"sink", make<Sink>},
    {"lasernoise", make<LaserNoise>},
    {"rasterize", make<Rasterize>},
    {"dynamic", make<Dynamic>},
});

std::unique_ptr<Batch> make_built_in(const std::string& name) {
  const auto found = std::ranges::find(kBuiltIns, name, &BuiltIn::name);
  return found == kBuiltIns.end() ? nullptr : found->make(name);
}

std::vector<std::string_view> built_in_names() {
  std::vector<std::string_view> names;
  for (const BuiltIn& built_in : kBuiltIns) names.push_back(built_in.name);
  return names;
}

constexpr libraries::LibraryAbi kProvided{"controller", "PLAYHOUSE_CONTROLLER", "playhouse_controller",
                                          kControllerVersionLeast, kControllerVersion};

/// The batches of a world under construction.
class Batches {
 public:
  Batches(world::World& world, const Libraries& libraries) : world_(world), libraries_(libraries) {}

  Result<void> add(const Post& post, const std::string& where);
  void warn(std::string line) { warnings_.push_back(std::move(line)); }
  std::vector<std::string> take_warnings() { return std::move(warnings_); }

 private:
  /// The batch of that name; null, with a warning, if libraries are only located.
  Result<Batch*> batch(const std::string& name, const std::string& where);

  world::World& world_;
  const Libraries& libraries_;
  std::map<std::string, Batch*> by_name_;
  std::vector<std::string> warnings_;
};

Result<Batch*> Batches::batch(const std::string& name, const std::string& where) {
  if (const auto at = by_name_.find(name); at != by_name_.end()) return at->second;
  std::unique_ptr<Batch> made = make_built_in(name);
  if (!made) {
    const std::vector<std::string_view> built_ins = built_in_names();
    const auto library = libraries::load({kProvided, name, where, built_ins}, libraries_, warnings_);
    if (!library) return library.error();
    if (*library) made = std::make_unique<Loaded>(name, *library);
  }
  Batch* const batch = made.get();
  by_name_.emplace(name, batch);
  if (made) world_.deciders.push_back(std::move(made));
  return batch;
}

Result<void> Batches::add(const Post& post, const std::string& where) {
  const Result<Batch*> found = batch(post.name, where);
  if (!found) return found.error();
  if (!*found) return {};
  if (const Result<void> added = (*found)->add(world_, post); !added) {
    return Error{where, "controller " + in_quotes(post.name) + " of " +
                            in_quotes(world_.name(world_.row(post.model))) + ": " + added.error().line()};
  }
  return {};
}

}  // namespace

void describe_for(scene::SceneDesc& scene) {
  Dynamic::describe_parts(scene);
}

Result<std::vector<std::string>> attach(world::World& world, const Libraries& libraries,
                                        std::vector<Error>* others) {
  Batches batches(world, libraries);
  std::set<std::string> faulty;
  std::vector<Error> told;  // the first error of each controller
  for (const world::ModelRow row : world.models.rows()) {
    if (world.desc(row).ctrl.empty()) continue;
    const std::string where = world.scene().at(world.where(row));
    std::vector<std::string> repeated;
    for (const Post& post : posts_of(world, {row}, &repeated)) {
      if (faulty.contains(post.name) || told.size() == limits::kWarningsOfAKind) continue;
      const Result<void> added = batches.add(post, where);
      if (added) continue;
      faulty.insert(post.name);
      told.push_back(added.error());
    }
    for (const std::string& name : repeated)
      batches.warn(where + ": " + in_quotes(world.name(row)) + " names controller " + in_quotes(name) +
                   " twice; the second is left out");
  }
  if (told.empty()) return batches.take_warnings();
  if (others) others->assign(told.begin() + 1, told.end());
  return told.front();
}

}  // namespace playhouse::controllers
