// What rangers measure in the arena: as in the stage engine where the world is flat, and in space.

#include "playhouse/arena/sensing/lidar_sense.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/arena/testing_runs.h"

namespace playhouse::arena {
namespace {

struct Session : EngineRun {
  Session(const char* text, bool arena, unsigned workers = 1) : EngineRun(text, arena, workers) {
    for (const world::ModelRow ranger : world().rangers.model) world::subscribe(world(), ranger);
  }
  float range(std::uint32_t beam) { return world().sensors.ranges[{beam}]; }
  float intensity(std::uint32_t beam) { return world().sensors.intensities[{beam}]; }
};

constexpr const char* kFlat = R"(
interval_sim 100
define rover position( size [0.4 0.4 0.3] drive "omni"
  ranger( pose [0.1 0 -0.1 0] size [0.1 0.1 0.1]
    sensor( samples 181 fov 270 range [0.1 8] )
    sensor( pose [0 0 0 30] samples 4 fov 40 range [0 5] noise [0.01 0.02 5] ) ) )
rover( name "a" pose [0 0 0 20] )
rover( name "b" pose [1 1.3 0 90] color "green" )
model( name "glass" pose [2 0 0 10] size [0.3 0.9 0.5] ranger_return -1 )
model( name "bright" pose [-2 0.5 0 10] size [0.3 0.9 0.5] ranger_return 7.5 )
model( name "low" pose [1.2 -0.5 0 30] size [0.3 0.3 0.1] )
model( name "box" pose [0.5 -1.5 0 30] size [0.3 0.3 0.3] gripper_return 1 )
model( name "ring" pose [0 0 0 0] size [7 7 1] boundary 1 noblocks 1 )
)";

TEST(LidarSense, measures_what_the_stage_engine_does_where_the_world_is_flat) {
  Session stage(kFlat, false), arena(kFlat, true);
  stage.step();
  arena.step();
  ASSERT_EQ(arena.world().sensors.ranges.size(), 2 * 185u);
  int near = 0;
  for (std::uint32_t beam = 0; beam < 2 * 185u; ++beam) {
    EXPECT_NEAR(arena.range(beam), stage.range(beam), 1e-4) << beam;
    EXPECT_EQ(arena.intensity(beam), stage.intensity(beam)) << beam;
    near += arena.range(beam) < 2;
  }
  EXPECT_GT(near, 20);
}

TEST(LidarSense, a_tilted_ranger_sees_the_ground_and_above_walls) {
  constexpr const char* kTilted = R"(
interval_sim 100
model( name "wall" pose [3 0 0 0] size [0.2 8 1] )
model( name "carrier" pose [0 0 0 0] size [0.2 0.2 0.5] gripper_return 1
  ranger( pose [0 0 0 0] size [0.02 0.02 0.02] alwayson 1
    sensor( samples 3 fov 180 range [0 8] ) ) )
)";
  const auto ahead = [&](double pitch) {
    Session run(kTilted, true);
    const world::ModelRow carrier = run.world().find("carrier");
    run.world().models.tilt_PM.set(carrier, {0, pitch});
    run.world().models.still.set(carrier, 100);  // rests as it stands
    world::place_tree(run.world(), carrier);
    run.step();
    EXPECT_EQ(run.world().models.tilt_PM[carrier].y, pitch);
    return std::pair(run.range(1), run.intensity(1));
  };
  const double h = 0.51 * std::cos(0.3);  // of the sensor, above the ground
  EXPECT_NEAR(ahead(0).first, 2.9, 1e-5);
  EXPECT_NEAR(ahead(0.3).first, h / std::sin(0.3), 1e-3);
  EXPECT_EQ(ahead(0.3).second, 1);
  EXPECT_EQ(ahead(-0.3).first, 8) << "over the wall";
  EXPECT_EQ(ahead(-0.3).second, 0);
}

