#pragma once

/// SpringEngine: a second engine, for tests of what stands in front of engines. Everything is a disc; robots
/// drive through each other, and what is loose rolls along x as on a spring, about where it was put. Rangers
/// measure, other sensors do not.

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "playhouse/behaviour/phased_engine.h"
#include "playhouse/behaviour/sense_phase.h"

namespace playhouse::behaviour::testing {

/// Discs of all top-level models.
struct Discs {
  struct RootDisc {
    geom::Vec2 center;  // m, in W
    double radius = 0;  // m
    world::ModelRow root;
  };
  std::vector<RootDisc> all;
};

class DiscRanger final : public SensePhaseOf<Discs> {
 public:
  SensorTable table(world::World& world) const override {
    return {world.rangers.model, world.rangers.measured_tick};
  }
  void populate(const world::World&, const Discs&) override {}

  std::uint64_t sense(world::World& world, const Discs& discs, std::span<const world::KindRow> due,
                      std::uint64_t, world::Workers& workers) override {
    workers.run(due.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) measure(world, discs, due[i]);
    });
    std::uint64_t rays = 0;
    for (const world::RangerRow ranger : due)
      for (std::uint32_t k = 0; k < world.rangers.sensor_count[ranger]; ++k)
        rays += world.sensors.beam_count[world.rangers.first_sensor[ranger] + k];
    return rays;
  }

 private:
  static void measure(world::World& world, const Discs& discs, world::RangerRow ranger) {
    const world::ModelRow model = world.rangers.model[ranger];
    const scene::ModelDesc& desc = world.desc(model);
    const geom::Pose X_WB = geom::compose(world.models.X_WM[model], desc.X_MB);
    for (std::uint32_t k = 0; k < desc.sensors.size(); ++k) {
      const scene::RangerSensorDesc& sensor = desc.sensors[k];
      const geom::Pose X_WS = geom::compose(X_WB, sensor.X_BS);
      const world::BeamRow first = world.sensors.first_beam[world.rangers.first_sensor[ranger] + k];
      for (std::uint32_t beam = 0; beam < sensor.samples; ++beam) {
        const double share = sensor.samples == 1 ? 0 : beam / (sensor.samples - 1.0) - 0.5;
        world.sensors.ranges[first + beam] =
            static_cast<float>(nearest(discs, {X_WS.x, X_WS.y, 0, X_WS.a + share * sensor.fov},
                                       sensor.range_max, world.models.root[model]));
      }
    }
  }

  static double nearest(const Discs& discs, const geom::Pose& X_WR, double range, world::ModelRow own) {
    const geom::Rotation rotation = geom::Rotation::of(X_WR.a);
    for (const Discs::RootDisc& disc : discs.all) {
      if (disc.root == own) continue;
      const geom::Vec2 p_R = rotation.inverse(disc.center - X_WR.xy());
      const double half = disc.radius * disc.radius - p_R.y * p_R.y;
      if (half < 0 || p_R.x < 0) continue;
      range = std::min(range, std::max(0.0, p_R.x - std::sqrt(half)));
    }
    return range;
  }
};

class SpringEngine final : public PhasedEngine {
 public:
  static constexpr double kSwing = 0.25;  // m, to each side
  static constexpr double kPeriod = 2;    // s

  SpringEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers)
      : PhasedEngine(scene, seed, workers) {
    world_.engine = "spring";
    world_.upright = false;
    senses_.add(std::make_unique<DiscRanger>());
    populate();
  }

  std::uint64_t rays() const override { return rays_; }
  /// Of events that came to its tables.
  std::size_t ingested() const { return ingested_; }

 private:
  void ingest(std::span<const world::Event> events) override {
    ingested_ += events.size();
    populate();
  }

  void move() override {
    for (const world::ModelRow row : world_.models.rows()) {
      if (world_.models.parent[row]) continue;
      if (world_.models.mobility[row] == world::Mobility::kLoose) roll(row, swing(1) - swing(0));
      geom::Pose& X_WM = world_.models.X_PM.own(row);
      if (world_.models.kind[row] == scene::ModelKind::kPosition) drive(world_.models.part[row], X_WM);
      world::place_tree(world_, row);
    }
    place();
  }

  /// Along x of the world, without slip. [m]
  void roll(world::ModelRow ball, double way) {
    const geom::SpatialPose X = world::pose_in_parent(world_.models, ball);
    const geom::Quaternion turned = geom::orientation(0, {0, way / radius_of(ball)});
    const geom::SpatialPose rolled =
        geom::spatial_pose({X.X.x + way, X.X.y, X.X.z}, turned * geom::orientation(X.X.a, X.tilt));
    world_.models.X_PM.own(ball) = rolled.X;
    world_.models.tilt_PM.set(ball, rolled.tilt);
  }

  double radius_of(world::ModelRow top) const {
    const geom::Size& size = world_.desc(top).size;
    return 0.5 * std::max(size.x, size.y);
  }

  void drive(world::PositionRow robot, geom::Pose& X_WM) {
    const double dt = world_.scene().interval;
    const geom::Twist& v = world_.positions.velocity[robot];
    const geom::Pose X_MN{v.x * dt, v.y * dt, 0, v.a * dt};  // from this tick to the next
    X_WM = geom::compose(X_WM, X_MN);
    world_.positions.X_OM[robot] = geom::compose(world_.positions.X_OM[robot], X_MN);
  }

  /// Where the spring is so many ticks from now. [m]
  double swing(std::uint64_t ahead) const {
    const double time = static_cast<double>(world_.tick() + ahead) * world_.scene().interval;
    return kSwing * geom::sincos(geom::kTwoPi * std::fmod(time, kPeriod) / kPeriod).sin;
  }

  void sense(std::uint64_t tick) override { rays_ += senses_.sense(world_, discs_, tick, workers_); }

  void touching(world::ModelRow model, const world::ByModel<std::uint8_t>& wanted,
                std::vector<world::ModelRow>& out) const override {
    const world::ModelRow own = world_.models.root[model];
    const auto disc_of = [&](world::ModelRow root) {
      return *std::ranges::find(discs_.all, root, &Discs::RootDisc::root);
    };
    const Discs::RootDisc mine = disc_of(own);
    for (const world::ModelRow row : world_.models.rows()) {
      if (!wanted[row] || world_.models.root[row] == own) continue;
      const Discs::RootDisc other = disc_of(world_.models.root[row]);
      const geom::Vec2 between = other.center - mine.center;
      const double reach = mine.radius + other.radius;
      if (geom::dot(between, between) <= reach * reach) out.push_back(row);
    }
  }

  void populate() {
    place();
    senses_.populate(world_, discs_);
  }

  void place() {
    discs_.all.clear();
    for (const world::ModelRow row : world_.models.rows()) {
      if (world_.models.parent[row]) continue;
      discs_.all.push_back({world_.models.X_WM[row].xy(), radius_of(row), row});
    }
  }

  SensesOf<Discs> senses_;
  Discs discs_;
  std::uint64_t rays_ = 0;
  std::size_t ingested_ = 0;
};

}  // namespace playhouse::behaviour::testing
