#include "playhouse/scene/text/expansion.h"

#include <algorithm>
#include <string>

#include "playhouse/base/in_quotes.h"
#include "playhouse/scene/kinds.h"

namespace playhouse::scene {

bool Expansion::has_room(const Counts& more) const {
  const Counts sum = counts_ + more;
  return sum.models <= limits_.models && sum.sensors <= limits_.sensors && sum.fields <= limits_.fields;
}

Result<void> Expansion::check_cycle(const config::Section& section) const {
  auto each = std::ranges::find(around_, &section);
  if (each == around_.end()) return {};
  std::string others;
  while (++each != around_.end())
    others += (others.empty() ? ", by way of " : ", ") + in_quotes((*each)->name);
  return document_.error(section.where, "macro " + in_quotes(section.name) + " holds itself" + others);
}

Result<void> Expansion::add(const config::Section& section, config::SourceLine top, int depth) {
  const Result<config::ExpandedSection> instance = macros_.instance(section);
  if (!instance) return instance.error();
  const auto too_many = [&](std::size_t limit, const char* what) {
    return document_.error(top, "the world holds more than " + std::to_string(limit) + " " + what);
  };
  for (const config::Section* part : instance->parts) counts_.fields += 1 + part->fields.size();
  if (counts_.fields > limits_.fields)
    return too_many(limits_.fields, "properties, those of its macros included");
  if (const Kind* kind = find_entity(instance->type); kind && kind->entity != EntityForm::kModel) {
    if (kind->table.empty()) return {};  // shapes are limited by corners
    return ++counts_.sensors > limits_.sensors ? too_many(limits_.sensors, "sensors") : Result<void>();
  }
  if (++counts_.models > limits_.models) return too_many(limits_.models, "models");
  if (depth > limits::kEntityDepth) {
    return document_.error(section.where,
                           "models nested more than " + std::to_string(limits::kEntityDepth) + " deep");
  }
  if (const Result<void> finite = check_cycle(section); !finite) return finite;
  around_.push_back(&section);
  for (const config::Section* part : instance->parts) {
    for (const config::Section& inner : part->sections) {
      if (const Result<void> added = add(inner, top, depth + 1); !added) return added;
    }
  }
  around_.pop_back();
  return {};
}

}  // namespace playhouse::scene
