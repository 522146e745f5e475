/// MoteSense: the phase in which motes measure and report, and base stations hear them.
///
/// In: poses of models; their `heat`; batteries; the walls; whether and how often motes report.
/// Out: readings of each mote that reports; for each subscribed base station the motes in reach, and which of
///   them it heard in this tick. Nobody measures while nobody has subscribed a mote.
/// Cost: for a report as an imu and a thermometer; for a base station the motes in range, a logarithm each, and
///   with a wall_factor the wall cells between them.
/// Source: radio.h; air.h; sense_imu.cc for the accelerometer.

#include <algorithm>
#include <cmath>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/rays/walls_between.h"
#include "playhouse/senses/air.h"
#include "playhouse/senses/body_motion.h"
#include "playhouse/senses/generated/senses.h"
#include "playhouse/senses/radio.h"
#include "playhouse/world/periods.h"
#include "playhouse/world/traits.h"

namespace playhouse::senses {
namespace {

using geom::Quaternion;
using geom::Vec3;

constexpr double kCarrier = 2450;  // MHz

const scene::MoteDesc& mote_of(const world::World& world, world::MoteRow row) {
  return *world.desc(world.motes.model[row]).mote;
}

Vec3 place_of(const geom::Pose& X) {
  return {X.x, X.y, X.z};
}

Vec3 clamped(const Vec3& v, double most) {
  return {std::clamp(v.x, -most, most), std::clamp(v.y, -most, most), std::clamp(v.z, -most, most)};
}

double voltage(const world::World& world, world::ModelRow model, const scene::MoteDesc& mote) {
  const world::PackRow pack = world::pack_of(world, model);
  const double stored = pack ? world.packs.stored[pack] : -1,
               capacity = pack ? world.packs.capacity[pack] : 0;
  const double charge = stored >= 0 && capacity > 0 ? std::clamp(stored / capacity, 0.0, 1.0) : 1;
  return mote.volts_empty + charge * (mote.volts_full - mote.volts_empty);
}

class MoteSense final : public SensePhase {
 public:
  explicit MoteSense(unsigned workers) : crossed_(workers) {}

  SensorTable table(world::World& world) const override {
    return {world.motes.model, world.motes.measured_tick};
  }
  void populate(const world::World& world, const bodies::Space&) override {
    air_.populate(world);
    places_.populate(world.motes.size(), 1);
  }
  behaviour::Sharing sharing() const override {
    return behaviour::Sharing::kAll;  // it carries reports between motes
  }
  bool has_work(const world::World& world) const override {
    return std::ranges::any_of(world.motes.model,
                               [&](world::ModelRow model) { return world.models.subscribers[model] > 0; });
  }
  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow>,
                      std::uint64_t tick, world::Workers& workers) override;

 private:
  static bool reports(const world::World& world, world::MoteRow row, std::uint64_t tick);
  void measure(world::World& world, world::MoteRow row, std::uint64_t tick) const;
  void hear(world::World& world, const bodies::Space& space, world::MoteRow base, std::uint64_t tick,
            std::vector<bodies::EdgeRow>& crossed) const;

  Air air_;
  bodies::DiscIndex places_;                           // all motes, as points
  std::vector<std::vector<bodies::EdgeRow>> crossed_;  // scratch buffers (workers)
};

std::uint64_t MoteSense::sense(world::World& world, const bodies::Space& space,
                               std::span<const world::KindRow>, std::uint64_t tick, world::Workers& workers) {
  const world::Motes& motes = world.motes;
  workers.run(motes.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (const world::MoteRow row : motes.rows().part(begin, end))
      if (reports(world, row, tick)) measure(world, row, tick);
  });
  places_.rebuild(
      motes.size(),
      [&](std::size_t i) {
        const world::ModelRow model = motes.model[motes.rows()[i]];
        return bodies::DiscIndex::Disc{world.models.X_WM[model].xy(), 0, 0, 0, model.index,
                                       world.models.root[model]};
      },
      workers);
  workers.run(motes.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (const world::MoteRow row : motes.rows().part(begin, end)) {
      world.motes.links[row].clear();
      const bool listens = mote_of(world, row).base && world.models.subscribers[motes.model[row]] > 0;
      if (listens) hear(world, space, row, tick, crossed_[workers.current()]);
    }
  });
  return 0;
}

