// What detectors find, by what their words say: laws against exact places, and against lines that are
// marched.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"
#include "playhouse/world/population/population.h"

namespace playhouse::senses {
namespace {

using stage::testing::box;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A detector at the origin that looks along +x, a metre up.
scene::SceneDesc lookout(scene::DetectorDesc detector = {}) {
  scene::SceneDesc scene;
  scene::ModelDesc& model = scene.models.emplace_back();
  model.name = model.alias = "detector";
  model.type = "detector";
  model.kind = scene::ModelKind::kDetector;
  model.X_PM = {0, 0, 1, 0};
  model.alwayson = true;
  model.size = {};
  model.detector = std::move(detector);
  return scene;
}

scene::ModelDesc& add(scene::SceneDesc& scene, const std::string& name, const geom::Pose& X_WM,
                      const geom::Size& size = {0.4, 0.4, 2}) {
  scene.models.push_back(box(name, X_WM, size));
  return scene.models.back();
}

/// What the detector of a scene has after a tick.
struct Seen {
  explicit Seen(const scene::SceneDesc& scene, unsigned workers = 1, std::uint64_t seed = 1) {
    auto made = stage::make_engine(scene, {.seed = seed, .workers = workers});
    EXPECT_TRUE(made.ok());
    (*made)->step();
    const world::World& world = (*made)->world();
    EXPECT_EQ(world.detectors.measured_tick[{0}], 1u);
    echoes = world.detectors.echoes[{0}];
    finds = world.detectors.finds[{0}];
    for (const world::Detection& found : finds) names.push_back(world.name(world.row(found.target)));
  }
  std::vector<double> ranges() const {
    std::vector<double> ranges;
    for (const world::Echo& echo : echoes) ranges.push_back(static_cast<double>(echo.range));
    return ranges;
  }
  std::vector<world::Echo> echoes;
  std::vector<world::Detection> finds;
  std::vector<std::string> names;
};

scene::DetectorDesc fan(double degrees, std::uint32_t samples, std::uint32_t rays = 1) {
  scene::DetectorDesc detector;
  detector.fov = geom::radians(degrees);
  detector.samples = samples;
  detector.rays = rays;
  return detector;
}

TEST(DetectorSense, beams_tell_the_nearest_thing_in_their_share_of_the_field_of_view) {
  scene::SceneDesc scene = lookout(fan(90, 3));  // beams look to -30, 0 and 30 degrees
  add(scene, "ahead", {2, 0, 0, 0});
  add(scene, "left",
      {3 * std::cos(geom::radians(30)), 3 * std::sin(geom::radians(30)), 0, geom::radians(30)});
  const Seen seen(scene);
  ASSERT_EQ(seen.echoes.size(), 3u);
  EXPECT_EQ(seen.ranges()[0], 8) << "nothing there: its largest range";
  EXPECT_NEAR(seen.ranges()[1], 1.8, 1e-6);
  EXPECT_NEAR(seen.ranges()[2], 2.8, 1e-6);
  EXPECT_EQ(seen.echoes[0].level, 0);
  EXPECT_EQ(seen.echoes[1].level, 100);
  EXPECT_THAT(seen.names, ElementsAre("ahead", "left"));
  EXPECT_NEAR(seen.finds[1].bearing, geom::radians(30), 1e-12);
  EXPECT_NEAR(seen.finds[1].range, 2.8, 1e-9);
}

TEST(DetectorSense, more_rays_make_a_beam_wider) {
  scene::SceneDesc scene = lookout(fan(60, 1));
  add(scene, "aside", {3, 1, 0, 0});
  EXPECT_THAT(Seen(scene).names, IsEmpty()) << "a laser looks past it";
  scene.models[0].detector->rays = 16;
  const Seen sonar(scene);
  EXPECT_THAT(sonar.names, ElementsAre("aside"));
  EXPECT_NEAR(sonar.finds[0].bearing, std::atan2(1, 3), geom::radians(60.0 / 16));
  EXPECT_LT(sonar.ranges()[0], std::hypot(3, 1));
  EXPECT_GT(sonar.ranges()[0], std::hypot(2.8, 0.8) - 1e-9);
}

TEST(DetectorSense, sees_all_around_and_finds_one_thing_once) {
  scene::SceneDesc scene = lookout(fan(360, 360));
  add(scene, "behind", {-2, 0, 0, 0});
  const Seen seen(scene);
  ASSERT_THAT(seen.names, ElementsAre("behind"));
  EXPECT_NEAR(std::fabs(seen.finds[0].bearing), geom::kPi, 1e-9);
}

TEST(DetectorSense, sees_what_it_is_to_see_and_the_rest_is_in_the_way) {
  scene::SceneDesc scene = lookout(fan(10, 1));
  scene.models[0].detector->sees = {"color=red"};
  add(scene, "fence", {1.5, 0, 0, 0}).color = {0, 1, 0, 1};
  add(scene, "red", {3, 0, 0, 0}).color = {1, 0, 0, 1};
  EXPECT_THAT(Seen(scene).names, IsEmpty());
  scene.models[0].detector->walls = 1;
  const Seen through(scene);
  EXPECT_THAT(through.names, ElementsAre("red"));
  EXPECT_NEAR(through.ranges()[0], 2.8, 1e-6);
  EXPECT_EQ(through.finds[0].bodies, 1u);
}

TEST(DetectorSense, sees_through_as_many_bodies_as_it_may) {
  scene::SceneDesc scene = lookout(fan(10, 1));
  for (const double x : {1.0, 2.0, 3.0, 4.0, 5.0})
    add(scene, "x" + std::to_string(static_cast<int>(x)), {x, 0, 0, 0});
  scene.models[0].detector->walls = 2;
  const Seen seen(scene);
  EXPECT_THAT(seen.names, ElementsAre("x1", "x2", "x3"));
  EXPECT_NEAR(seen.ranges()[0], 0.8, 1e-6);
}

TEST(DetectorSense, what_is_of_glass_is_no_hindrance_and_takes_nothing) {
  scene::DetectorDesc detector = fan(10, 1);
  detector.sees = {"name=goal"};
  detector.through = {"material=glass", "material=air*"};
  detector.loss_per_body = 200;
  scene::SceneDesc scene = lookout(detector);
  add(scene, "pane", {1, 0, 0, 0}).material = "glass";
  add(scene, "balloon", {2, 0, 0, 0}).material = "airship";
  add(scene, "goal", {3, 0, 0, 0});
  const Seen seen(scene);
  EXPECT_THAT(seen.names, ElementsAre("goal"));
  EXPECT_EQ(seen.finds[0].level, 100);
  EXPECT_EQ(seen.finds[0].bodies, 0u);
}

TEST(DetectorSense, what_is_lost_on_the_way_adds_up_until_nothing_is_left) {
  scene::DetectorDesc detector = fan(10, 1);
  detector.walls = 5;
  detector.loss_per_body = 6;
  detector.loss_per_metre = 10;
  detector.spread = 2;
  detector.budget = 40;
  scene::SceneDesc scene = lookout(detector);
  add(scene, "near", {2, 0, 0, 0}, {1, 1, 2});  // from 1.5 to 2.5 m
  add(scene, "far", {5, 0, 0, 0}, {2, 1, 2});   // from 4 to 6 m
  add(scene, "lost", {7, 0, 0, 0}, {1, 1, 2});
  const Seen seen(scene);
  ASSERT_THAT(seen.names, ElementsAre("near", "far"));
  EXPECT_NEAR(seen.finds[0].level, 40 - 20 * std::log10(1.5), 1e-9);
  EXPECT_NEAR(seen.finds[1].level, 40 - 20 * std::log10(4) - 6 - 10, 1e-9);
}

TEST(DetectorSense, looks_up_and_down_as_far_as_its_layers_do) {
  scene::SceneDesc scene = lookout(fan(10, 1));
  add(scene, "low", {2, 0, 0, 0}, {0.4, 0.4, 0.5});
  EXPECT_THAT(Seen(scene).names, IsEmpty());
  scene.models[0].detector->fov_vertical = geom::radians(60);
  scene.models[0].detector->layers = 3;  // -20, 0 and 20 degrees
  const Seen seen(scene);
  ASSERT_THAT(seen.names, ElementsAre("low"));
  // The line down enters it by its front at 1.8 m (0.655 down), beneath its top of 0.5 m.
  EXPECT_NEAR(seen.finds[0].range, 1.8 / std::cos(geom::radians(20)), 1e-9);
}

TEST(DetectorSense, sees_over_a_low_wall) {
  scene::DetectorDesc detector = fan(10, 1);
  detector.fov_vertical = geom::radians(40);
  detector.layers = 2;  // -10 and 10 degrees
  detector.sees = {"name=tower"};
  scene::SceneDesc scene = lookout(detector);
  add(scene, "wall", {1, 0, 0, 0}, {0.1, 2, 1.1});
  add(scene, "tower", {4, 0, 0, 0}, {0.4, 0.4, 3});
  EXPECT_THAT(Seen(scene).names, ElementsAre("tower"));
  scene.models[1].blocks[0].z_max = 1.5;
  scene.models[1].size.z = 1.5;
  EXPECT_THAT(Seen(scene).names, IsEmpty());
}

TEST(DetectorSense, tells_nothing_nearer_or_farther_than_its_range) {
  scene::SceneDesc scene = lookout(fan(10, 1));
  scene.models[0].detector->walls = 9;
  scene.models[0].detector->range_min = 1;
  scene.models[0].detector->range_max = 4;
  for (const double x : {0.8, 2.0, 4.1, 5.0}) add(scene, "x" + std::to_string(x), {x, 0, 0, 0});
  EXPECT_THAT(Seen(scene).names, ElementsAre("x2.000000", "x4.100000"));
}

TEST(DetectorSense, does_not_see_what_it_is_part_of_or_stands_in) {
  scene::SceneDesc scene = lookout(fan(10, 1));
  add(scene, "hall", {0, 0, 0, 0}, {3, 3, 3});
  add(scene, "thing", {2.5, 0, 0, 0});
  EXPECT_THAT(Seen(scene).names, ElementsAre("thing"));
  std::swap(scene.models[0], scene.models[1]);
  scene.models[1].parent = 0;  // on the hall, and looks back at it
  scene.models[1].X_PM = {1.8, 0, 0, geom::kPi};
  EXPECT_THAT(Seen(scene).names, IsEmpty());
}

TEST(DetectorSense, errors_have_the_deviation_that_is_said_and_repeat_with_the_seed) {
  scene::DetectorDesc detector = fan(10, 1);
  detector.noise_constant = 0.1;
  detector.noise_angular = 0.02;
  scene::SceneDesc scene = lookout(detector);
  add(scene, "thing", {4.2, 0, 0, 0});
  double range = 0, squared = 0, bearing = 0;
  constexpr int kRuns = 400;
  for (int seed = 1; seed <= kRuns; ++seed) {
    const Seen seen(scene, 1, static_cast<std::uint64_t>(seed));
    const double error = seen.ranges()[0] - 4;
    range += error / kRuns;
    squared += error * error / kRuns;
    bearing += seen.finds[0].bearing * seen.finds[0].bearing / kRuns;
  }
  EXPECT_NEAR(range, 0, 0.1 * 4 / std::sqrt(kRuns));
  EXPECT_NEAR(std::sqrt(squared), 0.1, 0.015);
  EXPECT_NEAR(std::sqrt(bearing), 0.02, 0.003);
  EXPECT_EQ(Seen(scene, 1, 7).finds, Seen(scene, 1, 7).finds);
}

TEST(DetectorSense, misses_what_it_is_said_to_miss_and_rounds_to_its_resolution) {
  scene::DetectorDesc detector = fan(10, 1);
  detector.miss = 0.25;
  detector.resolution = 0.5;
  scene::SceneDesc scene = lookout(detector);
  add(scene, "thing", {4.1, 0, 0, 0});
  int missed = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const Seen seen(scene, 1, seed);
    missed += seen.names.empty() ? 1 : 0;
    EXPECT_EQ(seen.ranges()[0], seen.names.empty() ? 8 : 4);
  }
  EXPECT_NEAR(missed, 100, 40);
}

TEST(DetectorSense, is_the_same_for_any_number_of_workers) {
  scene::DetectorDesc detector = fan(120, 12, 4);
  detector.walls = 1;
  detector.noise_constant = 0.05;
  detector.miss = 0.1;
  scene::SceneDesc scene = lookout(detector);
  for (int i = 0; i < 40; ++i)
    add(scene, "b" + std::to_string(i), {1 + 0.15 * i, 2 * std::sin(1.3 * i), 0, 0.4 * i});
  EXPECT_THAT(Seen(scene).names, ::testing::SizeIs(::testing::Gt(4u)));
  EXPECT_EQ(Seen(scene, 1).finds, Seen(scene, 3).finds);
  EXPECT_EQ(Seen(scene, 1).echoes, Seen(scene, 3).echoes);
}

// ---- what models are and show

/// Whether a detector with this condition sees the first model, a robot with a lamp that drives.
class Shown : public ::testing::Test {
 protected:
  Shown() {
    scene_ = lookout(fan(10, 1));
    scene::ModelDesc robot = stage::testing::robot("r0", {3, 0, 0, 0}, {0.4, 0.4, 2});
    robot.color = {0, 0, 1, 1};
    robot.mass = 12;
    robot.fiducial_return = 5;
    robot.say = "hello world";
    scene_.models.push_back(robot);
    scene::ModelDesc lamp = box("r0.lamp", {0, 0, 0, 0}, {0.1, 0.1, 0.1});
    lamp.kind = scene::ModelKind::kBlinkenlight;
    lamp.type = "blinkenlight";
    lamp.parent = 1;
    lamp.alwayson = true;
    lamp.blinkenlight.emplace();
    lamp.blinkenlight->period = 0;
    scene_.models.push_back(lamp);
  }
  bool sees(const std::string& condition, const std::function<void(world::World&)>& change = {}) {
    scene_.models[0].detector->sees = {condition};
    auto made = stage::make_engine(scene_, {.seed = 1, .workers = 1});
    EXPECT_TRUE(made.ok());
    (*made)->step();
    if (change) change((*made)->world());
    while ((*made)->world().tick() < 4) (*made)->step();
    EXPECT_GT((*made)->world().detectors.measured_tick[{0}], 1u);
    return !(*made)->world().detectors.finds[{0}].empty();
  }

