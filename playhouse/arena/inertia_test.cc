// What inertial units and satellite receivers tell, against closed forms, in both engines; and their errors.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "playhouse/arena/testing_runs.h"

namespace playhouse::arena {
namespace {

using geom::Vec3;

constexpr double kGravity = 9.81;

struct Session : EngineRun {
  using EngineRun::EngineRun;
  world::Imus& imus() { return world().imus; }
  world::Receivers& receivers() { return world().receivers; }
};

void expect_near(const Vec3& is, const Vec3& wanted, double error) {
  EXPECT_NEAR(is.x, wanted.x, error);
  EXPECT_NEAR(is.y, wanted.y, error);
  EXPECT_NEAR(is.z, wanted.z, error);
}

/// A robot that drives in a circle, with a unit `ahead` of its middle.
std::string circle(double v, double degrees, double ahead) {
  return "interval_sim 10\nposition( name \"r\" size [0.4 0.4 0.3] alwayson 1 velocity [" +
         std::to_string(v) + " 0 0 " + std::to_string(degrees) + "] imu( pose [" + std::to_string(ahead) +
         " 0 0 0] alwayson 1 update_interval 10 ) )\n";
}

TEST(ImuSense, feels_the_centripetal_acceleration_and_the_turn_of_a_circle) {
  const double v = 0.8, w = geom::radians(60);
  Session run(circle(v, 60, 0), false);
  for (int tick = 0; tick < 300; ++tick) {
    run.step();
    if (tick < 2) continue;  // the robot sets off
    // A tick goes straight ahead, so that half a tick's turn is lost.
    expect_near(run.imus().reading[{0}].v, {0, v * w, kGravity}, 1.01 * v * w * 0.5 * w * 0.01);
    expect_near(run.imus().reading[{0}].w, {0, 0, w}, 1e-9);
  }
}

TEST(ImuSense, feels_more_the_further_it_is_from_where_the_robot_turns) {
  const double w = geom::radians(80);
  Session run(circle(0, 80, 0.15), false);
  run.step(20);
  expect_near(run.imus().reading[{0}].v, {-0.15 * w * w, 0, kGravity}, 1e-3);
}

TEST(ImuSense, knows_where_it_is_as_long_as_it_has_no_errors) {
  for (const bool arena : {false, true}) {
    Session run(circle(0.5, 40, 0.1), arena);
    run.step(500);
    const geom::Pose &is = run.imus().X_WB[{0}], &believed = run.imus().X_WE[{0}];
    EXPECT_NEAR(believed.x, is.x, 1e-6) << arena;
    EXPECT_NEAR(believed.y, is.y, 1e-6) << arena;
    EXPECT_NEAR(believed.z, is.z, 1e-6) << arena;
    EXPECT_NEAR(geom::normalize(believed.a - is.a), 0, 1e-9) << arena;
    EXPECT_GT(std::hypot(is.x, is.y), 0.3) << arena;
  }
}

constexpr const char* kBox = R"(
interval_sim 10
model( name "box" pose [0 0 3 0] size [0.3 0.3 0.3] gripper_return 1
  imu( pose [0 0 -0.15 30] alwayson 1 update_interval 10 ) )
)";

TEST(ImuSense, feels_nothing_in_free_fall_and_the_ground_afterwards) {
  Session run(kBox, true);
  run.step(30);
  expect_near(run.imus().reading[{0}].v, {0, 0, 0}, 1e-2);
  EXPECT_LT(run.imus().X_WB[{0}].z, 3);
  run.step(400);
  expect_near(run.imus().reading[{0}].v, {0, 0, kGravity}, 1e-2);
}

TEST(ImuSense, tells_a_slope_by_gravity) {
  Session run(kBox, true);
  const world::ModelRow box = run.world().find("box");
  const geom::Tilt tilt{0, 0.35};
  run.world().models.tilt_PM.set(box, tilt);
  run.world().models.still.set(box, 1000);  // rests as it stands
  world::place_tree(run.world(), box);
  run.step(3);
  // Nose down by 0.35, as seen by a unit that is turned by 30 degrees on it.
  const double down = -kGravity * std::sin(0.35), c = std::cos(geom::radians(30)),
               s = std::sin(geom::radians(30));
  expect_near(run.imus().reading[{0}].v, {c * down, -s * down, kGravity * std::cos(0.35)}, 1e-9);
  expect_near(run.imus().reading[{0}].w, {0, 0, 0}, 1e-9);
  const geom::RollPitchYaw told = geom::roll_pitch_yaw(run.imus().X_WE[{0}].a, run.imus().tilt_WE[{0}]);
  const geom::RollPitchYaw is = geom::roll_pitch_yaw(run.imus().X_WB[{0}].a, run.imus().tilt_WB[{0}]);
  EXPECT_NEAR(told.pitch, is.pitch, 1e-9);
  EXPECT_NEAR(told.roll, is.roll, 1e-9);
  EXPECT_GT(std::fabs(is.pitch), 0.2);
}

TEST(ImuSense, reads_no_more_than_its_range) {
  Session run(R"(
interval_sim 10
position( name "r" alwayson 1 velocity [1 0 0 170] velocity_bounds [-2 2 -2 2 -2 2 -200 200]
  imu( pose [0.2 0 0 0] alwayson 1 update_interval 10 acceleration_range 1.5 gyro_range 2 ) )
)",
              false);
  run.step(10);
  EXPECT_EQ(run.imus().reading[{0}].v.x, -1.5);
  EXPECT_EQ(run.imus().reading[{0}].v.z, 1.5);
  EXPECT_EQ(run.imus().reading[{0}].w.z, 2);
}

