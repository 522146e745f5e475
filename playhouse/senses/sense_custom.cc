/// CustomSense: the phase in which custom models that are subscribed and due measure, by library code.
///
/// In: what the library reads of the world, and its surroundings: ray casts, nearby models.
/// Out: customs.readings.
/// Cost: that of the library; and once per tick, if any custom model is due, an index of all models.

#include <algorithm>

#include "playhouse/behaviour/sense_custom.h"
#include "playhouse/rays/walls_between.h"
#include "playhouse/senses/generated/senses.h"

namespace playhouse::senses {
namespace {

/// Surroundings in the 2D engine, for one worker.
class PlaneSurroundings final : public world::Surroundings {
 public:
  PlaneSurroundings(const world::World& world, const bodies::Space& space, const bodies::DiscIndex& places,
                    std::vector<bodies::EdgeRow>& crossed)
      : world_(world), space_(space), places_(places), crossed_(crossed) {}

  world::RayEnd cast(const geom::Pose& X_WS, double range, world::ModelRow own) const override {
    const geom::Rotation heading = geom::Rotation::of(X_WS.a);
    const world::ModelRow root = own ? world_.models.root[own] : world::ModelRow{};
    const bodies::Hit hit = bodies::cast(
        space_,
        {X_WS.xy(), {heading.c, heading.s}, X_WS.z, X_WS.z, range, bit(bodies::SeenBy::kRanger), root});
    if (!hit.solid) return {range, {}};
    return {hit.range, space_.solids.model[hit.solid]};
  }

  void near(const geom::Pose& p_W, double radius, std::vector<world::ModelRow>& found) const override {
    found.clear();
    places_.near(p_W.xy(), radius, 0, 0, [&](const bodies::DiscIndex::Disc& disc) {
      const geom::Pose& X_WM = world_.models.X_WM[disc.model()];
      const geom::Vec2 apart = X_WM.xy() - p_W.xy();
      const double above = X_WM.z - p_W.z;
      if (geom::dot(apart, apart) + above * above <= radius * radius) found.push_back(disc.model());
    });
    std::ranges::sort(found);
  }

  int walls_between(const geom::Pose& from_W, const geom::Pose& to_W) const override {
    return rays::walls_between(space_, from_W, to_W, bit(bodies::SeenBy::kRanger), crossed_);
  }

 private:
  const world::World& world_;
  const bodies::Space& space_;
  const bodies::DiscIndex& places_;
  std::vector<bodies::EdgeRow>& crossed_;
};

class CustomSense final : public SensePhase {
 public:
  explicit CustomSense(unsigned workers) : scratch_(workers) {}

  behaviour::Sharing sharing() const override {
    return behaviour::Sharing::kAll;  // code of users, which may read measurements of other sensors
  }
  SensorTable table(world::World& world) const override {
    return {world.customs.model, world.customs.measured_tick};
  }

  void populate(const world::World& world, const bodies::Space&) override {
    places_.populate(world.customs.size() > 0 ? world.models.size() : 0, 1);
  }

  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t tick, world::Workers& workers) override {
    places_.rebuild(
        world.models.size(),
        [&](std::size_t i) {
          const world::ModelRow row = world.models.rows()[i];
          return bodies::DiscIndex::Disc{world.models.X_WM[row].xy(), 0, 0, 0, row.index,
                                         world.models.root[row]};
        },
        workers);
    workers.run(due.size(), 4, [&](std::size_t begin, std::size_t end) {
      Scratch& scratch = scratch_[workers.current()];
      const PlaneSurroundings around(world, space, places_, scratch.crossed);
      for (std::size_t i = begin; i < end; ++i)
        behaviour::sense_custom(world, due[i], tick, around, scratch.readings);
    });
    return 0;  // rays of libraries are not counted
  }

 private:
  struct Scratch {
    std::vector<bodies::EdgeRow> crossed;
    std::vector<double> readings;
  };

  bodies::DiscIndex places_;      // all models, as points
  std::vector<Scratch> scratch_;  // per worker
};

}  // namespace

std::unique_ptr<SensePhase> make_custom_sense(unsigned workers) {
  return std::make_unique<CustomSense>(workers);
}

}  // namespace playhouse::senses
