#include "playhouse/scene/world_loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <map>
#include <set>

#include "playhouse/base/folders_of.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/config/shipped_worlds.h"
#include "playhouse/config/text/expand.h"
#include "playhouse/config/text/syntax.h"
#include "playhouse/scene/budget.h"
#include "playhouse/scene/forms/actuator.h"
#include "playhouse/scene/forms/body.h"
#include "playhouse/scene/forms/camera.h"
#include "playhouse/scene/forms/detector.h"
#include "playhouse/scene/forms/mesh_words.h"
#include "playhouse/scene/forms/shape_files.h"
#include "playhouse/scene/generated/bodies.h"
#include "playhouse/scene/generated/read_kinds.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/scene/properties.h"
#include "playhouse/scene/text/expansion.h"
#include "playhouse/scene/text/old_words.h"
#include "playhouse/scene/text/other_files.h"
#include "playhouse/scene/text/read_word.h"
#include "playhouse/scene/text/repeats.h"
#include "playhouse/scene/text/token_names.h"
#include "playhouse/scene/text/vocabulary.h"

namespace playhouse::scene {
namespace {

std::size_t text_bytes_of(const ModelDesc& model) {
  std::size_t bytes = model.name.size() + model.alias.size() + model.say.size();
  for (const std::string& ctrl : model.ctrl) bytes += ctrl.size();
  return bytes;
}

/// Number of tokens in a tree that start with the root's.
std::size_t names_below(std::span<const ModelDesc> tree) {
  std::size_t below = 0;
  for (const ModelDesc& part : tree.subspan(1))
    for (const std::string* token : {&part.name, &part.alias})
      below += token_in(*token, tree[0].name, "").size() < token->size() ? 1 : 0;
  return below;
}

class WorldLoader {
 public:
  WorldLoader(const config::Document& document, config::FileReader& files, const WorldLimits& limits)
      : document_(document),
        limits_(limits),
        macros_(document),
        state_{document, {}, {}, {}, config::Warnings(document.sources)},
        shape_files_(state_, files, limits_),
        corners_(limits.corners, "corners of bodies"),
        beams_(limits.beams, "beams of rangers, lines of detectors and pixels of cameras"),
        text_bytes_(limits.text_bytes, "bytes of names and texts") {}

  Result<SceneDesc> load();
  /// Errors after the one returned by load().
  std::vector<Error> take_others() { return std::move(state_.others); }

 private:
  using Siblings = std::map<std::string_view, int>;
  /// A tree that may be repeated by further sections, with its resource use.
  struct Repeat {
    std::uint32_t top = 0;  // row of SceneDesc::models
    const Kind* kind = nullptr;
    std::string given;  // default name, unless a section has one
    // Default per-tree values.
    geom::Pose X_WM;
    Color color;
    int fiducial_return = 0;
    bool random_color = false;
    Expansion::Counts counts;
    std::size_t corners = 0, beams = 0;
    std::size_t text_bytes = 0, names_below = 0;  // without the root's name, with which so many others start
  };

