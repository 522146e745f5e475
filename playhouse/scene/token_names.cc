#include "playhouse/scene/token_names.h"

#include <algorithm>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::scene {

void TokenNames::name(ModelDesc& model, std::string_view given, int index) {
  const std::string prefix =
      model.parent < 0 ? "" : scene_.models[static_cast<std::size_t>(model.parent)].name + ".";
  model.alias = prefix + model.type + ":" + std::to_string(index);
  if (given.starts_with('/') && given.size() > 1) {
    model.name = given.substr(1);
  } else {
    model.name = given.empty() ? model.alias : prefix + std::string(given);
  }
  if (const auto taken = rows_.find(model.name); taken != rows_.end()) {
    const std::size_t earlier = taken->second;
    state_.warnings.add(Warning::kName, model.where,
                        "the name " + in_quotes(model.name) + " was given at " +
                            scene_.at(scene_.models[earlier].where) + " already; this model has it now");
    rename_subtree(earlier);
  }
  rows_[model.name] = scene_.models.size();
}

std::string TokenNames::unused(const std::string& name) {
  std::string candidate = name;
  // Goes on where the search for the same name ended last, or many of one name would take quadratic time.
  for (int& i = suffixes_.try_emplace(name, 2).first->second; rows_.contains(candidate); ++i) {
    candidate = name + "~" + std::to_string(i);
  }
  return candidate;
}

void TokenNames::rename_subtree(std::size_t row) {
  std::vector<ModelDesc>& models = scene_.models;
  const std::string old_prefix = models[row].name + ".";
  const std::string fresh = unused(models[row].alias);
  const auto rename = [this](std::size_t r, const std::string& name) {
    rows_.erase(scene_.models[r].name);
    scene_.models[r].name = name;
    rows_[name] = r;
  };
  rename(row, fresh);
  // A subtree is the run of rows after its root whose parents lie in the run.
  for (std::size_t r = row + 1; r < models.size() && models[r].parent >= static_cast<std::int32_t>(row);
       ++r) {
    if (models[r].alias.starts_with(old_prefix)) {
      models[r].alias = fresh + "." + models[r].alias.substr(old_prefix.size());
    }
    if (models[r].name.starts_with(old_prefix)) {
      rename(r, unused(fresh + "." + models[r].name.substr(old_prefix.size())));
    }
  }
}

void TokenNames::check_follow_model(SourceLine follow_where) {
  const std::string& wanted = scene_.window.follow_model;
  if (wanted.empty() || rows_.contains(wanted)) return;
  std::vector<std::string_view> names;
  for (const ModelDesc& model : scene_.models) {
    if (model.alias == wanted) return;
    names.push_back(model.name);
  }
  state_.warnings.add(
      Warning::kNoEffect, follow_where,
      "the window follows " + in_quotes(wanted) + ", which is no model" + did_you_mean(wanted, names));
}

}  // namespace playhouse::scene