/// At once after it has been woken.
bool MoteSense::reports(const world::World& world, world::MoteRow row, std::uint64_t tick) {
  const world::Motes& motes = world.motes;
  if (!motes.awake[row]) return false;
  const double frequency = motes.frequency[row];
  const std::uint64_t least = world::update_ticks(world, motes.model[row]);
  const std::uint64_t wanted = frequency > 0 ? world::ticks_of(1 / frequency, world.scene().interval) : least;
  return motes.reported_tick[row] == 0 || tick - motes.reported_tick[row] >= std::max(least, wanted);
}

/// The first time as if it had moved at its present velocity.
void MoteSense::measure(world::World& world, world::MoteRow row, std::uint64_t tick) const {
  world::Motes& motes = world.motes;
  const world::ModelRow model = motes.model[row];
  const scene::MoteDesc& mote = mote_of(world, row);
  const geom::SpatialPose X_WB = body_pose(world, model);
  const Vec3 p = place_of(X_WB.X);
  const bool is_first = motes.reported_tick[row] == 0;
  const double dt =
      static_cast<double>(is_first ? 1 : tick - motes.reported_tick[row]) * world.scene().interval;
  if (is_first) motes.v_WB[row] = velocity_at(world, world.models.root[model], p);
  const Vec3 v = is_first ? motes.v_WB[row] : (1 / dt) * (p - place_of(motes.X_WB[row]));
  const Quaternion q_WA = is_first ? geom::orientation(X_WB.X.a, X_WB.tilt)
                                   : geom::orientation(motes.X_WB[row].a, motes.tilt_WB[row]);
  const Vec3 force = (1 / dt) * (v - motes.v_WB[row]) + Vec3{0, 0, world.scene().gravity};
  motes.acceleration[row] =
      clamped(Quaternion{q_WA.w, -q_WA.x, -q_WA.y, -q_WA.z} * force, mote.acceleration_range);
  motes.temperature[row] =
      std::max(air_.temperature(world, model, {mote.ambient, mote.lapse}), kAbsoluteZero);
  motes.volts[row] = voltage(world, model, mote);
  motes.X_WB[row] = X_WB.X;
  motes.tilt_WB[row] = X_WB.tilt;
  motes.v_WB[row] = v;
  motes.reported_tick[row] = tick;
}

void MoteSense::hear(world::World& world, const bodies::Space& space, world::MoteRow base, std::uint64_t tick,
                     std::vector<bodies::EdgeRow>& crossed) const {
  const world::ModelRow model = world.motes.model[base];
  const scene::MoteDesc& ear = mote_of(world, base);
  const geom::Pose& X_WM = world.models.X_WM[model];
  std::vector<world::MoteLink>& links = world.motes.links[base];
  places_.near(X_WM.xy(), ear.range, 0, 0, [&](const bodies::DiscIndex::Disc& disc) {
    const world::ModelRow other = disc.model();
    const world::MoteRow sender = world.models.part[other];
    const scene::MoteDesc& mote = mote_of(world, sender);
    if (other == model || mote.base || mote.group != ear.group) return;
    const geom::Pose& X_WS = world.models.X_WM[other];
    const Vec3 way = place_of(X_WS) - place_of(X_WM);
    const double distance = std::sqrt(dot(way, way));
    if (distance > ear.range) return;
    double level = mote.power - path_loss(scene::WifiDesc{}, kCarrier, distance);
    if (ear.wall_factor > 0)
      level -= ear.wall_factor * rays::walls_between(space, X_WM, X_WS, bit(bodies::SeenBy::kRadio), crossed);
    if (level < ear.sensitivity) return;
    Rng rng(world.seed(), tick, {Purpose::kReading, world.serial(model), world.serial(other)});
    const bool is_heard = world.motes.reported_tick[sender] == tick && 100 * rng.uniform() >= ear.loss;
    links.push_back({world.id(other), level, is_heard});
  });
  std::ranges::sort(links, {}, &world::MoteLink::station);
}

}  // namespace

std::unique_ptr<SensePhase> make_mote_sense(unsigned workers) {
  return std::make_unique<MoteSense>(workers);
}

}  // namespace playhouse::senses
