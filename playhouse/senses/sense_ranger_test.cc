#include "playhouse/senses/sense_ranger.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "playhouse/simd/testing_instruction_sets.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::senses {
namespace {

using stage::testing::box;
using stage::testing::ranger;
using stage::testing::robot;
using stage::testing::sensor;

std::unique_ptr<world::Engine> run(const scene::SceneDesc& scene, int ticks = 1, unsigned workers = 1) {
  auto made = stage::make_engine(scene, {.seed = 7, .workers = workers});
  PLAYHOUSE_ASSERT(made.ok());
  for (int i = 0; i < ticks; ++i) (*made)->step();
  return std::move(*made);
}

// The oracle: every edge of every body, from the scene and the poses alone, no index and no shape tables.
struct Seen {
  double range, intensity;
};

Seen look(const world::World& world, world::ModelRow own_root, geom::Vec2 p, double z, double bearing,
          double range_max) {
  const geom::SinCos sc = geom::sincos(bearing);
  const geom::Vec2 d{sc.cos, sc.sin};
  Seen seen{range_max, 0};
  const auto edge = [&](geom::Vec2 a, geom::Vec2 b, double intensity) {
    const geom::Vec2 e = b - a, w = a - p;
    const double denominator = geom::cross(d, e);
    if (denominator == 0) return;
    const double t = geom::cross(w, e) / denominator, s = geom::cross(w, d) / denominator;
    if (s >= 0 && s <= 1 && t >= 0 && t < seen.range) seen = {t, intensity};
  };
  for (const world::ModelRow row : world.models.rows()) {
    const scene::ModelDesc& desc = world.desc(row);
    if (world.models.root[row] == own_root || desc.ranger_return < 0) continue;
    const geom::Pose X_WB = geom::compose(world.models.X_WM[row], desc.X_MB);
    const auto loop = [&](const std::vector<geom::Vec2>& points, double z_min, double z_max) {
      if (z < X_WB.z + z_min || z > X_WB.z + z_max) return;
      for (std::size_t i = 0; i < points.size(); ++i)
        edge(geom::transform(X_WB, points[i]), geom::transform(X_WB, points[(i + 1) % points.size()]),
             desc.ranger_return);
    };
    for (const scene::Block& block : desc.blocks) loop(block.points, block.z_min, block.z_max);
    for (const scene::Contours& bitmap : desc.bitmaps)
      for (const std::vector<geom::Vec2>& points : bitmap.loops) loop(points, bitmap.z_min, bitmap.z_max);
  }
  return seen;
}

/// Compares all beams of all rangers with the oracle; a beam that grazes a corner may see either side of it,
/// so a difference counts only if beams turned by a hair to both sides agree on what the engine did not say.
void expect_like_oracle(const world::World& world) {
  for (const world::RangerRow row : world.rangers.rows()) {
    const world::ModelRow model = world.rangers.model[row];
    const scene::ModelDesc& desc = world.desc(model);
    const world::ModelRow root = world.models.root[model];
    for (std::uint32_t i = 0; i < desc.sensors.size(); ++i) {
      const scene::RangerSensorDesc& s = desc.sensors[i];
      const geom::Pose X_WS = geom::compose(geom::compose(world.models.X_WM[model], desc.X_MB), s.X_BS);
      const world::BeamRow first = world.sensors.first_beam[world.rangers.first_sensor[row] + i];
      for (std::uint32_t k = 0; k < s.samples; ++k) {
        const double bearing = X_WS.a + (s.samples > 1 ? -s.fov / 2 + s.fov * k / (s.samples - 1) : 0.0);
        const double got = static_cast<double>(world.sensors.ranges[first + k]);
        const double intensity = static_cast<double>(world.sensors.intensities[first + k]);
        const auto agrees = [&](double turn) {
          const Seen seen = look(world, root, X_WS.xy(), X_WS.z + s.size.z / 2, bearing + turn, s.range_max);
          // Whether something at the very end of the range is hit at all is a matter of rounding.
          const bool at_the_end = std::fabs(seen.range - s.range_max) < 1e-5;
          return std::fabs(got - seen.range) < 1e-5 &&
                 (at_the_end || std::fabs(intensity - seen.intensity) < 1e-6);
        };
        RC_ASSERT(agrees(0) || agrees(1e-9) || agrees(-1e-9));
      }
    }
  }
}

double in(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1 << 20) / (1 << 20);
}

geom::Pose any_pose(double extent) {
  return {in(-extent, extent), in(-extent, extent), 0, in(-3.1, 3.1)};
}

/// A star-shaped polygon, convex or not.
scene::ModelDesc any_body(const std::string& name) {
  scene::ModelDesc model = box(name, any_pose(6), {1, 1, 1});
  const int corners = *rc::gen::inRange(3, 12);
  const double z = in(0, 0.5), size = in(0.05, 1.5);
  model.blocks = {{{}, z, z + in(0, 1)}};
  for (int i = 0; i < corners; ++i) {
    const geom::SinCos sc = geom::sincos((i + in(0, 0.9)) * geom::kTwoPi / corners);
    const double r = in(0.2, 1.0) * size;
    model.blocks[0].points.push_back({r * sc.cos, r * sc.sin});
  }
  model.ranger_return = *rc::gen::element(-1.0, 0.0, 0.5, 2.0);
  if (*rc::gen::inRange(0, 3) == 0) {  // some of them as robots that stand
    model.kind = scene::ModelKind::kPosition;
    model.position.emplace();
  }
  return model;
}

