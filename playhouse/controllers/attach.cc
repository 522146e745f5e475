#include "playhouse/controllers/attach.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "playhouse/base/folders_of.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/controllers/diffusion.h"
#include "playhouse/controllers/dynamic.h"
#include "playhouse/controllers/expand.h"
#include "playhouse/controllers/fasr.h"
#include "playhouse/controllers/lasernoise.h"
#include "playhouse/controllers/loaded.h"
#include "playhouse/controllers/rasterize.h"
#include "playhouse/controllers/source_sink.h"
#include "playhouse/controllers/wander.h"

namespace playhouse::controllers {
namespace {

/// A controller that comes with the program, and how a batch of it is made.
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

Error unknown(const std::string& where, const std::string& name,
              const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> words;
  for (const BuiltIn& built_in : kBuiltIns) words.emplace_back(built_in.name);
  for (const std::filesystem::path& folder : folders) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
      if (entry.path().extension() == ".so" && entry.is_regular_file(ignored))
        words.push_back(entry.path().stem().string());
    }
  }
  // Folders list their files in any order.
  std::sort(words.begin() + kBuiltIns.size(), words.end());
  const std::vector<std::string_view> candidates(words.begin(), words.end());
  const std::string nearest = did_you_mean(name, candidates);
  if (std::filesystem::path(name).is_absolute())
    return {where,
            "no controller " + in_quotes(name) + ": there is no file " + in_quotes(library_file(name))};
  if (!nearest.empty()) return {where, "no controller " + in_quotes(name) + nearest};
  std::string places;
  for (const std::filesystem::path& folder : folders)
    places += (places.empty() ? "" : ", ") + escaped(folder.string());
  return {where, "no controller " + in_quotes(name) + ": it is not built in, and " +
                     in_quotes(library_file(name)) + " is not in " + places};
}

/// Whether a name leads out of the folders in which it is looked for.
bool leads_outside(std::string_view name) {
  const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
  return path.is_absolute() || (!path.empty() && *path.begin() == "..");
}

/// The batches of one world while they fill.
class Batches {
 public:
  Batches(world::World& world, const Libraries& libraries) : world_(world), libraries_(libraries) {}

  Result<void> add(const Post& post, const std::string& where);
  void warn(std::string line) { warnings_.push_back(std::move(line)); }
  std::vector<std::string> take_warnings() { return std::move(warnings_); }

 private:
  /// The batch of that name; null, with a warning, where nothing is loaded.
  Result<Batch*> batch(const std::string& name, const std::string& where);
  /// The same for the library at `file`.
  Result<std::unique_ptr<Batch>> load(const std::string& name, const std::filesystem::path& file,
                                      const std::string& where);
  bool is_allowed(const std::string& name, const std::filesystem::path& file) const;

  world::World& world_;
  const Libraries& libraries_;
  std::map<std::string, Batch*> by_name_;
  std::vector<std::string> warnings_;
};

Result<Batch*> Batches::batch(const std::string& name, const std::string& where) {
  if (const auto at = by_name_.find(name); at != by_name_.end()) return at->second;
  std::unique_ptr<Batch> made = make_built_in(name);
  const std::filesystem::path file = made ? "" : find_library(name, libraries_.folders);
  if (!file.empty()) {
    Result<std::unique_ptr<Batch>> loaded = load(name, file, where);
    if (!loaded) return loaded.error();
    made = std::move(*loaded);
  } else if (!made) {
    return unknown(where, name, libraries_.folders);
  }
  Batch* const batch = made.get();
  by_name_.emplace(name, batch);
  if (made) world_.deciders.push_back(std::move(made));
  return batch;
}

bool Batches::is_allowed(const std::string& name, const std::filesystem::path& file) const {
  std::error_code ignored;
  return !leads_outside(name) ||
         std::ranges::any_of(libraries_.allowed, [&](const std::filesystem::path& allowed) {
           return std::filesystem::equivalent(file, allowed, ignored);
         });
}

Result<std::unique_ptr<Batch>> Batches::load(const std::string& name, const std::filesystem::path& file,
                                             const std::string& where) {
  const std::string path = escaped(std::filesystem::absolute(file).lexically_normal().string());
  if (libraries_.use == Libraries::Use::kFind) {
    warn(where + ": controller " + in_quotes(name) + " is " + path +
         ", which is there and not checked: checking loads no code" +
         (is_allowed(name, file) ? "" : "; running it takes --allow-library " + path));
    return std::unique_ptr<Batch>();
  }
  if (!is_allowed(name, file)) {
    return Error{where, "controller " + in_quotes(name) +
                            " is code outside the folders of controllers; if you trust it, " +
                            "run with --allow-library " + path};
  }
  log::info("controller {}: loads {}", in_quotes(name), path);
  Result<Library> library = Library::open(file);
  if (!library) return Error{where, "controller " + in_quotes(name) + ": " + library.error().line()};
  return std::unique_ptr<Batch>(std::make_unique<Loaded>(name, std::move(*library)));
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

std::vector<std::filesystem::path> library_folders(const scene::SceneDesc& scene,
                                                   const std::filesystem::path& program_folder) {
  std::vector<std::filesystem::path> folders;
  const std::filesystem::path folder = std::filesystem::path(scene.path).parent_path();
  folders.push_back(folder.empty() ? "." : folder);
  for (const char* variable : {"PLAYHOUSE_PATH", "STAGEPATH"})
    for (std::string& named : folders_of(variable)) folders.emplace_back(std::move(named));
  folders.push_back(program_folder);
  return folders;
}

void describe_for(scene::SceneDesc& scene) {
  Dynamic::describe_parts(scene);
}

Result<std::vector<std::string>> attach(world::World& world, const Libraries& libraries) {
  Batches batches(world, libraries);
  for (std::uint32_t row = 0; row < world.models.size(); ++row) {
    if (world.desc({row}).ctrl.empty()) continue;
    const std::string where = world.scene().at(world.where({row}));
    std::vector<std::string> repeated;
    for (const Post& post : posts_of(world, {row}, &repeated))
      if (const Result<void> added = batches.add(post, where); !added) return added.error();
    for (const std::string& name : repeated)
      batches.warn(where + ": " + in_quotes(world.name({row})) + " names controller " + in_quotes(name) +
                   " twice; the second is left out");
  }
  return batches.take_warnings();
}

}  // namespace playhouse::controllers
