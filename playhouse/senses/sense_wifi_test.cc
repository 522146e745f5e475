// Which radios a radio hears, and how strongly.

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/scene/world_loader.h"
#include "playhouse/senses/radio.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::senses {
namespace {

scene::WifiDesc radio(scene::Propagation propagation = scene::Propagation::kFriis) {
  scene::WifiDesc desc;
  desc.propagation = propagation;
  return desc;
}

void add(scene::SceneDesc& scene, double x, double y, const scene::WifiDesc& desc = radio()) {
  scene::ModelDesc& model = scene.models.emplace_back();
  model.name = model.alias = "radio" + std::to_string(scene.models.size());
  model.type = "wifi";
  model.kind = scene::ModelKind::kWifi;
  model.X_PM = {x, y, 0.2, 0};
  model.alwayson = true;
  model.wifi = desc;
}

/// What the first radio of a scene hears in its first tick.
std::vector<world::WifiLink> heard_in(const scene::SceneDesc& scene, unsigned workers = 1) {
  auto engine = stage::make_engine(scene, {.seed = 1, .workers = workers});
  EXPECT_TRUE(engine.ok());
  (*engine)->step();
  EXPECT_EQ((*engine)->world().wifis.measured_tick[{0}], 1u);
  return (*engine)->world().wifis.links[{0}];
}

TEST(Radio, waves_get_weaker_as_the_formulas_say) {
  EXPECT_NEAR(path_loss(radio(), 2450, 1), 40.23, 0.01);    // Friis at a metre
  EXPECT_NEAR(path_loss(radio(), 2450, 100), 80.23, 0.01);  // 20 dB a decade
  EXPECT_NEAR(path_loss(radio(), 245, 100), 60.23, 0.01);
  scene::WifiDesc indoor = radio(scene::Propagation::kItuIndoor);
  EXPECT_NEAR(path_loss(indoor, 2450, 10), 20 * std::log10(2450) + 30 - 28, 1e-9);
  scene::WifiDesc outdoor = radio(scene::Propagation::kLogDistance);
  outdoor.ple = 4;
  EXPECT_NEAR(path_loss(outdoor, 2450, 10), 40.23 + 40, 0.01);
  EXPECT_EQ(path_loss(radio(), 1, 0), 0) << "nothing is won";
}

TEST(Radio, is_heard_as_far_as_its_budget_lasts) {
  for (const auto propagation : {scene::Propagation::kFriis, scene::Propagation::kItuIndoor,
                                 scene::Propagation::kLogDistance, scene::Propagation::kRaytrace}) {
    const scene::WifiDesc desc = radio(propagation);
    const double far = farthest_heard(desc, 15, 2450);
    EXPECT_LE(path_loss(desc, 2450, far * 0.999), 85);
    EXPECT_GE(path_loss(desc, 2450, far * 1.001), 85);
  }
  EXPECT_EQ(farthest_heard(radio(scene::Propagation::kSimple), 15, 2450), 30);
  EXPECT_EQ(farthest_heard(radio(), 400, 2450), 1e6);
  EXPECT_EQ(farthest_heard(radio(), -300, 2450), 0);
}

TEST(WifiSense, hears_who_is_near_enough_in_the_order_of_ids) {
  scene::SceneDesc scene;
  scene::WifiDesc simple = radio(scene::Propagation::kSimple);
  simple.range = 10;
  add(scene, 0, 0, simple);
  add(scene, 9, 0);
  add(scene, 11, 0);
  add(scene, 0, -5);
  const std::vector<world::WifiLink> links = heard_in(scene);
  ASSERT_EQ(links.size(), 2u);
  EXPECT_EQ(links[0].station.value, 1u);
  EXPECT_EQ(links[1].station.value, 3u);
  EXPECT_NEAR(links[0].level, 15 - path_loss(simple, 2450, 9), 1e-9);
  EXPECT_GT(links[1].quality, links[0].quality);
}

TEST(WifiSense, does_not_hear_other_networks_nor_what_is_too_weak) {
  scene::SceneDesc scene;
  add(scene, 0, 0);
  scene::WifiDesc other = radio();
  other.essid = "elsewhere";
  add(scene, 1, 0, other);
  scene::WifiDesc weak = radio();
  weak.power = -60;
  add(scene, 2, 0, weak);
  EXPECT_TRUE(heard_in(scene).empty());
}

TEST(WifiSense, counts_each_wall_on_the_way_once) {
  scene::SceneDesc scene;
  add(scene, 0, 0.1, radio(scene::Propagation::kRaytrace));
  add(scene, 20, 0.1);
  const double free = heard_in(scene).at(0).level;
  for (const double x : {5.0, 12.0})
    scene.models.push_back(stage::testing::box("wall" + std::to_string(x), {x, 0, 0, 0}, {0.2, 30, 1}));
  scene.models.push_back(stage::testing::box("low", {8, 0, 0, 0}, {0.2, 30, 0.1}));
  scene.models.push_back(stage::testing::box("aside", {8, 30, 0, 0}, {0.2, 3, 1}));
  EXPECT_NEAR(heard_in(scene).at(0).level, free - 10, 1e-9);
}

TEST(WifiSense, fades_from_tick_to_tick_as_much_as_it_says) {
  scene::SceneDesc scene;
  scene::WifiDesc fading = radio();
  fading.fading = 4;
  add(scene, 0, 0, fading);
  add(scene, 5, 0);
  auto engine = *stage::make_engine(scene, {.seed = 3, .workers = 1});
  const double clear = 15 - path_loss(radio(), 2450, 5);
  double sum = 0, squares = 0;
  constexpr int kTicks = 2000;
  for (int tick = 0; tick < kTicks; ++tick) {
    engine->step();
    const double off = engine->world().wifis.links[{0}].at(0).level - clear;
    sum += off;
    squares += off * off;
  }
  EXPECT_NEAR(sum / kTicks, 0, 0.4);
  EXPECT_NEAR(std::sqrt(squares / kTicks), 4, 0.3);
}

TEST(WifiSense, is_the_same_for_any_number_of_workers) {
  scene::SceneDesc scene;
  for (int i = 0; i < 200; ++i) {
    scene::WifiDesc desc = radio(scene::Propagation::kLogDistance);
    desc.fading = 3;
    add(scene, i % 20 * 7.0, i / 20 * 7.0, desc);
  }
  std::vector<std::uint64_t> hashes;
  for (const unsigned workers : {1u, 3u}) {
    auto engine = *stage::make_engine(scene, {.seed = 3, .workers = workers});
    for (int tick = 0; tick < 5; ++tick) engine->step();
    hashes.push_back(engine->world().sensed_hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(WifiSense, reads_what_old_worlds_say_of_radios) {
  config::MemoryFiles none({});
  const auto scene = scene::load_world_text(R"(
position( name "robot" wifi( ip "192.168.0.2" mac "08:00:20:ae:fd:7e" essid "test network" model "ITU indoor"
  power 30 sensitivity -70 plc 30 ) ))",
                                            "old.world", none);
  ASSERT_TRUE(scene.ok()) << scene.error().text;
  const scene::WifiDesc& desc = *scene->models.at(1).wifi;
  EXPECT_EQ(desc.ip, "192.168.0.2");
  EXPECT_EQ(desc.essid, "test network");
  EXPECT_EQ(desc.propagation, scene::Propagation::kItuIndoor);
  EXPECT_EQ(desc.power, 30);
  EXPECT_EQ(desc.sensitivity, -70);
}

}  // namespace
}  // namespace playhouse::senses
