/// A world as it stands, written as a file, is that world again at its start.

#include "playhouse/world/saving/as_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/scene/forms/actuator.h"
#include "playhouse/scene/testing_same_scene.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/scene/write_world.h"
#include "playhouse/world/population/population.h"

namespace playhouse::world {
namespace {

constexpr const char* kYard = R"(
define robot position (
  size [0.4 0.4 0.22] mass 5
  ranger ( pose [0.1 0 -0.05 0] sensor ( samples 3 ) model ( name "lamp" color "green" ) )
  model ( name "plate" pose [0 0 0.1 90] size [0.2 0.2 0.01] )
)
model ( name "wall" size [0.1 8 1] pose [5 0 0 0] )
robot ( name "r0" pose [1 2 0 45] color "blue" )
robot ( name "r1" pose [1 -2 0 200] fiducial_return 3 say "hello" )
position ( name "alone" pose [-1 0 0 0] kjoules 2 )
model ( name "puck" pose [3 1 0 0] size [0.1 0.1 0.1] gripper_return 1 )
model ( pose [3 2 0 0] size [0.1 0.1 0.1] gripper_return 1 model ( name "lid" ) )
position ( name "hauler" pose [-3 0 0 0] gripper ( name "hand" pose [0.3 0 -0.2 0] ) )
gripper ( name "claw" pose [-3 3 0 0] paddle_state ["closed" "up"] )
)";

class AsSceneTest : public ::testing::Test {
 protected:
  ModelRow row(const std::string& name) {
    const ModelRow found = world_.find(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  ModelId id(const std::string& name) { return world_.id(row(name)); }

  struct Stand {
    double paddles = 0;
    std::int32_t closing = 0;
    double lift = 0;
    std::int32_t rising = 0;
    double close_limit = 1;
    ModelId held = {};
  };
  void stand(const std::string& gripper, const Stand& stand) {
    const GripperRow at = world_.models.part[row(gripper)];
    world_.grippers.paddles[at] = stand.paddles;
    world_.grippers.closing[at] = stand.closing;
    world_.grippers.lift[at] = stand.lift;
    world_.grippers.rising[at] = stand.rising;
    world_.grippers.close_limit[at] = stand.close_limit;
    world_.grippers.held[at] = stand.held;
  }

  /// The world that the file says.
  const World& again() {
    const Result<std::string> text = scene::write_world(as_scene(world_), "w/saved.world");
    EXPECT_TRUE(text.ok());
    text_ = text ? *text : "";
    Result<scene::SceneDesc> scene = scene::load_world_text(text_, "w/saved.world", files_);
    EXPECT_TRUE(scene.ok()) << scene.error().line() << "\n" << text_;
    saved_ = scene ? std::move(*scene) : scene::SceneDesc{};
    again_ = std::make_unique<World>(saved_, 1);
    return *again_;
  }

  /// Everybody stands where they stood, with their names and looks.
  void expect_same() {
    const World& other = again();
    ASSERT_EQ(other.models.size(), world_.models.size()) << text_;
    for (const ModelRow at : world_.models.rows()) {
      const std::string name = world_.name(at);
      const ModelRow found = other.find(name);
      ASSERT_TRUE(found) << name << "\n" << text_;
      const geom::Pose &was = world_.models.X_WM[at], &is = other.models.X_WM[found];
      EXPECT_NEAR(was.x, is.x, 1e-12) << name;
      EXPECT_NEAR(was.y, is.y, 1e-12) << name;
      EXPECT_NEAR(was.z, is.z, 1e-12) << name;
      EXPECT_NEAR(geom::normalize(was.a - is.a), 0, 1e-12) << name;
      EXPECT_EQ(world_.models.color[at], other.models.color[found]) << name;
      EXPECT_EQ(world_.models.say[at], other.models.say[found]) << name;
      EXPECT_EQ(world_.models.fiducial_return[at], other.models.fiducial_return[found]) << name;
      EXPECT_EQ(world_.desc(at).type, other.desc(found).type) << name;
      EXPECT_EQ(world_.desc(at).blocks, other.desc(found).blocks) << name;
      const ModelRow parent = world_.models.parent[at], other_parent = other.models.parent[found];
      ASSERT_EQ(parent.valid(), other_parent.valid()) << name;
      if (parent) EXPECT_EQ(world_.name(parent), other.name(other_parent)) << name;
    }
  }

  config::MemoryFiles files_{{}};
  scene::SceneDesc scene_ = *scene::load_world_text(kYard, "w/t.world", files_);
  World world_{scene_, 1};
  std::string text_;
  scene::SceneDesc saved_;
  std::unique_ptr<World> again_;
};

TEST_F(AsSceneTest, at_the_start_it_is_the_scene) {
  EXPECT_EQ(difference(scene_, as_scene(world_)), "");
  again();
  EXPECT_EQ(difference(scene_, saved_), "");
  EXPECT_EQ(saved_.models.size(), scene_.models.size());
}

TEST_F(AsSceneTest, every_file_here_is_the_same_at_its_start) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(PLAYHOUSE_SOURCE_DIR) + "/worlds")) {
    if (entry.path().extension() != ".world") continue;
    const Result<scene::SceneDesc> scene = scene::load_world(entry.path().string());
    ASSERT_TRUE(scene.ok());
    const World world(*scene, 1);
    EXPECT_EQ(difference(*scene, as_scene(world)), "") << entry.path();
  }
}