scene::SceneDesc any_scene() {
  scene::SceneDesc scene;
  const int bodies = *rc::gen::inRange(0, 40);
  for (int i = 0; i < bodies; ++i) {
    scene.models.push_back(any_body("b" + std::to_string(i)));
    // Small cases are full of equal numbers; sensors in line with edges to the last bit see either side of
    // them.
    scene.models.back().X_PM.x += 0.0061803 * (i + 1);
    scene.models.back().X_PM.y += 0.0041421 * (i + 1);
  }
  if (*rc::gen::inRange(0, 2)) stage::testing::add_arena(scene, in(2, 20));
  for (int i = 0; i < 4; ++i) {
    const int parent = static_cast<int>(scene.models.size());
    const bool stands = *rc::gen::inRange(0, 4) == 0;  // its own edges are among the walls
    const std::string name = "r" + std::to_string(i);
    const geom::Pose X_WM = any_pose(6);
    const geom::Size size{0.4, 0.3, 0.6};
    scene.models.push_back(stands ? box(name, X_WM, size) : robot(name, X_WM, size));
    scene.models.back().X_MB = {0.1, 0.05, 0, 0.2};
    scene.models.push_back(
        ranger("s" + std::to_string(i), parent, {in(-0.2, 0.2), 0, in(0, 0.9), in(-3, 3)}));
    const int sensors = *rc::gen::inRange(1, 20);
    for (int k = 0; k < sensors; ++k) {
      const auto samples = static_cast<std::uint32_t>(*rc::gen::element(1, 1, 1, 2, 8, 90, 361));
      scene.models.back().sensors.push_back(
          sensor({in(-0.3, 0.3), in(-0.3, 0.3), 0, in(-3, 3)}, in(0.1, 12), in(0, 7), samples));
    }
  }
  return scene;
}

RC_GTEST_PROP(RangerSense, every_beam_is_the_exact_distance_to_the_nearest_edge, ()) {
  const scene::SceneDesc scene = any_scene();
  simd::testing::with_every_instruction_set([&] { expect_like_oracle(run(scene)->world()); });
}

TEST(RangerSense, a_crowd_in_motion_is_seen_as_the_oracle_sees_it) {
  for (const stage::testing::Sensing sensing :
       {stage::testing::Sensing::kSonar, stage::testing::Sensing::kLaser}) {
    const scene::SceneDesc scene = stage::testing::crowd(60, sensing);
    simd::testing::with_every_instruction_set([&] { expect_like_oracle(run(scene, 20)->world()); });
  }
}

TEST(RangerSense, beams_run_from_right_to_left_and_report_what_they_hit) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.1, 0.1, 0.1}));
  scene.models.push_back(ranger("r.ranger:0", 0, {}));
  scene.models[1].sensors = {sensor({0, 0, 0.05, 0}, 5, geom::kPi, 3)};
  scene.models.push_back(box("right", {0, -2, 0, 0}, {0.5, 1, 1}));
  scene.models.back().ranger_return = 3;
  const auto engine = run(scene);
  const std::vector<float>& ranges = engine->world().sensors.ranges;
  EXPECT_NEAR(ranges[0], 1.5, 1e-6);
  EXPECT_EQ(engine->world().sensors.intensities[{0}], 3.0f);
  EXPECT_EQ(ranges[1], 5.0f);
  EXPECT_EQ(ranges[2], 5.0f);
  EXPECT_EQ(engine->world().sensors.intensities[{2}], 0.0f);
  EXPECT_EQ(engine->rays(), 3u);
}

TEST(RangerSense, scanners_of_one_ranger_do_not_write_into_each_others_beams) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.1, 0.1, 0.1}));
  scene.models.push_back(ranger("r.ranger:0", 0, {}));
  scene.models[1].sensors = {sensor({0, 0, 0.05, 0}, 5, 1.0, 9), sensor({0, 0, 0.05, geom::kPi}, 5, 1.0, 9)};
  stage::testing::add_arena(scene, 8);
  scene.models.push_back(robot("q", {1, 0.1, 0, 0.3}, {0.5, 0.5, 0.5}));
  for (const double side : {1.0, -1.0}) {
    scene.models.back().X_PM.y = 0.4 * side;
    simd::testing::with_every_instruction_set([&] { expect_like_oracle(run(scene)->world()); });
  }
}

TEST(RangerSense, a_range_below_the_minimum_is_reported_as_the_minimum) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.1, 0.1, 0.1}));
  scene.models.push_back(ranger("r.ranger:0", 0, {}));
  scene.models[1].sensors = {sensor({0, 0, 0.05, 0}, 5, 0.1, 1)};
  scene.models[1].sensors[0].range_min = 0.4;
  scene.models.push_back(box("near", {0.5, 0, 0, 0}, {0.5, 1, 1}));
  EXPECT_EQ(run(scene)->world().sensors.ranges[{0}], 0.4f);
}

