#include "playhouse/scene/write_world.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"
#include "playhouse/config/text/expand.h"
#include "playhouse/config/text/file_search.h"
#include "playhouse/config/text/source_text.h"
#include "playhouse/scene/forms/body.h"
#include "playhouse/scene/forms/mesh_words.h"
#include "playhouse/scene/generated/bodies.h"
#include "playhouse/scene/generated/read_kinds.h"
#include "playhouse/scene/generated/write_kinds.h"
#include "playhouse/scene/kinds.h"

namespace playhouse::scene {
namespace {

constexpr std::size_t kLineBytes = 160;

void append(std::string& text, const Entity& entity, const std::string& indent = {}) {
  std::string line = indent + entity.type + " (";
  for (const std::string& word : entity.words) line += " " + word;
  if (entity.parts.empty() && line.size() <= kLineBytes) {
    text += line + " )\n";
    return;
  }
  text += indent + entity.type + " (\n";
  for (const std::string& word : entity.words) text += indent + "  " + word + "\n";
  for (const Entity& part : entity.parts) append(text, part, indent + "  ");
  text += indent + ")\n";
}

/// Nesting depth of an entity.
int depth_of(const Entity& entity) {
  int depth = 0;
  for (const Entity& part : entity.parts) depth = std::max(depth, depth_of(part));
  return depth + 1;
}

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

void keep_common(std::vector<std::string>& words, const std::vector<std::string>& others) {
  std::erase_if(words, [&](const std::string& word) { return !has(others, word); });
}

void drop_common(std::vector<std::string>& words, const std::vector<std::string>& common) {
  std::erase_if(words, [&](const std::string& word) { return has(common, word); });
}

/// Keeps the common words, and the common prefix of entities.
void keep_common(Entity& entity, const Entity& other) {
  keep_common(entity.words, other.words);
  entity.parts.erase(std::ranges::mismatch(entity.parts, other.parts).in1, entity.parts.end());
}

/// Removes from an instance what its macro states.
void drop_common(Entity& entity, const Entity& common) {
  drop_common(entity.words, common.words);
  const auto first = entity.parts.begin();
  entity.parts.erase(first, first + static_cast<std::ptrdiff_t>(common.parts.size()));
}

/// True for a part with an absolute name: no other tree has a part of that name.
bool has_full_name(const Entity& entity) {
  return std::ranges::any_of(entity.words,
                             [](const std::string& word) { return word.starts_with("name \"/"); }) ||
         std::ranges::any_of(entity.parts, has_full_name);
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// A valid macro name that shadows nothing needed.
std::string macro_word(std::string_view label) {
  std::string word;
  for (const char c : label) {
    const bool good = is_letter(c) || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_';
    word += good ? c : '_';
  }
  const bool reserved = word == "define" || word == "include" || find_kind(word) != nullptr;
  return !word.empty() && is_letter(word.front()) && !reserved ? word : "a_" + word;
}

/// The `name` that produces this token below `parent`
/// ("" at the top); none if it is the default anyway.
std::string name_for(const std::string& token, const std::string& parent, const std::string& otherwise) {
  const auto has_slash = [](const std::string& name) { return name.starts_with('/') && name.size() > 1; };
  if (token == otherwise) return {};
  if (parent.empty()) return has_slash(token) ? "/" + token : token;
  const std::string below = token.starts_with(parent + ".") ? token.substr(parent.size() + 1) : "";
  return below.empty() || has_slash(below) ? "/" + token : below;
}

class WorldWriter {
 public:
  WorldWriter(const SceneDesc& scene, const std::string& path)
      : scene_(scene),
        path_(path),
        made_(scene.trees.empty() ? one_of_each(scene) : std::vector<TreeDesc>()),
        trees_(scene.trees.empty() ? made_ : scene.trees) {}

  Result<std::string> write();

 private:
  /// Trees of one type and label, candidates for a macro.
  struct Group {
    std::string label;
    std::vector<std::uint32_t> trees;
    /// By row of the root, without per-tree values;
    /// after define() without what the macro states.
    std::map<std::uint32_t, Entity> prototypes;
    std::string macro;  // empty: none
    Entity common;      // content of the macro
  };
  using Siblings = std::map<std::string_view, int>;

  void write_globals();
  void write_window();
  void find_groups();
  /// True if a macro makes the file shorter, or was in the original file.
  bool wants_macro(const Group& group) const;
  void define(Group& group);
  void write_tree(std::uint32_t tree);

  /// The root in this row with its parts, without per-tree values.
  Entity entity_of(std::uint32_t row, std::uint32_t tree);
  void add_parts(std::uint32_t row, std::uint32_t tree, Entity& to) const;
  /// Words of a model's kind and body, beyond those of PlainDesc.
  void add_kind_and_body(const ModelDesc& model, Entity& to) const;
  void add_body(const ModelDesc& model, Entity& to) const;
  void add_block(const Prism& prism, Entity& to) const;
  std::vector<std::string> pose_of(const TreeDesc& tree) const;
  /// Per-tree values other than name and pose.
  std::vector<std::string> looks_of(const TreeDesc& tree) const;

  const Kind& kind_of(const ModelDesc& model) const;
  PlainDesc unsaid_of(const ModelDesc& model) const;
  /// The default body of a model.
  std::vector<Block> unsaid_blocks(const ModelDesc& model) const;
  bool has_names_alone(std::uint32_t tree) const;
  std::string token_of(std::uint32_t row, std::uint32_t tree) const;
  /// The default token of another child of its type.
  std::string unsaid_token(const Kind& kind, const std::string& parent, Siblings& siblings) const;
  std::string file_name(const std::string& path) const;

  const SceneDesc& scene_;
  const std::string path_;
  const std::vector<TreeDesc> made_;
  const std::vector<TreeDesc>& trees_;
  std::map<std::pair<std::string, std::string_view>, Group> groups_;  // by label and type
  std::vector<const Group*> group_of_;                                // by tree; null: no group
  std::set<std::string> macros_;
  Siblings tops_{{"model", 1}};  // the original's invisible ground is model:0
  int depth_ = 0;                // maximum nesting depth
  std::string text_;
};

Result<std::string> WorldWriter::write() {
  write_globals();
  write_window();
  find_groups();
  for (std::uint32_t tree = 0; tree < trees_.size() && text_.size() <= limits::kFileBytes; ++tree)
    write_tree(tree);
  if (depth_ > limits::kEntityDepth)
    return Error{{}, "models are nested more than " + std::to_string(limits::kEntityDepth) + " deep"};
  if (text_.size() > limits::kFileBytes)
    return Error{{}, "the world is too large for a file of " + std::to_string(limits::kFileBytes) + " bytes"};
  return std::move(text_);
}

void WorldWriter::write_globals() {
  std::vector<std::string> all;
  Words words(scene_.units, all);
  if (scene_.units.length != config::Units().length)
    words.text("unit_length", config::length_word(scene_.units));
  if (scene_.units.angle != config::Units().angle) words.text("unit_angle", config::angle_word(scene_.units));
  WorldDesc unsaid;
  unsaid.name = scene_.path;
  scene::write(scene_, unsaid, words);
  for (const KeptWord& word : scene_.kept) words.kept(word);
  for (const std::string& word : all) text_ += word + "\n";
  if (!all.empty()) text_ += "\n";
}

void WorldWriter::write_window() {
  Entity window{"window", {}, {}};
  Words words(scene_.units, window.words);
  scene::write(scene_.window, {}, words);
  for (const KeptWord& word : scene_.kept_of_window) words.kept(word);
  if (window.words.empty()) return;
  append(text_, window);
  text_ += "\n";
}

void WorldWriter::find_groups() {
  std::vector<Group*> groups;  // by first tree
  group_of_.resize(trees_.size());
  for (std::uint32_t tree = 0; tree < trees_.size(); ++tree) {
    if (has_names_alone(tree)) continue;
    const std::uint32_t top = trees_[tree].top;
    const ModelDesc& model = scene_.models[top];
    const auto [found, is_first] = groups_.try_emplace({model.prototype, kind_of(model).name});
    Group& group = found->second;
    if (is_first) groups.push_back(&group);
    group.label = model.prototype;
    group.trees.push_back(tree);
    if (!group.prototypes.contains(top)) group.prototypes[top] = entity_of(top, tree);
    group_of_[tree] = &group;
  }
  for (Group* group : groups)
    if (wants_macro(*group)) define(*group);
}

bool WorldWriter::wants_macro(const Group& group) const {
  bool was_macro = false, has_parts = false;
  for (const auto& [top, entity] : group.prototypes) {
    was_macro = was_macro || scene_.models[top].name != group.label;
    has_parts = has_parts || !entity.parts.empty();
  }
  return was_macro || (has_parts && group.trees.size() > 1);
}

void WorldWriter::define(Group& group) {
  group.common = group.prototypes.begin()->second;
  for (const auto& [top, entity] : group.prototypes) keep_common(group.common, entity);
  group.common.parts.erase(std::ranges::find_if(group.common.parts, has_full_name), group.common.parts.end());
  std::vector<std::string> looks = looks_of(trees_[group.trees.front()]);
  for (std::size_t i = 1; i < group.trees.size() && !looks.empty(); ++i)
    keep_common(looks, looks_of(trees_[group.trees[i]]));
  for (auto& [top, entity] : group.prototypes) drop_common(entity, group.common);
  group.common.words.insert(group.common.words.begin(), looks.begin(), looks.end());

  const std::string word = macro_word(group.label);
  group.macro = word;
  for (int i = 2; !macros_.insert(group.macro).second; ++i) group.macro = word + "_" + std::to_string(i);
  Entity definition = group.common;
  definition.type = "define " + group.macro + " " + group.common.type;
  append(text_, definition);
  text_ += "\n";
}

void WorldWriter::write_tree(std::uint32_t tree) {
  const TreeDesc& desc = trees_[tree];
  const Group* group = group_of_[tree];
  Entity entity = group ? group->prototypes.at(desc.top) : entity_of(desc.top, tree);
  std::vector<std::string> own;
  const std::string otherwise = unsaid_token(kind_of(scene_.models[desc.top]), {}, tops_);
  if (const std::string name = name_for(desc.name, {}, otherwise); !name.empty())
    Words(scene_.units, own).text("name", name);
  std::ranges::move(pose_of(desc), std::back_inserter(own));
  std::ranges::move(looks_of(desc), std::back_inserter(own));
  if (group && !group->macro.empty()) {
    drop_common(own, group->common.words);
    entity.type = group->macro;
  }
  entity.words.insert(entity.words.begin(), own.begin(), own.end());
  append(text_, entity);
}

Entity WorldWriter::entity_of(std::uint32_t row, std::uint32_t tree) {
  const ModelDesc& model = scene_.models[row];
  const PlainDesc unsaid = unsaid_of(model);
  PlainDesc says = model;
  says.X_PM = unsaid.X_PM;
  says.color = unsaid.color;
  says.fiducial_return = unsaid.fiducial_return;
  Entity entity{std::string(kind_of(model).name), {}, {}};
  Words words(scene_.units, entity.words);
  scene::write(says, unsaid, 0, words);
  add_kind_and_body(model, entity);
  add_parts(row, tree, entity);
  depth_ = std::max(depth_, depth_of(entity));
  return entity;
}

void WorldWriter::add_parts(std::uint32_t row, std::uint32_t tree, Entity& to) const {
  const std::string parent = token_of(row, tree);
  Siblings siblings;
  const auto self = static_cast<std::int32_t>(row);
  // A subtree: consecutive rows after its root with parents among them.
  for (std::uint32_t child = row + 1; child < scene_.models.size() && scene_.models[child].parent >= self;
       ++child) {
    const ModelDesc& model = scene_.models[child];
    if (model.parent != self) continue;
    const Kind& kind = kind_of(model);
    Entity& part = to.parts.emplace_back(Entity{std::string(kind.name), {}, {}});
    Words words(scene_.units, part.words);
    const std::string otherwise = unsaid_token(kind, parent, siblings);
    if (const std::string name = name_for(token_of(child, tree), parent, otherwise); !name.empty())
      words.text("name", name);
    PlainDesc unsaid = unsaid_of(model);
    unsaid.X_PM.z = model.stacked;
    scene::write(model, unsaid, model.stacked, words);
    add_kind_and_body(model, part);
    add_parts(child, tree, part);
  }
}

void WorldWriter::add_kind_and_body(const ModelDesc& model, Entity& to) const {
  write_kind(model, scene_.units, to);
  add_body(model, to);
  Words words(scene_.units, to.words);
  if (!model.stacks_children) words.flag("stack_children", false);
  for (const KeptWord& word : model.kept) words.kept(word);
}

void WorldWriter::add_body(const ModelDesc& model, Entity& to) const {
  Words words(scene_.units, to.words);
  const BodyDesc& body = model.body;
  if (!body.bitmap.empty()) words.text("bitmap", file_name(body.bitmap));
  if (!body.mesh.empty()) words.text("mesh", file_name(body.mesh));
  if (!body.look.empty()) words.text("look", file_name(body.look));
  write_placement(body.placement, words);
  if (body.noblocks) words.flag("noblocks", true);
  if (body.boundary) words.flag("boundary", true);
  for (const Prism& prism : body.prisms) add_block(prism, to);
  if (body != BodyDesc()) return;

  if (model.blocks == unsaid_blocks(model)) return;
  if (model.blocks.empty()) words.flag("noblocks", true);
  for (const Block& block : model.blocks)
    add_block({block.points, Interval{block.z_min, block.z_max}, {}}, to);
}

void WorldWriter::add_block(const Prism& prism, Entity& to) const {
  Entity& block = to.parts.emplace_back(Entity{"block", {}, {}});
  Words words(scene_.units, block.words);
  words.integer("points", static_cast<std::int64_t>(prism.points.size()));
  for (std::size_t i = 0; i < prism.points.size(); ++i)
    words.tuple("point[" + std::to_string(i) + "]", "LL", std::array{prism.points[i].x, prism.points[i].y});
  if (prism.z) words.tuple("z", "LL", std::array{prism.z->min, prism.z->max});
}

std::vector<std::string> WorldWriter::pose_of(const TreeDesc& tree) const {
  const PlainDesc unsaid = unsaid_of(scene_.models[tree.top]);
  PlainDesc says = unsaid;
  says.X_PM = tree.X_WM;
  std::vector<std::string> all;
  Words words(scene_.units, all);
  scene::write(says, unsaid, 0, words);
  return all;
}

std::vector<std::string> WorldWriter::looks_of(const TreeDesc& tree) const {
  const PlainDesc unsaid = unsaid_of(scene_.models[tree.top]);
  PlainDesc says = unsaid;
  says.color = tree.color;
  says.fiducial_return = tree.fiducial_return;
  std::vector<std::string> all;
  Words words(scene_.units, all);
  scene::write(says, unsaid, 0, words);
  return all;
}

const Kind& WorldWriter::kind_of(const ModelDesc& model) const {
  if (const Kind* kind = find_model_type(model.type)) return *kind;
  return *std::ranges::find_if(kinds(), [&](const Kind& kind) {  // made in code
    return kind.simulated && kind.entity == EntityForm::kModel && kind.kind == model.kind;
  });
}

PlainDesc WorldWriter::unsaid_of(const ModelDesc& model) const {
  PlainDesc desc = unsaid(kind_of(model), model.parent < 0);
  desc.update_interval = std::max(desc.update_interval, scene_.interval);
  return desc;
}

std::vector<Block> WorldWriter::unsaid_blocks(const ModelDesc& model) const {
  const std::optional<geom::Size> size = kind_of(model).solid ? body_size(model.size) : std::nullopt;
  if (!size || !is_described(model.kind, model)) return {};
  ModelDesc unsaid;
  unsaid.kind = model.kind;
  static_cast<KindDescs&>(unsaid) = model;
  make_body(*size, unsaid);
  return unsaid.blocks;
}

bool WorldWriter::has_names_alone(std::uint32_t tree) const {
  const auto first = scene_.renamed.lower_bound({tree, 0});
  return first != scene_.renamed.end() && first->first.first == tree;
}

std::string WorldWriter::token_of(std::uint32_t row, std::uint32_t tree) const {
  const TreeDesc& desc = trees_[tree];
  if (row == desc.top) return desc.name;
  const auto renamed = scene_.renamed.find({tree, row - desc.top});
  if (renamed != scene_.renamed.end()) return renamed->second.name;
  return token_in(scene_.models[row].name, scene_.models[desc.top].name, desc.name);
}

std::string WorldWriter::unsaid_token(const Kind& kind, const std::string& parent, Siblings& siblings) const {
  const std::string own = std::string(kind.name) + ":" + std::to_string(siblings[kind.name]++);
  return parent.empty() ? own : parent + "." + own;
}

std::string WorldWriter::file_name(const std::string& path) const {
  if (!path_.empty())
    if (const auto below = config::path_from(path_, path); !below.empty() && *below.begin() != "..")
      return below.string();
  return config::physical_path(path).string();
}

}  // namespace

Result<std::string> write_world(const SceneDesc& scene, const std::string& path) {
  return WorldWriter(scene, path).write();
}

}  // namespace playhouse::scene