TEST_F(AsSceneTest, it_has_what_was_moved_painted_and_marked) {
  ASSERT_TRUE(set_pose(world_, row("r0"), {-2.123456789, 0.1, 0.3, 2.7182818284}));
  ASSERT_TRUE(set_pose(world_, row("wall"), {7, 1, 0, -geom::kPi}));
  set_color(world_, row("r1"), {0.1f, 0.2f, 0.3f, 1});
  set_fiducial_return(world_, row("r1"), 0);
  world_.models.say.set(row("r0"), "there");
  world_.models.say.set(row("r1"), "");
  expect_same();
  EXPECT_EQ(text_.find("say \"hello\""), std::string::npos);
  EXPECT_NE(text_.find("\nrobot ( name \"r0\""), std::string::npos) << "it is one of them still\n" << text_;
}

TEST_F(AsSceneTest, batteries_hold_what_they_hold_now) {
  ASSERT_EQ(world_.packs.stored.size(), 1u);
  world_.packs.stored[{0}] = 1234.5;
  expect_same();
  ASSERT_EQ(again_->packs.stored.size(), 1u);
  EXPECT_EQ(again_->packs.stored[{0}], 1234.5);
  EXPECT_EQ(again_->packs.capacity[{0}], 2000);
}

TEST_F(AsSceneTest, lamps_are_set_as_they_are_and_not_as_the_file_says) {
  scene_ = *scene::load_world_text(
      "define lamp blinkenlight ( period 200 )\nlamp ( name \"a\" enabled 0 )\nlamp ( name \"b\" )\n"
      "position ( name \"r\" lamp ( name \"c\" dutycycle 0.5 ) )\n",
      "w/t.world", files_);
  World world(scene_, 1);
  EXPECT_EQ(difference(scene_, as_scene(world)), "");
  const auto set = [&](const char* name, bool enabled, double period, double dutycycle) {
    const BlinkenlightRow lamp = world.models.part[world.find(name)];
    world.blinkenlights.enabled[lamp] = enabled;
    world.blinkenlights.period[lamp] = period;
    world.blinkenlights.dutycycle[lamp] = dutycycle;
  };
  set("a", true, 1, 1);
  set("r.c", false, static_cast<double>(0.1f), static_cast<double>(0.3f));
  const Result<std::string> text = scene::write_world(as_scene(world), "w/saved.world");
  ASSERT_TRUE(text.ok());
  const Result<scene::SceneDesc> saved = scene::load_world_text(*text, "w/saved.world", files_);
  ASSERT_TRUE(saved.ok()) << saved.error().line() << "\n" << *text;
  const World again(*saved, 1);
  for (const char* name : {"a", "b", "r.c"}) {
    const BlinkenlightRow was = world.models.part[world.find(name)];
    const BlinkenlightRow is = again.models.part[again.find(name)];
    EXPECT_EQ(again.blinkenlights.enabled[is], world.blinkenlights.enabled[was]) << name << "\n" << *text;
    EXPECT_EQ(again.blinkenlights.lit[is], again.blinkenlights.enabled[is]) << name;
    EXPECT_NEAR(again.blinkenlights.period[is], world.blinkenlights.period[was], 1e-6)
        << "files have microseconds";
    EXPECT_EQ(again.blinkenlights.dutycycle[is], world.blinkenlights.dutycycle[was]) << name;
  }
}

