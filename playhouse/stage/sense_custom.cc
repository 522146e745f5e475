/// CustomSense: the phase in which custom models that are subscribed and due measure, by library code.
///
/// In: what the library reads of the world, and its surroundings: ray casts, nearby models.
/// Out: customs.readings.
/// Cost: that of the library; and once per tick, if any custom model is due, an index of all models.

#include <algorithm>

#include "playhouse/behaviour/sense_custom.h"
#include "playhouse/stage/generated/senses.h"
#include "playhouse/stage/walls_between.h"

namespace playhouse::stage {
namespace {

/// Surroundings in the 2D engine, for one worker.
class PlaneSurroundings final : public world::Surroundings {
 public:
  PlaneSurroundings(const world::World& world, const Space& space, const DiscIndex& places,
                    std::vector<std::uint32_t>& crossed)
      : world_(world), space_(space), places_(places), crossed_(crossed) {}

  world::RayEnd cast(const Pose& X_WS, double range, world::ModelRow own) const override {
    const geom::Rotation heading = geom::Rotation::of(X_WS.a);
    const std::uint32_t root = own ? world_.models.root[own.index] : world::ModelRow::kNone;
    const Hit hit = stage::cast(
        space_, {X_WS.xy(), {heading.c, heading.s}, X_WS.z, X_WS.z, range, bit(Observer::kRanger), root});
    if (hit.solid == world::ModelRow::kNone) return {range, {}};
    return {hit.range, {space_.solids.model[hit.solid]}};
  }

  void near(const Pose& p_W, double radius, std::vector<world::ModelRow>& found) const override {
    found.clear();
    places_.near(p_W.xy(), radius, 0, 0, [&](const DiscIndex::Disc& disc) {
      const Pose& X_WM = world_.models.X_WM[disc.row];
      const Vec2 apart = X_WM.xy() - p_W.xy();
      const double above = X_WM.z - p_W.z;
      if (geom::dot(apart, apart) + above * above <= radius * radius) found.push_back({disc.row});
    });
    std::ranges::sort(found);
  }

  int walls_between(const Pose& from_W, const Pose& to_W) const override {
    return stage::walls_between(space_, from_W, to_W, bit(Observer::kRanger), crossed_);
  }

 private:
  const world::World& world_;
  const Space& space_;
  const DiscIndex& places_;
  std::vector<std::uint32_t>& crossed_;
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

  void populate(const world::World& world, const Space&) override {
    places_.populate(world.customs.size() > 0 ? world.models.size() : 0, 1);
  }

  std::uint64_t sense(world::World& world, const Space& space, std::span<const std::uint32_t> due,
                      std::uint64_t tick, world::Workers& workers) override {
    places_.rebuild(
        world.models.size(),
        [&](std::size_t row) {
          return DiscIndex::Disc{world.models.X_WM[row].xy(), 0, 0, 0, static_cast<std::uint32_t>(row),
                                 world.models.root[row]};
        },
        workers);
    workers.run(due.size(), 4, [&](std::size_t begin, std::size_t end) {
      Scratch& scratch = scratch_[workers.current()];
      const PlaneSurroundings around(world, space, places_, scratch.crossed);
      for (std::size_t i = begin; i < end; ++i)
        behaviour::sense_custom(world, {due[i]}, tick, around, scratch.readings);
    });
    return 0;  // rays of libraries are not counted
  }

 private:
  struct Scratch {
    std::vector<std::uint32_t> crossed;
    std::vector<double> readings;
  };

  DiscIndex places_;              // all models, as points
  std::vector<Scratch> scratch_;  // per worker
};

}  // namespace

std::unique_ptr<SensePhase> make_custom_sense(unsigned workers) {
  return std::make_unique<CustomSense>(workers);
}

}  // namespace playhouse::stage
