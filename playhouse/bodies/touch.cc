#include "playhouse/bodies/touch.h"

#include <algorithm>
#include <limits>

#include "playhouse/bodies/overlap.h"

namespace playhouse::bodies {
namespace {

constexpr double kFar = std::numeric_limits<double>::max();  // m, above and below everything

struct Rows {
  std::size_t begin = 0, end = 0;
};

/// A range of solids that includes those of a model.
Rows solids_about(const Solids& solids, const Trees& trees, const world::Models& models,
                  std::uint32_t model) {
  if (models.mobility[model] == world::Mobility::kFixed) {
    const auto end = solids.model.begin() + static_cast<std::ptrdiff_t>(solids.fixed);
    const auto own = std::equal_range(solids.model.begin(), end, model);
    return {static_cast<std::size_t>(own.first - solids.model.begin()),
            static_cast<std::size_t>(own.second - solids.model.begin())};
  }
  const TreeRow tree = trees.of_root(models.root[model]);
  return {trees.first_solid[tree], trees.first_solid[tree + 1]};
}

bool solids_touch(const Solids& solids, std::size_t a, std::size_t b) {
  const Vec2 apart = solids.center[a] - solids.center[b];
  const double reach = solids.radius[a] + solids.radius[b] + kMargin;
  return geom::dot(apart, apart) <= reach * reach && touch(solids.polygon(a), solids.polygon(b));
}

}  // namespace

void touching(const Space& space, const Trees& trees, const world::Models& models, world::ModelRow model,
              std::span<const std::uint8_t> wanted, std::vector<std::uint32_t>& out) {
  const Solids& solids = space.solids;
  const std::uint32_t root = models.root[model.index];
  const auto first = static_cast<std::ptrdiff_t>(out.size());
  const auto meet = [&](std::size_t own, std::size_t other) {
    if (wanted[solids.model[other]] != 0 && solids.root[other] != root && solids_touch(solids, own, other))
      out.push_back(solids.model[other]);
  };
  const Rows rows = solids_about(solids, trees, models, model.index);
  for (std::size_t own = rows.begin; own < rows.end; ++own) {
    if (solids.model[own] != model.index) continue;
    for (std::size_t fixed = 0; fixed < solids.fixed; ++fixed) meet(own, fixed);
    space.index.near(solids.center[own], solids.radius[own] + kMargin, -kFar, kFar,
                     [&](const DiscIndex::Disc& disc) { meet(own, disc.row); });
  }
  std::sort(out.begin() + first, out.end());
  out.erase(std::unique(out.begin() + first, out.end()), out.end());
}

}  // namespace playhouse::bodies