TEST_F(AsSceneTest, actuators_start_at_the_position_that_they_have_on_the_way_that_they_had) {
  scene_ = *scene::load_world_text(
      "actuator( name \"slide\" pose [1 2 0 30] start_position 0.3 model( name \"load\" ) )\n"
      "position( name \"r\" actuator( name \"joint\" type \"rotational\" min_position -2 start_position 0.7 "
      ") )\n"
      "actuator( name \"stays\" pose [0.1 -0.7 0 77] start_position 0.9 )",
      "w/t.world", files_);
  World world(scene_, 1);
  EXPECT_EQ(difference(scene_, as_scene(world)), "");
  const auto go = [&](const char* name, double position) {
    const ModelRow row = world.find(name);
    const ActuatorRow actuator = world.models.part[row];
    world.actuators.position[actuator] = position;
    world.models.X_PM.own(row) =
        geom::compose(world.actuators.X_PJ[actuator], scene::way_along(*world.desc(row).actuator, position));
    place_tree(world, row);
  };
  go("slide", 0.1234567);
  go("r.joint", -1.1);
  ASSERT_TRUE(set_pose(world, world.find("stays"), {3, 3, 0, 1}));
  const Result<std::string> text = scene::write_world(as_scene(world), "w/saved.world");
  ASSERT_TRUE(text.ok());
  const Result<scene::SceneDesc> saved = scene::load_world_text(*text, "w/saved.world", files_);
  ASSERT_TRUE(saved.ok()) << saved.error().line() << "\n" << *text;
  World again(*saved, 1);
  for (const ModelRow row : world.models.rows()) {
    const ModelRow found = again.find(world.name(row));
    ASSERT_TRUE(found) << *text;
    const geom::Pose &was = world.models.X_WM[row], &is = again.models.X_WM[found];
    EXPECT_NEAR(was.x, is.x, 1e-12) << *text;
    EXPECT_NEAR(was.y, is.y, 1e-12) << *text;
    EXPECT_NEAR(geom::normalize(was.a - is.a), 0, 1e-12) << *text;
  }
  EXPECT_EQ(again.actuators.position, world.actuators.position);
  EXPECT_NE(text->find("start_position -1.1"), std::string::npos) << *text;
}

TEST_F(AsSceneTest, it_has_who_came_and_not_who_went) {
  ASSERT_TRUE(despawn(world_, id("r0")).ok());
  ASSERT_TRUE(spawn(world_, world_.models.desc[row("r1")], {4, 4, 0, 1}).ok());
  ASSERT_TRUE(spawn(world_, world_.models.desc[row("alone")], {5, 4, 0, 1}, "second").ok());
  ASSERT_TRUE(spawn(world_, world_.models.desc[row("model:3")], {6, 4, 0, 1}).ok());
  expect_same();
  EXPECT_FALSE(again_->find("r0"));
  EXPECT_TRUE(again_->find("r1~2.ranger:0.lamp")) << text_;
}

TEST_F(AsSceneTest, who_came_has_no_controller_there_either) {
  scene_ = *scene::load_world_text(
      "define robot position ( ctrl \"wander\" ranger ( ) )\nrobot ( name \"a\" )\nrobot ( )", "w/t.world",
      files_);
  World world(scene_, 1);
  ASSERT_TRUE(spawn(world, 0, {1, 0, 0, 0}).ok());
  const Result<std::string> text = scene::write_world(as_scene(world), "w/t.world");
  ASSERT_TRUE(text.ok());
  EXPECT_NE(text->find("robot ( name \"a\" ctrl \"wander\" )\nrobot ( ctrl \"wander\" )\nrobot ( name "
                       "\"a~2\" pose [1 0 0 0] )\n"),
            std::string::npos)
      << *text;
}

