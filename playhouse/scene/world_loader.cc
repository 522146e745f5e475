#include "playhouse/scene/world_loader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "playhouse/base/in_quotes.h"
#include "playhouse/scene/bitmap.h"
#include "playhouse/scene/body.h"
#include "playhouse/scene/expand.h"
#include "playhouse/scene/expansion.h"
#include "playhouse/scene/generated/read_kinds.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/scene/properties.h"
#include "playhouse/scene/syntax.h"
#include "playhouse/scene/token_names.h"
#include "playhouse/scene/vocabulary.h"

namespace playhouse::scene {
namespace {

std::size_t text_bytes_of(const ModelDesc& model) {
  std::size_t bytes = model.name.size() + model.alias.size() + model.say.size();
  for (const std::string& ctrl : model.ctrl) bytes += ctrl.size();
  return bytes;
}

class WorldLoader {
 public:
  WorldLoader(const Document& document, FileReader& files, const WorldLimits& limits)
      : document_(document),
        files_(files),
        limits_(limits),
        macros_(document),
        state_{document, {}, {}, {}, Warnings(document.sources)},
        bitmap_bytes_{limits.bitmap_bytes, limits.bitmap_bytes, "bytes of bitmap files"},
        pixels_{limits.pixels, limits.pixels, "pixels of bitmaps"},
        outlines_{limits.corners, limits.corners, "corners of bitmaps"},
        corners_{limits.corners, limits.corners, "corners of bodies"},
        beams_{limits.beams, limits.beams, "beams of rangers"},
        text_bytes_{limits.text_bytes, limits.text_bytes, "bytes of names and texts"} {}

  Result<SceneDesc> load();
  /// The errors after the one that load() gave.
  std::vector<Error> take_others() { return std::move(state_.others); }

 private:
  using Loops = std::vector<std::vector<geom::Vec2>>;
  /// What all models of a world share a limited amount of.
  struct Budget {
    std::size_t left, limit;
    std::string_view what;
  };

  void read_globals();
  void define(const Statement& statement);
  /// The section with its macros applied.
  std::optional<Instance> instance(const Section& section);
  void load_window(const Instance& window, const Kind& kind);
  /// A model and everything inside it. `siblings` counts the models of each type in the parent.
  void load_model(const Instance& instance, std::int32_t parent, std::map<std::string_view, int>& siblings);
  /// What the words of a model say, of its own kind and of every one.
  void read_words(const Properties& properties, const Kind& kind, ModelDesc& model);
  /// Reads the entities that are parts of a model of this kind; returns all others, the models inside it.
  std::vector<Instance> load_parts(const Instance& entity, const Kind& kind, ModelDesc& model, Shape& shape);
  void load_block(const Properties& properties, SourceLine where, Shape& shape);
  void load_sensor(const Properties& properties, SourceLine where, ModelDesc& model);
  void check_holds_nothing(const Instance& entity);
  /// The shape of a model from its bitmap and its `block` entities.
  void read_body(const Properties& properties, const Kind& kind, Shape shape, ModelDesc& model);
  const Loops* load_bitmap(const Properties& properties);
  /// `path` was tried last; the error tells of `why.where`.
  const Loops* fail_bitmap(const std::string& path, SourceLine where, const Error& why);
  /// Macros and bitmaps make much of little text: a fault when the world has no room for `amount` more.
  void spend(Budget& budget, std::size_t amount, SourceLine where);
  /// The kind of a model; null, and a fault, when it has none.
  const Kind* kind_of(const Instance& entity);
  void fail_unknown_type(const Instance& entity);

