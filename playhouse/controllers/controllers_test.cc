/// The built-in controllers one decision at a time, on beams that the tests make up. How they behave over
/// minutes, in an engine, is tested in scenarios.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "playhouse/controllers/attach.h"
#include "playhouse/controllers/rasterize.h"
#include "playhouse/controllers/testing/scenes.h"
#include "playhouse/scene/forms/colors.h"
#include "playhouse/world/population/population.h"

namespace playhouse::controllers {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A world whose controllers are attached; `error` is empty when that went well.
struct Fixture {
  explicit Fixture(scene::SceneDesc made) : scene(std::move(made)), world(scene, 7) {
    auto attached = attach(world, {});
    if (attached) {
      warnings = *attached;
    } else {
      error = attached.error().line();
    }
  }
  const geom::Twist& command(std::uint32_t robot) const { return world.positions.command[{robot}]; }

  scene::SceneDesc scene;
  world::World world;
  std::vector<std::string> warnings;
  std::string error;
};

TEST(Controllers, decide_for_a_robot_that_comes_during_the_run_as_for_those_before_it) {
  Fixture f(testing::robots(1, testing::scanner(180), "wander"));
  testing::decide(f.world);
  ASSERT_TRUE(world::spawn(f.world, f.world.models.desc[{0}], {5, 5, 0, 0}));
  testing::decide(f.world);  // it joins, and its sensor is subscribed
  EXPECT_EQ(f.world.models.controllers, std::vector<std::uint32_t>(4, 1));
  testing::measure(f.world, {8.0f});
  testing::decide(f.world);
  EXPECT_EQ(f.command(1), (geom::Twist{0.4, 0, 0, 0}));
  ASSERT_TRUE(world::despawn(f.world, f.world.id({0})));
  testing::measure(f.world, {0.1f});
  testing::decide(f.world);
  EXPECT_EQ(f.command(0).x, 0) << "the one that is left";
}

TEST(Wander, drives_ahead_when_nothing_is_near) {
  Fixture f(testing::robots(1, testing::scanner(180), "wander"));
  ASSERT_EQ(f.error, "");
  testing::measure(f.world, {8.0f});
  testing::decide(f.world);
  EXPECT_EQ(f.command(0), (geom::Twist{0.4, 0, 0, 0}));
}

TEST(Wander, turns_away_from_the_nearer_side_and_keeps_turning_for_ten_scans_at_least) {
  Fixture f(testing::robots(1, testing::scanner(180), "wander"));
  std::vector<float> beams(180, 8.0f);
  beams[100] = 0.8f;  // ahead, a little to the left
  testing::measure(f.world, beams);
  testing::decide(f.world);
  EXPECT_EQ(f.command(0), (geom::Twist{0.05, 0, 0, -0.5}));
  int kept = 1;
  for (; kept < 100; ++kept) {
    testing::measure(f.world, {8.0f});
    testing::decide(f.world);
    if (f.command(0).x == 0.4) break;
  }
  EXPECT_GE(kept, 10);
  EXPECT_LT(kept, 20);
}

TEST(Wander, stops_and_turns_when_anything_is_very_near) {
  Fixture f(testing::robots(1, testing::scanner(180), "wander"));
  std::vector<float> beams(180, 8.0f);
  beams[0] = 0.2f;  // far right
  testing::measure(f.world, beams);
  testing::decide(f.world);
  EXPECT_EQ(f.command(0), (geom::Twist{0, 0, 0, 0.5}));
}

TEST(Wander, works_with_any_number_of_samples) {
  for (std::uint32_t samples = 1; samples <= 40; ++samples) {
    Fixture f(testing::robots(2, testing::scanner(samples), "wander"));
    ASSERT_EQ(f.error, "") << samples;
    testing::measure(f.world, {0.25f});
    testing::decide(f.world);
    EXPECT_EQ(f.command(1).x, 0) << samples;
    EXPECT_EQ(std::abs(f.command(1).a), 0.5) << samples;
  }
}

TEST(Wander, sees_an_obstacle_in_every_beam) {
  for (const std::uint32_t samples : {1u, 7u, 8u, 9u, 16u, 31u, 180u, 181u}) {
    for (std::uint32_t k = 0; k < samples; ++k) {
      Fixture f(testing::robots(1, testing::scanner(samples), "wander"));
      std::vector<float> beams(samples, 8.0f);
      beams[k] = 0.29f;
      testing::measure(f.world, beams);
      testing::decide(f.world);
      ASSERT_EQ(f.command(0).x, 0) << samples << " samples, beam " << k;
    }
  }
}

TEST(Wander, acts_on_new_scans_only) {
  Fixture f(testing::robots(1, testing::scanner(180), "wander"));
  testing::measure(f.world, {8.0f});
  testing::decide(f.world);
  f.world.positions.command[{0}] = {};
  ++f.world.tick_;
  testing::decide(f.world);
  EXPECT_EQ(f.command(0), geom::Twist{});
}

TEST(Wander, prefers_a_scanner_to_sonars) {
  scene::SceneDesc scene = testing::robots(1, testing::ring(16), "wander");
  scene::ModelDesc laser = scene.models[1];
  laser.name = laser.alias = "r0.ranger:1";
  laser.sensors = testing::scanner(9);
  scene.models.push_back(laser);
  Fixture f(std::move(scene));
  ASSERT_EQ(f.error, "");
  EXPECT_EQ(f.world.models.subscribers[{0}], 1u);
  EXPECT_EQ(f.world.models.subscribers[{1}], 0u) << "the sonars stay asleep";
  EXPECT_EQ(f.world.models.subscribers[{2}], 1u);
}

TEST(Expand, drives_towards_free_space_ahead) {
  for (const char* name : {"expand_swarm", "expand_pioneer"}) {
    Fixture f(testing::robots(1, testing::ring(12), name));
    ASSERT_EQ(f.error, "") << name;
    std::vector<float> beams(12, 5.0f);
    beams[5] = beams[6] = beams[7] = 1.0f;  // something behind
    testing::measure(f.world, beams);
    testing::decide(f.world);
    EXPECT_GT(f.command(0).x, 0) << name;
    EXPECT_NEAR(f.command(0).a, 0, 1e-6) << name;
  }
}

TEST(Expand, turns_to_the_side_with_more_room_and_stops_when_blocked) {
  Fixture f(testing::robots(1, testing::ring(16), "expand_swarm"));
  std::vector<float> beams(16, 5.0f);
  beams[0] = 0.4f;                           // ahead
  beams[15] = beams[14] = beams[13] = 1.0f;  // right
  testing::measure(f.world, beams);
  testing::decide(f.world);
  EXPECT_EQ(f.command(0).x, 0);
  EXPECT_GT(f.command(0).a, 0);
}

/// True if a robot drives on whose beam at `degrees` is this long, with free space ahead in all others.
bool drives_with(const char* name, int degrees, float range) {
  Fixture f(testing::robots(1, testing::ring(36), name));
  EXPECT_EQ(f.error, "");
  std::vector<float> beams(36, 5.0f);
  std::fill(beams.begin() + 10, beams.end() - 9, 1.0f);  // behind
  beams[static_cast<std::size_t>((degrees + 360) % 360 / 10)] = range;
  testing::measure(f.world, beams);
  testing::decide(f.world);
  return f.command(0).x > 0;
}

TEST(Expand, drives_while_every_beam_is_longer_than_stage_wants_it_at_its_bearing) {
  const struct {
    const char* name;
    int degrees;
    float longer_than;  // m
  } wanted[] = {{"expand_swarm", 0, 0.5f},        {"expand_swarm", 30, 0.5f / 1.5f},
                {"expand_swarm", 60, 0.5f / 3},   {"expand_swarm", 90, 0.5f / 5},
                {"expand_pioneer", 10, 0.75f},    {"expand_pioneer", 30, 0.75f / 2},
                {"expand_pioneer", 50, 0.75f / 4}};
  for (const auto& [name, degrees, longer_than] : wanted) {
    for (const int side : {degrees, -degrees}) {
      EXPECT_FALSE(drives_with(name, side, longer_than)) << name << " at " << side;
      EXPECT_TRUE(drives_with(name, side, longer_than + 0.001f)) << name << " at " << side;
    }
  }
  for (const int side : {120, 180, -120}) EXPECT_TRUE(drives_with("expand_swarm", side, 0)) << side;
  for (const int side : {80, 90, 180, -90}) EXPECT_TRUE(drives_with("expand_pioneer", side, 0)) << side;
}

TEST(Expand, works_with_a_ring_of_any_size) {
  for (std::size_t sensors = 1; sensors <= 40; ++sensors) {
    Fixture f(testing::robots(3, testing::ring(sensors), "expand_pioneer"));
    ASSERT_EQ(f.error, "") << sensors;
    testing::measure(f.world, {0.1f});
    testing::decide(f.world);
    EXPECT_EQ(f.command(2).x, 0) << sensors;
  }
}

TEST(Diffusion, drives_ahead_until_something_is_near_and_turns_away_from_it_on_one_wheel) {
  std::vector<scene::RangerSensorDesc> ring = testing::ring(24);
  for (scene::RangerSensorDesc& sensor : ring) sensor.range_min = 0.1, sensor.range_max = 0.2;
  const auto command = [&](std::initializer_list<std::size_t> near, float range) {
    Fixture f(testing::robots(1, ring, "diffusion"));
    EXPECT_EQ(f.error, "");
    std::vector<float> beams(24, 0.2f);
    for (const std::size_t k : near) beams[k] = range;
    testing::measure(f.world, beams);
    testing::decide(f.world);
    return f.command(0);
  };
  EXPECT_EQ(command({}, 0).x, 0.05);
  EXPECT_EQ(command({}, 0).a, 0);
  EXPECT_EQ(command({0}, 0.19f).a, 0) << "ahead, and far less than a tenth of what the ring could see";
  EXPECT_EQ(command({0, 1, 23}, 0.1f).x, 0.025) << "2.9 of 24 is more than a tenth";
  EXPECT_NEAR(command({3}, 0.15f).a, -0.05 / 0.14, 1e-12) << "on the left: turns right";
  EXPECT_NEAR(command({21}, 0.15f).a, 0.05 / 0.14, 1e-12);
}

TEST(Source, fills_up_to_its_capacity_and_a_sink_counts_what_it_is_given) {
  scene::SceneDesc scene = testing::robots(2, testing::ring(1), "source 3 10");
  scene.models[2].ctrl = {"sink"};
  Fixture f(std::move(scene));
  ASSERT_EQ(f.error, "");
  for (int tick = 0; tick < 5; ++tick) testing::decide(f.world);
  EXPECT_EQ(f.world.models.flags[{0}], 3);
  EXPECT_EQ(f.world.models.say[{2}], "");
  f.world.models.flags[{2}] = 2;
  testing::decide(f.world);
  f.world.models.flags[{2}] = 1;
  testing::decide(f.world);
  f.world.models.flags[{2}] = 2;
  testing::decide(f.world);
  EXPECT_EQ(f.world.models.say[{2}], "received 3");
}

TEST(Source, makes_a_flag_at_each_update_of_its_model) {
  scene::SceneDesc scene = testing::robots(1, testing::ring(1), "source 100");
  scene.interval = 0.1;
  scene.models[0].update_interval = 0.5;
  Fixture f(std::move(scene));
  ASSERT_EQ(f.error, "");
  for (int tick = 0; tick < 20; ++tick) {
    testing::measure(f.world, {1});
    testing::decide(f.world);
  }
  EXPECT_EQ(f.world.models.flags[{0}], 4);
}

TEST(Source, gives_what_it_makes_when_all_have_decided) {
  Fixture f(testing::robots(2, testing::ring(1), "source 5"));
  ASSERT_EQ(f.error, "");
  world::Decider& source = *f.world.deciders[0];
  source.decide(f.world, 1, 2);
  source.decide(f.world, 0, 1);
  EXPECT_EQ(f.world.models.flags[{0}], 0);
  EXPECT_EQ(f.world.models.flags[{2}], 0);
  source.deliver(f.world);
  EXPECT_EQ(f.world.models.flags[{0}], 1);
  EXPECT_EQ(f.world.models.flags[{2}], 1);
}

/// Robots with a ring of eight sonars and a fiducial finder, 2 m apart.
scene::SceneDesc flock(std::size_t count) {
  scene::SceneDesc scene = testing::robots(count, testing::ring(8), "pioneer_flocking");
  for (std::size_t i = 0; i < count; ++i) {
    scene::ModelDesc finder;
    finder.name = finder.alias = "finder" + std::to_string(i);
    finder.kind = scene::ModelKind::kFiducial;
    finder.fiducial.emplace();
    finder.parent = static_cast<std::int32_t>(3 * i);
    scene.models.insert(scene.models.begin() + static_cast<std::ptrdiff_t>(3 * i + 2), finder);
    if (i + 1 < count) scene.models[3 * i + 4].parent = static_cast<std::int32_t>(3 * i + 3);
  }
  return scene;
}

TEST(PioneerFlocking, turns_as_the_nearest_of_those_that_it_sees_is_turned) {
  Fixture f(flock(1));
  ASSERT_EQ(f.error, "");
  f.world.fiducials.hits[{0}] = {{.range = 3, .heading = -1}, {.range = 2, .heading = 0.5}};
  testing::measure(f.world, {3.0f});
  testing::decide(f.world);
  EXPECT_EQ(f.command(0).x, 0.4);
  EXPECT_NEAR(f.command(0).a, 0.3 * 0.5, 1e-6);
}

TEST(PioneerFlocking, stops_and_turns_where_the_way_is_not_free) {
  Fixture f(flock(1));
  f.world.fiducials.hits[{0}] = {{.range = 2, .heading = 0.5}};
  testing::measure(f.world, {0.9f, 3, 3, 3, 3, 3, 3, 3});
  testing::decide(f.world);
  EXPECT_EQ(f.command(0).x, 0);
  EXPECT_GT(f.command(0).a, 0) << "drawn: both sides are alike";
  EXPECT_NE(f.command(0).a, 0.3 * 0.5);
}

TEST(PioneerFlocking, turns_right_where_there_is_more_room) {
  Fixture f(flock(1));
  testing::measure(f.world, {0.5f, 0.5f, 0.5f, 3, 3, 3, 5, 5});
  testing::decide(f.world);
  EXPECT_EQ(f.command(0).x, 0);
  const double diagonal =
      std::sqrt(0.5);  // beams at 0, 45, 90, -90 and -45 degrees: 0.5, 0.5, 0.5, 5 and 5 m
  EXPECT_NEAR(f.command(0).a, 0.3 * std::atan2((0.5 - 5) * diagonal + 0.5 - 5, 0.5 + (0.5 + 5) * diagonal),
              1e-6);
}

TEST(PioneerFlocking, wants_a_metre_at_30_degrees_to_either_side) {
  for (const std::size_t beam : {1u, 11u}) {
    Fixture f(testing::robots(1, testing::ring(12), "pioneer_flocking"));
    std::vector<float> ranges(12, 3);
    ranges[beam] = 0.9f;
    testing::measure(f.world, ranges);
    testing::decide(f.world);
    EXPECT_EQ(f.command(0).x, 0) << beam;
  }
}

TEST(PioneerFlocking, looks_at_nothing_behind_it) {
  Fixture f(flock(1));
  testing::measure(f.world, {3, 3, 3, 0.1f, 3, 3, 3, 3});
  testing::decide(f.world);
  EXPECT_NEAR(f.command(0).a, 0, 1e-6);
}

scene::SceneDesc noisy_scanner(std::size_t beams) {
  scene::SceneDesc scene = testing::robots(1, testing::scanner(static_cast<std::uint32_t>(beams)), "wander");
  scene.models[1].ctrl = {"lasernoise"};
  return scene;
}

/// What engines do after they sensed.
void filter(world::World& world) {
  --world.tick_;  // scans are of the tick that is being made
  for (const auto& decider : world.deciders) decider->filter(world, 0, decider->size());
  ++world.tick_;
}

TEST(LaserNoise, puts_every_new_range_off_by_five_per_cent) {
  Fixture f(noisy_scanner(1000));
  ASSERT_EQ(f.error, "");
  testing::measure(f.world, {4.0f});
  filter(f.world);
  double sum = 0, squares = 0;
  for (const float range : f.world.sensors.ranges) {
    sum += range / 4 - 1;
    squares += (range / 4 - 1) * (range / 4 - 1);
  }
  EXPECT_NEAR(sum / 1000, 0, 0.005);
  EXPECT_NEAR(std::sqrt(squares / 1000), 0.05, 0.005);
  const std::vector<float> noisy(f.world.sensors.ranges.begin(), f.world.sensors.ranges.end());
  ++f.world.tick_;
  filter(f.world);
  EXPECT_TRUE(std::ranges::equal(f.world.sensors.ranges, noisy)) << "nothing was measured since";
}

TEST(LaserNoise, stays_within_the_range_of_each_sensor_and_leaves_beams_without_a_hit_alone) {
  scene::SceneDesc scene = noisy_scanner(1000);
  scene.models[1].sensors.push_back(scene.models[1].sensors[0]);
  scene.models[1].sensors[1].range_min = 3.9;
  scene.models[1].sensors[1].range_max = 4.1;
  Fixture f(std::move(scene));
  ASSERT_EQ(f.error, "");
  std::vector<float> measured(1000, 7.9f);
  measured[0] = 8;
  measured.insert(measured.end(), 1000, 4.0f);
  measured.back() = 4.1f;
  testing::measure(f.world, measured);
  filter(f.world);
  const std::span<const float> ranges(f.world.sensors.ranges);
  EXPECT_EQ(ranges[0], 8) << "it hit nothing";
  EXPECT_EQ(std::ranges::max(ranges.first(1000)), 8);
  EXPECT_LT(std::ranges::min(ranges.first(1000)), 7.5);
  EXPECT_EQ(ranges.back(), 4.1f);
  EXPECT_EQ(std::ranges::max(ranges.subspan(1000)), 4.1f);
  EXPECT_EQ(std::ranges::min(ranges.subspan(1000)), 3.9f);
}

TEST(LaserNoise, needs_a_ranger) {
  Fixture f(testing::robots(1, testing::scanner(9), "lasernoise"));
  EXPECT_THAT(f.error, HasSubstr("needs to be on a ranger"));
}

TEST(Rasterize, draws_the_outline_of_a_body_in_its_box) {
  scene::ModelDesc desc;
  desc.size = {4, 2, 1};
  desc.blocks.push_back({{{-2, -1}, {2, -1}, {2, 1}, {-2, 1}}, 0, 1});
  desc.blocks.push_back({{{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.4}}, 0, 1});
  EXPECT_THAT(raster_of(desc, 8, 6),
              ::testing::ElementsAre("OOOOOOOO", "O....O.O", "O...OO.O", "O......O", "O......O", "OOOOOOOO"));
}

TEST(Dynamic, gives_its_model_a_hundred_parts_within_a_metre) {
  scene::SceneDesc scene = testing::robots(2, testing::scanner(9), "dynamic");
  describe_for(scene);
  describe_for(scene);
  EXPECT_EQ(scene.models.size(), 5u) << "what the parts are like is said once";
  Fixture f(std::move(scene));
  ASSERT_EQ(f.error, "");
  EXPECT_EQ(f.world.models.size(), 4u);
  for (int tick = 0; tick < 2; ++tick) testing::decide(f.world);
  EXPECT_EQ(f.world.models.size(), 204u);
  for (const world::ModelRow robot : f.world.positions.model) {
    int parts = 0;
    for (const world::ModelRow child : f.world.children(robot)) {
      if (f.world.models.kind[child] != scene::ModelKind::kPlain) continue;
      ++parts;
      const geom::Pose& X_PM = f.world.models.X_PM[child];
      EXPECT_LE(std::max(std::fabs(X_PM.x), std::fabs(X_PM.y)), 1);
      EXPECT_EQ(f.world.models.color[child], *scene::color_by_name("blue"));
    }
    EXPECT_EQ(parts, 100);
  }
}

TEST(Patrol, goes_from_waypoint_to_waypoint_and_begins_again) {
  Fixture f(testing::robots(1, {}, "patrol 0.5 3 0 0 4"));
  ASSERT_EQ(f.error, "");
  testing::decide(f.world);
  EXPECT_EQ(f.command(0), (geom::Twist{0.5, 0, 0, 0})) << "ahead";
  f.world.models.X_WM[{0}] = {2.95, 0, 0, 0};  // there: the second is behind, to the left
  testing::decide(f.world);
  EXPECT_EQ(f.command(0), (geom::Twist{0, 0, 0, 1.5}));
  f.world.models.X_WM[{0}] = {0, 2, 0, geom::radians(80)};
  testing::decide(f.world);
  EXPECT_NEAR(f.command(0).x, 0.5 * std::cos(geom::radians(10)), 1e-12);
  EXPECT_NEAR(f.command(0).a, 3 * geom::radians(10), 1e-12);
  f.world.models.X_WM[{0}] = {0, 4, 0, geom::radians(-45)};  // and back to the first
  testing::decide(f.world);
  EXPECT_GT(f.command(0).x, 0.4);
}

TEST(Patrol, stays_at_its_only_waypoint) {
  Fixture f(testing::robots(1, {}, "patrol 0 0.05"));
  ASSERT_EQ(f.error, "");
  testing::decide(f.world);
  EXPECT_EQ(f.command(0), geom::Twist());
}

TEST(Patrol, says_what_is_wrong_with_its_arguments) {
  const auto error = [](const std::string& ctrl) { return Fixture(testing::robots(1, {}, ctrl)).error; };
  EXPECT_THAT(error("patrol"), HasSubstr("controller \"patrol\" of \"r0\": needs [SPEED] X Y"));
  EXPECT_THAT(error("patrol 1"), HasSubstr("needs [SPEED] X Y"));
  EXPECT_THAT(error("patrol 1 1 two 2"), HasSubstr("not \"two\""));
  EXPECT_THAT(error("patrol 1 nan"), HasSubstr("not \"nan\""));
  EXPECT_THAT(error("patrol -1 2 2"), HasSubstr("a speed is more than 0"));
  EXPECT_THAT(error("patrol 1e12 2"), HasSubstr("out of the largest world"));
  scene::SceneDesc car = testing::robots(1, {}, "patrol 1 1");
  car.models[0].position->drive = scene::Drive::kCar;
  EXPECT_THAT(Fixture(std::move(car)).error, HasSubstr("a car cannot turn"));
}

TEST(Attach, names_the_line_and_the_nearest_word_for_an_unknown_controller) {
  Fixture f(testing::robots(1, testing::ring(4), "wandr 1"));
  EXPECT_EQ(f.error, "test.world:1: no controller \"wandr\" (did you mean \"wander\"?)");
}

TEST(Attach, says_what_a_model_lacks) {
  Fixture without_sensors(testing::robots(1, {}, "wander"));
  EXPECT_EQ(without_sensors.error,
            "test.world:1: controller \"wander\" of \"r0\": needs a ranger with at least one sensor");
  Fixture bad_number(testing::robots(1, testing::ring(4), "source many"));
  EXPECT_THAT(bad_number.error, HasSubstr("capacity as a whole number, not \"many\""));
}

TEST(Attach, gives_a_robot_several_controllers_but_each_only_once) {
  scene::SceneDesc scene = testing::robots(1, testing::ring(4), "wander");
  scene.models[0].ctrl = {"wander", "source 2", "wander fast"};
  Fixture f(std::move(scene));
  ASSERT_EQ(f.error, "");
  EXPECT_EQ(f.world.deciders.size(), 2u);
  EXPECT_EQ(f.world.deciders[0]->size(), 1u);
  ASSERT_EQ(f.warnings.size(), 1u);
  EXPECT_THAT(f.warnings[0], HasSubstr("names controller \"wander\" twice"));
}

TEST(Attach, puts_all_robots_of_one_controller_into_one_batch) {
  Fixture f(testing::robots(50, testing::ring(4), "expand_swarm"));
  ASSERT_EQ(f.world.deciders.size(), 1u);
  EXPECT_EQ(f.world.deciders[0]->size(), 50u);
}

TEST(Attach, gives_the_same_decisions_however_the_robots_are_divided) {
  const scene::SceneDesc scene = testing::robots(64, testing::scanner(30), "wander");
  Fixture whole(scene), halves(scene);
  for (int tick = 0; tick < 200; ++tick) {
    std::vector<float> beams(7 * 30);
    Rng random(tick);
    for (float& beam : beams) beam = static_cast<float>(random.uniform(0.2, 3));
    testing::measure(whole.world, beams);
    testing::measure(halves.world, beams);
    testing::decide(whole.world);
    halves.world.deciders[0]->decide(halves.world, 40, 64);
    halves.world.deciders[0]->decide(halves.world, 0, 40);
    halves.world.deciders[0]->deliver(halves.world);
  }
  EXPECT_EQ(whole.world.hash(), halves.world.hash());
}

}  // namespace
}  // namespace playhouse::controllers
