// Charging by contact, and that energy is the same for any number of workers and after a load. What is drawn
// is tested in behaviour/energy_test.cc.

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "playhouse/bodies/overlap.h"
#include "playhouse/bodies/touch.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/world/saving/state.h"
#include "playhouse/world/traits.h"

namespace playhouse::stage {
namespace {

using geom::Vec2;

/// Robots of 0.4 m, each with a bump in front that takes 20 W, and stations.
constexpr const char* kMacros = R"(
interval_sim 100
define bump model( size [0.1 0.1 0.1] take_watts 20 obstacle_return 0 )
define robot position( size [0.4 0.4 0.3] joules 10 joules_capacity 100 alwayson 1 obstacle_return 0
  bump( pose [0.25 0 0 0] ) )
define station model( size [0.2 0.2 0.5] joules -1 give_watts 50 alwayson 1 obstacle_return 0 )
)";

class Charging : public ::testing::Test {
 protected:
  void make(const std::string& text, unsigned workers = 1) {
    config::MemoryFiles none({});
    auto loaded = scene::load_world_text(kMacros + text, "test.world", none);
    ASSERT_TRUE(loaded) << loaded.error().line();
    engine_.reset();  // it refers to the scene
    scene_ = std::move(*loaded);
    engine_ = *make_engine(scene_, {.seed = 1, .workers = workers});
  }
  world::World& world() { return engine_->world(); }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) engine_->step();
  }
  world::PackRow pack(const char* model) { return world::pack_of(world(), world().find(model)); }
  double stored(const char* model) { return world().packs.stored[pack(model)]; }
  bool is_charging(const char* model) { return world().packs.charging[pack(model)] != 0; }
  double watts(const char* model) { return world().packs.watts[pack(model)]; }

  scene::SceneDesc scene_;
  std::unique_ptr<world::Engine> engine_;
};

TEST_F(Charging, is_of_what_touches_the_giver_with_the_part_that_takes) {
  make(R"(station( name "s" ) robot( name "in" pose [-0.3 0 0 0] ) robot( name "edge" pose [-0.4 0.05 0 0] )
          robot( name "off" pose [-0.41 0 0 0] ) robot( name "tail" pose [0.2 0 0 0] ))");
  run(1);
  EXPECT_TRUE(is_charging("in"));
  EXPECT_DOUBLE_EQ(stored("in"), 10 + (20 - 1) * 0.1) << "less what the robot draws";
  EXPECT_DOUBLE_EQ(watts("in"), 1 - 20);
  EXPECT_TRUE(is_charging("edge")) << "it touches";
  EXPECT_FALSE(is_charging("off"));
  EXPECT_FALSE(is_charging("tail")) << "only its body is there";
  EXPECT_DOUBLE_EQ(watts("s"), 2 * 20);
  EXPECT_LT(stored("s"), 0);
}

TEST_F(Charging, ends_when_the_robot_leaves) {
  make(R"(station( name "s" ) robot( name "r" pose [-0.35 0 0 0] velocity [-0.5 0 0 0] ))");
  run(1);
  EXPECT_TRUE(is_charging("r"));
  run(1);
  EXPECT_FALSE(is_charging("r"));
  EXPECT_EQ(watts("s"), 0);
}

TEST_F(Charging, fills_no_more_than_there_is_room_for) {
  make(R"(station( name "s" ) robot( name "r" pose [-0.3 0 0 0] joules 99 joules_capacity 100 ))");
  run(3);
  EXPECT_DOUBLE_EQ(stored("r"), 100);
  EXPECT_NEAR(watts("s"), 1, 1e-9) << "what is drawn from a full one";
}

TEST_F(Charging, takes_no_more_than_the_giver_has) {
  make(R"(station( name "s" joules 3 ) robot( name "r" pose [-0.3 0 0 0] ))");
  run(3);
  EXPECT_DOUBLE_EQ(stored("s"), 0);
  EXPECT_DOUBLE_EQ(stored("r"), 10 + 3 - 0.3);
  EXPECT_FALSE(is_charging("r"));
}