TEST(LidarSense, bodies_are_seen_as_they_lie) {
  constexpr const char* kPlank = R"(
interval_sim 100
model( name "plank" pose [2 0 0 0] size [0.1 0.1 2] gripper_return 1 )
model( name "post" pose [0 0 0 0] size [0.2 0.2 0.5]
  ranger( pose [0 0 0.5 0] size [0.02 0.02 0.02] alwayson 1 sensor( samples 3 fov 20 range [0 8] ) ) )
)";
  Session run(kPlank, true);
  run.step();
  EXPECT_NEAR(run.range(1), 1.95, 1e-4) << "stands";
  const world::ModelRow plank = run.world().find("plank");
  world::wake(run.world().models);
  run.world().models.V_WM.set(plank, {{}, {1, 0, 0}});
  run.step(40);
  EXPECT_GT(std::fabs(run.world().models.tilt_WM[plank].x), 1.3) << "fell";
  EXPECT_EQ(run.range(1), 8) << "lies below the beam";
}

TEST(LidarSense, a_single_beam_is_a_cone) {
  constexpr const char* kCone = R"(
interval_sim 100
model( name "thin" pose [2 0.35 0 0] size [0.2 0.2 0.6] )
model( name "slanted" pose [3 0 0 70] size [0.05 20 1] ranger_return 2 )
model( name "post" pose [0 0 0 0] size [0.2 0.2 0.2]
  ranger( pose [0 0 0.1 0] size [0.02 0.02 0.02] alwayson 1
    sensor( fov 20 range [0 8] ) sensor( fov 0 range [0 8] ) ) )
)";
  Session run(kCone, true);
  run.step();
  EXPECT_NEAR(run.range(0), 1.93, 0.05) << "beside the axis, and nearer than the ground";
  EXPECT_NEAR(run.range(1), 3 - 0.025 / std::cos(70 * geom::kPi / 180), 1e-3) << "along the axis alone";
  EXPECT_EQ(run.intensity(1), 2);
}

/// What a sector of the plane, `half` to either side, sees of a disc: its distance along the bearing in the
/// sector nearest to its middle. Infinite if the disc faces that by more than `most`, or is beside it.
double nearest_in_sector(double half, double distance, double bearing, double radius, double most) {
  const double off = std::max(0.0, std::fabs(bearing) - half), beside = distance * std::sin(off);
  if (beside > radius * std::sin(most)) return 1e9;
  return distance * std::cos(off) - std::sqrt(radius * radius - beside * beside);
}

TEST(LidarSense, a_cone_misses_no_post_of_five_centimetres) {
  constexpr double kRadius = 0.025, kRangeMax = 5;
  std::string post = "define post model( size [0.05 0.05 1] block( z [0 1] points 48 ";
  for (int k = 0; k < 48; ++k) {
    const double around = 2 * geom::kPi * k / 48;
    post += "point[" + std::to_string(k) + "] [" + std::to_string(std::cos(around)) + " " +
            std::to_string(std::sin(around)) + "] ";
  }
  const std::string sonar =
      ") )\ninterval_sim 100\nmodel( pose [0 0 0 0] size [0.2 0.2 0.2] ranger( size [0.02 0.02 0.02] "
      "alwayson 1 sensor( fov 20 range [0 5] ) ) )\npost( name \"post\" pose [1 0 0 0] )\n";
  Session run((post + sonar).c_str(), true);
  run.step();
  for (const double distance : {0.5, 2.0, 4.9})
    for (double degrees = -12; degrees <= 12; degrees += 0.25) {
      const double bearing = geom::radians(degrees);
      ASSERT_TRUE(world::set_pose(run.world(), run.world().find("post"),
                                  {distance * std::cos(bearing), distance * std::sin(bearing), 0, 0}));
      run.step();
      // The normals of 48 sides are up to 3.75 degrees from those of the disc.
      const auto seen = [&](double most) {
        return nearest_in_sector(geom::radians(10), distance, bearing, kRadius, geom::radians(most));
      };
      const double wanted = seen(60 - 3.75);
      // Rays are at most sqrt(3) radii apart at the largest range, so that the nearest meets the disc at most
      // half as far beside its middle; 48 sides are up to 0.1 mm inside the disc.
      const double beside = kRadius * std::sqrt(0.75) * distance / kRangeMax;
      const double late = kRadius - std::sqrt(kRadius * kRadius - beside * beside) + 2e-4;
      if (wanted < kRangeMax) {
        EXPECT_GE(run.range(0), wanted - 1e-4) << distance << " m, " << degrees;
        EXPECT_LE(run.range(0), wanted + late) << distance << " m, " << degrees;
      } else if (seen(60 + 3.75) > kRangeMax) {
        EXPECT_EQ(run.range(0), kRangeMax) << distance << " m, " << degrees;
      }
    }
}

