#include "playhouse/scene/text/token_names.h"

#include <algorithm>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::scene {
namespace {

bool is_below(std::string_view token, std::string_view name) {
  return token.size() > name.size() && token.starts_with(name) && token[name.size()] == '.';
}

}  // namespace

void TokenNames::add_top(std::uint32_t row, std::string_view type, std::string_view given, int index,
                         config::SourceLine where) {
  std::string alias = std::string(type) + ":" + std::to_string(index);
  if (given.starts_with('/') && given.size() > 1) given.remove_prefix(1);
  std::string name = given.empty() ? alias : std::string(given);
  claim(name, where);
  has_odd_ = has_odd_ || name.find('.') != std::string::npos;
  const auto instance = static_cast<std::uint32_t>(scene_.trees.size());
  tops_[name] = instance;
  scene_.trees.push_back({row, std::move(name), std::move(alias), where, {}, {}, 0});
  open_ = instance;
  names_parts_alone_ = false;
}

void TokenNames::name_part(ModelDesc& part, std::string_view given, int index) {
  const TreeDesc& tree = scene_.trees[open_];
  const auto place = static_cast<std::uint32_t>(scene_.models.size()) - tree.top;
  const std::string& parent = scene_.models[static_cast<std::size_t>(part.parent)].name;
  const std::string& top = scene_.models[tree.top].name;
  part.alias = parent + "." + part.type + ":" + std::to_string(index);
  if (given.starts_with('/') && given.size() > 1) {
    part.name = in_prototype(open_, std::string(given.substr(1)));
    names_parts_alone_ = true;
  } else {
    part.name = given.empty() ? part.alias : parent + "." + std::string(given);
  }
  const std::string name = token_in(part.name, top, tree.name);
  claim(name, part.where);
  note({open_, place}, name);
  parts_[{tree.top, part.name}] = place;
}

void TokenNames::note(TreePlace place, const std::string& name) {
  if (is_below(name, scene_.trees[place.first].name)) return;
  odd_parts_[name] = place;
  has_odd_ = true;
}

void TokenNames::share(std::uint32_t row) {
  const std::uint32_t instance = static_cast<std::uint32_t>(scene_.trees.size()) - 1;
  std::uint32_t& top = scene_.trees[instance].top;
  parts_.erase(parts_.lower_bound({top, ""}), parts_.end());  // it was the last tree
  top = row;
}

void TokenNames::claim(const std::string& name, config::SourceLine where) {
  const std::optional<TreePlace> taken = find(name);
  if (!taken) return;
  const config::SourceLine before =
      taken->second == 0 ? scene_.trees[taken->first].where : desc(*taken).where;
  state_.warnings.add(config::Warning::kName, where,
                      "the name " + in_quotes(name) + " was given at " + scene_.at(before) +
                          " already; this model has it now");
  if (taken->second == 0) {
    rename_top(taken->first);
  } else {
    rename_part(*taken);
  }
}

std::optional<TokenNames::TreePlace> TokenNames::find(std::string_view name) const {
  if (const auto top = tops_.find(name); top != tops_.end()) return TreePlace{top->second, 0};
  if (const auto odd = odd_parts_.find(name); odd != odd_parts_.end()) return odd->second;
  for (std::size_t dot = name.find('.'); dot != std::string_view::npos; dot = name.find('.', dot + 1)) {
    const auto top = tops_.find(name.substr(0, dot));
    if (top == tops_.end()) continue;
    const std::uint32_t row = scene_.trees[top->second].top;
    if (row >= scene_.models.size()) continue;  // the root of the tree under construction is not stored yet
    const auto part = parts_.find({row, scene_.models[row].name + std::string(name.substr(dot))});
    if (part == parts_.end() || scene_.renamed.contains({top->second, part->second})) continue;
    return TreePlace{top->second, part->second};
  }
  return std::nullopt;
}

std::string TokenNames::unused(const std::string& name) {
  std::string candidate = name;
  // Continues at the last suffix: restarting would be quadratic for many equal names.
  for (int& i = suffixes_.try_emplace(name, 2).first->second; find(candidate); ++i) {
    candidate = name + "~" + std::to_string(i);
  }
  return candidate;
}