  void read_globals();
  void define(const config::Statement& statement);
  /// The section with macros expanded and old words translated;
  /// none if it is dropped, or if the load is aborted.
  std::optional<config::ExpandedSection> instance(const config::Section& section);
  void load_window(const config::ExpandedSection& window, const Kind& kind);
  /// A top-level section.
  void load_section(const config::Section& section);
  /// Describes the types of client robots: prototypes without an instance in the scene.
  void load_robot_types();
  void load_robot_type(const config::Value& word, config::SourceLine where);
  /// Repeats an equal section except for per-tree values. False,
  /// without effect, if there is none or it needs full parsing.
  bool repeat_tree(const config::Section& section);
  /// Fully parses a root and everything inside it.
  void load_tree(const config::Section& section, const config::ExpandedSection& entity);
  /// If the models from `first` on equal the previous tree made by this word,
  /// removes them and shares that tree. Returns the final row of the root.
  std::uint32_t share_tree(std::uint32_t first, std::string_view word);
  /// Parses a model with its parts. `siblings` counts models of each type in the parent.
  void load_model(const config::ExpandedSection& entity, std::int32_t parent, Siblings& siblings);
  /// Index of the model in the world, in file order.
  std::size_t number_of(std::size_t row) const { return counts_before_.models + row - first_row_; }
  /// Reads a model's words, own and common.
  void read_words(const Properties& properties, const Kind& kind, ModelDesc& model);
  /// Reads the part entities of a model of this kind; returns the others, its child models.
  std::vector<config::ExpandedSection> load_parts(const config::ExpandedSection& entity, const Kind& kind,
                                                  ModelDesc& model, UnscaledBody& shape);
  void load_part(const config::ExpandedSection& entity, const Kind& part, ModelDesc& model,
                 UnscaledBody& shape);
  void load_block(const Properties& properties, config::SourceLine where, UnscaledBody& shape);
  void load_sensor(const Properties& properties, config::SourceLine where, ModelDesc& model);
  void check_holds_nothing(const config::ExpandedSection& entity);
  /// Builds the body of a model from its bitmap and its `block` entities.
  void read_body(const Properties& properties, const Kind& kind, UnscaledBody shape, ModelDesc& model);
  /// Reads a mesh as visual and body. False if the model has none.
  bool read_mesh_body(const Properties& properties, const Kind& kind, bool has_other, ModelDesc& model);
  void read_look(const Properties& properties, const Kind& kind, ModelDesc& model);
  /// The kind of a model; null, with an error, if it is unknown.
  const Kind* kind_of(const config::ExpandedSection& entity);
  void fail_unknown_type(const config::ExpandedSection& entity);

