#include "playhouse/world/population/population.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/rng.h"
#include "playhouse/scene/testing_expanded.h"
#include "playhouse/world/columns.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::world {
namespace {

scene::ModelDesc model(const std::string& name, scene::ModelKind kind, std::int32_t parent) {
  scene::ModelDesc desc;
  desc.name = desc.alias = name;
  desc.kind = kind;
  desc.parent = parent;
  return desc;
}

/// Row 0: a wall. 1: robot "r" with a ranger of two sensors (2), on which stands a finder (3). 4: a puck.
/// 5: robot "s" with a ranger (6).
scene::SceneDesc make_scene() {
  scene::SceneDesc scene;
  scene.models.push_back(model("wall", scene::ModelKind::kPlain, -1));
  scene.models.push_back(model("r", scene::ModelKind::kPosition, -1));
  scene.models.back().position.emplace();
  scene.models.back().X_PM = {1, 2, 0, geom::kPi / 2};
  scene.models.push_back(model("r.ranger:0", scene::ModelKind::kRanger, 1));
  scene.models.back().X_PM = {0.5, 0, 0.1, 0};
  scene.models.back().sensors.resize(2);
  scene.models.back().sensors[0].samples = 3;
  scene.models.push_back(model("r.ranger:0.fiducial:0", scene::ModelKind::kFiducial, 2));
  scene.models.back().fiducial.emplace();
  scene.models.push_back(model("puck", scene::ModelKind::kPlain, -1));
  scene.models.back().gripper_return = true;
  scene.models.back().X_PM = {3, 3, 0, 0};
  scene.models.push_back(model("s", scene::ModelKind::kPosition, -1));
  scene.models.back().position.emplace();
  scene.models.push_back(model("s.ranger:0", scene::ModelKind::kRanger, 5));
  scene.models.back().sensors.resize(1);
  return scene;
}

class PopulationTest : public ::testing::Test {
 protected:
  ModelId spawned(std::uint32_t prototype, const geom::Pose& X_WM, const std::string& name = {}) {
    const Result<ModelId> id = spawn(world, prototype, X_WM, name);
    EXPECT_TRUE(id.ok());
    return id.ok() ? *id : ModelId{};
  }

  /// Every derived column is what it would be if it were derived anew.
  void expect_whole() {
    std::vector<std::byte> bytes;
    ASSERT_TRUE(save_state(world, bytes).ok());
    World again(scene, 1);
    const Result<void> loaded = load_state(again, bytes);
    ASSERT_TRUE(loaded.ok()) << loaded.error().line();
    each_column(
        [](const auto& column, const auto& values, const auto& values_again) {
          if (column.role != Role::kUse) EXPECT_EQ(values, values_again) << column.name;
        },
        world, again);
    EXPECT_EQ(world.hash(), again.hash());
    EXPECT_EQ(first_difference(world, again), std::nullopt);
  }

  std::string name(ModelId id) const { return world.name(world.row(id)); }

