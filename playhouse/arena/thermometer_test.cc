// What thermometers tell, against closed forms, in both engines; and their noise.

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/arena/testing_runs.h"

namespace playhouse::arena {
namespace {

constexpr const char* kThermometer = "thermometer( size [0.02 0.02 0.02] alwayson 1 update_interval 20 ";

struct Session : EngineRun {
  explicit Session(const std::string& text, bool arena = false, unsigned workers = 1)
      : EngineRun("interval_sim 20\n" + text, arena, workers) {}
  double temperature(world::ThermometerRow row = {0}) { return world().thermometers.temperature[row]; }
};

/// A body of 0.2 m that nothing meets, and that is 30 K warmer than the air.
std::string ball(const std::string& words) {
  return "model( size [0.2 0.2 0.2] obstacle_return 0 heat 30 heat_radius 0.5 " + words + " )\n";
}

TEST(ThermometerSense, reads_the_air_where_nothing_is_warm) {
  for (const bool arena : {false, true}) {
    Session run(
        std::string(kThermometer) + "pose [0 0 2.49 0] ambient 15 lapse 0.5 )\n" + "model( pose [3 0 0 0] )",
        arena);
    run.step(5);
    EXPECT_NEAR(run.temperature(), 15 - 0.5 * 2.5, 1e-12) << arena;
  }
}

TEST(ThermometerSense, reads_the_field_of_a_warm_ball_at_any_distance) {
  for (const bool arena : {false, true}) {
    for (const double distance : {0.0, 0.3, 0.5, 0.75, 2.0, 40.0}) {
      // The middles of both bodies are as high, at 3-4-5 in the plane.
      Session run(std::string(kThermometer) + "pose [" + std::to_string(0.6 * distance) + " " +
                      std::to_string(0.8 * distance) + " 0.09 0] ambient -5 )\n" + ball(""),
                  arena);
      run.step(2);
      EXPECT_NEAR(run.temperature(), -5 + 30 * std::min(1.0, 0.5 / distance), 1e-6) << distance << arena;
    }
  }
}

TEST(ThermometerSense, adds_up_what_is_warm_and_what_is_cold) {
  Session run(std::string(kThermometer) + "pose [0 0 0.09 0] )\n" + ball("pose [2 0 0 0]") +
              ball("pose [0 -3 0 0]") + ball("pose [0 0 4 0] heat -10"));
  run.step();
  EXPECT_NEAR(run.temperature(), 20 + 30 * 0.5 / 2 + 30 * 0.5 / 3 - 10 * 0.5 / 4, 1e-12);
}

TEST(ThermometerSense, reads_nothing_below_absolute_zero) {
  Session run(std::string(kThermometer) + ")\n" + ball("heat -1000"));
  run.step();
  EXPECT_EQ(run.temperature(), -273.15);
}

TEST(ThermometerSense, feels_the_robot_that_carries_it_come_near) {
  for (const bool arena : {false, true}) {
    Session run("position( name \"r\" size [0.4 0.4 0.2] alwayson 1 velocity [0.5 0 0 0] " +
                    std::string(kThermometer) + ") )\n" + ball("name \"stove\" pose [4 0 0 0]"),
                arena);
    run.step(100);  // 2 s
    const world::Models& models = run.world().models;
    const geom::Pose &X_WT = models.X_WM[run.world().thermometers.model[{0}]],
                     &X_WS = models.X_WM[run.world().find("stove")];
    EXPECT_GT(X_WT.x, 0.8) << arena;
    const double distance = std::hypot(X_WS.x - X_WT.x, X_WS.y - X_WT.y, X_WS.z + 0.1 - (X_WT.z + 0.01));
    EXPECT_NEAR(run.temperature(), 20 + 30 * 0.5 / distance, 1e-6) << arena;
  }
}

TEST(ThermometerSense, feels_what_is_warm_come_and_go) {
  Session run(std::string(kThermometer) + ")\n" + ball("name \"stove\" pose [0 0 0 0]"));
  run.step();
  EXPECT_NEAR(run.temperature(), 50, 1e-12);
  ASSERT_TRUE(world::despawn(run.world(), run.world().id(run.world().find("stove"))).ok());
  run.step();
  EXPECT_NEAR(run.temperature(), 20, 1e-12);
}

TEST(ThermometerSense, has_noise_of_its_own_and_of_the_seed_with_any_number_of_workers) {
  std::string text;
  for (int k = 0; k < 400; ++k) text += std::string(kThermometer) + "noise 0.5 )\n";
  Session run(text), again(text, false, 4);
  run.step(5), again.step(5);
  EXPECT_EQ(run.world().thermometers.temperature, again.world().thermometers.temperature);
  double sum = 0, squares = 0;
  for (const double each : run.world().thermometers.temperature)
    sum += each - 20, squares += (each - 20) * (each - 20);
  // Five standard errors of 400 draws: of their mean, and of their variance.
  EXPECT_NEAR(sum / 400, 0, 5 * 0.5 / 20);
  EXPECT_NEAR(squares / 400, 0.25, 5 * 0.25 * std::sqrt(2.0 / 400));
  const double before = run.temperature();
  run.step();
  EXPECT_NE(run.temperature(), before);
}

}  // namespace
}  // namespace playhouse::arena
