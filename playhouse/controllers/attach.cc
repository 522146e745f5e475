#include "playhouse/controllers/attach.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/controllers/expand.h"
#include "playhouse/controllers/fasr.h"
#include "playhouse/controllers/loaded.h"
#include "playhouse/controllers/source_sink.h"
#include "playhouse/controllers/wander.h"

namespace playhouse::controllers {
namespace {

constexpr std::array<std::string_view, 6> kBuiltIns{"wander",         "fasr",   "expand_swarm",
                                                    "expand_pioneer", "source", "sink"};

/// Come with Stage, and world files name them, but this program has no equivalent yet.
constexpr std::array<std::string_view, 7> kStageDemos{
    "fasr2", "fasr_plan", "rasterize", "dynamic", "pioneer_flocking", "wander_accel", "lasernoise"};

bool is_stage_demo(std::string_view name) {
  return std::find(kStageDemos.begin(), kStageDemos.end(), name) != kStageDemos.end();
}

std::unique_ptr<Batch> make_built_in(std::string_view name) {
  if (name == "wander") return std::make_unique<Wander>();
  if (name == "fasr") return std::make_unique<Fasr>();
  if (name == "expand_swarm") return std::make_unique<Expand>("expand_swarm", kExpandSwarm);
  if (name == "expand_pioneer") return std::make_unique<Expand>("expand_pioneer", kExpandPioneer);
  if (name == "source") return std::make_unique<Source>();
  if (name == "sink") return std::make_unique<Sink>();
  return nullptr;
}

Error unknown(const std::string& where, const std::string& name,
              const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> words(kBuiltIns.begin(), kBuiltIns.end());
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

void add_folders(const char* variable, std::vector<std::filesystem::path>& folders) {
  const char* value = std::getenv(variable);
  if (!value) return;
  std::istringstream stream{std::string(value)};
  for (std::string folder; std::getline(stream, folder, ':');) {
    if (!folder.empty()) folders.emplace_back(folder);
  }
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
  void warn_of_demo(const std::string& name, const std::string& where);
  std::vector<std::string> take_warnings() { return std::move(warnings_); }

 private:
  /// The batch of that name; null, with a warning, for a demonstration of Stage and where nothing is loaded.
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
  } else if (!made && is_stage_demo(name)) {
    warn_of_demo(name, where);
  } else if (!made) {
    return unknown(where, name, libraries_.folders);
  }
  Batch* const batch = made.get();
  by_name_.emplace(name, batch);
  if (made) world_.deciders.push_back(std::move(made));
  return batch;
}

void Batches::warn_of_demo(const std::string& name, const std::string& where) {
  warn(where + ": Stage's demonstration " + in_quotes(name) +
       " is not part of this program; its robots stay without a controller");
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
  if (library) return std::unique_ptr<Batch>(std::make_unique<Loaded>(name, std::move(*library)));
  // STAGEPATH leads to Stage's own builds of its demonstrations: no reason to refuse the world.
  if (!is_stage_demo(name))
    return Error{where, "controller " + in_quotes(name) + ": " + library.error().line()};
  warn_of_demo(name, where);
  return std::unique_ptr<Batch>();
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
  add_folders("PLAYHOUSE_PATH", folders);
  add_folders("STAGEPATH", folders);
  folders.push_back(program_folder);
  return folders;
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