  const scene::SceneDesc scene = make_scene();
  World world{scene, 1};
};

TEST_F(PopulationTest, what_comes_has_the_parts_of_its_prototype_and_names_of_its_own) {
  const ModelId top = spawned(1, {5, 5, 0, 0}, "new");
  EXPECT_EQ(top, ModelId{7});
  EXPECT_EQ(name(top), "new");
  EXPECT_EQ(name({8}), "new.ranger:0");
  EXPECT_EQ(name({9}), "new.ranger:0.fiducial:0");
  EXPECT_EQ(world.find("new.ranger:0"), ModelRow{8});
  EXPECT_NEAR(world.models.X_WM[{8}].x, 5.5, 1e-12);
  EXPECT_EQ(world.positions.size(), 3u);
  EXPECT_EQ(world.sensors.ranges.size(), 4u + 1u + 4u);
  EXPECT_EQ(world.position(top), PositionRow{2});
  EXPECT_EQ(name(spawned(1, {})), "r~2");
  EXPECT_EQ(name(spawned(1, {})), "r~3");
  expect_whole();
}

TEST_F(PopulationTest, what_goes_takes_its_parts_along_and_its_id_is_not_used_again) {
  const ModelId first = spawned(5, {});
  ASSERT_TRUE(despawn(world, {1}).ok());
  EXPECT_FALSE(world.row({1}).valid());
  EXPECT_FALSE(world.row({3}).valid());
  EXPECT_FALSE(world.find("r").valid());
  EXPECT_EQ(world.row({4}), ModelRow{1});
  EXPECT_EQ(world.positions.size(), 2u);
  EXPECT_EQ(world.fiducials.size(), 0u);
  EXPECT_EQ(world.sensors.ranges.size(), 2u);
  expect_whole();
  ASSERT_TRUE(despawn(world, first).ok());
  const ModelId second = spawned(5, {});
  EXPECT_GT(second, first);
  EXPECT_EQ(name(second), "s~2") << "names of those that are gone are free";
  expect_whole();
}

TEST_F(PopulationTest, who_comes_or_goes_changes_nobody_elses_hash) {
  const auto of_all_but_the_run = [&] {
    std::vector<std::byte> bytes;
    EXPECT_TRUE(save_state(world, bytes).ok());
    return world.hash();
  };
  const geom::Twist error = world.positions.odom_error[{1}];
  ASSERT_TRUE(despawn(world, {1}).ok());
  EXPECT_EQ(world.positions.odom_error[{0}], error);
  const std::uint64_t before = of_all_but_the_run();
  const ModelId id = spawned(1, {});
  EXPECT_NE(of_all_but_the_run(), before);
  ASSERT_TRUE(despawn(world, id).ok());
  EXPECT_NE(of_all_but_the_run(), before) << "the next id is another";
}

TEST_F(PopulationTest, a_puck_is_carried_and_put_down) {
  ASSERT_TRUE(attach(world, {4}, {2}, {0.1, 0, 0, 0}).ok());
  EXPECT_EQ(world.models.root[{4}], ModelRow{1});
  EXPECT_EQ(world.models.mobility[{4}], Mobility::kDriven);
  EXPECT_NEAR(world.models.X_WM[{4}].y, 2.6, 1e-12);
  ASSERT_TRUE(set_pose(world, {1}, {1, 3, 0, geom::kPi / 2}));
  EXPECT_NEAR(world.models.X_WM[{4}].y, 3.6, 1e-12);
  expect_whole();
  ASSERT_TRUE(detach(world, {4}).ok());
  EXPECT_EQ(world.models.root[{4}], ModelRow{4});
  EXPECT_EQ(world.models.mobility[{4}], Mobility::kLoose);
  EXPECT_NEAR(world.models.X_PM[{4}].y, 3.6, 1e-12);
  expect_whole();
}

TEST(Mobility, is_that_of_each_model_so_that_walls_with_a_robot_in_them_stand_still) {
  scene::SceneDesc scene;
  scene.models.push_back(model("walls", scene::ModelKind::kPlain, -1));
  scene.models.back().bitmaps.emplace_back();
  scene.models.push_back(model("walls.r", scene::ModelKind::kPosition, 0));
  scene.models.back().position.emplace();
  scene.models.push_back(model("walls.r.plate", scene::ModelKind::kPlain, 1));
  scene.models.push_back(model("walls.shelf", scene::ModelKind::kPlain, 0));
  scene.models.push_back(model("puck", scene::ModelKind::kPlain, -1));
  scene.models.back().gripper_return = true;
  World world(scene, 1);
  using enum Mobility;
  EXPECT_EQ(world.models.mobility, (std::vector{kFixed, kDriven, kDriven, kFixed, kLoose}));
  ASSERT_TRUE(attach(world, {4}, {2}, {}));
  EXPECT_EQ(world.models.mobility, (std::vector{kFixed, kDriven, kDriven, kFixed, kDriven}));
}

TEST(Actuators, begin_at_their_start_and_have_it_again_after_a_return) {
  scene::SceneDesc scene;
  scene.models.push_back(model("lift", scene::ModelKind::kActuator, -1));
  scene.models.back().X_PM = {1, 2, 0, 0};
  scene.models.back().actuator.emplace();
  scene.models.back().actuator->axis_z = 2;
  scene.models.back().actuator->start_position = 0.5;
  scene.models.push_back(model("lift.load", scene::ModelKind::kPlain, 0));
  scene.models.back().X_PM = {0.1, 0, 0.2, 0};
  World world(scene, 1);
  EXPECT_EQ(world.models.X_WM[{1}], (geom::Pose{1.1, 2, 0.7, 0}));
  EXPECT_EQ(world.actuators.position[{0}], 0.5);
  ASSERT_TRUE(set_pose(world, {0}, {4, 4, 1, 0}));
  EXPECT_EQ(world.actuators.X_PJ[{0}], (geom::Pose{4, 4, 0.5, 0}));
  world.actuators.position[{0}] = 0.2;
  return_to_start(world);
  EXPECT_EQ(world.models.X_WM[{1}], (geom::Pose{1.1, 2, 0.7, 0}));
  EXPECT_EQ(world.actuators.X_PJ[{0}], (geom::Pose{1, 2, 0, 0}));
  EXPECT_EQ(world.actuators.position[{0}], 0.5);
  EXPECT_TRUE(spawn(world, 0, {-1, 0, 0, 0}));
  EXPECT_EQ(world.models.X_WM[{2}], (geom::Pose{-1, 0, 0.5, 0})) << "its pose is where it is at 0";
}

TEST(Attach, refuses_what_holds_something_that_drives) {
  scene::SceneDesc scene;
  scene.models.push_back(model("tray", scene::ModelKind::kPlain, -1));
  scene.models.back().gripper_return = true;
  scene.models.push_back(model("tray.r", scene::ModelKind::kPosition, 0));
  scene.models.back().position.emplace();
  scene.models.push_back(model("s", scene::ModelKind::kPosition, -1));
  scene.models.back().position.emplace();
  World world(scene, 1);
  EXPECT_EQ(world.models.mobility[{0}], Mobility::kLoose);
  EXPECT_FALSE(attach(world, {0}, {2}, {}));
}

TEST_F(PopulationTest, what_a_robot_carried_stays_when_it_goes) {
  ASSERT_TRUE(attach(world, {4}, {3}, {}).ok());
  const geom::Pose there = world.models.X_WM[{4}];
  ASSERT_TRUE(despawn(world, {1}).ok());
  ASSERT_TRUE(world.row({4}).valid());
  EXPECT_EQ(world.models.X_WM[world.row({4})], there);
  expect_whole();
}

TEST_F(PopulationTest, names_are_found_as_in_a_world_that_never_changed) {
  scene::SceneDesc same = scene;
  same.models[4].name = "s";  // the wall's puck is called as the second robot, which is the last of the name
  for (const scene::SceneDesc* each : {&scene, static_cast<const scene::SceneDesc*>(&same)}) {
    World changed(*each, 1), fresh(*each, 1);
    ASSERT_TRUE(changed.find("s").valid()) << "from here on it knows names";
    for (const std::uint32_t prototype : {1u, 5u, 1u})
      for (World* world : {&changed, &fresh}) ASSERT_TRUE(spawn(*world, prototype, {}).ok());
    for (World* world : {&changed, &fresh}) {
      ASSERT_TRUE(despawn(*world, {5}).ok());
      ASSERT_TRUE(despawn(*world, {7}).ok());
    }
    World again(*each, 1);  // asked only now
    std::vector<std::byte> bytes;
    ASSERT_TRUE(save_state(fresh, bytes).ok());
    ASSERT_TRUE(load_state(again, bytes).ok());
    for (const char* name :
         {"wall", "r", "r~2", "r~3", "r~3.ranger:0", "s", "s~2", "s.ranger:0", "puck", "x"})
      EXPECT_EQ(changed.find(name), again.find(name)) << name;
  }
}

TEST_F(PopulationTest, peers_bring_so_many_models_sensors_and_beams_and_no_more) {
  const auto spawns_until_full = [](scene::SceneDesc scene, std::size_t most) {
    World full(scene, 1);
    std::size_t spawns = 0;
    while (spawns < most && check_budget(full)) {
      EXPECT_TRUE(spawn(full, 5, {}, "n" + std::to_string(spawns)));
      ++spawns;
    }
    return spawns;
  };
  scene::SceneDesc many = scene;  // of a robot with a ranger: two models
  EXPECT_EQ(spawns_until_full(many, 1 << 15), limits::kBroughtModels / 2);
  many.models[6].sensors.resize(64);
  EXPECT_EQ(spawns_until_full(many, 1 << 15), limits::kBroughtSensors / 64);
  for (scene::RangerSensorDesc& sensor : many.models[6].sensors) sensor.samples = 1024;
  EXPECT_EQ(spawns_until_full(many, 1 << 15), limits::kBroughtBeams / (64 * 1024));
  World whoever_went(scene, 1);
  for (std::size_t i = 0; i < 10; ++i) {
    const Result<ModelId> id = spawn(whoever_went, 5, {});
    ASSERT_TRUE(id && despawn(whoever_went, *id));
  }
  EXPECT_TRUE(check_budget(whoever_went));
}

TEST_F(PopulationTest, the_smallest_free_number_is_given_whoever_went) {
  std::vector<ModelId> ids;
  for (int number = 2; number < 12; ++number) {
    ids.push_back(spawned(1, {}));
    EXPECT_EQ(name(ids.back()), "r~" + std::to_string(number));
  }
  EXPECT_EQ(name(spawned(5, {})), "s~2") << "numbers are those of a name";
  spawned(1, {}, "r~12");
  ASSERT_TRUE(despawn(world, ids[3]).ok());
  EXPECT_EQ(name(spawned(1, {})), "r~5");
  EXPECT_EQ(name(spawned(1, {})), "r~13");
}

TEST_F(PopulationTest, several_are_attached_and_detached_as_they_would_be_one_by_one) {
  World other(scene, 1);
  std::vector<ModelId> pucks;
  std::vector<AttachedChild> attachments;
  for (int i = 0; i < 3; ++i) {
    pucks.push_back(spawned(4, {1.0 * i, 0, 0, 0}));
    ASSERT_TRUE(spawn(other, 4, {1.0 * i, 0, 0, 0}).ok());
    attachments.push_back({pucks.back(), {0.1 * i, 0.2, 0, 0.5}});
  }
  const auto kinds = [](const World& w) {
    std::vector<std::pair<Event::EventKind, Mobility>> list;
    for (const Event& event : w.events.since(0)) list.emplace_back(event.kind, event.mobility);
    return list;
  };
  ASSERT_TRUE(attach(world, attachments, {2}).ok());
  for (const auto& [child, X_PC] : attachments) ASSERT_TRUE(attach(other, child, {2}, X_PC).ok());
  EXPECT_EQ(world.hash(), other.hash());
  EXPECT_EQ(attached_models(world), pucks);
  expect_whole();
  EXPECT_FALSE(attach(world, attachments, {2}).ok()) << "they are parts already";
  EXPECT_FALSE(detach(world, std::vector{pucks[0], ModelId{1}}).ok()) << "all or nothing";
  EXPECT_EQ(world.hash(), other.hash());
  ASSERT_TRUE(detach(world, pucks).ok());
  for (const ModelId puck : pucks) ASSERT_TRUE(detach(other, puck).ok());
  EXPECT_EQ(world.hash(), other.hash());
  EXPECT_EQ(kinds(world), kinds(other));
  EXPECT_TRUE(attached_models(world).empty());
  expect_whole();
}

TEST_F(PopulationTest, several_go_as_they_would_one_by_one) {
  World other(scene, 1);
  std::vector<ModelId> going = {{5}, {1}};
  for (World* each : {&world, &other}) {
    for (int i = 0; i < 4; ++i) {
      const Result<ModelId> robot = spawn(*each, i % 2 == 0 ? 1 : 5, {1.0 * i, 0, 0, 0});
      ASSERT_TRUE(robot.ok());
      if (each == &world && i != 1) going.push_back(*robot);
    }
    const Result<ModelId> puck = spawn(*each, 4, {});
    ASSERT_TRUE(attach(*each, *puck, {8}, {}).ok());
    ASSERT_TRUE(attach(*each, {4}, *puck, {}).ok());
  }
  const std::uint64_t before = world.events.end();
  ASSERT_TRUE(despawn(world, going).ok());
  for (const ModelId each : going) ASSERT_TRUE(despawn(other, each).ok());
  expect_whole();
  EXPECT_EQ(first_difference(world, other), std::nullopt);
  EXPECT_EQ(world.hash(), other.hash());
  std::vector<ModelId> gone;
  for (const Event& event : world.events.since(before))
    if (event.kind == Event::EventKind::kDespawn) gone.push_back(event.model);
  EXPECT_EQ(gone, going);
  ASSERT_TRUE(despawn(world, std::vector(world.models.id)[0]).ok()) << "the wall";
}

TEST_F(PopulationTest, of_several_all_stay_where_one_cannot_go) {
  const std::uint64_t before = world.hash();
  EXPECT_FALSE(despawn(world, std::vector<ModelId>{{1}, {2}}).ok()) << "a part";
  EXPECT_FALSE(despawn(world, std::vector<ModelId>{{1}, {99}}).ok());
  EXPECT_FALSE(despawn(world, std::vector<ModelId>{{1}, {5}, {1}}).ok()) << "twice";
  EXPECT_EQ(world.hash(), before);
  EXPECT_EQ(world.events.end(), 0u);
  EXPECT_TRUE(despawn(world, std::span<const ModelId>()).ok());
}

TEST_F(PopulationTest, refuses_what_makes_no_world) {
  const std::uint64_t before = world.hash();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(spawn(world, 2, {}).ok()) << "a part";
  EXPECT_FALSE(spawn(world, 99, {}).ok());
  EXPECT_FALSE(spawn(world, 1, {nan, 0, 0, 0}).ok());
  EXPECT_FALSE(spawn(world, 1, {}, "puck").ok());
  EXPECT_FALSE(despawn(world, {2}).ok()) << "a part";
  EXPECT_FALSE(despawn(world, {99}).ok());
  EXPECT_FALSE(attach(world, {0}, {1}, {}).ok()) << "fixed";
  EXPECT_FALSE(attach(world, {5}, {1}, {}).ok()) << "drives";
  EXPECT_FALSE(attach(world, {4}, {4}, {}).ok());
  EXPECT_FALSE(attach(world, {4}, {99}, {}).ok());
  EXPECT_FALSE(attach(world, {4}, {1}, {0, nan, 0, 0}).ok());
  EXPECT_FALSE(detach(world, {4}).ok());
  EXPECT_FALSE(detach(world, {2}).ok()) << "part of the robot as the scene has it";
  EXPECT_EQ(world.hash(), before);
  EXPECT_EQ(world.events.end(), 0u);
}

TEST_F(PopulationTest, every_change_is_in_the_list) {
  const ModelId id = spawned(4, {1, 1, 0, 0});
  ASSERT_TRUE(attach(world, id, {1}, {}).ok());
  ASSERT_TRUE(detach(world, id).ok());
  ASSERT_TRUE(set_pose(world, world.row(id), {2, 2, 0, 0}));
  set_color(world, world.row(id), {});
  ASSERT_TRUE(despawn(world, id).ok());
  using EventKind = Event::EventKind;
  std::vector<EventKind> kinds;
  for (const Event& event : world.events.since(0)) {
    EXPECT_EQ(event.model, id);
    EXPECT_EQ(event.mobility, Mobility::kLoose);
    kinds.push_back(event.kind);
  }
  EXPECT_EQ(kinds, (std::vector<EventKind>{EventKind::kSpawn, EventKind::kAttach, EventKind::kDetach,
                                           EventKind::kPlace, EventKind::kSet, EventKind::kDespawn}));
  world.events.drop_before(4);
  EXPECT_EQ(world.events.since(0).size(), 2u);
  EXPECT_EQ(world.events.since(5).size(), 1u);
  EXPECT_EQ(world.events.end(), 6u);
}

TEST_F(PopulationTest, returns_to_the_start_with_whoever_is_there) {
  ASSERT_TRUE(despawn(world, {5}).ok());
  const ModelId id = spawned(5, {7, 8, 0, 1});
  ASSERT_TRUE(attach(world, {4}, {1}, {}).ok());
  ASSERT_TRUE(set_pose(world, world.row(id), {}));
  return_to_start(world);
  EXPECT_EQ(world.models.X_WM[world.row(id)], (geom::Pose{7, 8, 0, 1}));
  EXPECT_EQ(world.models.X_WM[{4}], (geom::Pose{3, 3, 0, 0}));
  EXPECT_FALSE(world.models.parent_id[{4}].valid());
  expect_whole();
}

TEST_F(PopulationTest, any_sequence_leaves_a_whole_world) {
  Rng rng(7);
  const auto some = [&](std::size_t below) { return static_cast<std::uint32_t>(rng.bits() % below); };
  const std::uint32_t prototypes[] = {0, 1, 4, 5};
  for (int step = 0; step < 400; ++step) {
    const ModelId any = world.models.size() > 0 ? world.models.id[{some(world.models.size())}] : ModelId{};
    const geom::Pose X{rng.uniform(-5, 5), rng.uniform(-5, 5), 0, rng.uniform(-3, 3)};
    switch (some(5)) {
      case 0:
      case 1:
        EXPECT_TRUE(spawn(world, prototypes[some(4)], X).ok());
        break;
      case 2:
        static_cast<void>(despawn(world, any).ok());
        break;
      case 3:
        if (world.models.size() > 0)
          static_cast<void>(attach(world, any, world.models.id[{some(world.models.size())}], X).ok());
        break;
      default:
        static_cast<void>(detach(world, any).ok());
    }
    if (step % 20 == 0) expect_whole();
  }
  EXPECT_GT(world.models.size(), 0u);
}

/// A state that somebody made up does no harm, whatever it says.
TEST_F(PopulationTest, a_state_cut_or_changed_anywhere_is_refused_or_is_a_whole_world) {
  spawned(1, {1, 1, 0, 0});
  ASSERT_TRUE(attach(world, {4}, {2}, {}).ok());
  ASSERT_TRUE(despawn(world, {5}).ok());
  std::vector<std::byte> bytes;
  ASSERT_TRUE(save_state(world, bytes).ok());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    World other(scene, 1);
    EXPECT_FALSE(load_state(other, std::span(bytes).first(size)).ok()) << size;
  }
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int flip : {0x01, 0x80, 0xff}) {
      std::vector<std::byte> changed = bytes;
      changed[at] ^= static_cast<std::byte>(flip);
      World other(scene, 1);
      if (!load_state(other, changed).ok()) continue;
      std::vector<std::byte> again;
      ASSERT_TRUE(save_state(other, again).ok());
      EXPECT_EQ(again, changed) << at;
      while (other.models.size() > 0)
        ASSERT_TRUE(despawn(other, other.id(other.models.root[{0}])).ok()) << at;
    }
  }
}

