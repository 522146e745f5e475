// What custom models do with the code of a library: when its hooks run, what they see and set, and that runs
// repeat. The code is made here; that it comes from libraries is tested in playhouse/libraries.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/world/custom_library.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::stage {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using world::CustomActor;
using world::CustomKind;
using world::CustomModel;
using world::CustomSensor;

/// Counts its ticks from 100 on, draws, and moves and looks as commands say: 0 ahead, 1 up, 2 turn, 3 red.
/// Measures range, how many models are within 3 m, walls to 2 m ahead, the count, and noise.
class Probe : public CustomKind {
 public:
  Sizes configure(std::span<const std::string>) override { return {4, 2, 5}; }
  void begin(const CustomModel&, std::span<double> state, std::span<double>) const override {
    state[0] = 100;
  }
  void act(CustomActor& self) const override {
    self.state[0] += 1;
    self.state[1] = self.random.uniform();
    self.velocity = {self.command[0], 0, self.command[1], self.command[2]};
    if (self.command[3] > 0) self.color = {1, 0, 0, 1};
  }
  void sense(CustomSensor& self) const override {
    const geom::Pose& X_WM = self.world.models.X_WM[self.model];
    std::vector<world::ModelRow> found;
    self.around.near(X_WM, 3, found);
    self.readings[0] = self.around.cast(X_WM, 8, self.model).range;
    self.readings[1] = static_cast<double>(found.size());
    self.readings[2] = self.around.walls_between(X_WM, geom::compose(X_WM, {2, 0, 0, 0}));
    self.readings[3] = self.state[0];
    self.readings[4] = self.random.gaussian();
  }
};

constexpr const char* kWorld = R"(
define probe custom( library "probe" size [0.2 0.2 0.2] )
probe( name "one" pose [0 0 0 0] update_interval 200 )
probe( name "two" pose [0 -2 0 0] )
model( name "wall" pose [1.5 0 0 0] size [0.2 1 1] )
position( name "far" pose [9 9 0 0] alwayson 1 velocity [0.2 0 0 10] )
)";

/// A scene that runs, with the code for all its custom models.
class Running {
 public:
  explicit Running(std::shared_ptr<CustomKind> kind = std::make_shared<Probe>(), unsigned workers = 1,
                   const std::string& text = kWorld) {
    config::MemoryFiles none({});
    auto loaded = scene::load_world_text(text, "test.world", none);
    EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().line());
    scene_ = std::make_unique<scene::SceneDesc>(std::move(*loaded));
    auto made = make_engine(*scene_, {.seed = 5, .workers = workers});
    EXPECT_TRUE(made) << (made ? "" : made.error().line());
    engine_ = std::move(*made);
    auto code = std::make_shared<world::CustomCode>();
    code->sizes = kind->configure({});
    code->kind = std::move(kind);
    for (const scene::ModelDesc& model : scene_->models)
      world().custom_codes.push_back(model.kind == scene::ModelKind::kCustom ? code : nullptr);
  }
  world::World& world() { return engine_->world(); }
  world::Customs& customs() { return world().customs; }
  const geom::Pose& X_WM(const char* name) { return world().models.X_WM[world().find(name)]; }
  void subscribe() {
    for (const world::ModelRow model : customs().model) world::subscribe(world(), model);
  }
  void step(int ticks = 1) {
    for (int k = 0; k < ticks; ++k) engine_->step();
  }
  void command(std::uint32_t which, double value, std::uint32_t custom = 0) {
    EXPECT_TRUE(world::command_custom(world(), {custom}, which, value));
  }

 private:
  std::unique_ptr<scene::SceneDesc> scene_;
  std::unique_ptr<world::Engine> engine_;
};

TEST(Custom, acts_in_every_tick_from_the_state_with_which_it_begins) {
  Running run;
  run.step(3);
  EXPECT_EQ(run.customs().state[{0}][0], 103);
  EXPECT_NE(run.customs().state[{0}][1], run.customs().state[{1}][1]) << "each draws numbers of its own";
}

