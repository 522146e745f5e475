/// RfidSense: the phase in which readers of radio tags that are subscribed and due read.
///
/// In: poses of models; which have a tag; range, field of view and wall_factor of each reader; the walls.
/// Out: for each due reader the tags in range, by the id of their models.
/// Cost: the tags in range, a square root each, and the wall cells on the way to those in the field of view.
/// Source: a passive tag answers as long as the reader's field feeds it, so its range is that of the way there
///   alone: free space loses 20 dB per decade of distance, and L dB of walls divide the range by 10^(L/20)
///   (Friis; Finkenzeller, "RFID Handbook", 3rd ed., 2010, 4.2).

#include <algorithm>
#include <cmath>

#include "playhouse/geom/exponential.h"
#include "playhouse/rays/walls_between.h"
#include "playhouse/senses/body_motion.h"
#include "playhouse/senses/generated/senses.h"

namespace playhouse::senses {
namespace {

using geom::Vec3;

constexpr double kNeperPerDecibel = 0.1151292546497;  // ln 10 / 20
constexpr double kMostLoss = 600;                     // in nepers, which is as good as any more

class RfidSense final : public SensePhase {
 public:
  explicit RfidSense(unsigned workers) : crossed_(workers) {}

  SensorTable table(world::World& world) const override {
    return {world.rfids.model, world.rfids.measured_tick};
  }

  void populate(const world::World& world, const bodies::Space&) override {
    tagged_.clear();
    if (world.rfids.size() == 0) return;
    for (const world::ModelRow row : world.models.rows())
      if (!world.desc(row).rfid_tag.empty()) tagged_.push_back(row);
    index_.populate(tagged_.size(), 1);
    for (std::vector<bodies::EdgeRow>& each : crossed_) each.reserve(rays::kUsualCrossings);
  }

  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t, world::Workers& workers) override {
    index_.rebuild(
        tagged_.size(),
        [&](std::size_t i) {
          const world::ModelRow row = tagged_[i];
          return bodies::DiscIndex::Disc{
              middle_of_body(world, row).X.xy(), 0, 0, 0, row.index, world.models.root[row]};
        },
        workers);
    workers.run(due.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) read(world, space, due[i], crossed_[workers.current()]);
    });
    std::uint64_t rays = 0;
    for (const world::RfidRow reader : due) rays += world.rfids.tags[reader].size();
    return rays;
  }

 private:
  void read(world::World& world, const bodies::Space& space, world::RfidRow reader,
            std::vector<bodies::EdgeRow>& crossed) const {
    const world::ModelRow model = world.rfids.model[reader];
    const scene::RfidDesc& rfid = *world.desc(model).rfid;
    const geom::SpatialPose X_WC = middle_of_body(world, model);
    const Vec3 axis = geom::orientation(X_WC.X.a, X_WC.tilt) * Vec3{1, 0, 0};
    const double edge = geom::sincos(rfid.fov / 2).cos - bodies::kMargin;
    std::vector<world::TagInRange>& tags = world.rfids.tags[reader];
    tags.clear();
    index_.near(X_WC.X.xy(), rfid.range_max, 0, 0, [&](const bodies::DiscIndex::Disc& disc) {
      const world::ModelRow target = disc.model();
      if (target == model) return;
      const geom::Pose X_WT = middle_of_body(world, target).X;
      const Vec3 way = Vec3{X_WT.x, X_WT.y, X_WT.z} - Vec3{X_WC.X.x, X_WC.X.y, X_WC.X.z};
      const double distance = std::sqrt(dot(way, way));
      if (distance > rfid.range_max || dot(axis, way) < edge * distance) return;
      const int walls = rfid.wall_factor > 0
                            ? rays::walls_between(space, X_WC.X, X_WT, bit(bodies::SeenBy::kRadio), crossed,
                                                  world.models.root[model], disc.root)
                            : 0;
      const double loss = std::min(kNeperPerDecibel * rfid.wall_factor * walls, kMostLoss);
      if (distance * geom::exp(loss) <= rfid.range_max) tags.push_back({world.id(target), distance});
    });
    std::ranges::sort(tags, {}, &world::TagInRange::target);
  }

  std::vector<world::ModelRow> tagged_;                // models with a tag, if there is a reader
  bodies::DiscIndex index_;                            // these, as points
  std::vector<std::vector<bodies::EdgeRow>> crossed_;  // scratch of each worker
};

}  // namespace

std::unique_ptr<SensePhase> make_rfid_sense(unsigned workers) {
  return std::make_unique<RfidSense>(workers);
}

}  // namespace playhouse::senses