TEST(LidarSense, follows_a_population_that_changes_and_any_number_of_workers) {
  Session one(kFlat, true, 1), three(kFlat, true, 3);
  const auto change = [](Session& run) {
    run.step(3);
    ASSERT_TRUE(world::despawn(run.world(), run.world().id(run.world().find("low"))));
    run.step(3);
    ASSERT_TRUE(world::despawn(run.world(), run.world().id(run.world().find("box"))));
    ASSERT_TRUE(world::set_pose(run.world(), run.world().find("bright"), {-1, -1, 0, 0}));
    run.step(3);
  };
  change(one);
  change(three);
  EXPECT_EQ(one.world().sensed_hash(), three.world().sensed_hash());
  Session stage(kFlat, false);
  change(stage);
  for (std::uint32_t beam = 0; beam < 181u; ++beam)
    EXPECT_NEAR(one.range(beam), stage.range(beam), 1e-3) << beam;
}

/// What a ray meets of an upright box on the ground or of the ground, in double precision, slab by slab.
double oracle(const geom::Vec3& p, const geom::Vec3& d, const scene::ModelDesc& box) {
  const geom::Rotation turn = geom::Rotation::of(box.X_PM.a);
  const geom::Vec2 q = turn.inverse({p.x - box.X_PM.x, p.y - box.X_PM.y}), e = turn.inverse({d.x, d.y});
  const double from[3] = {q.x, q.y, p.z - box.X_PM.z}, along[3] = {e.x, e.y, d.z};
  const double low[3] = {-box.size.x / 2, -box.size.y / 2, 0},
               high[3] = {box.size.x / 2, box.size.y / 2, box.size.z};
  double enter = 0, leave = 1e9;
  for (int axis = 0; axis < 3; ++axis) {
    double a = (low[axis] - from[axis]) / along[axis], b = (high[axis] - from[axis]) / along[axis];
    if (a > b) std::swap(a, b);
    enter = std::max(enter, a);
    leave = std::min(leave, b);
  }
  return enter < leave ? enter : 1e9;
}

TEST(LidarSense, every_ring_sees_what_a_slow_oracle_sees) {
  constexpr const char* kRings = R"(
interval_sim 100
model( name "a" pose [3 1 0 20] size [0.5 1 0.4] )
model( name "b" pose [-2 2 0 70] size [1 0.3 2] )
model( name "c" pose [1 -4 0.8 -30] size [2 0.5 0.3] )
model( name "d" pose [6 0 0 5] size [0.4 6 3] )
position( name "r" pose [0.3 -0.2 0 33] size [0.4 0.4 0.4] obstacle_return 0
  ranger( pose [0.05 0 0.1 0] size [0.1 0.1 0.1]
    sensor( samples 61 fov 300 range [0.2 12] rings 16 ring_fov [-15 15] ) ) )
)";
  Session run(kRings, true);
  run.step();
  const world::World& world = run.world();
  const world::ModelRow ranger = world.rangers.model[{0}];
  const scene::RangerSensorDesc& sensor = world.desc(ranger).sensors[0];
  const geom::Pose& X = world.models.X_WM[ranger];
  ASSERT_EQ(world.rangers.ring_ranges[{0}].size(), 16 * 61u);
  const geom::Vec3 p{X.x, X.y, X.z + 0.5 * sensor.size.z};
  int met = 0, on_ground = 0;
  for (std::uint32_t ring = 0; ring < 16; ++ring)
    for (std::uint32_t sample = 0; sample < 61; ++sample) {
      const double elevation = geom::radians(-15 + 2.0 * ring),
                   bearing = X.a + geom::radians(-150 + 5.0 * sample);
      const geom::Vec3 d{std::cos(elevation) * std::cos(bearing), std::cos(elevation) * std::sin(bearing),
                         std::sin(elevation)};
      double wanted = 12;
      const double ground = d.z < 0 ? p.z / -d.z : 1e9;
      for (const scene::ModelDesc& model : world.scene().models)
        if (model.kind == scene::ModelKind::kPlain) wanted = std::min(wanted, oracle(p, d, model));
      on_ground += ground < wanted;
      wanted = std::min(wanted, ground);
      EXPECT_NEAR(world.rangers.ring_ranges[{0}][ring * 61 + sample], wanted, 2e-4) << ring << " " << sample;
      met += wanted < 12;
    }
  EXPECT_GT(met, 300);
  EXPECT_GT(on_ground, 100);
}