  scene::SceneDesc scene_;
};

TEST_F(Shown, what_models_are_is_seen) {
  for (const char* holds :
       {"kind=position", "kind!=ranger", "name=r0", "name=r*", "name!=r1", "mass=12", "mass>11", "mass<13",
        "mass!=11", "obstacle_return=1", "gripper_return=0", "ranger_return=1", "color=blue name=r0"})
    EXPECT_TRUE(sees(holds)) << holds;
  for (const char* fails : {"kind=ranger", "kind!=position", "name=r", "name!=r*", "mass>12", "mass<12",
                            "mass!=12", "obstacle_return=0", "gripper_return=1", "color=blue name=r1"})
    EXPECT_FALSE(sees(fails)) << fails;
}

TEST_F(Shown, what_models_show_is_seen_as_it_changes) {
  EXPECT_TRUE(sees("color=blue"));
  EXPECT_FALSE(sees("color=red"));
  EXPECT_TRUE(sees("color=red", [](world::World& world) { world::set_color(world, {1}, {1, 0, 0, 1}); }));
  EXPECT_TRUE(sees("says=hello*"));
  EXPECT_FALSE(sees("says=bye"));
  EXPECT_TRUE(sees("says=bye", [](world::World& world) { world::set_say(world, {1}, "bye"); }));
  EXPECT_TRUE(sees("fiducial_return=5"));
  EXPECT_TRUE(
      sees("fiducial_return>8", [](world::World& world) { world::set_fiducial_return(world, {1}, 9); }));
}

TEST_F(Shown, a_lamp_that_is_lit_and_motion_are_seen) {
  EXPECT_TRUE(sees("light=on"));
  EXPECT_FALSE(sees("light=off"));
  const auto out = [](world::World& world) { world.blinkenlights.enabled[{0}] = 0; };
  EXPECT_TRUE(sees("light=off", out));
  EXPECT_FALSE(sees("light=on", out));
  scene_.models[1].lamp = 65;
  EXPECT_TRUE(sees("light=on", out)) << "one without a switch";
  EXPECT_TRUE(sees("speed<0.1"));
  EXPECT_FALSE(sees("speed>0.1"));
  const auto drive = [](world::World& world) { world.positions.command[{0}] = {0.5, 0, 0, 0}; };
  EXPECT_TRUE(sees("speed>0.1", drive));
  EXPECT_FALSE(sees("speed<0.1", drive));
}

// ---- against lines that are marched

/// Where a line from the detector enters a box, in steps of two millimetres on the floor; 100 where it does
/// not within 8 m.
double entered(const scene::ModelDesc& box, double bearing, double slope) {
  const double c = std::cos(box.X_PM.a), s = std::sin(box.X_PM.a);
  const geom::Vec2 ahead{std::cos(bearing), std::sin(bearing)};
  for (double t = 0; t < 8; t += 0.002) {
    const geom::Vec2 p = geom::Vec2{t * ahead.x, t * ahead.y} - box.X_PM.xy();
    const double x = c * p.x + s * p.y, y = c * p.y - s * p.x, z = 1 + t * slope;
    if (std::fabs(x) <= 0.5 * box.size.x && std::fabs(y) <= 0.5 * box.size.y && z >= 0 && z <= box.size.z)
      return t * std::sqrt(1 + slope * slope);
  }
  return 100;
}

/// The nearest goal on a line, behind as many others as `walls`.
double nearest_goal(const scene::SceneDesc& scene, double bearing, double slope, std::size_t walls) {
  std::vector<std::pair<double, bool>> met;
  for (std::size_t i = 1; i < scene.models.size(); ++i)
    met.emplace_back(entered(scene.models[i], bearing, slope), scene.models[i].name.starts_with("goal"));
  std::ranges::sort(met);
  for (std::size_t i = 0; i < met.size() && i <= walls; ++i)
    if (met[i].second) return met[i].first;
  return 100;
}

TEST(DetectorSense, lines_meet_bodies_where_marched_ones_do) {
  for (const std::uint32_t walls : {0u, 1u, 3u}) {
    scene::DetectorDesc detector = fan(170, 17);
    detector.fov_vertical = geom::radians(20);
    detector.layers = 3;
    detector.walls = walls;
    detector.range_max = 7.5;
    detector.sees = {"name=goal*"};
    scene::SceneDesc scene = lookout(detector);
    for (int i = 0; i < 48; ++i) {
      const double angle = 2.4 * i, distance = 1 + 0.12 * i;
      add(scene, (i % 3 == 2 ? "goal" : "wall") + std::to_string(i),
          {distance * std::cos(angle), distance * std::sin(angle), 0, 0.7 * i}, {0.3, 0.9, 0.6 + 0.06 * i});
    }
    const Seen seen(scene);
    std::size_t told = 0;
    for (std::uint32_t beam = 0; beam < 17; ++beam) {
      const double bearing = geom::radians(170 * ((beam + 0.5) / 17 - 0.5));
      double nearest = 7.5;
      for (const double degrees : {-20.0 / 3, 0.0, 20.0 / 3})
        nearest = std::min(nearest, nearest_goal(scene, bearing, std::tan(geom::radians(degrees)), walls));
      EXPECT_NEAR(seen.ranges()[beam], nearest, 0.0025) << "beam " << beam << " behind " << walls;
      told += nearest < 7.5 ? 1 : 0;
    }
    EXPECT_GT(told, 4u);
  }
}

}  // namespace
}  // namespace playhouse::senses