TEST(Custom, measures_what_is_around_it_when_it_is_subscribed_and_due) {
  Running run;
  run.step(2);
  EXPECT_THAT(run.customs().readings[{0}], IsEmpty()) << "nobody has subscribed";
  run.subscribe();
  run.step();
  EXPECT_EQ(run.customs().measured_tick[{0}], 3u);
  EXPECT_NEAR(run.customs().readings[{0}][0], 1.4, 1e-12);
  EXPECT_EQ(run.customs().readings[{0}][1], 3) << "both probes and the wall";
  EXPECT_EQ(run.customs().readings[{0}][2], 1);
  EXPECT_EQ(run.customs().readings[{0}][3], 103) << "after all have acted";
  EXPECT_EQ(run.customs().readings[{1}][0], 8) << "nothing in the way";
  EXPECT_EQ(run.customs().readings[{1}][2], 0);
  run.step();
  EXPECT_EQ(run.customs().measured_tick[{0}], 3u) << "its update_interval is two ticks";
  EXPECT_EQ(run.customs().measured_tick[{1}], 4u);
}

TEST(Custom, moves_turns_and_rises_as_its_library_says_until_something_is_in_the_way) {
  Running run;
  run.command(0, 1);
  run.step(10);
  EXPECT_NEAR(run.X_WM("one").x, 1, 1e-12);
  EXPECT_EQ(run.customs().stall[{0}], 0);
  run.step(10);
  EXPECT_EQ(run.customs().stall[{0}], 1);
  EXPECT_NEAR(run.X_WM("one").x, 1.25, 0.06) << "a wall is at 1.4, and half of it is 0.1";
  run.command(0, 0);
  run.command(1, 0.5, 1);
  run.command(2, 0.3, 1);
  run.step(10);
  EXPECT_NEAR(run.X_WM("two").z, 0.5, 1e-12);
  EXPECT_NEAR(run.X_WM("two").a, 0.3, 1e-12);
}

TEST(Custom, takes_its_parts_along) {
  Running run(std::make_shared<Probe>(), 1,
              "custom( name \"table\" library \"probe\"  model( name \"load\" pose [0.5 0 0 0] ) )");
  run.command(2, 0.5);
  run.step(10);
  EXPECT_NEAR(run.X_WM("table.load").x, 0.5 * std::cos(0.5), 1e-12);
  EXPECT_NEAR(run.X_WM("table.load").y, 0.5 * std::sin(0.5), 1e-12);
  EXPECT_NEAR(run.X_WM("table.load").a, 0.5, 1e-12);
}

TEST(Custom, has_the_color_that_its_library_gives_it) {
  Running run;
  const scene::Color before = run.world().models.color[{1}];
  run.command(3, 1);
  run.step();
  EXPECT_EQ(run.world().models.color[{0}], (scene::Color{1, 0, 0, 1}));
  EXPECT_EQ(run.world().models.color[{1}], before) << "of the same description";
}

