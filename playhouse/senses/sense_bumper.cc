/// BumperSense: the phase that finds what presses the switches of bumpers that are subscribed and due.
///
/// In: poses and bodies of models; bpose and blength of each bumper.
/// Out: the model that presses each switch.
/// Cost: a ray along the face of each switch, and another one if that misses.
/// Source: as in Stage, the face of a switch is a segment, pressed by any body of another tree whose outline
///   crosses it, at any height; in 3D at the heights of its robot and its own. Stage's robots stop before
///   contact; here they drive up to a wall, and a straight face may be inside the wall, where no outline is.
///   So an obstacle also presses a switch if its outline is between the centre of the robot and the centre
///   of the face.

#include <algorithm>
#include <cmath>

#include "playhouse/bodies/overlap.h"
#include "playhouse/senses/generated/senses.h"

namespace playhouse::senses {
namespace {

/// Height range in which a switch is pressed.  [m, in W]
struct Heights {
  double low = -1e300, high = 1e300;
};

/// In Stage's worlds a bumper is stacked on its robot like any
/// part, but means a ring around it: the range covers both.
Heights heights_of(const world::World& world, world::ModelRow bumper, world::ModelRow root) {
  if (world.upright) return {};
  const double own = world.models.X_WM[bumper].z, robot = world.models.X_WM[root].z;
  return {std::min(own, robot), std::max(own + world.desc(bumper).size.z, robot + world.desc(root).size.z)};
}

/// The first solid on the segment from a to b, or touched by its
/// end, that is visible to `by`, or none.
bodies::SolidRow met(const bodies::Space& space, geom::Vec2 a, geom::Vec2 b, const Heights& heights,
                     bodies::SeenBy by, world::ModelRow root) {
  const geom::Vec2 way = b - a;
  const double length = std::sqrt(geom::dot(way, way));
  if (!(length > 0)) return {};
  const geom::Vec2 d = (1 / length) * way;
  return cast(space, {a - bodies::kTouch * d, d, heights.low, heights.high, length + 2 * bodies::kTouch,
                      bit(by), root})
      .solid;
}

/// The solid that presses the switch whose face is at X_WS.
bodies::SolidRow pressed_by(const bodies::Space& space, const geom::Pose& X_WS, double length,
                            const Heights& heights, geom::Vec2 middle, world::ModelRow root) {
  const geom::Vec2 left = geom::Rotation::of(X_WS.a) * geom::Vec2{0, 0.5 * length};
  const bodies::SolidRow across =
      met(space, X_WS.xy() - left, X_WS.xy() + left, heights, bodies::SeenBy::kBumper, root);
  if (across) return across;
  return met(space, middle, X_WS.xy(), heights, bodies::SeenBy::kMotion, root);
}

class BumperSense final : public SensePhase {
 public:
  SensorTable table(world::World& world) const override {
    return {world.bumpers.model, world.bumpers.measured_tick};
  }
  void populate(const world::World&, const bodies::Space&) override {}

  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t, world::Workers& workers) override {
    workers.run(due.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) feel(world, space, due[i]);
    });
    std::uint64_t rays = 0;
    for (const world::BumperRow row : due) {
      for (const world::ModelId hit : world.bumpers.hits[row]) rays += hit ? 1 : 2;
    }
    return rays;
  }

 private:
  static void feel(world::World& world, const bodies::Space& space, world::BumperRow row) {
    const world::ModelRow model = world.bumpers.model[row];
    const scene::ModelDesc& desc = world.desc(model);
    const scene::BumperDesc& bumper = *desc.bumper;
    const geom::Pose X_WB = geom::compose(world.models.X_WM[model], desc.X_MB);
    const world::ModelRow root = world.models.root[model];
    const geom::Vec2 middle = world.models.X_WM[root].xy();
    std::vector<world::ModelId>& hits = world.bumpers.hits[row];
    const Heights heights = heights_of(world, model, root);
    hits.clear();
    for (std::size_t k = 0; k < bumper.X_BS.size(); ++k) {
      const geom::Pose X_WS = geom::compose(X_WB, bumper.X_BS[k]);
      const bodies::SolidRow solid = pressed_by(space, X_WS, bumper.blength[k], heights, middle, root);
      hits.push_back(solid ? world.id(space.solids.model[solid]) : world::ModelId{});
    }
  }
};

}  // namespace

std::unique_ptr<SensePhase> make_bumper_sense(unsigned) {
  return std::make_unique<BumperSense>();
}

}  // namespace playhouse::senses
