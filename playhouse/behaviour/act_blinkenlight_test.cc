#include <gtest/gtest.h>

#include <string>

#include "playhouse/behaviour/generated/acts.h"

namespace playhouse::behaviour {
namespace {

/// A lamp that somebody has open, in a world of ten ticks a second.
class Lamp {
 public:
  Lamp(double period, double dutycycle, bool enabled = true)
      : scene_(make_scene(period, dutycycle, enabled)), world(scene_, 1) {
    world::subscribe(world, {0});
  }

  /// What it shows in these ticks: '*' where it is lit.
  std::string shown(int ticks) {
    std::string text;
    for (int k = 0; k < ticks; ++k) {
      phase_->act(world, workers_);
      ++world.tick_;
      text += world.blinkenlights.lit[{0}] ? '*' : '.';
    }
    return text;
  }

 private:
  static scene::SceneDesc make_scene(double period, double dutycycle, bool enabled) {
    scene::SceneDesc scene;
    scene::ModelDesc& lamp = scene.models.emplace_back();
    lamp.kind = scene::ModelKind::kBlinkenlight;
    lamp.blinkenlight = {period, dutycycle, enabled};
    return scene;
  }

  scene::SceneDesc scene_;
  world::Workers workers_{1};
  std::unique_ptr<ActPhase> phase_ = make_blinkenlight_act();

 public:
  world::World world;
};

TEST(Blinkenlight, is_lit_for_its_share_of_each_period) {
  EXPECT_EQ(Lamp(1, 0.3).shown(21), "**.......***.......**") << "ticks 1 to 21";
  EXPECT_EQ(Lamp(0.2, 0.5).shown(6), ".*.*.*");
  EXPECT_EQ(Lamp(0.25, 0.5).shown(10), "*.*.**.*.*") << "a period of no whole number of ticks";
}

TEST(Blinkenlight, burns_steadily_without_a_period_or_with_all_of_it_and_never_with_none) {
  EXPECT_EQ(Lamp(0, 0.3).shown(5), "*****");
  EXPECT_EQ(Lamp(1, 1).shown(11), "***********");
  EXPECT_EQ(Lamp(1, 0).shown(11), "...........");
}

TEST(Blinkenlight, is_dark_while_it_is_off_and_goes_on_in_step) {
  Lamp lamp(1, 0.5, false);
  EXPECT_EQ(lamp.shown(3), "...");
  lamp.world.blinkenlights.enabled[{0}] = 1;
  EXPECT_EQ(lamp.shown(8), "*.....**");
}

TEST(Blinkenlight, that_nobody_has_open_is_lit_while_it_is_on) {
  Lamp lamp(0.2, 0.5);
  world::unsubscribe(lamp.world, {0});
  EXPECT_EQ(lamp.shown(4), "****");
  lamp.world.blinkenlights.enabled[{0}] = 0;
  EXPECT_EQ(lamp.shown(2), "..");
  world::subscribe(lamp.world, {0});
  lamp.world.blinkenlights.enabled[{0}] = 1;
  EXPECT_EQ(lamp.shown(4), ".*.*");
}

TEST(Blinkenlight, shows_the_same_for_any_number_of_workers) {
  scene::SceneDesc scene;
  for (int k = 0; k < 5000; ++k) {
    scene::ModelDesc& lamp = scene.models.emplace_back();
    lamp.kind = scene::ModelKind::kBlinkenlight;
    lamp.alwayson = true;
    lamp.blinkenlight = {0.1 * (k % 17), 0.1 * (k % 11), k % 5 != 0};
  }
  std::vector<std::uint8_t> lit[2];
  for (int run = 0; run < 2; ++run) {
    world::World world(scene, 1);
    world::Workers workers(1 + 2 * static_cast<unsigned>(run));
    world.tick_ = 7;
    make_blinkenlight_act()->act(world, workers);
    lit[run] = world.blinkenlights.lit;
  }
  EXPECT_EQ(lit[0], lit[1]);
}

}  // namespace
}  // namespace playhouse::behaviour