const ModelDesc& TokenNames::desc(TreePlace place) const {
  return scene_.models[scene_.trees[place.first].top + place.second];
}

std::string TokenNames::name_of(TreePlace place) const {
  const TreeDesc& instance = scene_.trees[place.first];
  if (const auto own = scene_.renamed.find(place); own != scene_.renamed.end()) return own->second.name;
  return token_in(desc(place).name, scene_.models[instance.top].name, instance.name);
}

std::string TokenNames::alias_of(TreePlace place) const {
  const TreeDesc& instance = scene_.trees[place.first];
  if (const auto own = scene_.renamed.find(place); own != scene_.renamed.end()) return own->second.alias;
  return token_in(desc(place).alias, scene_.models[instance.top].name, instance.name);
}

std::string TokenNames::in_prototype(std::uint32_t instance, const std::string& token) const {
  const TreeDesc& tree = scene_.trees[instance];
  return token_in(token, tree.name, scene_.models[tree.top].name);
}

void TokenNames::set_tokens(TreePlace place, std::string name, std::string alias) {
  if (const auto odd = odd_parts_.find(name_of(place)); odd != odd_parts_.end() && odd->second == place)
    odd_parts_.erase(odd);
  const auto [instance, at] = place;
  if (instance == open_) {
    const std::uint32_t top = scene_.trees[instance].top;
    ModelDesc& part = scene_.models[top + at];
    parts_.erase({top, part.name});
    part.name = in_prototype(instance, name);
    part.alias = in_prototype(instance, alias);
    parts_[{top, part.name}] = at;
    note(place, name);
  } else {
    odd_parts_[name] = place;
    has_odd_ = true;
    scene_.renamed[place] = {std::move(name), std::move(alias)};
  }
}

void TokenNames::rename_top(std::uint32_t instance) {
  std::string& name = scene_.trees[instance].name;
  std::string fresh = unused(scene_.trees[instance].alias);
  tops_.erase(name);
  name = std::move(fresh);
  tops_[name] = instance;
  if (has_odd_) rename_clashing_parts(instance);
}

void TokenNames::rename_clashing_parts(std::uint32_t instance) {
  const std::uint32_t top = scene_.trees[instance].top;
  for (std::uint32_t at = 1;
       top + at < scene_.models.size() && desc({instance, at}).parent >= static_cast<std::int32_t>(top);
       ++at) {
    const TreePlace place{instance, at};
    const std::string name = name_of(place);
    if (const auto holder = find(name); holder && *holder != place)
      set_tokens(place, unused(name), alias_of(place));
  }
}

void TokenNames::rename_part(TreePlace place) {
  const auto [instance, first] = place;
  const std::uint32_t top = scene_.trees[instance].top;
  const std::string old = name_of(place), alias = alias_of(place), fresh = unused(alias);
  set_tokens(place, fresh, alias);
  // A subtree: consecutive rows after its root with parents among them.
  for (std::uint32_t at = first + 1; top + at < scene_.models.size() &&
                                     desc({instance, at}).parent >= static_cast<std::int32_t>(top + first);
       ++at) {
    const TreePlace inner{instance, at};
    std::string name = name_of(inner);
    if (is_below(name, old)) name = unused(token_in(name, old, fresh));
    set_tokens(inner, std::move(name), token_in(alias_of(inner), old, fresh));
  }
}

void TokenNames::check_follow_model(config::SourceLine follow_where) {
  const std::string& wanted = scene_.window.follow_model;
  if (wanted.empty() || find(wanted)) return;
  std::vector<std::string> names;
  for (std::uint32_t instance = 0; instance < scene_.trees.size(); ++instance) {
    const TreeDesc& tree = scene_.trees[instance];
    if (tree.alias == wanted) return;
    names.push_back(tree.name);
    const std::uint32_t size = tree_size(scene_, tree.top);
    for (std::uint32_t at = 1; at < size; ++at) {
      if (alias_of({instance, at}) == wanted) return;
      names.push_back(name_of({instance, at}));
    }
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  state_.warnings.add(
      config::Warning::kNoEffect, follow_where,
      "the window follows " + in_quotes(wanted) + ", which is not a model" + did_you_mean(wanted, known));
}

}  // namespace playhouse::scene