TEST_F(AsSceneTest, default_names_stay_with_those_who_have_them) {
  ASSERT_TRUE(spawn(world_, world_.models.desc[row("model:3")], {6, 4, 0, 1}, "m").ok());
  ASSERT_TRUE(despawn(world_, id("wall")).ok());
  ASSERT_TRUE(despawn(world_, id("puck")).ok());
  expect_same();
  EXPECT_TRUE(again_->find("model:3.lid")) << text_;
}

TEST_F(AsSceneTest, what_is_carried_is_a_part_of_who_carries_it) {
  ASSERT_TRUE(attach(world_, id("puck"), id("r0"), {0.1, 0.2, 0.05, 1}).ok());
  ASSERT_TRUE(attach(world_, id("model:3"), id("r1.ranger:0"), {0.1, 0, -0.1, 0.5}).ok());
  expect_same();
  EXPECT_NE(text_.find("\nrobot (\n  name \"r0\"\n  pose [1 2 0 45]\n  model ( name \"/puck\""),
            std::string::npos)
      << "a macro's instance, and the puck\n"
      << text_;
  ASSERT_TRUE(despawn(world_, id("r0")).ok());
  expect_same();
}

TEST_F(AsSceneTest, paddles_are_as_they_stand_or_as_the_file_has_them_while_they_move) {
  const auto state_of = [&](const char* gripper) {
    const scene::GripperDesc& desc = *again_->desc(again_->find(gripper)).gripper;
    return std::pair(desc.paddles, desc.lift);
  };
  using scene::Lift;
  using scene::Paddles;
  stand("hauler.hand", {.paddles = 0.5, .closing = 1, .lift = 0.5, .rising = 1});
  stand("claw", {.paddles = 0.5, .lift = 0.5});
  again();
  EXPECT_EQ(difference(scene_, saved_), "") << "on their way, or stopped there";
  stand("hauler.hand", {.paddles = 1, .lift = 1});
  stand("claw", {.paddles = 0, .lift = 0});
  again();
  EXPECT_EQ(state_of("hauler.hand"), std::pair(Paddles::kClosed, Lift::kUp));
  EXPECT_EQ(state_of("claw"), std::pair(Paddles::kOpen, Lift::kDown));
  EXPECT_EQ(again_->grippers.paddles, world_.grippers.paddles);
  EXPECT_EQ(again_->grippers.lift, world_.grippers.lift);
  EXPECT_NE(again_->desc(again_->find("claw")).blocks, world_.desc(row("claw")).blocks)
      << "its paddles are open";
  EXPECT_EQ(again_->desc(again_->find("claw")).moving_blocks, 2u);
  EXPECT_EQ(difference(as_scene(world_), saved_), "") << text_;
  stand("hauler.hand", {.paddles = 0.9, .closing = -1, .lift = 1});
  again();
  EXPECT_EQ(state_of("hauler.hand"), std::pair(Paddles::kOpen, Lift::kUp));
}

TEST_F(AsSceneTest, what_a_gripper_holds_is_a_part_of_it_and_its_paddles_are_closed) {
  ASSERT_TRUE(attach(world_, id("puck"), id("hauler.hand"), {}).ok());
  stand("hauler.hand", {.paddles = 0.66, .close_limit = 0.66, .held = id("puck")});
  again();
  const ModelRow hand = again_->find("hauler.hand"), puck = again_->find("puck");
  ASSERT_TRUE(hand && puck) << text_;
  EXPECT_EQ(again_->models.parent[puck], hand) << text_;
  EXPECT_EQ(again_->desc(hand).gripper->paddles, scene::Paddles::kClosed);
  EXPECT_EQ(again_->models.X_WM[puck], world_.models.X_WM[row("puck")]);
  EXPECT_EQ(difference(as_scene(world_), saved_), "") << text_;
}

