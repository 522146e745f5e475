#include "playhouse/bodies/touch.h"

#include <algorithm>
#include <limits>

#include "playhouse/bodies/overlap.h"

namespace playhouse::bodies {
namespace {

constexpr double kFar = std::numeric_limits<double>::max();  // m, above and below everything

/// A range of solids that includes those of a model.
SolidRows solids_about(const Solids& solids, const Trees& trees, const world::Models& models,
                       world::ModelRow model) {
  if (models.mobility[model] == world::Mobility::kFixed) {
    const auto end = solids.model.begin() + static_cast<std::ptrdiff_t>(solids.fixed_rows().size());
    const auto own = std::equal_range(solids.model.begin(), end, model);
    const auto row_at = [&](auto place) {
      return solids.rows()[static_cast<std::size_t>(place - solids.model.begin())];
    };
    return {row_at(own.first), row_at(own.second)};
  }
  return trees.solids_of(trees.of_root(models.root[model]));
}

bool solids_touch(const Solids& solids, SolidRow a, SolidRow b) {
  const Vec2 apart = solids.center[a] - solids.center[b];
  const double reach = solids.radius[a] + solids.radius[b] + kMargin;
  return geom::dot(apart, apart) <= reach * reach && touch(solids.polygon(a), solids.polygon(b));
}

}  // namespace

void touching(const Space& space, const Trees& trees, const world::Models& models, world::ModelRow model,
              const world::ByModel<std::uint8_t>& wanted, std::vector<world::ModelRow>& out) {
  const Solids& solids = space.solids;
  const world::ModelRow root = models.root[model];
  const auto first = static_cast<std::ptrdiff_t>(out.size());
  const auto meet = [&](SolidRow own, SolidRow other) {
    if (wanted[solids.model[other]] != 0 && solids.root[other] != root && solids_touch(solids, own, other))
      out.push_back(solids.model[other]);
  };
  for (const SolidRow own : solids_about(solids, trees, models, model)) {
    if (solids.model[own] != model) continue;
    for (const SolidRow fixed : solids.fixed_rows()) meet(own, fixed);
    space.index.near(solids.center[own], solids.radius[own] + kMargin, -kFar, kFar,
                     [&](const DiscIndex::Disc& disc) { meet(own, disc.solid()); });
  }
  std::sort(out.begin() + first, out.end());
  out.erase(std::unique(out.begin() + first, out.end()), out.end());
}

}  // namespace playhouse::bodies