/// Three robots of one description and a puck, as the loader makes it.
scene::SceneDesc shared_scene() {
  scene::SceneDesc scene = make_scene();
  scene.models.resize(5);
  scene.models[1].color = {0, 1, 0, 1};
  scene.models[1].fiducial_return = 3;
  scene.trees = {{1, "r", "position:0", {}, {1, 1, 0, 0}, {0, 1, 0, 1}, 3},
                 {4, "puck", "model:1", {}, {3, 3, 0, 0}, {}, 0},
                 {1, "s", "position:1", {}, {2, 1, 0, 0}, {}, 0},
                 {1, "t.u", "position:2", {}, {3, 1, 0, 1}, {}, 0}};
  scene.renamed[{2, 1}] = {"elsewhere", "s.ranger:0"};
  return scene;
}

TEST(SharedScene, makes_the_world_that_a_scene_with_a_description_for_each_model_makes) {
  const scene::SceneDesc shared = shared_scene(), each = scene::expanded(shared);
  ASSERT_EQ(each.models.size(), 10u);
  World a(shared, 1), b(each, 1);
  const auto expect_same = [&] {
    EXPECT_EQ(a.hash(), b.hash());
    EXPECT_EQ(a.sensed_hash(), b.sensed_hash());
    each_column(
        [](const auto& column, const auto& values, const auto& others) {
          if (std::string_view(column.name) != "models.desc") EXPECT_EQ(values, others) << column.name;
        },
        a, b);
    for (const ModelRow row : a.models.rows()) {
      EXPECT_EQ(a.name({row}), b.name({row}));
      EXPECT_EQ(a.alias({row}), b.alias({row}));
      for (const std::string& token : {a.name({row}), a.alias({row})})
        EXPECT_EQ(a.find(token), b.find(token)) << token;
      EXPECT_EQ(a.find(a.name({row})), ModelRow{row}) << a.name({row});
    }
  };
  expect_same();
  for (World* world : {&a, &b}) {
    ASSERT_TRUE(spawn(*world, 0 + (world == &a ? 1u : 0u), {9, 9, 0, 0}, "new"));
    ASSERT_TRUE(set_pose(*world, {1}, {0.1, 0.2, 0.3, 0.4}));
    set_color(*world, {7}, {0, 0, 1, 1});
    ASSERT_TRUE(despawn(*world, {3}));
  }
  expect_same();
  return_to_start(a);
  return_to_start(b);
  expect_same();
  EXPECT_FALSE(a.find("puck").valid());
  EXPECT_FALSE(a.find("s.ranger:0.none").valid());
}