  const config::Document& document_;
  WorldLimits limits_;
  config::Macros macros_;
  LoadState state_;
  OldWords old_words_{state_, macros_};
  VocabularyCheck vocabulary_;
  SceneDesc scene_;
  TokenNames names_{scene_, state_};
  std::deque<std::string> type_names_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> unknown_types_;  // files and lines told
  std::map<std::string, Repeat, std::less<>> repeats_;               // by repeat_key()
  std::map<std::string_view, std::uint32_t> latest_;  // row of the latest tree that a word made
  std::string key_;                                   // of the section that is read
  Siblings tops_{{"model", 1}};                       // the original's invisible ground is model:0
  // Of the current tree.
  Expansion::Counts counts_before_;
  std::size_t first_row_ = 0;
  std::size_t colors_with_top_ = 0;  // random colours so far, including the root's
  bool has_window_ = false;
  config::SourceLine follow_where_;  // of the window's follow_model
  Expansion expansion_{document_, macros_, limits_};
  ShapeFiles shape_files_;
  Budget corners_, beams_, text_bytes_;
};

Result<SceneDesc> WorldLoader::load() {
  scene_.files = document_.sources.file_names();
  scene_.path = scene_.files.front();
  read_globals();
  for (const config::Statement& statement : document_.statements) {
    if (state_.over) break;
    if (!statement.base.empty()) {
      define(statement);
    } else {
      load_section(statement.section);
    }
  }
  if (!state_.over) load_robot_types();
  if (state_.error) {
    if (std::optional<Error> slip = state_.warnings.slip()) state_.others.push_back(std::move(*slip));
    return *state_.error;
  }
  names_.check_follow_model(follow_where_);
  scene_.warnings = state_.warnings.take();
  return std::move(scene_);
}

void WorldLoader::load_section(const config::Section& section) {
  key_ = repeat_key(section);
  if (repeat_tree(section)) return;
  counts_before_ = expansion_.counts();
  if (const Result<void> counted = expansion_.add(section); !counted) return state_.end(counted.error());
  const std::optional<config::ExpandedSection> entity = instance(section);
  if (!entity) return;
  const Kind* kind = find_entity(entity->type);
  if (kind && kind->entity == EntityForm::kWindow) {
    load_window(*entity, *kind);
  } else {
    load_tree(section, *entity);
  }
}

void WorldLoader::load_robot_types() {
  const config::Field* const types = config::FieldSet(document_.fields).find("robot_types");
  if (types == nullptr) return;
  if (scene_.trees.empty())
    return state_.fail(types->where,
                       "a world with robot_types has at least one model of its own, as a floorplan");
  const std::size_t trees = scene_.trees.size();
  std::set<std::string_view> done;
  for (const config::Value& word : types->values)
    if (!state_.over && done.insert(word.text).second) load_robot_type(word, types->where);
  if (scene_.trees.size() > trees) scene_.trees.resize(trees);
  std::erase_if(scene_.renamed, [trees](const auto& each) { return each.first.first >= trees; });
}

/// Parsed as a section of this word, with a name that no model can have.
void WorldLoader::load_robot_type(const config::Value& word, config::SourceLine where) {
  const std::vector<std::string_view> known = macros_.names();
  if (macros_.find(word.text) == nullptr)
    return state_.fail(
        where, "robot_types: there is no define " + in_quotes(word.text) + did_you_mean(word.text, known));
  const std::string& name = type_names_.emplace_back(std::string(word.text) + " (type)");
  const std::size_t trees = scene_.trees.size();
  load_section({word.text, where, {{"name", {{config::ValueKind::kString, name}}, where}}, {}});
  if (scene_.trees.size() > trees) scene_.robot_types.emplace(word.text, scene_.trees.back().top);
}

bool WorldLoader::repeat_tree(const config::Section& section) {
  const auto found = repeats_.find(key_);
  if (found == repeats_.end()) return false;
  const Repeat& repeat = found->second;
  const Properties own(state_, section.fields);
  const config::Field* const name = own.fields().find("name");
  if (name && name->values.empty()) return false;
  const std::string_view given = name ? name->values.front().text : repeat.given;
  const std::size_t longest_name = given.size() + repeat.kind->name.size() + 12;
  const bool fits = expansion_.has_room(repeat.counts) && repeat.corners <= corners_.left() &&
                    repeat.beams <= beams_.left() &&
                    repeat.text_bytes + (repeat.names_below + 2) * longest_name <= text_bytes_.left();
  if (!fits || names_.may_clash(given)) return false;

  const std::size_t number = expansion_.counts().models;
  expansion_.add_again(repeat.counts);
  corners_.spend(repeat.corners);
  beams_.spend(repeat.beams);
  const geom::Pose X_WM = own.pose("pose").value_or(repeat.X_WM);
  Color color = repeat.color;
  if (repeat.random_color || own.has("color") || own.has("color_rgba"))
    color = Properties(state_, *instance(section)).color(repeat.kind->color, number);
  const int mark = own.integer("fiducial_return", repeat.fiducial_return);
  names_.add_top(repeat.top, repeat.kind->name, given, tops_[repeat.kind->name]++, section.where);
  names_.end_tree();
  TreeDesc& made = scene_.trees.back();
  made.X_WM = X_WM;
  made.color = color;
  made.fiducial_return = mark;
  text_bytes_.spend(repeat.text_bytes + made.alias.size() + (repeat.names_below + 1) * made.name.size());
  return true;
}

void WorldLoader::load_tree(const config::Section& section, const config::ExpandedSection& entity) {
  const auto first = static_cast<std::uint32_t>(scene_.models.size());
  const std::size_t trees = scene_.trees.size(), news = state_.warnings.news(), faults = state_.faults;
  const std::size_t corners = corners_.left(), beams = beams_.left(), texts = text_bytes_.left();
  first_row_ = first;
  const std::size_t colors = state_.random_colors;
  state_.warnings.watch(section.where);
  load_model(entity, -1, tops_);
  names_.end_tree();
  if (scene_.trees.size() == trees || state_.over) return;

  ModelDesc& top = scene_.models[first];
  TreeDesc& tree = scene_.trees.back();
  tree.X_WM = top.X_PM;
  tree.color = top.color;
  tree.fiducial_return = top.fiducial_return;
  top.prototype = macros_.find(section.name) ? std::string(section.name) : tree.name;

  const std::span<const ModelDesc> models = std::span(scene_.models).subspan(first);
  Repeat repeat;
  repeat.kind = find_entity(entity.type);
  repeat.given = Properties(state_, entity).text("name", "");
  repeat.X_WM = tree.X_WM;
  repeat.color = tree.color;
  repeat.fiducial_return = tree.fiducial_return;
  repeat.random_color = colors_with_top_ > colors;
  repeat.corners = corners - corners_.left();
  repeat.beams = beams - beams_.left();
  repeat.names_below = names_below(models);
  repeat.text_bytes =
      texts - text_bytes_.left() - top.alias.size() - (repeat.names_below + 1) * top.name.size();
  repeat.counts = expansion_.counts() - counts_before_;
  repeat.top = share_tree(first, section.name);
  const bool was_quiet = state_.warnings.news() == news && state_.faults == faults;
  const bool is_alone = names_.names_parts_alone() || state_.random_colors > colors_with_top_;
  if (was_quiet && !is_alone) repeats_.emplace(key_, std::move(repeat));
}

std::uint32_t WorldLoader::share_tree(std::uint32_t first, std::string_view word) {
  const auto [latest, is_first] = latest_.try_emplace(word, first);
  if (is_first) return first;
  const std::uint32_t before = latest->second;
  const std::span<const ModelDesc> models(scene_.models);
  if (names_.names_parts_alone() ||
      !is_same_tree(models.subspan(before, tree_size(scene_, before)), models.subspan(first))) {
    return latest->second = first;
  }
  names_.share(before);
  scene_.models.resize(first);
  return before;
}

void WorldLoader::read_globals() {
  const Result<config::Units> units = config::read_units(document_, config::FieldSet(document_.fields));
  if (!units) {
    state_.end(units.error());
    return;
  }
  state_.units = scene_.units = *units;
  const Properties properties(state_, old_words_.now_of_world(document_.fields));
  vocabulary_.check(world_kind(), properties);
  scene_.name = scene_.path;
  read(properties, scene_);
  require(std::fabs(scene_.latitude) <= 0.5 * geom::kPi, properties, "latitude", "needs -90 to 90 degrees");
  require(std::fabs(scene_.longitude) <= geom::kPi, properties, "longitude", "needs -180 to 180 degrees");
  scene_.kept = kept_words(world_kind(), properties);
}

void WorldLoader::define(const config::Statement& statement) {
  if (macros_.define(statement)) return repeats_.clear();  // the same words may have another meaning now
  const std::string_view name = statement.section.name;
  const std::string first = document_.sources.at(macros_.find(name)->section.where);
  if (first == document_.sources.at(statement.section.where)) return;  // a file that is included twice
  state_.warnings.add(
      config::Warning::kMacro, statement.section.where,
      "macro " + in_quotes(name) + " is defined at " + first + " already; the first definition counts");
}

std::optional<config::ExpandedSection> WorldLoader::instance(const config::Section& section) {
  Result<config::ExpandedSection> instance = macros_.instance(section);
  if (!instance) {
    state_.end(instance.error());
    return std::nullopt;
  }
  config::ExpandedSection now = old_words_.now(std::move(*instance));
  if (state_.over || now.type.empty()) return std::nullopt;
  return now;
}

void WorldLoader::load_window(const config::ExpandedSection& window, const Kind& kind) {
  if (has_window_) {
    state_.warnings.add(config::Warning::kNoEffect, window.where, "a second window has no effect");
    return;
  }
  has_window_ = true;
  const Properties properties(state_, window);
  vocabulary_.check(kind, properties);
  read(properties, scene_.window);
  scene_.kept_of_window = kept_words(kind, properties);
  follow_where_ = properties.where("follow_model");
}

void WorldLoader::fail_unknown_type(const config::ExpandedSection& entity) {
  // An unknown type of a macro is reported once, at its definition.
  const config::SourceLine where = entity.parts.front()->where;
  if (!unknown_types_.emplace(where.file, where.line).second) return;
  const auto later = std::find_if(
      document_.statements.begin(), document_.statements.end(),
      [&](const config::Statement& s) { return !s.base.empty() && s.section.name == entity.type; });
  if (later != document_.statements.end()) {
    state_.fail(entity.where, "macro " + in_quotes(entity.type) + " is used before its definition at " +
                                  document_.sources.at(later->section.where));
  } else {
    state_.fail(where,
                "unknown model type " + in_quotes(entity.type) + what_instead(entity.type, macros_.names()));
  }
}

const Kind* WorldLoader::kind_of(const config::ExpandedSection& entity) {
  const Kind* kind = find_entity(entity.type);
  if (!kind) {
    fail_unknown_type(entity);
  } else if (kind->entity != EntityForm::kModel) {
    state_.fail(entity.where, in_quotes(kind->name) + " belongs into " + place_of(*kind));
    return nullptr;
  }
  return kind;
}

void WorldLoader::read_words(const Properties& properties, const Kind& kind, ModelDesc& model) {
  static_cast<PlainDesc&>(model) = unsaid(kind, model.parent < 0);
  read(properties, number_of(scene_.models.size()), model);
  model.update_interval = std::max(model.update_interval, scene_.interval);
  read_kind(properties, kind.kind, model);
  if (model.actuator) check_actuator(properties, *model.actuator);
  if (model.fiducial && model.fiducial->range_min > model.fiducial->range_max)
    state_.warnings.add(config::Warning::kValue, properties.where("range_min"),
                        "\"range_min\" is above \"range_max\": the fiducial sees nothing");
  if (model.camera) {
    check_camera(properties, *model.camera);
    beams_.spend(kept_pixels_of(*model.camera), properties.where("resolution"), state_);
  }
  if (model.detector) {
    check_detector(properties, *model.detector);
    beams_.spend(lines_of(*model.detector), properties.where("samples"), state_);
  }
  // Worlds without heights: what a laser stands on is not higher than the walls it sees.
  model.stacks_children = properties.flag("stack_children", !properties.has_flat_size());
  model.kept = kept_words(kind, properties);
}

void WorldLoader::load_model(const config::ExpandedSection& entity, std::int32_t parent, Siblings& siblings) {
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
  if (parent < 0) colors_with_top_ = state_.random_colors;
  if (parent >= 0 && scene_.models[static_cast<std::size_t>(parent)].stacks_children) {
    model.stacked = scene_.models[static_cast<std::size_t>(parent)].size.z;
    model.X_PM.z += model.stacked;
  }
  const std::string given = properties.text("name", "");
  const int index = siblings[kind->name]++;
  if (parent >= 0) {
    names_.name_part(model, given, index);
  } else {
    names_.add_top(static_cast<std::uint32_t>(row), kind->name, given, index, entity.where);
    model.name = scene_.trees.back().name;
    model.alias = scene_.trees.back().alias;
  }
  text_bytes_.spend(text_bytes_of(model), entity.where, state_);

  UnscaledBody shape;
  const std::vector<config::ExpandedSection> children = load_parts(entity, *kind, model, shape);
  read_body(properties, *kind, std::move(shape), model);
  read_look(properties, *kind, model);
  if (row >= limits_.descriptions)
    return state_.end(document_.error(entity.where, "the world holds more than " +
                                                        std::to_string(limits_.descriptions) +
                                                        " models that are like no other"));
  scene_.models.push_back(std::move(model));
  Siblings grandchildren;
  for (const config::ExpandedSection& child : children) {
    if (state_.over) return;
    load_model(child, static_cast<std::int32_t>(row), grandchildren);
  }
}

std::vector<config::ExpandedSection> WorldLoader::load_parts(const config::ExpandedSection& entity,
                                                             const Kind& kind, ModelDesc& model,
                                                             UnscaledBody& shape) {
  std::vector<config::ExpandedSection> children;
  for (const config::Section* section_of : entity.parts) {
    for (const config::Section& section : section_of->sections) {
      std::optional<config::ExpandedSection> child = instance(section);
      if (state_.over) return {};
      if (!child) continue;
      const Kind* part = find_entity(child->type);
      if (!part || !is_part_of(*part, kind)) {
        children.push_back(std::move(*child));
        continue;
      }
      load_part(*child, *part, model, shape);
      if (state_.over) return {};
    }
  }
  if (!entity.now) return children;
  for (const config::Section& section : entity.now->sections) {  // generated words: never macros
    load_part({section.name, {&section}, section.where}, *find_entity(section.name), model, shape);
    if (state_.over) return {};
  }
  return children;
}

void WorldLoader::load_part(const config::ExpandedSection& entity, const Kind& part, ModelDesc& model,
                            UnscaledBody& shape) {
  check_holds_nothing(entity);
  const Properties properties(state_, entity);
  vocabulary_.check(part, properties);
  if (part.table.empty()) {  // a shape: without state in the world
    load_block(properties, entity.where, shape);
  } else {
    load_sensor(properties, entity.where, model);
  }
}

void WorldLoader::load_block(const Properties& properties, config::SourceLine where, UnscaledBody& shape) {
  corners_.spend(static_cast<std::size_t>(std::max(0, properties.integer("points", 0))), where, state_);
  if (!state_.over) shape.prisms.push_back(read_block(properties));
}

void WorldLoader::load_sensor(const Properties& properties, config::SourceLine where, ModelDesc& model) {
  RangerSensorDesc& sensor = model.sensors.emplace_back();
  read(properties, number_of(scene_.models.size()), sensor);
  if (sensor.samples > 1 && sensor.fov > geom::kTwoPi + 1e-9)
    state_.warnings.add(config::Warning::kValue, properties.where("fov"),
                        "\"fov\" is above 360 degrees: beams overlap");
  require(sensor.ring_lowest <= sensor.ring_highest, properties, "ring_fov",
          "needs the lowest ring before the highest");
  require(std::size_t{sensor.samples} * sensor.rings <= limits::kRangerSamples, properties, "rings",
          "needs at most " + std::to_string(limits::kRangerSamples) + " beams in all rings together");
  beams_.spend(std::size_t{sensor.samples} * sensor.rings, where, state_);
}

void WorldLoader::check_holds_nothing(const config::ExpandedSection& entity) {
  for (const config::Section* part : entity.parts) {
    if (part->sections.empty()) continue;
    state_.fail(part->sections.front().where, "a " + std::string(entity.type) + " holds no entities");
  }
}

void WorldLoader::read_body(const Properties& properties, const Kind& kind, UnscaledBody shape,
                            ModelDesc& model) {
  const bool has_other = !shape.prisms.empty() || !properties.text("bitmap", "").empty();
  if (read_mesh_body(properties, kind, has_other, model)) return;
  const ShapeFiles::TracedBitmap* bitmap = shape_files_.bitmap(properties, model.size);
  if (state_.error) return;  // the load fails anyway
  const bool boundary = properties.flag("boundary", false), noblocks = properties.flag("noblocks", false);
  model.body = {bitmap ? bitmap->first : "", "", {}, noblocks, boundary, shape.prisms, {}};
  const bool is_own = kind.solid && !bitmap && !boundary && shape.prisms.empty() && !noblocks;
  if (!is_own && !bitmap && !boundary && shape.prisms.empty()) return;
  check_body_size(model.size, properties);
  const std::optional<geom::Size> size = body_size(model.size);
  if (!size) return;
  if (bitmap) {
    for (const auto& loop : bitmap->second) corners_.spend(loop.size(), properties.where("bitmap"), state_);
    if (state_.error) return;
    shape.contours = bitmap->second;
  }
  fit_shape(shape, *size, state_, model);
  if (is_own) make_body(*size, model);
  if (boundary) {
    for (Block& wall : boundary_walls(*size)) model.blocks.push_back(std::move(wall));
  }
}

bool WorldLoader::read_mesh_body(const Properties& properties, const Kind& kind, bool has_other,
                                 ModelDesc& model) {
  const std::string name = properties.text("mesh", "");
  if (name.empty() && properties.text("look", "").empty()) warn_without_mesh(properties);
  if (name.empty() || state_.over) return false;
  const config::SourceLine where = properties.where("mesh");
  if (kind.kind == ModelKind::kGripper) {
    state_.fail(where, "a gripper has paddles and no mesh; a model inside it may have one");
    return true;
  }
  if (has_other || properties.has("noblocks") || properties.has("boundary"))
    state_.warnings.add(config::Warning::kNoEffect, where,
                        "a mesh is all of a body: blocks, bitmap, noblocks and boundary have no effect");
  const MeshBodies::LoadedMesh* entry = shape_files_.mesh(name, where);
  if (state_.over || entry == nullptr || !entry->mesh) return true;
  const mesh::Placement at = read_placement(properties);
  if (state_.error) return true;
  const bool has_size = properties.has("size");
  if (has_size) check_body_size(model.size, properties);
  const MeshBodies::MeshBody* const body =
      shape_files_.mesh_body(*entry, has_size && at.is_fitted ? &model.size : nullptr, at, where);
  if (!body) return true;
  for (const Block& block : body->blocks) corners_.spend(block.points.size(), where, state_);
  if (state_.error) return true;
  if (!has_size || !at.is_fitted) warn_of_extent(properties, entry->path, body->mesh->high - body->mesh->low);
  if (!has_size) model.size = body->size;
  model.mesh = body->mesh;
  model.blocks = body->blocks;
  model.body.mesh = entry->path;
  model.body.placement = at;
  return true;
}

/// The appearance alone, after the body: it fills the size, and is placed as a mesh is.
void WorldLoader::read_look(const Properties& properties, const Kind& kind, ModelDesc& model) {
  const std::string name = properties.text("look", "");
  if (name.empty() || state_.over || state_.error) return;
  const config::SourceLine where = properties.where("look");
  if (kind.kind == ModelKind::kGripper) {
    state_.fail(where, "a gripper has paddles and no look; a model inside it may have one");
    return;
  }
  const MeshBodies::LoadedMesh* entry = shape_files_.mesh(name, where, "look");
  if (state_.over || entry == nullptr || !entry->mesh) return;
  model.body.look = entry->path;
  if (!body_size(model.size)) {
    state_.warnings.add(config::Warning::kNoEffect, where,
                        "\"look\" has no effect on a model without a size");
    return;
  }
  const mesh::Placement at = read_placement(properties);
  if (state_.error) return;
  const MeshBodies::MeshBody* const body =
      shape_files_.mesh_body(*entry, at.is_fitted ? &model.size : nullptr, at, where);
  if (!body) return;
  model.look = body->mesh;
  model.body.placement = at;
}

}  // namespace

Result<SceneDesc> load_world_text(std::string text, const std::string& path, config::FileReader& files,
                                  const WorldLimits& limits, std::vector<Error>* others) {
  const Result<config::Document> document =
      config::parse_document(config::Format::kWorld, path, std::move(text), files);
  if (!document) return document.error();
  WorldLoader loader(*document, files, limits);
  Result<SceneDesc> scene = loader.load();
  if (others) *others = loader.take_others();
  return scene;
}

Result<SceneDesc> load_world(const std::string& path, config::NamedBy by, std::vector<Error>* others,
                             config::SourceFiles* sources) {
  config::DiskFiles disk;
  config::SourceFiles unused;
  config::SourceFiles& kept = sources ? *sources : unused;
  kept = {path, {}, disk.search_path()};
  config::RecordedFiles recorded(disk, kept);
  config::FileReader& files = sources ? static_cast<config::FileReader&>(recorded) : disk;
  const auto load = [&](std::string text, const std::string& found) -> Result<SceneDesc> {
    if (const std::optional<std::string> what = what_else(found, text)) return Error{escaped(found), *what};
    kept.path = found;
    if (sources) kept.files[found] = text;
    Result<SceneDesc> scene = load_world_text(std::move(text), found, files, {}, others);
    if (scene) scene->library_folder = config::containing_folder(found);
    return scene;
  };
  Result<std::string> text = config::DiskFiles(by).read(path);
  if (text) return load(std::move(*text), path);
  const std::vector<std::string> folders = folders_of("STAGEPATH");
  for (const std::string& folder : folders) {
    const std::string found = folder + "/" + path.substr(config::folder_of(path).size());
    if (Result<std::string> elsewhere = disk.read(found)) return load(std::move(*elsewhere), found);
  }
  return Error{escaped(path), text.error().text + (folders.empty() ? "" : ", also not in STAGEPATH") +
                                  config::did_you_mean_shipped(path)};
}

}  // namespace playhouse::scene