  const Document& document_;
  FileReader& files_;
  WorldLimits limits_;
  Macros macros_;
  LoadState state_;
  VocabularyCheck vocabulary_;
  SceneDesc scene_;
  TokenNames names_{scene_, state_};
  std::vector<bool> stacks_children_;  // by row of models
  std::map<std::string, Loops> bitmaps_;
  std::set<std::string_view> plain_types_;                           // warned of
  std::set<std::pair<std::uint32_t, std::uint32_t>> unknown_types_;  // files and lines told
  bool has_window_ = false;
  SourceLine follow_where_;  // of the window's follow_model
  Expansion expansion_{document_, macros_, limits_};
  Budget bitmap_bytes_, pixels_, outlines_;  // of the bitmaps themselves, however many bodies have them
  Budget corners_, beams_, text_bytes_;
};

Result<SceneDesc> WorldLoader::load() {
  scene_.files = document_.sources.file_names();
  scene_.path = scene_.files.front();
  read_globals();
  // The original's invisible ground is model:0.
  std::map<std::string_view, int> siblings{{"model", 1}};
  for (const Statement& statement : document_.statements) {
    if (state_.over) break;
    if (!statement.base.empty()) {
      define(statement);
    } else if (const Result<void> counted = expansion_.add(statement.section); !counted) {
      state_.end(counted.error());
    } else if (const auto entity = instance(statement.section)) {
      const Kind* kind = find_entity(entity->type);
      if (kind && kind->entity == EntityForm::kWindow) {
        load_window(*entity, *kind);
      } else {
        load_model(*entity, -1, siblings);
      }
    }
  }
  if (state_.error) return state_.warnings.with_slip(*state_.error);
  names_.check_follow_model(follow_where_);
  scene_.warnings = state_.warnings.take();
  return std::move(scene_);
}

void WorldLoader::read_globals() {
  const Properties properties(state_, document_.fields);
  vocabulary_.check(world_kind(), properties);
  const Result<Units> units = read_units(document_, properties.fields());
  if (!units) {
    state_.end(units.error());
    return;
  }
  state_.units = *units;
  scene_.name = scene_.path;
  read(properties, scene_);
}

void WorldLoader::define(const Statement& statement) {
  if (macros_.define(statement)) return;
  const std::string_view name = statement.section.name;
  state_.warnings.add(Warning::kMacro, statement.section.where,
                      "macro " + in_quotes(name) + " is defined at " +
                          document_.sources.at(macros_.find(name)->section.where) +
                          " already; the first definition counts");
}

std::optional<Instance> WorldLoader::instance(const Section& section) {
  Result<Instance> instance = macros_.instance(section);
  if (!instance) {
    state_.end(instance.error());
    return std::nullopt;
  }
  return std::move(*instance);
}

void WorldLoader::load_window(const Instance& window, const Kind& kind) {
  if (has_window_) {
    state_.warnings.add(Warning::kNoEffect, window.where, "a second window has no effect");
    return;
  }
  has_window_ = true;
  const Properties properties(state_, window);
  vocabulary_.check(kind, properties);
  read(properties, scene_.window);
  follow_where_ = properties.where("follow_model");
}

void WorldLoader::fail_unknown_type(const Instance& entity) {
  // Looking for the nearest word costs: once for a macro, however many instances it has.
  if (!unknown_types_.emplace(entity.where.file, entity.where.line).second) return;
  const auto later =
      std::find_if(document_.statements.begin(), document_.statements.end(),
                   [&](const Statement& s) { return !s.base.empty() && s.section.name == entity.type; });
  if (later != document_.statements.end()) {
    state_.fail(entity.where, "macro " + in_quotes(entity.type) + " is used before its definition at " +
                                  document_.sources.at(later->section.where));
  } else {
    state_.fail(entity.where,
                "unknown model type " + in_quotes(entity.type) + what_instead(entity.type, macros_.names()));
  }
}

const Kind* WorldLoader::kind_of(const Instance& entity) {
  const Kind* kind = find_entity(entity.type);
  if (!kind) {
    fail_unknown_type(entity);
  } else if (kind->entity != EntityForm::kModel) {
    state_.fail(entity.where, in_quotes(kind->name) + " belongs into " + place_of(*kind));
    return nullptr;
  } else if (!kind->simulated && plain_types_.insert(kind->name).second) {
    state_.warnings.add(Warning::kNoEffect, entity.where,
                        "model type " + in_quotes(kind->name) +
                            " is not simulated yet and loads as a plain " +
                            (kind->solid ? "body" : "model without a body"));
  }
  return kind;
}

void WorldLoader::read_words(const Properties& properties, const Kind& kind, ModelDesc& model) {
  model.size = kind.size;
  model.color = kind.color;
  model.gui_move = model.parent < 0;
  read(properties, scene_.models.size(), model);
  model.update_interval = std::max(model.update_interval, scene_.interval);
  read_kind(properties, kind.kind, model);
}

void WorldLoader::load_model(const Instance& entity, std::int32_t parent,
                             std::map<std::string_view, int>& siblings) {
  const Kind* kind = kind_of(entity);
  if (!kind) return;
  const std::size_t row = scene_.models.size();
  const Properties properties(state_, entity);
  vocabulary_.check(*kind, properties);
  ModelDesc model;
  model.where = entity.where;
  model.parent = parent;
  model.type = std::string(kind->name);
  model.kind = kind->kind;
  read_words(properties, *kind, model);
  if (parent >= 0 && stacks_children_[static_cast<std::size_t>(parent)]) {
    model.stacked = scene_.models[static_cast<std::size_t>(parent)].size.z;
    model.X_PM.z += model.stacked;
  }
  names_.name(model, properties.text("name", ""), siblings[kind->name]++);
  spend(text_bytes_, text_bytes_of(model), entity.where);

  Shape shape;
  const std::vector<Instance> children = load_parts(entity, *kind, model, shape);
  read_body(properties, *kind, std::move(shape), model);
  stacks_children_.push_back(properties.flag("stack_children", true));
  scene_.models.push_back(std::move(model));
  std::map<std::string_view, int> grandchildren;
  for (const Instance& child : children) {
    if (state_.over) return;
    load_model(child, static_cast<std::int32_t>(row), grandchildren);
  }
}

std::vector<Instance> WorldLoader::load_parts(const Instance& entity, const Kind& kind, ModelDesc& model,
                                              Shape& shape) {
  std::vector<Instance> children;
  for (const Section* section_of : entity.parts) {
    for (const Section& section : section_of->sections) {
      std::optional<Instance> child = instance(section);
      if (!child || state_.over) return {};
      const Kind* part = find_entity(child->type);
      if (!part || !is_part_of(*part, kind)) {
        children.push_back(std::move(*child));
        continue;
      }
      check_holds_nothing(*child);
      const Properties properties(state_, *child);
      vocabulary_.check(*part, properties);
      if (part->table.empty()) {  // a shape: the world keeps no state of it
        load_block(properties, child->where, shape);
      } else {
        load_sensor(properties, child->where, model);
      }
      if (state_.over) return {};
    }
  }
  return children;
}

void WorldLoader::load_block(const Properties& properties, SourceLine where, Shape& shape) {
  spend(corners_, static_cast<std::size_t>(std::max(0, properties.integer("points", 0))), where);
  if (!state_.over) shape.prisms.push_back(read_block(properties));
}

void WorldLoader::load_sensor(const Properties& properties, SourceLine where, ModelDesc& model) {
  read(properties, scene_.models.size(), model.sensors.emplace_back());
  spend(beams_, model.sensors.back().samples, where);
}

void WorldLoader::check_holds_nothing(const Instance& entity) {
  for (const Section* part : entity.parts) {
    if (part->sections.empty()) continue;
    state_.fail(part->sections.front().where, "a " + std::string(entity.type) + " holds no entities");
  }
}

void WorldLoader::read_body(const Properties& properties, const Kind& kind, Shape shape, ModelDesc& model) {
  const Loops* loops = load_bitmap(properties);
  if (state_.error) return;  // the world does not load, so nobody needs bodies
  const bool boundary = properties.flag("boundary", false);
  const bool replaced = loops || boundary || !shape.prisms.empty() || properties.flag("noblocks", false);
  const bool is_box = kind.solid && !replaced;
  if (!is_box && !loops && !boundary && shape.prisms.empty()) return;
  const std::optional<geom::Size> size = body_size(model.size, properties);
  if (!size) return;
  if (loops) {
    for (const auto& loop : *loops) spend(corners_, loop.size(), properties.where("bitmap"));
    if (state_.error) return;
    shape.contours = *loops;
  }
  fit_shape(shape, *size, state_, model);
  if (is_box) model.blocks.push_back(box_block(*size));
  if (boundary) {
    for (Block& wall : boundary_walls(*size)) model.blocks.push_back(std::move(wall));
  }
}

const WorldLoader::Loops* WorldLoader::load_bitmap(const Properties& properties) {
  const std::string name = properties.text("bitmap", "");
  if (name.empty() || state_.over) return nullptr;
  const SourceLine where = properties.where("bitmap");
  // Where the original would look only beside the world, a file beside the one that names it is meant as
  // well.
  const std::string beside_world = resolve(folder_of(scene_.path), name);
  std::string path = beside_world;
  if (const auto known = bitmaps_.find(path); known != bitmaps_.end()) return &known->second;
  Result<std::string> bytes = files_.read(path);
  if (!bytes) {
    path = resolve(folder_of(scene_.files[where.file]), name);
    if (const auto known = bitmaps_.find(path); known != bitmaps_.end()) return &known->second;
    Result<std::string> beside = files_.read(path);
    if (beside) bytes = std::move(beside);
  }
  if (!bytes) return fail_bitmap(path, where, {beside_world, bytes.error().text});
  spend(bitmap_bytes_, bytes->size(), where);
  if (state_.over) return nullptr;
  const Result<Bitmap> bitmap = decode_bitmap(*bytes, limits_.pixels);
  if (!bitmap) return fail_bitmap(path, where, {path, bitmap.error().text});
  spend(pixels_, bitmap->solid.size(), where);
  if (state_.over) return nullptr;
  Result<Loops> loops = trace_contours(*bitmap, limits_.corners);
  if (!loops) return fail_bitmap(path, where, {path, loops.error().text});
  for (const auto& loop : *loops) spend(outlines_, loop.size(), where);
  if (state_.over) return nullptr;
  if (loops->empty())
    state_.warnings.add(Warning::kShape, where,
                        "bitmap " + in_quotes(path) + " has no dark pixel, so it is no body");
  return &bitmaps_.emplace(std::move(path), std::move(*loops)).first->second;
}

const WorldLoader::Loops* WorldLoader::fail_bitmap(const std::string& path, SourceLine where,
                                                   const Error& why) {
  state_.fail(where, "bitmap " + in_quotes(why.where) + " " + why.text);
  return &bitmaps_.emplace(path, Loops{}).first->second;  // it is not read again for the next model
}

void WorldLoader::spend(Budget& budget, std::size_t amount, SourceLine where) {
  if (amount > budget.left) {
    state_.end(document_.error(
        where, "the world holds more than " + std::to_string(budget.limit) + " " + std::string(budget.what)));
    return;
  }
  budget.left -= amount;
}

}  // namespace

Result<SceneDesc> load_world_text(std::string text, const std::string& path, FileReader& files,
                                  const WorldLimits& limits, std::vector<Error>* others) {
  const Result<Document> document = parse_document(Format::kWorld, path, std::move(text), files);
  if (!document) return document.error();
  WorldLoader loader(*document, files, limits);
  Result<SceneDesc> scene = loader.load();
  if (others) *others = loader.take_others();
  return scene;
}

Result<SceneDesc> load_world(const std::string& path, NamedBy by, std::vector<Error>* others,
                             SourceFiles* sources) {
  DiskFiles disk;
  SourceFiles unused;
  SourceFiles& kept = sources ? *sources : unused;
  kept = {path, {}, disk.search_path()};
  RecordedFiles recorded(disk, kept);
  FileReader& files = sources ? static_cast<FileReader&>(recorded) : disk;
  const auto load = [&](std::string text, const std::string& found) {
    kept.path = found;
    if (sources) kept.files[found] = text;
    return load_world_text(std::move(text), found, files, {}, others);
  };
  Result<std::string> text = DiskFiles(by).read(path);
  if (text) return load(std::move(*text), path);
  const char* folders = std::getenv("STAGEPATH");
  std::string_view rest = folders ? folders : "";
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const std::string found = std::string(rest.substr(0, end)) + "/" + path.substr(folder_of(path).size());
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (Result<std::string> elsewhere = disk.read(found)) return load(std::move(*elsewhere), found);
  }
  return Error{escaped(path), text.error().text + (folders ? ", also not in STAGEPATH" : "")};
}

}  // namespace playhouse::scene
