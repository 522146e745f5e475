#include "playhouse/world/conditions.h"

#include <algorithm>
#include <cmath>

#include "playhouse/base/assert.h"
#include "playhouse/scene/forms/colors.h"

namespace playhouse::world {
namespace {

using scene::ModelKind;
using scene::Property;
using Compare = scene::Term::Compare;

bool fits(const scene::Term& term, std::string_view text) {
  return term.prefix ? text.starts_with(term.text) : text == term.text;
}

/// Speed of a driving model; 0 for others.  [m/s]
double speed_of(const World& world, ModelRow model) {
  if (world.models.kind[model] != ModelKind::kPosition) return 0;
  const geom::Twist& v = world.positions.velocity[world.models.part[model]];
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

/// True if the model or a part of it is a lit lamp.
bool has_light(const World& world, ModelRow model) {
  if (is_lit(world, model)) return true;
  for (const ModelRow child : world.children(model))
    if (has_light(world, child)) return true;
  return false;
}

double number_of(const World& world, Property property, ModelRow model) {
  const scene::ModelDesc& desc = world.desc(model);
  switch (property) {
    case Property::kLight:
      return has_light(world, model) ? 1 : 0;
    case Property::kSpeed:
      return speed_of(world, model);
    case Property::kFiducialReturn:
      return world.models.fiducial_return[model];
    case Property::kRangerReturn:
      return desc.ranger_return;
    case Property::kGripperReturn:
      return desc.gripper_return ? 1 : 0;
    case Property::kObstacleReturn:
      return desc.obstacle_return ? 1 : 0;
    default:
      return desc.mass;
  }
}

/// The test of a term; for != and < its negation.
bool compares(const scene::Term& term, double number) {
  if (term.compare == Compare::kBelow) return number >= term.number;
  if (term.compare == Compare::kAbove) return number > term.number;
  return number == term.number;
}

}  // namespace

std::optional<bool> switch_of(const World& world, ModelRow model) {
  const KindRow part = world.models.part[model];
  if (world.models.kind[model] == ModelKind::kBlinkenlight) return world.blinkenlights.lit[part] != 0;
  if (world.models.kind[model] == ModelKind::kLightindicator) return world.lightindicators.lit[part] != 0;
  return std::nullopt;
}

bool is_lit(const World& world, ModelRow model) {
  return switch_of(world, model).value_or(world.desc(model).lamp > 0);
}

Conditions::Conditions(const World& world, std::span<const std::string> texts) {
  for (const std::string& text : texts) {
    Result<scene::Condition> condition = scene::read_condition(text);
    PLAYHOUSE_ASSERT(condition.ok());
    std::vector<ResolvedTerm>& terms = conditions_.emplace_back();
    for (scene::Term& says : *condition) {
      ResolvedTerm& term = terms.emplace_back(ResolvedTerm{std::move(says), {}});
      if (term.says.property != Property::kName) continue;
      for (const ModelRow model : world.models.rows())
        term.named.push_back(fits(term.says, world.name(model)) ? 1 : 0);
    }
  }
}

bool Conditions::hold(const World& world, ModelRow model) const {
  return std::ranges::any_of(conditions_, [&](const std::vector<ResolvedTerm>& terms) {
    return std::ranges::all_of(terms, [&](const ResolvedTerm& term) { return holds(world, term, model); });
  });
}

bool Conditions::holds(const World& world, const ResolvedTerm& term, ModelRow model) {
  bool one_has = false;
  for (; model && !one_has; model = world.models.parent[model]) one_has = has(world, term, model);
  const bool unwanted = term.says.compare == Compare::kIsNot || term.says.compare == Compare::kBelow;
  return one_has != unwanted;
}

bool Conditions::has(const World& world, const ResolvedTerm& term, ModelRow model) {
  switch (term.says.property) {
    case Property::kName:
      return term.named[model.index] != 0;
    case Property::kMaterial:
      return fits(term.says, world.desc(model).material);
    case Property::kSays:
      return fits(term.says, world.models.say[model]);
    case Property::kKind:
      return world.models.kind[model] == term.says.kind;
    case Property::kColor:
      return scene::rgba8(world.models.color[model]) >> 8 == term.says.rgb;
    default:
      return compares(term.says, number_of(world, term.says.property, model));
  }
}

}  // namespace playhouse::world