TEST(SharedScene, keeps_what_models_have_in_common_once) {
  const scene::SceneDesc scene = shared_scene();
  const World world(scene, 1);
  EXPECT_TRUE(world.models.X_PM.is_own({0})) << "it drives";
  EXPECT_FALSE(world.models.X_PM.is_own({1}));
  EXPECT_FALSE(world.models.color.is_own({0}));
  EXPECT_TRUE(world.models.color.is_own({4})) << "not as the first of its like";
  EXPECT_FALSE(world.models.say.is_own({0}));
}

TEST(SharedColumn, is_a_column_of_values_whoever_has_them) {
  std::vector<std::uint32_t> prototypes;
  SharedColumn<double> column(prototypes);
  column.set_prototypes({1, 2});
  std::vector<double> expected;
  Rng rng(1, 0, {Purpose::kColor, 0});
  for (int step = 0; step < 2000; ++step) {
    const auto row = static_cast<std::size_t>(rng.uniform() * static_cast<double>(expected.size()));
    const double action = rng.uniform();
    if (expected.empty() || action < 0.4) {
      const std::uint32_t prototype = rng.uniform() < 0.5 ? 0 : 1;
      prototypes.push_back(prototype);
      expected.push_back(prototype + 1);
    } else if (action < 0.7) {
      column.set(row, action);
      expected[row] = action;
    } else if (action < 0.9) {
      column.set(row, 1);
      expected[row] = 1;
    } else if (action < 0.98) {
      struct Run {
        std::size_t begin, end;
      };
      const std::size_t size = expected.size(), end = std::min(row + 3, size);
      const Run runs[] = {{row, end}, {end, end}, {std::min(end + 2, size), std::min(end + 3, size)}};
      column.erase(runs);
      const auto erase_from = [&](auto& values) {
        for (const Run& run : {runs[2], runs[0]})
          values.erase(values.begin() + static_cast<std::ptrdiff_t>(run.begin),
                       values.begin() + static_cast<std::ptrdiff_t>(run.end));
      };
      erase_from(prototypes);
      erase_from(expected);
    } else {
      column.clear();
      prototypes.clear();
      expected.clear();
    }
    ASSERT_EQ(column.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(column[i], expected[i]) << step;
  }
  prototypes = {0};
  SharedColumn<double> zeros(prototypes);
  zeros.set_prototypes({0.0});
  zeros.set(0, -0.0);
  EXPECT_TRUE(std::signbit(zeros[0]));
}

TEST(SharedColumn, takes_the_value_of_another_row) {
  std::vector<std::uint32_t> prototypes(100);
  SharedColumn<double> column(prototypes);
  column.set_prototypes({1});
  column.set(0, 7);
  for (std::size_t row = 1; row < prototypes.size(); ++row) column.set(row, column[row - 1]);
  for (std::size_t row = 0; row < prototypes.size(); ++row) EXPECT_EQ(column[row], 7) << row;
}

}  // namespace
}  // namespace playhouse::world
