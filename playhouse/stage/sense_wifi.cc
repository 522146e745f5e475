/// WifiSense: the phase in which radios that are subscribed and due listen for the others of their network.
///
/// In: places of all radios, what they are, the walls.
/// Out: for each that listens the radios that it hears, and how strongly.
/// Cost: the radios near it, a logarithm each; with model "raytrace" the cells of the walls on the way too.
/// Source: radio.h.

#include <algorithm>
#include <cmath>

#include "playhouse/base/rng.h"
#include "playhouse/stage/generated/senses.h"
#include "playhouse/stage/radio.h"
#include "playhouse/stage/walls_between.h"

namespace playhouse::stage {
namespace {

const scene::WifiDesc& radio_of(const world::World& world, world::ModelRow model) {
  return *world.desc(model).wifi;
}

class WifiSense final : public SensePhase {
 public:
  explicit WifiSense(unsigned workers) : crossed_(workers) {}

  SensorTable table(world::World& world) const override {
    return {world.wifis.model, world.wifis.measured_tick};
  }

  /// How far a radio may hear follows from the strongest that there is.
  void populate(const world::World& world, const Space&) override {
    double power = -1e300, frequency = 1e300;
    for (const world::ModelRow model : world.wifis.model) {
      power = std::max(power, radio_of(world, model).power);
      frequency = std::min(frequency, radio_of(world, model).frequency);
    }
    reach_.assign(world.scene().models.size(), -1);
    for (const world::ModelRow model : world.wifis.model) {
      double& reach = reach_[world.models.desc[model.index]];
      if (reach < 0) reach = farthest_heard(radio_of(world, model), power, frequency);
    }
    stations_.populate(world.wifis.size(), 1);
  }

  std::uint64_t sense(world::World& world, const Space& space, std::span<const std::uint32_t> due,
                      std::uint64_t tick, world::Workers& workers) override {
    stations_.rebuild(
        world.wifis.size(),
        [&](std::size_t i) {
          const std::uint32_t row = world.wifis.model[i].index;
          return DiscIndex::Disc{world.models.X_WM[row].xy(), 0, 0, 0, row, world.models.root[row]};
        },
        workers);
    workers.run(due.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        listen(world, space, due[i], tick, crossed_[workers.current()]);
    });
    std::uint64_t rays = 0;
    for (const std::uint32_t row : due) rays += world.wifis.links[row].size();
    return rays;
  }

 private:
  void listen(world::World& world, const Space& space, std::uint32_t row, std::uint64_t tick,
              std::vector<std::uint32_t>& crossed) const {
    const world::ModelRow model = world.wifis.model[row];
    const scene::WifiDesc& radio = radio_of(world, model);
    const Pose& X_WM = world.models.X_WM[model.index];
    const double reach = reach_[world.models.desc[model.index]];
    std::vector<world::WifiLink>& links = world.wifis.links[row];
    links.clear();
    stations_.near(X_WM.xy(), reach, 0, 0, [&](const DiscIndex::Disc& disc) {
      const world::ModelRow other{disc.row};
      if (other.index == model.index) return;
      const scene::WifiDesc& station = radio_of(world, other);
      if (station.essid != radio.essid) return;
      const Pose& X_WS = world.models.X_WM[other.index];
      const Vec2 way = X_WS.xy() - X_WM.xy();
      const double distance = std::sqrt(geom::dot(way, way) + (X_WS.z - X_WM.z) * (X_WS.z - X_WM.z));
      if (distance > reach) return;
      double level = station.power - path_loss(radio, station.frequency, distance);
      if (radio.propagation == scene::Propagation::kRaytrace)
        level -= radio.wall_factor * walls_between(space, X_WM, X_WS, bit(Observer::kRadio), crossed);
      if (radio.fading > 0) {
        Rng rng(world.seed(), tick, {Purpose::kFading, world.id(model).value, world.id(other).value});
        level += radio.fading * rng.gaussian();
      }
      if (level >= radio.sensitivity) links.push_back({world.id(other), level, link_quality(radio, level)});
    });
    std::ranges::sort(links, {}, &world::WifiLink::station);
  }

  std::vector<double> reach_;                        // of radios [m] (rows of SceneDesc::models)
  DiscIndex stations_;                               // all radios, as points
  std::vector<std::vector<std::uint32_t>> crossed_;  // scratch memory of a worker
};

}  // namespace

std::unique_ptr<SensePhase> make_wifi_sense(unsigned workers) {
  return std::make_unique<WifiSense>(workers);
}

}  // namespace playhouse::stage
