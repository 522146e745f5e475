#include "playhouse/bodies/enclosure.h"

#include <algorithm>
#include <cmath>

#include "playhouse/bodies/space.h"

namespace playhouse::bodies {
namespace {

/// Larger trees are skipped: the test is quadratic.
constexpr std::size_t kMostSolids = 256;

/// A solid in the frame C of its carrier: the nearest
/// ancestor (or itself) that is a mover, otherwise the root.
struct Carried {
  world::ModelRow carrier;
  Pose X_CM;
  Vec2 center;          // m, in C
  double z_min, z_max;  // m, in C
};

Carried carried(const Solids& solids, const world::Models& models, SolidRow row) {
  world::ModelRow model = solids.model[row];
  Pose X_CM;
  while (!world::moves(models.kind[model]) && models.parent[model]) {
    X_CM = geom::compose(models.X_PM[model], X_CM);
    model = models.parent[model];
  }
  return {model, X_CM, geom::transform(X_CM, solids.center_M[row]), X_CM.z + solids.z_min_M[row],
          X_CM.z + solids.z_max_M[row]};
}

/// True if every corner of `inner` is inside every edge of `outer` by more than kMargin.
bool is_within(const Solids& solids, SolidRow inner, const Carried& of_inner, SolidRow outer,
               const Carried& of_outer) {
  const Pose X_OI = geom::compose(geom::inverse(of_outer.X_CM), of_inner.X_CM);
  const Rotation turn = Rotation::of(X_OI.a);
  const Vec2* const o = solids.p_M.from(solids.first_vertex[outer]);
  const std::size_t edges = solids.corners_of(outer);
  for (const Vec2 corner : solids.polygon_M(inner)) {
    const Vec2 p = X_OI.xy() + turn * corner;
    for (std::size_t i = 0; i < edges; ++i) {
      const Vec2 e = o[i + 1] - o[i];
      if (geom::cross(e, p - o[i]) <= kMargin * std::sqrt(geom::dot(e, e))) return false;
    }
  }
  return true;
}

bool can_enclose(const Solids& solids, SolidRow row) {
  return solids.convex[row] != 0 && solids.full[row] != 0 && solids.corners_of(row) <= kConvexCorners;
}

/// Height of the part of `inner`, from its bottom, that is within `outer`; kAll if all of it.  [m]
double enclosed_by(const Solids& solids, SolidRow inner, const Carried& in, SolidRow outer,
                   const Carried& out) {
  const Vec2 apart = in.center - out.center;
  const double room = solids.radius[outer] - solids.radius[inner];
  if (in.carrier != out.carrier || out.z_min > in.z_min || out.z_max <= in.z_min || room <= 0 ||
      geom::dot(apart, apart) > solids.radius[outer] * solids.radius[outer] ||
      (solids.seen_by[inner] & ~solids.seen_by[outer]) != 0 || !is_within(solids, inner, in, outer, out))
    return 0;
  return out.z_max >= in.z_max ? Solids::kAll : out.z_max - in.z_min;
}

}  // namespace

void find_enclosed(Solids& solids, const world::Models& models, SolidRows rows) {
  if (rows.size() < 2 || rows.size() > kMostSolids) return;
  std::vector<Carried> all;
  for (const SolidRow row : rows) all.push_back(carried(solids, models, row));
  for (const SolidRow outer : rows) {
    if (!can_enclose(solids, outer)) continue;
    for (const SolidRow inner : rows)
      if (inner != outer)
        solids.enclosed[inner] =
            std::max(solids.enclosed[inner],
                     enclosed_by(solids, inner, all[inner - rows.front()], outer, all[outer - rows.front()]));
  }
  for (const SolidRow row : rows)
    if (solids.enclosed[row] == Solids::kAll)
      solids.seen_by[row] &= static_cast<SeenByBits>(~bit(SeenBy::kMotion));
}

}  // namespace playhouse::bodies
