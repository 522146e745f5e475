/// MoteSense: the phase in which motes measure and report, and base stations hear them.
///
/// In: poses of models; their `heat`; batteries; the walls; whether and how often motes report.
/// Out: readings of each mote that reports to somebody: its own subscribers, or a base station with some that
///   has it in reach; for each such station the motes in reach, and which of them it heard in this tick.
/// Cost: for a report that of a thermometer; for a base station the motes in range that report, in its own
///   updates all of them, a logarithm each, and with a wall_factor the wall cells between them.
/// Source: radio.h; air.h. An accelerometer reads acceleration minus gravity, in the body frame (sense_imu.cc).

#include <algorithm>
#include <cmath>
#include <utility>
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
    const std::size_t count = world.motes.size();
    air_.populate(world, count);
    senders_.populate(count, 1);
    listening_.reserve(count), may_report_.reserve(count), sending_.reserve(count), measuring_.reserve(count);
    if (count == 0) return;
    for (std::vector<bodies::EdgeRow>& each : crossed_) each.reserve(rays::kUsualCrossings);
  }
  behaviour::Sharing sharing() const override {
    return behaviour::Sharing::kAll;  // it carries reports between motes
  }
  bool has_work(const world::World& world) const override {
    for (const world::MoteRow row : world.motes.rows())
      if (is_read(world, row) || remembers(world, row)) return true;
    return false;
  }
  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t tick, world::Workers& workers) override;

 private:
  static bool is_read(const world::World& world, world::MoteRow row) {
    return world.models.subscribers[world.motes.model[row]] > 0;
  }
  /// A base station that nobody reads any more.
  static bool remembers(const world::World& world, world::MoteRow row) {
    return world.motes.measured_tick[row] != 0 && mote_of(world, row).base && !is_read(world, row);
  }
  static bool may_report(const world::World& world, world::MoteRow row, std::uint64_t tick);
  void find_listening(world::World& world);
  void find_sending(const world::World& world, std::span<const world::KindRow> due, std::uint64_t tick);
  void find_measuring(const world::World& world);
  void measure(world::World& world, world::MoteRow row, std::uint64_t tick) const;
  void forget_reports(world::World& world, world::MoteRow base, std::uint64_t tick) const;
  void hear(world::World& world, const bodies::Space& space, world::MoteRow base, std::uint64_t tick,
            std::vector<bodies::EdgeRow>& crossed) const;

  Air air_;
  std::vector<world::MoteRow> listening_;              // base stations that somebody reads
  std::vector<std::uint8_t> may_report_;               // in this tick (motes)
  std::vector<world::MoteRow> sending_;                // motes to look for: those, or all if a station is due
  bodies::DiscIndex senders_;                          // these, as points
  std::vector<world::MoteRow> measuring_;              // motes whose report somebody reads
  std::vector<std::vector<bodies::EdgeRow>> crossed_;  // scratch buffers (workers)
};

std::uint64_t MoteSense::sense(world::World& world, const bodies::Space& space,
                               std::span<const world::KindRow> due, std::uint64_t tick,
                               world::Workers& workers) {
  find_listening(world);
  find_sending(world, due, tick);
  if (!listening_.empty()) {
    senders_.rebuild(
        sending_.size(),
        [&](std::size_t i) {
          const world::ModelRow model = world.motes.model[sending_[i]];
          return bodies::DiscIndex::Disc{world.models.X_WM[model].xy(), 0, 0, 0, model.index,
                                         world.models.root[model]};
        },
        workers);
    workers.run(listening_.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        forget_reports(world, listening_[i], tick);
        hear(world, space, listening_[i], tick, crossed_[workers.current()]);
      }
    });
  }
  find_measuring(world);
  if (measuring_.empty()) return 0;
  air_.begin_tick(world);
  workers.run(measuring_.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) measure(world, measuring_[i], tick);
  });
  return 0;
}

/// Base stations that nobody reads forget what they had in reach; read again, they are due at once.
void MoteSense::find_listening(world::World& world) {
  listening_.clear();
  for (const world::MoteRow row : world.motes.rows()) {
    if (remembers(world, row)) {
      world.motes.links[row].clear();
      world.motes.measured_tick[row] = 0;
    } else if (is_read(world, row) && mote_of(world, row).base) {
      listening_.push_back(row);
    }
  }
}

