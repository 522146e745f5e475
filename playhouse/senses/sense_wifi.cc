/// WifiSense: the phase that delivers messages to radios that are
/// subscribed, and measures links of radios that are subscribed and due.
///
/// In: places and descriptions of all radios, the walls, outgoing messages.
/// Out: for each due radio its links and their levels; for each subscribed radio the messages that reach it.
///   The outgoing lists are empty afterwards.
/// Cost: the radios in range, a logarithm each; with model "raytrace" also the wall cells between them;
///   for messages the same, among the radios that send.
///
/// Source: radio.h.

#include <algorithm>
#include <cmath>

#include "playhouse/base/rng.h"
#include "playhouse/rays/walls_between.h"
#include "playhouse/senses/generated/senses.h"
#include "playhouse/senses/radio.h"
#include "playhouse/world/radio_messages.h"

namespace playhouse::senses {
namespace {

const scene::WifiDesc& radio_of(const world::World& world, world::ModelRow model) {
  return *world.desc(model).wifi;
}

class WifiSense final : public SensePhase {
 public:
  explicit WifiSense(unsigned workers) : scratch_(workers) {}

  SensorTable table(world::World& world) const override {
    return {world.wifis.model, world.wifis.measured_tick};
  }

  /// The receive range follows from the strongest sender in the world.
  void populate(const world::World& world, const bodies::Space&) override {
    double power = -1e300, frequency = 1e300;
    for (const world::ModelRow model : world.wifis.model) {
      power = std::max(power, radio_of(world, model).power);
      frequency = std::min(frequency, radio_of(world, model).frequency);
    }
    reach_.assign(world.scene().models.size(), -1);
    for (const world::ModelRow model : world.wifis.model) {
      double& reach = reach_[world.models.desc[model]];
      if (reach < 0) reach = farthest_heard(radio_of(world, model), power, frequency);
    }
    stations_.populate(world.wifis.size(), 1);
    senders_.populate(world.wifis.size(), 1);
    sending_.reserve(world.wifis.size());
    for (Scratch& scratch : scratch_) {  // also of workers that get their first range in a late tick
      scratch.links.reserve(world.wifis.size());
      scratch.crossed.reserve(rays::kUsualCrossings);
    }
  }

  behaviour::Sharing sharing() const override {
    return behaviour::Sharing::kAll;  // it carries messages between radios
  }
  bool has_work(const world::World& world) const override {
    const auto has_any = [](const auto& messages) { return !messages.empty(); };
    return std::ranges::any_of(world.wifis.outgoing, has_any) ||
           std::ranges::any_of(world.wifis.incoming, has_any);
  }

  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t tick, world::Workers& workers) override {
    if (has_work(world)) carry(world, space, tick, workers);
    if (due.empty()) return 0;
    const std::size_t count = world.wifis.size();
    stations_.rebuild(
        count, [&](std::size_t i) { return place_of(world, world.wifis.model[world.wifis.rows()[i]]); },
        workers);
    workers.run(due.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        hear(world, space, due[i], stations_, tick, world.wifis.links[due[i]],
             scratch_[workers.current()].crossed);
    });
    std::uint64_t rays = 0;
    for (const world::WifiRow row : due) rays += world.wifis.links[row].size();
    return rays;
  }

 private:
  /// Scratch buffers of a worker.
  struct Scratch {
    std::vector<bodies::EdgeRow> crossed;
    std::vector<world::WifiLink> links;
  };

  static bodies::DiscIndex::Disc place_of(const world::World& world, world::ModelRow model) {
    return {world.models.X_WM[model].xy(), 0, 0, 0, model.index, world.models.root[model]};
  }