struct Moments {
  double mean = 0, deviation = 0;
};
Moments moments(const std::vector<double>& all) {
  const double n = static_cast<double>(all.size());
  const double mean = std::accumulate(all.begin(), all.end(), 0.0) / n;
  double sum = 0;
  for (const double each : all) sum += (each - mean) * (each - mean);
  return {mean, std::sqrt(sum / (n - 1))};
}

TEST(ImuSense, white_noise_has_the_deviation_of_its_density) {
  Session run(R"(
interval_sim 10
model( imu( alwayson 1 update_interval 40 acceleration_noise [0.004 0] gyro_noise [0.0001 0] ) )
)",
              false);
  std::vector<double> f, w;
  for (int i = 0; i < 4000; ++i) {
    run.step(4);
    f.push_back(run.imus().reading[{0}].v.y);
    w.push_back(run.imus().reading[{0}].w.x);
  }
  // Of 4,000 values the deviation is known to 1.1 %, the mean to 1.6 % of it.
  EXPECT_NEAR(moments(f).deviation, 0.004 / 0.2, 0.05 * 0.02);
  EXPECT_NEAR(moments(f).mean, 0, 0.05 * 0.02 * 2);
  EXPECT_NEAR(moments(w).deviation, 0.0001 / 0.2, 0.05 * 0.0005);
}

TEST(ImuSense, a_bias_begins_anywhere_and_wanders_with_the_root_of_time) {
  std::string text = "interval_sim 100\n";
  for (int i = 0; i < 600; ++i)
    text += "model( pose [" + std::to_string(i) +
            " 0 0 0] imu( alwayson 1 acceleration_noise [0 0.02] acceleration_bias 0.3 gyro_bias 0.01 ) )\n";
  Session run(text, false);
  run.step();
  const auto biases = [&] {
    std::vector<double> all;
    for (const geom::SpatialVelocity& bias : run.imus().bias)
      all.insert(all.end(), {bias.v.x, bias.v.y, bias.v.z});
    return all;
  };
  const std::vector<double> first = biases();
  EXPECT_NEAR(moments(first).deviation, 0.3, 0.3 * 0.06);
  run.step(250);
  std::vector<double> way = biases();
  for (std::size_t i = 0; i < way.size(); ++i) way[i] -= first[i];
  EXPECT_NEAR(moments(way).deviation, 0.02 * std::sqrt(25.0), 0.1 * 0.06);
}

TEST(ImuSense, its_heading_drifts_as_its_gyroscope_errs_and_its_level_as_its_accelerometers_do) {
  Session run(R"(
interval_sim 100
model( imu( alwayson 1 acceleration_bias 0.1 gyro_bias 0.01 ) )
)",
              false);
  run.step(200);
  const geom::SpatialVelocity& bias = run.imus().bias[{0}];
  EXPECT_NE(bias.w.z, 0);
  EXPECT_NEAR(run.imus().heading_error[{0}], 20 * bias.w.z, 1e-9);
  const geom::RollPitchYaw told = geom::roll_pitch_yaw(run.imus().X_WE[{0}].a, run.imus().tilt_WE[{0}]);
  const Vec3& f = run.imus().reading[{0}].v;
  EXPECT_NEAR(told.roll, std::atan2(f.y, f.z), 1.5e-3) << "as its own accelerometers have it";
  EXPECT_NEAR(told.pitch, std::atan2(-f.x, f.z), 1.5e-3);
}

TEST(GpsSense, tells_where_it_is_and_how_it_moves) {
  for (const bool arena : {false, true}) {
    Session run(R"(
interval_sim 10
position( name "r" size [0.4 0.4 0.3] pose [3 4 0 90] alwayson 1 velocity [0.5 0 0 0] gps( pose [0 0 0 0] alwayson 1 ) )
)",
                arena);
    run.step(300);
    const world::ModelRow gps = run.world().find("r.gps:0");
    const geom::Pose& X = run.world().models.X_WM[gps];
    EXPECT_NEAR(run.receivers().position[{0}].x, X.x, 1e-9) << arena;
    EXPECT_NEAR(run.receivers().position[{0}].y, X.y, 0.05) << "measured up to 0.1 s ago";
    EXPECT_NEAR(run.receivers().velocity[{0}].y, 0.5, 0.01);
    EXPECT_NEAR(run.receivers().velocity[{0}].x, 0, 0.01);
  }
}