TEST(LidarSense, the_ring_nearest_to_level_is_what_all_see_of_it) {
  const std::string text = R"(
interval_sim 100
model( name "wall" pose [3 0 0 0] size [0.2 8 1.5] )
model( name "post" pose [0 0 0 0] size [0.2 0.2 0.5]
  ranger( size [0.02 0.02 0.02] sensor( samples 5 fov 40 range [0 8] RINGS ) ) )
)";
  const auto with = [&](const char* rings) {
    std::string changed = text;
    changed.replace(changed.find("RINGS"), 5, rings);
    return changed;
  };
  Session rings(with("rings 4 ring_fov [-30 30]").c_str(), true);  // at -30, -10, 10 and 30 degrees
  rings.step();
  EXPECT_NEAR(rings.range(2), 2.9 / std::cos(geom::radians(10)), 1e-4) << "of two the upper one";
  EXPECT_EQ(rings.world().rangers.ring_ranges[{0}][2 * 5 + 2], rings.range(2));
  EXPECT_EQ(rings.world().rangers.ring_ranges[{0}][3 * 5 + 2], 8) << "over the wall";
  EXPECT_LT(rings.world().rangers.ring_ranges[{0}][2], 1.1) << "the ground";
  Session stage(with("rings 4 ring_fov [-30 30]").c_str(), false);
  stage.step();
  EXPECT_NEAR(stage.range(2), 2.9, 1e-6) << "level";
  EXPECT_TRUE(stage.world().rangers.ring_ranges[{0}].empty());
}

TEST(LidarSense, rings_of_several_sensors_follow_one_another) {
  constexpr const char* kThree = R"(
interval_sim 100
model( name "wall" pose [3 0 0 0] size [0.2 8 1.5] )
model( name "post" pose [0 0 0 0] size [0.2 0.2 0.5]
  ranger( size [0.02 0.02 0.02]
    sensor( samples 5 fov 40 range [0 8] rings 4 ring_fov [-30 30] )
    sensor( samples 9 fov 40 range [0 8] )
    sensor( samples 1 fov 0 range [0 2] rings 3 ring_fov [-5 5] ) ) )
)";
  Session three(kThree, true);
  three.step(3);
  const std::vector<float>& ranges = three.world().rangers.ring_ranges[{0}];
  ASSERT_EQ(ranges.size(), 4 * 5 + 3u) << "of the newest scan alone";
  EXPECT_EQ(three.world().rangers.ring_intensities[{0}].size(), ranges.size());
  EXPECT_EQ(ranges[2 * 5 + 2], three.range(2));
  for (std::size_t ring = 0; ring < 3; ++ring) EXPECT_EQ(ranges[4 * 5 + ring], 2) << "nothing so near";
}

TEST(LidarSense, rings_have_noise_of_their_own_and_are_the_same_for_any_number_of_workers) {
  constexpr const char* kNoisy = R"(
interval_sim 100
define lidar ranger( size [0.1 0.1 0.1]
  sensor( samples 31 fov 200 range [0 12] rings 4 ring_fov [-10 10] noise [0.02 0 0] error "lidar" noise_weak 0.1 ) )
model( name "wall" pose [5 0 0 0] size [0.2 20 4] )
position( name "r" pose [0 0 0 0] size [0.4 0.4 0.4] lidar() )
position( name "s" pose [0 2 0 0] size [0.4 0.4 0.4] lidar() )
)";
  Session one(kNoisy, true, 1), three(kNoisy, true, 3);
  one.step(3);
  three.step(3);
  EXPECT_EQ(one.world().sensed_hash(), three.world().sensed_hash());
  const std::vector<float>& ranges = one.world().rangers.ring_ranges[{0}];
  EXPECT_NE(ranges[15], ranges[3 * 31 + 15]) << "symmetric but for their noise";
}

}  // namespace
}  // namespace playhouse::arena