  /// Delivers all outgoing messages.
  void carry(world::World& world, const bodies::Space& space, std::uint64_t tick, world::Workers& workers) {
    world::Wifis& wifis = world.wifis;
    sending_.clear();
    for (const world::WifiRow row : wifis.rows())
      if (!wifis.outgoing[row].empty()) sending_.push_back(row);
    senders_.rebuild(
        sending_.size(), [&](std::size_t i) { return place_of(world, wifis.model[sending_[i]]); }, workers);
    workers.run(wifis.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (const world::WifiRow row : wifis.rows().part(begin, end))
        receive(world, space, row, tick, scratch_[workers.current()]);
    });
    for (const world::WifiRow row : sending_) {
      wifis.outgoing[row].clear();
      wifis.outgoing_bytes[row].clear();
    }
  }

  void receive(world::World& world, const bodies::Space& space, world::WifiRow row, std::uint64_t tick,
               Scratch& scratch) const {
    world::Wifis& wifis = world.wifis;
    wifis.incoming[row].clear();
    wifis.incoming_bytes[row].clear();
    const world::ModelRow model = wifis.model[row];
    if (sending_.empty() || world.models.subscribers[model] == 0) return;
    hear(world, space, row, senders_, tick, scratch.links, scratch.crossed);
    for (const world::WifiLink& link : scratch.links) {
      const world::WifiRow sender = world.models.part[world.row(link.station)];
      std::uint32_t number = 0;
      world::each_message(world::outgoing_of(wifis, sender), [&](const auto& message, auto bytes) {
        const Stream lost{Purpose::kMessageLoss, world.serial(model), world.serial(link.station), number++};
        const bool is_for_it = !message.station || message.station == world.id(model);
        if (is_for_it && !is_lost(radio_of(world, model), Rng(world.seed(), tick, lost)))
          world::receive_message(wifis, row, link.station, bytes);
      });
    }
  }

  static bool is_lost(const scene::WifiDesc& radio, Rng rng) { return 100 * rng.uniform() < radio.loss; }

  /// Replaces `links` by the radios of `stations` in range, sorted by id.
  void hear(const world::World& world, const bodies::Space& space, world::WifiRow row,
            const bodies::DiscIndex& stations, std::uint64_t tick, std::vector<world::WifiLink>& links,
            std::vector<bodies::EdgeRow>& crossed) const {
    const world::ModelRow model = world.wifis.model[row];
    const scene::WifiDesc& radio = radio_of(world, model);
    const geom::Pose& X_WM = world.models.X_WM[model];
    const double reach = reach_[world.models.desc[model]];
    links.clear();
    stations.near(X_WM.xy(), reach, 0, 0, [&](const bodies::DiscIndex::Disc& disc) {
      const world::ModelRow other = disc.model();
      if (other == model) return;
      const scene::WifiDesc& station = radio_of(world, other);
      if (station.essid != radio.essid) return;
      const geom::Pose& X_WS = world.models.X_WM[other];
      const geom::Vec2 way = X_WS.xy() - X_WM.xy();
      const double distance = std::sqrt(geom::dot(way, way) + (X_WS.z - X_WM.z) * (X_WS.z - X_WM.z));
      if (distance > reach) return;
      double level = station.power - path_loss(radio, station.frequency, distance);
      if (radio.propagation == scene::Propagation::kRaytrace)
        level -=
            radio.wall_factor * rays::walls_between(space, X_WM, X_WS, bit(bodies::SeenBy::kRadio), crossed);
      if (radio.fading > 0) {
        Rng rng(world.seed(), tick, {Purpose::kFading, world.serial(model), world.serial(other)});
        level += radio.fading * rng.gaussian();
      }
      if (level >= radio.sensitivity) links.push_back({world.id(other), level, link_quality(radio, level)});
    });
    std::ranges::sort(links, {}, &world::WifiLink::station);
  }

  std::vector<double> reach_;            // of radios [m] (rows of SceneDesc::models)
  bodies::DiscIndex stations_;           // all radios, as points
  std::vector<world::WifiRow> sending_;  // radios with outgoing messages
  bodies::DiscIndex senders_;            // these, as points
  std::vector<Scratch> scratch_;
};

}  // namespace

std::unique_ptr<SensePhase> make_wifi_sense(unsigned workers) {
  return std::make_unique<WifiSense>(workers);
}

}  // namespace playhouse::senses