void MoteSense::find_sending(const world::World& world, std::span<const world::KindRow> due,
                             std::uint64_t tick) {
  const bool all =
      std::ranges::any_of(due, [&](world::KindRow row) { return mote_of(world, world::MoteRow(row)).base; });
  may_report_.assign(world.motes.size(), 0);
  sending_.clear();
  for (const world::MoteRow row : world.motes.rows()) {
    const bool may_be_heard = !listening_.empty() && !mote_of(world, row).base;
    if (!may_be_heard && !is_read(world, row)) continue;
    may_report_[row.index] = may_report(world, row, tick);
    if (may_be_heard && (all || may_report_[row.index])) sending_.push_back(row);
  }
}

/// Those that somebody reads himself, and those that a base station has in reach.
void MoteSense::find_measuring(const world::World& world) {
  measuring_.clear();
  std::vector<std::uint8_t>& unread = may_report_;  // from here on: reports that nobody has read yet
  const auto read = [&](world::MoteRow row) {
    if (std::exchange(unread[row.index], 0)) measuring_.push_back(row);
  };
  for (const world::MoteRow row : world.motes.rows())
    if (is_read(world, row)) read(row);
  for (const world::MoteRow base : listening_)
    for (const world::MoteLink& link : world.motes.links[base])
      if (const world::ModelRow model = world.row(link.station)) read(world.models.part[model]);
}

/// At once if it has been silent for that long, as after it was woken from a long sleep.
bool MoteSense::may_report(const world::World& world, world::MoteRow row, std::uint64_t tick) {
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
  const Vec3 v = velocity_at(world, world.models.root[model], place_of(X_WB.X));
  Vec3 force{0, 0, world.scene().gravity};
  if (motes.reported_tick[row] != 0) {
    const double dt = static_cast<double>(tick - motes.reported_tick[row]) * world.scene().interval;
    force = force + (1 / dt) * (v - motes.v_WB[row]);
  }
  const Quaternion q_WB = geom::orientation(X_WB.X.a, X_WB.tilt);
  motes.acceleration[row] =
      clamped(Quaternion{q_WB.w, -q_WB.x, -q_WB.y, -q_WB.z} * force, mote.acceleration_range);
  motes.temperature[row] =
      std::max(air_.temperature(world, model, {mote.ambient, mote.lapse}), kAbsoluteZero);
  motes.volts[row] = voltage(world, model, mote);
  motes.v_WB[row] = v;
  motes.reported_tick[row] = tick;
}

/// Leaves the links that hear() does not measure again: in a tick in which the station is due, none.
void MoteSense::forget_reports(world::World& world, world::MoteRow base, std::uint64_t tick) const {
  const bool is_due = world.motes.measured_tick[base] == tick;
  std::erase_if(world.motes.links[base], [&](world::MoteLink& link) {
    link.heard = 0;
    const world::ModelRow model = world.row(link.station);
    return is_due || !model || may_report_[world.models.part[model].index];
  });
}

void MoteSense::hear(world::World& world, const bodies::Space& space, world::MoteRow base, std::uint64_t tick,
                     std::vector<bodies::EdgeRow>& crossed) const {
  const world::ModelRow model = world.motes.model[base];
  const scene::MoteDesc& ear = mote_of(world, base);
  const geom::Pose& X_WM = world.models.X_WM[model];
  const bool is_due = world.motes.measured_tick[base] == tick;
  std::vector<world::MoteLink>& links = world.motes.links[base];
  senders_.near(X_WM.xy(), ear.range, 0, 0, [&](const bodies::DiscIndex::Disc& disc) {
    const world::ModelRow other = disc.model();
    const world::MoteRow sender = world.models.part[other];
    const scene::MoteDesc& mote = mote_of(world, sender);
    const bool reports = may_report_[sender.index] != 0;
    if (mote.group != ear.group || !(is_due || reports)) return;
    const geom::Pose& X_WS = world.models.X_WM[other];
    const Vec3 way = place_of(X_WS) - place_of(X_WM);
    const double distance = std::sqrt(dot(way, way));
    if (distance > ear.range) return;
    double level = mote.power - path_loss(scene::WifiDesc{}, kCarrier, distance);
    if (ear.wall_factor > 0)
      level -= ear.wall_factor * rays::walls_between(space, X_WM, X_WS, bit(bodies::SeenBy::kRadio), crossed,
                                                     world.models.root[model], disc.root);
    if (level < ear.sensitivity) return;
    Rng rng(world.seed(), tick, {Purpose::kReading, world.serial(model), world.serial(other)});
    links.push_back({world.id(other), level, reports && 100 * rng.uniform() >= ear.loss});
  });
  std::ranges::sort(links, {}, &world::MoteLink::station);
}

}  // namespace

std::unique_ptr<SensePhase> make_mote_sense(unsigned workers) {
  return std::make_unique<MoteSense>(workers);
}

}  // namespace playhouse::senses