TEST(GpsSense, what_varies_slowly_is_a_gauss_markov_process) {
  std::string text = "interval_sim 1000\n";
  for (int i = 0; i < 1000; ++i)
    text += "model( pose [" + std::to_string(i) +
            " 0 0 0] gps( alwayson 1 drift [2 3] drift_time 40 noise [0 0] ) )\n";
  Session run(text, false);
  run.step();
  const auto errors = [&] {
    std::vector<double> all;
    for (const geom::Vec3& drift : run.receivers().drift) all.push_back(drift.y);
    return all;
  };
  const std::vector<double> before = errors();
  run.step(20);
  const std::vector<double> after = errors();
  EXPECT_NEAR(moments(before).deviation, 2, 2 * 0.1);
  EXPECT_NEAR(moments(after).deviation, 2, 2 * 0.1);
  double together = 0;
  for (std::size_t i = 0; i < before.size(); ++i) together += before[i] * after[i] / (1000 * 4.0);
  EXPECT_NEAR(together, std::exp(-20 / 40.0), 0.13);
  std::vector<double> up;
  for (const geom::Vec3& position : run.receivers().position) up.push_back(position.z);
  EXPECT_NEAR(moments(up).deviation, 3, 3 * 0.1);
}

constexpr const char* kNoisy = R"(
interval_sim 20
define rover position( size [0.4 0.4 0.3] alwayson 1 velocity [0.4 0 0 30]
  imu( alwayson 1 update_interval 20 acceleration_noise [0.01 0.01] gyro_noise [0.001 0.001] gyro_bias 0.01 )
  gps( alwayson 1 noise [1 2] drift [2 2] velocity_noise 0.1 ) )
rover( pose [0 0 0 0] )
rover( pose [2 0 0 0] )
rover( pose [4 0 0 0] )
)";

TEST(ImuSense, is_the_same_for_any_number_of_workers_and_who_opens_it_later_sees_no_jump) {
  for (const bool arena : {false, true}) {
    Session one(kNoisy, arena, 1), three(kNoisy, arena, 3);
    one.step(100);
    three.step(100);
    EXPECT_EQ(one.world().sensed_hash(), three.world().sensed_hash()) << arena;
    EXPECT_NE(one.imus().reading[{0}].w.z, one.imus().reading[{1}].w.z) << "errors of their own";
  }
  Session late(R"(
interval_sim 10
position( name "r" alwayson 1 velocity [0.9 0 0 0] imu( update_interval 10 ) )
)",
               false);
  late.step(50);
  world::subscribe(late.world(), late.imus().model[{0}]);
  for (int tick = 0; tick < 5; ++tick) {
    late.step();
    expect_near(late.imus().reading[{0}].v, {0, 0, kGravity}, 1e-6);
  }
}

// The phase is that of the stage engine; here what it feels is where contacts hold the robot.
TEST(BumperSense, feels_what_a_robot_pushes_and_nothing_once_it_has_backed_away) {
  Session run(R"(
interval_sim 20
model( name "wall" pose [1.05 0 0 0] size [0.1 4 1] )
position( name "r" size [0.4 0.4 0.3] alwayson 1 velocity [0.4 0 0 0]
  bumper( size [0.4 0.4 0.1] noblocks 1 alwayson 1 bcount 2 blength 0.3
    bpose[0] [0.201 0 0 0] bpose[1] [-0.201 0 0 180] ) )
)",
              true);
  const auto pressed = [&] {
    const std::vector<world::ModelId>& hits = run.world().bumpers.hits[{0}];
    return std::pair(static_cast<bool>(hits[0]), static_cast<bool>(hits[1]));
  };
  run.step(50);
  EXPECT_EQ(pressed(), std::pair(false, false)) << "on its way";
  run.step(150);
  EXPECT_EQ(pressed(), std::pair(true, false)) << "against the wall";
  run.world().positions.command[{0}] = {-0.4, 0, 0, 0};
  run.step(50);
  EXPECT_EQ(pressed(), std::pair(false, false));
}

TEST(BumperSense, feels_what_is_as_high_as_its_robot_and_nothing_above) {
  const auto pressed = [](const std::string& thing) {
    Session run(R"(
interval_sim 20
position( name "r" size [0.4 0.4 0.3] alwayson 1
  bumper( size [0.4 0.4 0.1] noblocks 1 alwayson 1 bcount 1 blength 0.3 bpose[0] [0.25 0 0 0] ) )
model( pose [0.3 0 )" +
                    thing + R"( 0] size [0.2 1 0.1] gui_move 0 )
)",
                true);
    run.step(5);
    return static_cast<bool>(run.world().bumpers.hits[{0}][0]);
  };
  EXPECT_TRUE(pressed("0"));
  EXPECT_TRUE(pressed("0.35")) << "it stands on the robot";
  EXPECT_FALSE(pressed("0.45")) << "a beam above it";
}

}  // namespace
}  // namespace playhouse::arena