TEST_F(AsSceneTest, parts_that_were_moved_or_painted_are_where_they_are) {
  ASSERT_TRUE(set_pose(world_, row("r1.plate"), {0.05, 0, 0.5, 0.3}));
  set_color(world_, row("r0.ranger:0.lamp"), {1, 1, 0, 1});
  expect_same();
  EXPECT_EQ(text_.find("\nrobot"), std::string::npos) << text_;
}

TEST_F(AsSceneTest, nobody_left_is_nobody_in_the_file) {
  while (!world_.models.id.empty()) ASSERT_TRUE(despawn(world_, world_.models.id[{0}]).ok());
  expect_same();
}

TEST_F(AsSceneTest, a_name_that_another_model_took_stays_with_it) {
  scene_ = *scene::load_world_text(
      "define robot position ( ranger ( ) )\nrobot ( name \"a\" )\nrobot ( name \"b\" )\n"
      "model ( name \"a.ranger:0\" )\nrobot ( name \"b\" )\nrobot ( )",
      "w/t.world", files_);
  World world(scene_, 1);
  ASSERT_TRUE(despawn(world, world.id(world.find("position:1"))).ok());
  const scene::SceneDesc standing = as_scene(world);
  EXPECT_EQ(standing.renamed.size(), 1u);
  const Result<std::string> text = scene::write_world(standing, "w/t.world");
  ASSERT_TRUE(text.ok());
  const scene::SceneDesc saved = *scene::load_world_text(*text, "w/t.world", files_);
  const World again(saved, 1);
  for (const ModelRow at : world.models.rows()) EXPECT_EQ(again.name(at), world.name(at)) << *text;
}

/// Not every heading has a number of degrees.
bool is_same_but_for_last_bits(const std::string& difference) {
  return difference.empty() || difference.ends_with("words of every model");
}

/// Any hundred changes, twenty times.
TEST_F(AsSceneTest, whatever_was_done_the_file_has_it) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed, 0, {Purpose::kColor, 0});
    const auto any = [&](std::size_t count) {
      return static_cast<std::uint32_t>(rng.uniform() * static_cast<double>(count));
    };
    const auto any_pose = [&] {
      return geom::Pose{rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(0, 1), rng.uniform(-3, 3)};
    };
    World world(scene_, 1);
    for (int change = 0; change < 100 && world.models.size() > 0; ++change) {
      const ModelRow model{any(world.models.size())};
      const ModelId top = world.id(world.models.root[model]);
      switch (any(7)) {
        case 0:
          static_cast<void>(set_pose(world, model, any_pose()));
          break;
        case 1:
          static_cast<void>(despawn(world, top));
          break;
        case 2:
          static_cast<void>(attach(world, top, world.id({any(world.models.size())}), any_pose()));
          break;
        case 3:
          static_cast<void>(detach(world, world.id(model)));
          break;
        case 4:
          world.models.say.set(model, "words");
          break;
        default:
          static_cast<void>(spawn(world, scene_.trees[any(scene_.trees.size())].top, any_pose()));
      }
    }
    const Result<std::string> text = scene::write_world(as_scene(world), "w/t.world");
    ASSERT_TRUE(text.ok());
    const Result<scene::SceneDesc> saved = scene::load_world_text(*text, "w/t.world", files_);
    ASSERT_TRUE(saved.ok()) << saved.error().line();
    const World again(*saved, 1);
    ASSERT_EQ(again.models.size(), world.models.size());
    EXPECT_TRUE(is_same_but_for_last_bits(difference(as_scene(world), *saved))) << *text;
    for (const ModelRow at : world.models.rows()) {
      const ModelRow found = again.find(world.name(at));
      ASSERT_TRUE(found);
      const geom::Pose &is = again.models.X_WM[found], &was = world.models.X_WM[at];
      EXPECT_NEAR(is.x, was.x, 1e-9);
      EXPECT_NEAR(geom::normalize(is.a - was.a), 0, 1e-12);
      EXPECT_EQ(again.models.say[found], world.models.say[at]);
    }
  }
}

}  // namespace
}  // namespace playhouse::world
