#pragma once

/// SensePhaseOf: one kind of sensor in an engine whose bodies are in
/// `Space`; and SensesOf, all kinds of an engine. A new kind is a new class.

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "playhouse/base/packing.h"
#include "playhouse/behaviour/due_list.h"
#include "playhouse/world/division.h"
#include "playhouse/world/saving/sensed_rows.h"
#include "playhouse/world/workers.h"

namespace playhouse::behaviour {

/// Which nodes of a cluster measure in a phase.
enum class Sharing : std::uint8_t {
  kRows,  // each some sensors: a measurement does not depend on which others are measured with it
  kHead,  // the head, and the others take its measurements
  kAll,   // each all sensors. May read measurements of this tick: those of other phases are complete
};

template <typename Space>
class SensePhaseOf {
 public:
  virtual ~SensePhaseOf() = default;

  /// The table of these sensors. Valid until the population changes.
  virtual SensorTable table(world::World& world) const = 0;

  /// Sizes and fills what depends on the population. To be called between two ticks, again after
  /// a spawn or removal or when a static solid has moved; data shared by equal sensors is kept.
  virtual void populate(const world::World& world, const Space& space) = 0;

  /// Whether it has work even in a tick without due sensors.
  virtual bool has_work(const world::World& world) const { return static_cast<void>(world), false; }

  /// Which nodes of a cluster measure. Unless it is kAll, sense() changes nothing but the measurements of
  /// `due`.
  virtual Sharing sharing() const { return Sharing::kRows; }

  /// Measures with the sensors `due`; `tick` is the number that the
  /// state will have once frozen. Returns the number of rays cast.
  virtual std::uint64_t sense(world::World& world, const Space& space, std::span<const world::KindRow> due,
                              std::uint64_t tick, world::Workers& workers) = 0;
};

template <typename Space>
class SensesOf {
 public:
  void add(std::unique_ptr<SensePhaseOf<Space>> phase) { entries_.push_back({std::move(phase), {}, {}}); }

  /// See SensePhaseOf::populate().
  void populate(world::World& world, const Space& space) {
    for (DuePhase& entry : entries_) {
      entry.due.populate(world, entry.phase->table(world).model);
      entry.phase->populate(world, space);
    }
  }

  /// The phase `sense`, shared with other nodes if there is a division. Returns the number of rays cast.
  std::uint64_t sense(world::World& world, const Space& space, std::uint64_t tick, world::Workers& workers,
                      world::Division* division = nullptr) {
    for (DuePhase& entry : entries_) entry.now = entry.due.take(world, entry.phase->table(world), tick);
    SenseWork work(*this, world, space, tick, workers);
    if (division) {
      division->run(work);
    } else {
      work.measure({});
    }
    for (const DuePhase& entry : entries_)
      if (entry.phase->sharing() == Sharing::kAll) work.measure(entry, entry.now);
    return work.rays;
  }

 private:
  struct DuePhase {
    std::unique_ptr<SensePhaseOf<Space>> phase;
    DueList due;
    std::span<const world::KindRow> now = {};  // the rows that are due in this tick

    /// The rows that are measured in a share.
    std::span<const world::KindRow> part(world::Share share) const {
      const Sharing sharing = phase->sharing();
      if (sharing == Sharing::kAll || (sharing == Sharing::kHead && share.index != 0)) return {};
      if (sharing == Sharing::kHead) return now;
      const std::size_t begin = share.begin(now.size());
      return now.subspan(begin, share.end(now.size()) - begin);
    }
  };

  /// The measurements of one tick.
  class SenseWork final : public world::DividedWork {
   public:
    SenseWork(SensesOf& senses, world::World& world, const Space& space, std::uint64_t tick,
              world::Workers& workers)
        : senses_(senses), world_(world), space_(space), tick_(tick), workers_(workers) {}

    void measure(const DuePhase& entry, std::span<const world::KindRow> due) {
      if (!due.empty() || entry.phase->has_work(world_))
        rays += entry.phase->sense(world_, space_, due, tick_, workers_);
    }
    void measure(world::Share share) {
      each(share, [&](const DuePhase& entry, std::span<const world::KindRow> due) { measure(entry, due); });
    }
    void compute(world::Share share, std::vector<std::byte>& out) override {
      const std::uint64_t before = rays;
      measure(share);
      Packer(out).varint(rays - before);
      each(share, [&](const DuePhase& entry, std::span<const world::KindRow> due) {
        world::pack_sensed(world_, kind_of(entry), due, out);
      });
    }
    bool take(world::Share share, std::span<const std::byte> results) override {
      Unpacker in(results);
      rays += in.varint();
      bool good = in.ok();
      each(share, [&](const DuePhase& entry, std::span<const world::KindRow> due) {
        good = good && world::unpack_sensed(world_, kind_of(entry), due, in);
      });
      return good && in.at_end();
    }

    std::uint64_t rays = 0;

   private:
    template <typename Visit>
    void each(world::Share share, const Visit& visit) {
      for (const DuePhase& entry : senses_.entries_)
        if (!entry.part(share).empty()) visit(entry, entry.part(share));
    }
    scene::ModelKind kind_of(const DuePhase& entry) {
      return world_.models.kind[entry.phase->table(world_).model[entry.now.front().index]];
    }

    SensesOf& senses_;
    world::World& world_;
    const Space& space_;
    std::uint64_t tick_;
    world::Workers& workers_;
  };
  std::vector<DuePhase> entries_;
};

}  // namespace playhouse::behaviour