TEST(RangerSense, only_what_is_subscribed_and_due_is_measured) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.1, 0.1, 0.1}));
  for (const double interval : {0.1, 0.15, 0.3}) {
    scene.models.push_back(ranger("s", 0, {}));
    scene.models.back().sensors = {sensor({}, 5, 0.1, 1)};
    scene.models.back().update_interval = interval;
  }
  scene.models.push_back(ranger("asleep", 0, {}));
  scene.models.back().alwayson = false;
  const auto engine = run(scene, 7);
  EXPECT_EQ(engine->world().rangers.measured_tick, (std::vector<std::uint64_t>{7, 6, 6, 0}));
}

TEST(RangerSense, constant_noise_has_the_given_standard_deviation_and_stays_within_the_range) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.1, 0.1, 0.1}));
  scene.models.push_back(ranger("s", 0, {}));
  scene.models.back().sensors = {sensor({}, 5, 1.0, 400)};
  scene.models.back().sensors[0].noise_constant = 0.05;
  const double radius = 2;  // a ring of edges about the sensor
  scene.models.push_back(box("ring", {}, {1, 1, 1}));
  scene.models.back().blocks[0].points.clear();
  for (int i = 0; i < 720; ++i) {
    const geom::SinCos sc = geom::sincos(i * geom::kPi / 360);
    scene.models.back().blocks[0].points.push_back({radius * sc.cos, radius * sc.sin});
  }
  const auto engine = run(scene);
  double sum = 0, squares = 0;
  for (const float range : engine->world().sensors.ranges) {
    sum += static_cast<double>(range) - radius;
    squares += (static_cast<double>(range) - radius) * (static_cast<double>(range) - radius);
  }
  EXPECT_NEAR(sum / 400, 0, 0.01);
  EXPECT_NEAR(std::sqrt(squares / 400), 0.05, 0.01);

  scene.models[1].sensors[0].noise_constant = 50;
  const auto wild = run(scene);
  for (const float range : wild->world().sensors.ranges) {
    EXPECT_GE(range, 0.0f);
    EXPECT_LE(range, 5.0f);
  }
}

TEST(RangerSense, angular_noise_turns_beams_by_no_more_than_it_says) {
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.1, 0.1, 0.1}));
  scene.models.push_back(ranger("s", 0, {}));
  scene.models.back().sensors = {sensor({}, 5, 0.5, 50)};
  scene.models.back().sensors[0].noise_angular = 0.1;
  scene.models.push_back(box("wall", {2.5, 0, 0, 0}, {1, 40, 1}));
  const auto engine = run(scene);
  bool turned = false;
  for (std::uint32_t k = 0; k < 50; ++k) {
    const double bearing = -0.25 + 0.5 * k / 49,
                 range = static_cast<double>(engine->world().sensors.ranges[{k}]);
    const double seen = geom::atan2(std::sqrt(range * range - 4), 2);
    EXPECT_LE(std::fabs(seen - std::fabs(bearing)), 0.1 + 1e-6);
    turned |= std::fabs(seen - std::fabs(bearing)) > 0.01;
  }
  EXPECT_TRUE(turned);
}

// One sensor is turned by angular noise, the next has noise along its beam: from both ranges follow the
// numbers that were drawn.
TEST(RangerSense, the_angular_noise_of_a_beam_is_not_the_range_noise_of_the_next_sensor) {
  constexpr double kBearing = 0.5, kSpread = 0.1, kShare = 0.1;
  scene::SceneDesc scene;
  scene.models.push_back(robot("r", {}, {0.1, 0.1, 0.1}));
  scene.models.push_back(ranger("s", 0, {}));
  scene.models.back().sensors = {sensor({0, 0, 0, kBearing}, 5, 0, 1), sensor({}, 5, 0, 1)};
  scene.models.back().sensors[0].noise_angular = kSpread;
  scene.models.back().sensors[1].noise_proportional = kShare;
  scene.models.push_back(box("wall", {2.5, 0, 0, 0}, {1, 40, 1}));
  const auto engine = run(scene, 0);
  int equal = 0;
  for (int tick = 0; tick < 20; ++tick) {
    engine->step();
    const std::vector<float>& ranges = engine->world().sensors.ranges;
    const double turned_range = static_cast<double>(ranges[0]), noisy_range = static_cast<double>(ranges[1]);
    const double seen = geom::atan2(std::sqrt(turned_range * turned_range - 4), 2);
    const double of_beam = (seen - kBearing) / kSpread, of_range = (noisy_range / 2 - 1) / kShare;
    EXPECT_LE(std::fabs(of_beam), 1.001);
    EXPECT_LE(std::fabs(of_range), 1.001);
    equal += std::fabs(of_beam - of_range) < 1e-3;
  }
  EXPECT_LE(equal, 1) << "of 20 draws";
}

}  // namespace
}  // namespace playhouse::senses
