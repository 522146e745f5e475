// What comes back of light: the laws of the error model, and what a lidar makes of mirrors, glass and black.

#include "playhouse/arena/sensing/lidar_echo.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/arena/engine.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/population/population.h"

namespace playhouse::arena {
namespace {

struct Reading {
  float range, intensity;
};

/// What the middle beam of a lidar at the origin, 0.25 m above the ground, reads along x.
class Lidar {
 public:
  explicit Lidar(const std::string& models, const std::string& words = "") {
    const std::string text = "interval_sim 100\n" + models + R"(
model( name "lidar" size [0.1 0.1 0.2]
  ranger( size [0.1 0.1 0.1] sensor( samples 3 fov 2 range [0 50] error "lidar" range_dark 10 )" +
                             words + " ) ) )\n";
    config::MemoryFiles files({{"w.world", text}});
    Result<scene::SceneDesc> loaded = scene::load_world_text(text, "w.world", files);
    EXPECT_TRUE(loaded) << loaded.error().line();
    scene_ = std::make_unique<scene::SceneDesc>(std::move(*loaded));
    engine_ = *make_engine(*scene_, {.seed = 1, .workers = 1});
    world::subscribe(engine_->world(), engine_->world().rangers.model[{0}]);
  }
  Reading read() {
    engine_->step();
    return {engine_->world().sensors.ranges[{1}], engine_->world().sensors.intensities[{1}]};
  }

 private:
  std::unique_ptr<scene::SceneDesc> scene_;
  std::unique_ptr<world::Engine> engine_;
};

/// A wall whose face is at x, turned by degrees.
std::string wall(double x, const std::string& words, double degrees = 0) {
  const double middle = x + 0.05 / std::cos(geom::radians(degrees));
  return "model( pose [" + std::to_string(middle) + " 0 0 " + std::to_string(degrees) + "] size [0.1 8 3] " +
         words + " )\n";
}

TEST(LidarEcho, what_comes_back_falls_with_the_cosine_and_with_the_square_of_the_distance) {
  const Reading square = Lidar(wall(4, "material \"paper\"")).read();
  EXPECT_NEAR(square.range, 4, 1e-4);
  EXPECT_NEAR(square.intensity, 90, 1e-2) << "percent, at any distance";
  EXPECT_NEAR(Lidar(wall(9, "material \"paper\"")).read().intensity, 90, 1e-2);
  EXPECT_NEAR(Lidar(wall(4, "material \"paper\"", 60)).read().intensity, 45, 1e-2);
  EXPECT_NEAR(echo_power(0.8, 6), echo_power(0.8, 3) / 4, 1e-15);
}

TEST(LidarEcho, what_is_too_dark_is_not_seen) {
  // A tenth is seen up to 10 m, so a share of rho at the cosine c up to 10 sqrt(10 rho c).
  const struct {
    const char* material;
    double share, degrees;
  } kCases[] = {{"rubber", 0.02, 0},   {"neoprene", 0.05, 0}, {"asphalt", 0.17, 0},
                {"concrete", 0.24, 0}, {"paper", 0.9, 0},     {"paper", 0.9, 60}};
  for (const auto& each : kCases) {
    const double farthest = 10 * std::sqrt(10 * each.share * std::cos(geom::radians(each.degrees)));
    const std::string words = std::string("material \"") + each.material + "\"";
    EXPECT_NEAR(Lidar(wall(0.99 * farthest, words, each.degrees)).read().range, 0.99 * farthest, 1e-3)
        << each.material;
    const Reading beyond = Lidar(wall(1.01 * farthest, words, each.degrees)).read();
    EXPECT_EQ(beyond.range, 50) << each.material;
    EXPECT_EQ(beyond.intensity, 0) << each.material;
  }
}

TEST(LidarEcho, without_a_material_the_colour_counts_and_a_reflector_is_brighter) {
  EXPECT_EQ(Lidar(wall(6, "color \"black\"")).read().range, 50);
  EXPECT_NEAR(Lidar(wall(6, "color \"white\"")).read().range, 6, 1e-3);
  EXPECT_NEAR(Lidar(wall(6, "color \"white\"")).read().intensity, 90, 1e-2);
  EXPECT_NEAR(Lidar(wall(6, "color \"red\"")).read().intensity, 21.26, 1e-2);
  EXPECT_NEAR(Lidar(wall(6, "color \"black\" ranger_return 50")).read().intensity, 100, 1e-2);
}

TEST(LidarEcho, a_mirror_shows_what_it_mirrors_as_far_away_as_the_light_goes) {
  const std::string mirror = wall(3, "material \"mirror\"", 45);
  // Along x to the mirror at 3 m, and from there along +y or -y: a sheet on either side of it.
  const std::string sheets =
      "model( pose [3 4.05 0 90] size [0.1 8 3] material \"paper\" )\n"
      "model( pose [3 -4.05 0 90] size [0.1 8 3] material \"paper\" )\n";
  const Reading shown = Lidar(mirror + sheets).read();
  EXPECT_NEAR(shown.range, 3 + 4, 2e-3);
  EXPECT_NEAR(shown.intensity, 90 * 0.9 * 0.9, 1e-2) << "there and back";
  EXPECT_EQ(Lidar(mirror).read().range, 50) << "nothing to mirror";
  EXPECT_NEAR(Lidar(wall(3, "material \"mirror\"")).read().range, 3, 1e-4) << "straight on it is bright";
}

TEST(LidarEcho, glass_lets_light_through_but_when_it_is_very_slanted) {
  const std::string behind = wall(6, "material \"paper\"");
  const Reading seen = Lidar(wall(3, "material \"glass\"", 30) + behind).read();
  EXPECT_NEAR(seen.range, 6, 5e-3);
  EXPECT_LT(seen.intensity, 0.9f * 90);
  EXPECT_GT(seen.intensity, 0.7f * 90);
  EXPECT_EQ(Lidar(wall(3, "material \"glass\"", 30)).read().range, 50);
  const Optics slanted = met_at(optics_of("glass"), std::cos(geom::radians(87)));
  EXPECT_GT(slanted.mirrors, slanted.passes);
}

TEST(LidarEcho, weak_echoes_are_less_exact) {
  // White at 10 m returns nine times the power of the weakest that is seen.
  Lidar lidar(wall(10, "material \"paper\""), "noise_weak 0.45");
  double sum = 0, squares = 0;
  constexpr int kReadings = 3000;
  for (int i = 0; i < kReadings; ++i) {
    const double error = static_cast<double>(lidar.read().range) - 10;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(std::sqrt(squares / kReadings), 0.45 / 9, 0.05 * 0.07);
  EXPECT_NEAR(sum / kReadings, 0, 0.005);
}

TEST(LidarEcho, light_that_is_mirrored_for_ever_ends) {
  const std::string mirrors =
      "model( pose [3.05 0 0 2] size [0.1 8 3] material \"mirror\" )\n"
      "model( pose [-3.05 0 0 0] size [0.1 8 3] material \"mirror\" )\n";
  EXPECT_EQ(Lidar(mirrors).read().range, 50);
}

}  // namespace
}  // namespace playhouse::arena