TEST(Custom, takes_commands_that_it_has_and_that_are_numbers) {
  Running run;
  EXPECT_TRUE(world::command_custom(run.world(), {0}, 3, 2.5)) << "before its first tick, too";
  EXPECT_FALSE(world::command_custom(run.world(), {0}, 4, 2.5));
  EXPECT_FALSE(world::command_custom(run.world(), {0}, 0, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_THAT(run.customs().command[{0}], ElementsAre(0, 0, 0, 2.5));
}

TEST(Custom, begins_anew_after_a_return_to_the_start_and_when_it_comes) {
  Running run;
  run.command(0, 0.5);
  run.step(4);
  world::return_to_start(run.world());
  run.step();
  EXPECT_EQ(run.customs().state[{0}][0], 101);
  EXPECT_EQ(run.X_WM("one"), geom::Pose{});
  const auto id = world::spawn(run.world(), run.world().models.desc[{0}], {5, 5, 0, 0});
  ASSERT_TRUE(id) << id.error().line();
  run.step(2);
  EXPECT_EQ(run.customs().state[{2}][0], 102);
  EXPECT_EQ(run.customs().state[{0}][0], 103);
  ASSERT_TRUE(world::despawn(run.world(), run.world().id(run.world().find("one"))));
  run.step();
  EXPECT_EQ(run.customs().size(), 2u);
  EXPECT_EQ(run.customs().state[{1}][0], 103) << "who is left keeps what is its own";
}

TEST(Custom, runs_the_same_with_any_number_of_workers) {
  std::string text = kWorld;
  for (int k = 0; k < 200; ++k)
    text += "probe( pose [" + std::to_string(k % 20) + " " + std::to_string(5 + k / 20) + " 0 0] )\n";
  Running one(std::make_shared<Probe>(), 1, text), two(std::make_shared<Probe>(), 2, text);
  for (Running* run : {&one, &two}) {
    run->subscribe();
    for (std::uint32_t custom = 0; custom < run->customs().size(); ++custom) {
      run->command(0, 0.1, custom);
      run->command(2, 0.01 * custom, custom);
    }
    run->step(20);
  }
  EXPECT_EQ(one.world().hash(), two.world().hash());
  EXPECT_EQ(one.world().sensed_hash(), two.world().sensed_hash());
}

TEST(Custom, goes_on_the_same_after_it_was_saved_and_loaded) {
  Running run, again;
  for (Running* each : {&run, &again}) each->subscribe();
  run.command(2, 0.4);
  run.step(7);
  std::vector<std::byte> state;
  ASSERT_TRUE(world::save_state(run.world(), state));
  run.step(9);
  const auto loaded = world::load_state(again.world(), state);
  ASSERT_TRUE(loaded) << loaded.error().line();
  again.step(9);
  EXPECT_EQ(run.world().hash(), again.world().hash());
  EXPECT_EQ(run.world().sensed_hash(), again.world().sensed_hash());
  EXPECT_EQ(world::first_difference(run.world(), again.world()), std::nullopt);
}

TEST(Custom, that_people_look_at_does_what_it_did) {
  Running run, watched;
  for (const world::ModelRow model : watched.customs().model) world::watch(watched.world(), model);
  for (Running* each : {&run, &watched}) each->step(5);
  EXPECT_THAT(watched.customs().readings[{0}], Not(IsEmpty()));
  EXPECT_EQ(run.world().hash(), watched.world().hash());
}

/// Writes into everything, then fails in one of the ways that there are.
class Faulty : public CustomKind {
 public:
  enum class Way { kThrow, kThrowNoException, kNotFinite, kTooFast };
  explicit Faulty(Way way) : way_(way) {}
  Sizes configure(std::span<const std::string>) override { return {1, 1, 1}; }
  void act(CustomActor& self) const override {
    self.velocity = {1, 0, 0, 0};
    self.color = {1, 1, 1, 1};
    fail(self.state[0] = 7);
    if (way_ == Way::kTooFast) self.velocity.x = 1e30;
  }
  void sense(CustomSensor& self) const override { fail(self.readings[0] = 7); }

 private:
  void fail(double& number) const {
    if (way_ == Way::kThrow) throw std::runtime_error("out of order");
    if (way_ == Way::kThrowNoException) throw 5;
    if (way_ == Way::kNotFinite) number = std::numeric_limits<double>::infinity();
  }
  Way way_;
};

/// What the log says during `act`, behind the place in a file.
template <typename Act>
std::string logged(const Act& act) {
  std::ostringstream text;
  const auto before = spdlog::default_logger();
  const auto sink = std::make_shared<spdlog::sinks::ostream_sink_st>(text);
  sink->set_pattern("%g: %v");
  spdlog::set_default_logger(std::make_shared<spdlog::logger>("test", sink));
  act();
  spdlog::set_default_logger(before);
  return text.str();
}

TEST(Custom, whose_hook_fails_is_as_it_was) {
  for (const auto way : {Faulty::Way::kThrow, Faulty::Way::kThrowNoException, Faulty::Way::kNotFinite,
                         Faulty::Way::kTooFast}) {
    Running run(std::make_shared<Faulty>(way));
    run.subscribe();
    const scene::Color before = run.world().models.color[{0}];
    const std::string log = logged([&] { run.step(3); });
    EXPECT_EQ(std::ranges::count(log, '\n'), 1) << "once for all that are alike:\n" << log;
    EXPECT_THAT(log, StartsWith("test.world:3: custom model \"probe\" of \""));
    EXPECT_THAT(run.customs().state[{0}], ElementsAre(0));
    EXPECT_EQ(run.X_WM("one"), geom::Pose{});
    EXPECT_EQ(run.world().models.color[{0}], before);
    if (way != Faulty::Way::kTooFast) EXPECT_THAT(run.customs().readings[{0}], ElementsAre(0));
  }
}

TEST(Custom, without_code_stands_still_and_measures_nothing) {
  Running run;
  run.world().custom_codes.clear();
  run.subscribe();
  run.step(3);
  EXPECT_THAT(run.customs().readings, Each(IsEmpty()));
  EXPECT_FALSE(world::command_custom(run.world(), {0}, 0, 1));
}

}  // namespace
}  // namespace playhouse::stage