TEST_F(Charging, needs_somebody_to_subscribe_the_giver_and_leave_of_both) {
  make(R"(station( name "s" alwayson 0 ) robot( name "r" pose [-0.3 0 0 0] ))");
  run(1);
  EXPECT_FALSE(is_charging("r"));
  world::subscribe(world(), world().find("s"));
  run(1);
  EXPECT_TRUE(is_charging("r"));
  world().packs.takes[pack("r")] = 0;
  run(1);
  EXPECT_FALSE(is_charging("r"));
  world().packs.takes[pack("r")] = 1;
  world().packs.gives[pack("s")] = 0;
  run(1);
  EXPECT_FALSE(is_charging("r"));
}

TEST_F(Charging, is_never_of_the_own_tree) {
  make(R"(robot( name "r" give_watts 5 bump( pose [0 0 0 0] ) ))");
  run(1);
  EXPECT_FALSE(is_charging("r"));
}

TEST_F(Charging, passes_from_robot_to_robot_and_to_what_stands_still) {
  make(R"(robot( name "giver" give_watts 5 joules 50 ) robot( name "taker" pose [-0.4 0 0 0] )
          bump( name "bank" pose [0.2 0 5 0] joules_capacity 40 ))");
  run(1);
  EXPECT_DOUBLE_EQ(stored("taker"), 10 + (5 - 1) * 0.1);
  EXPECT_DOUBLE_EQ(stored("bank"), 0.5) << "heights do not count";
  EXPECT_DOUBLE_EQ(stored("giver"), 50 - (1 + 5 + 5) * 0.1);
}

std::string fleet() {
  std::string text;
  for (int i = 0; i < 200; ++i)
    text += "robot( pose [" + std::to_string(i % 20) + " " + std::to_string(i / 20) + " 0 " +
            std::to_string(i * 7) + "] velocity [0.3 0 0 " + std::to_string(i % 90) + "] give_watts " +
            std::to_string(i % 3) + " )\n";
  for (int i = 0; i < 20; ++i) text += "station( pose [" + std::to_string(i) + " 4.4 0 0] )\n";
  return text;
}

TEST_F(Charging, has_the_same_bits_for_any_number_of_workers) {
  make(fleet());
  run(50);
  const std::uint64_t hash = world().hash();
  int charging = 0;
  for (const std::uint8_t flag : world().packs.charging) charging += flag;
  EXPECT_GT(charging, 0);
  make(fleet(), 3);
  run(50);
  EXPECT_EQ(world().hash(), hash);
}

TEST_F(Charging, goes_on_in_a_run_that_was_saved) {
  make(fleet());
  run(20);
  std::vector<std::byte> saved;
  ASSERT_TRUE(world::save_state(world(), saved));
  run(20);
  const std::uint64_t hash = world().hash();
  make(fleet());
  ASSERT_TRUE(world::load_state(world(), saved));
  run(20);
  EXPECT_EQ(world().hash(), hash);
}

TEST(Touch, is_to_come_near_to_cross_or_to_be_inside) {
  const auto square = [](double x, double y, double side) {
    const double h = side / 2;
    return std::vector<Vec2>{{x - h, y - h}, {x + h, y - h}, {x + h, y + h}, {x - h, y + h}};
  };
  const std::vector<Vec2> unit = square(0, 0, 1);
  EXPECT_TRUE(bodies::touch(unit, square(1, 0.3, 1))) << "an edge along an edge";
  EXPECT_TRUE(bodies::touch(unit, square(1, 1, 1))) << "corner to corner";
  EXPECT_TRUE(bodies::touch(unit, square(0.8, 0, 1)));
  EXPECT_TRUE(bodies::touch(unit, square(0.1, 0, 0.2))) << "inside";
  EXPECT_TRUE(bodies::touch(square(0.1, 0, 0.2), unit));
  EXPECT_TRUE(bodies::touch(unit, unit));
  EXPECT_TRUE(bodies::touch(unit, square(1 + 0.5 * bodies::kTouch, 0, 1)));
  EXPECT_FALSE(bodies::touch(unit, square(1 + 10 * bodies::kTouch, 0, 1)));
  EXPECT_FALSE(bodies::touch(unit, {{{0.6, -1}, {2, -1}, {0.6, 1}}}));
  const std::vector<Vec2> hook = {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_FALSE(bodies::touch(hook, square(1.5, 2, 0.5))) << "in the mouth";
  EXPECT_TRUE(bodies::touch(hook, square(1.5, 2, 1)));
}

}  // namespace
}  // namespace playhouse::stage
