#include "playhouse/world/world.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "playhouse/scene/kinds.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/columns.h"
#include "playhouse/world/population.h"
#include "playhouse/world/state.h"
#include "playhouse/world/values.h"
#include "playhouse/world/workers.h"

namespace playhouse::world {
namespace {

/// A robot "r" at (1, 2, 90 degrees) with a two-beam ranger 0.1 m ahead of it, and a box "box".
scene::SceneDesc small_scene() {
  scene::SceneDesc scene;
  scene::ModelDesc robot;
  robot.name = "r";
  robot.alias = "position:0";
  robot.kind = scene::ModelKind::kPosition;
  robot.X_PM = {1, 2, 0, geom::kPi / 2};
  robot.position.emplace();
  scene::ModelDesc ranger;
  ranger.name = "r.ranger:0";
  ranger.alias = ranger.name;
  ranger.kind = scene::ModelKind::kRanger;
  ranger.parent = 0;
  ranger.X_PM = {0.1, 0, 0.2, 0};
  ranger.sensors.resize(1);
  ranger.sensors[0].samples = 2;
  scene::ModelDesc box;
  box.name = "box";
  box.alias = "model:1";
  scene.models = {robot, ranger, box};
  return scene;
}

TEST(World, finds_models_by_name_and_by_default_name) {
  const scene::SceneDesc scene = small_scene();
  const World world(scene, 1);
  EXPECT_EQ(world.find("r"), ModelRow{0});
  EXPECT_EQ(world.find("position:0"), ModelRow{0});
  EXPECT_EQ(world.find("model:1"), ModelRow{2});
  EXPECT_FALSE(world.find("nobody").valid());
  std::vector<std::uint32_t> children;
  for (const std::uint32_t child : world.children({0})) children.push_back(child);
  EXPECT_EQ(children, std::vector<std::uint32_t>{1});
  EXPECT_EQ(world.models.root[1], 0u);
}

TEST(World, of_equal_names_the_last_wins_and_a_given_name_beats_a_default_one) {
  scene::SceneDesc scene = small_scene();
  scene.models[0].name = "model:1";
  scene.models[1].name = "same";
  scene.models[2].name = "same";
  const World world(scene, 1);
  EXPECT_EQ(world.find("same"), ModelRow{2});
  EXPECT_EQ(world.find("model:1"), ModelRow{0});
}

TEST(World, children_follow_when_their_parent_is_put_elsewhere) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  EXPECT_NEAR(world.models.X_WM[1].x, 1.0, 1e-12);
  EXPECT_NEAR(world.models.X_WM[1].y, 2.1, 1e-12);
  EXPECT_NEAR(world.models.X_WM[1].z, 0.2, 1e-12);
  ASSERT_TRUE(set_pose(world, {0}, {-1, 0, 0, 0}));
  EXPECT_NEAR(world.models.X_WM[1].x, -0.9, 1e-12);
  EXPECT_NEAR(world.models.X_WM[1].y, 0, 1e-12);
  ASSERT_EQ(world.changes.since(0).size(), 1u);
  EXPECT_EQ(world.changes.since(0)[0].kind, Change::Kind::kPlace);
  EXPECT_EQ(world.changes.since(0)[0].model, ModelId{0});
  EXPECT_NEAR(world.positions.X_OM[0].x, -1, 1e-12);
}

TEST(World, gps_without_an_origin_is_the_true_pose_and_odometry_starts_at_zero) {
  scene::SceneDesc scene = small_scene();
  EXPECT_NEAR(World(scene, 1).positions.X_OM[0].y, 2, 1e-12);
  scene.models[0].position->localization_origin = geom::Pose{1, 0, 0, 0};
  EXPECT_NEAR(World(scene, 1).positions.X_OM[0].x, 0, 1e-12);
  EXPECT_NEAR(World(scene, 1).positions.X_OM[0].y, 2, 1e-12);
  scene.models[0].position->localization_origin.reset();
  scene.models[0].position->localization = scene::Localization::kOdometry;
  EXPECT_NEAR(World(scene, 1).positions.X_OM[0].y, 0, 1e-12);
}

TEST(World, tilted_models_take_their_parts_along_in_space) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  world.upright = false;
  ASSERT_TRUE(set_spatial_pose(world, {0}, {{1, 2, 0.5, geom::kPi / 2}, {0, geom::kPi / 2}}));  // nose down
  EXPECT_NEAR(world.models.X_WM[1].x, 1, 1e-12);
  EXPECT_NEAR(world.models.X_WM[1].y, 2.2, 1e-12) << "what was above it is ahead";
  EXPECT_NEAR(world.models.X_WM[1].z, 0.4, 1e-12) << "what was ahead is below";
  EXPECT_NEAR(world.models.tilt_WM[1].y, geom::kPi / 2, 1e-12);
  ASSERT_TRUE(set_pose(world, {0}, {0, 0, 0, 0}));
  EXPECT_NEAR(world.models.X_WM[1].z, -0.1, 1e-12) << "it is as tilted as it was";
  return_to_start(world);
  EXPECT_EQ(world.models.X_WM[1], World(scene, 1).models.X_WM[1]);
  EXPECT_EQ(world.models.tilt_WM[0], geom::Tilt{});
}

TEST(World, what_comes_off_a_tilted_model_stays_as_it_stands) {
  scene::SceneDesc scene = small_scene();
  scene.models[2].gripper_return = true;
  World world(scene, 1);
  world.upright = false;
  ASSERT_TRUE(set_spatial_pose(world, {0}, {{0, 0, 1, 0}, {0.5, 0}}));
  ASSERT_TRUE(set_spatial_pose(world, {2}, {{5, 5, 0, 0}, {0, 1}}));
  ASSERT_TRUE(attach(world, {2}, {0}, {0, 0.3, 0, 0}));
  const geom::SpatialPose held = pose_in_world(world.models, {2});
  EXPECT_EQ(world.models.tilt_PM[2], geom::Tilt{}) << "it is put down flat";
  EXPECT_NEAR(held.tilt.x, 0.5, 1e-12);
  ASSERT_TRUE(detach(world, {2}));
  EXPECT_EQ(pose_in_parent(world.models, {2}), held);
}

TEST(World, of_an_engine_that_keeps_models_upright_has_no_tilts) {
  const scene::SceneDesc scene = small_scene();
  World upright(scene, 1), tilting(scene, 1);
  tilting.upright = false;
  const geom::SpatialPose X_WM{{1, 2, 3, 0.5}, {0.25, 0}};
  for (World* world : {&upright, &tilting}) ASSERT_TRUE(set_spatial_pose(*world, {0}, X_WM));
  EXPECT_EQ(pose_in_world(tilting.models, {0}), X_WM);
  EXPECT_EQ(pose_in_world(upright.models, {0}), (geom::SpatialPose{X_WM.X, {}}));
  std::vector<std::byte> saved;
  ASSERT_TRUE(save_state(tilting, saved));
  World other(scene, 1);
  other.upright = false;
  ASSERT_TRUE(load_state(other, saved));
  EXPECT_EQ(pose_in_world(other.models, {1}), pose_in_world(tilting.models, {1}));
  const Result<void> loaded = load_state(upright, saved);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().text, "has models that are tilted, and this engine keeps all upright");
}

TEST(World, a_robot_told_where_it_is_believes_it_also_after_it_was_moved) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  ASSERT_TRUE(set_odometry(world, {0}, {5, 6, 0, 0}));
  EXPECT_EQ(world.positions.X_OM[0].x, 5);
  ASSERT_TRUE(set_pose(world, {0}, {1, 3, 0, geom::kPi / 2}));  // a metre ahead
  EXPECT_NEAR(world.positions.X_OM[0].x, 6, 1e-12);
  EXPECT_NEAR(world.positions.X_OM[0].y, 6, 1e-12);
}

TEST(World, refuses_numbers_that_are_not_finite) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  const std::uint64_t before = world.hash();
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(command_velocity(world, {0}, {nan, 0, 0, 0}));
  EXPECT_FALSE(command_position(world, {0}, {0, infinite, 0, 0}));
  EXPECT_FALSE(command_acceleration(world, {0}, {0, 0, 0, nan}));
  EXPECT_FALSE(set_odometry(world, {0}, {nan, 0, 0, 0}));
  EXPECT_FALSE(set_pose(world, {0}, {0, 0, infinite, 0}));
  EXPECT_FALSE(set_spatial_pose(world, {0}, {{}, {nan, 0}}));
  EXPECT_FALSE(set_spatial_pose(world, {0}, {{}, {0, 4}}));
  EXPECT_EQ(world.hash(), before);
}

TEST(World, refuses_places_whose_distance_is_no_number) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  const std::uint64_t before = world.hash();
  for (const geom::Pose& far : {geom::Pose{1e308, 0, 0, 0}, {0, -1e308, 0, 0}, {0, 0, 2e9, 0}}) {
    EXPECT_FALSE(command_position(world, {0}, far));
    EXPECT_FALSE(set_odometry(world, {0}, far));
    EXPECT_FALSE(set_pose(world, {0}, far));
  }
  EXPECT_EQ(world.hash(), before);
  EXPECT_TRUE(set_pose(world, {0}, {-1e9, 1e9, 0, 1e300})) << "any angle is one";
}

TEST(World, returns_to_its_start_but_keeps_its_time_and_users) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  const std::uint64_t start = world.hash();
  subscribe(world, {0});
  world.tick_ = 7;
  ASSERT_TRUE(set_pose(world, {0}, {5, 5, 0, 1}));
  ASSERT_TRUE(set_pose(world, {1}, {0.2, 0, 0.2, 1}));
  ASSERT_TRUE(command_velocity(world, {0}, {1, 0, 0, 1}));
  ASSERT_TRUE(set_odometry(world, {0}, {9, 9, 0, 0}));
  world.positions.motor_on[0] = 0;
  const std::uint64_t before = world.changes.end();
  return_to_start(world);
  const auto changes = world.changes.since(before);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].model, ModelId{0});
  EXPECT_EQ(changes[1].model, ModelId{1});
  EXPECT_EQ(world.tick(), 7u);
  EXPECT_EQ(world.models.subscribers[0], 1u);
  unsubscribe(world, {0});
  world.tick_ = 0;
  EXPECT_EQ(world.hash(), start);
}

TEST(World, the_last_unsubscribe_stops_the_robot) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  subscribe(world, {0});
  subscribe(world, {0});
  ASSERT_TRUE(command_velocity(world, {0}, {0.5, 0, 0, 0}));
  unsubscribe(world, {0});
  EXPECT_EQ(world.positions.command[0].x, 0.5);
  unsubscribe(world, {0});
  EXPECT_EQ(world.positions.command[0].x, 0.0);
}

TEST(World, the_odometry_error_is_drawn_per_robot_from_the_seed) {
  const scene::SceneDesc scene = small_scene();
  const geom::Twist first = World(scene, 1).positions.odom_error[0];
  EXPECT_EQ(first, World(scene, 1).positions.odom_error[0]);
  EXPECT_NE(first, World(scene, 2).positions.odom_error[0]);
  EXPECT_LE(std::fabs(first.x), 0.015);
  EXPECT_LE(std::fabs(first.a), 0.025);
}

/// Changes one part of a value; false: it has no such part.
template <typename T>
bool change(T& value, int part) {
  if constexpr (std::is_same_v<T, std::string>) {
    value += '!';
    return part == 0;
  } else if constexpr (kIsList<T>) {
    if (part > 0) return change(value[0], part - 1);
    value.emplace_back();
    return true;
  } else {
    int numbers = 0;
    each_number(value, [&](auto& number) {
      using Number = std::remove_cvref_t<decltype(number)>;
      if (numbers++ != part) return;
      if constexpr (std::is_floating_point_v<Number>) {
        number += 1;
      } else {
        number = static_cast<Number>(static_cast<int>(number) ^ 1);
      }
    });
    return part < numbers;
  }
}

/// The value of the first row, to be changed.
template <typename T>
T& first_of(std::vector<T>& values) {
  return values[0];
}
template <typename T>
T& first_of(SharedColumn<T>& values) {
  return values.own(0);
}

/// small_scene() with a model of every further kind on the robot, of which each list has one thing.
class EveryColumn : public ::testing::Test {
 protected:
  EveryColumn() { see_one_thing(world); }

  static void see_one_thing(World& world) {
    each_column(
        [](const auto&, auto& values) {
          using Value = typename std::remove_cvref_t<decltype(values)>::value_type;
          if constexpr (kIsList<Value> && !std::is_same_v<Value, std::string>) values[0].emplace_back();
        },
        world);
    world.wifis.incoming[0][0].size = world.wifis.outgoing[0][0].size = 1;  // as the lists of bytes have it
  }

  /// The values of a column of any table.
  template <typename Table, typename Values>
  static const Values& column_of(const World& world, const Column<Table, Values>& column) {
    return world.*std::get<Table Tables::*>(kTables).*column.values;
  }

  static scene::SceneDesc make_scene() {
    scene::SceneDesc scene = small_scene();
    auto place = scene.models.begin() + 2;
    for (const scene::Kind& kind : scene::kinds()) {
      const bool is_there = scene::ModelKind::kPlain == kind.kind ||
                            kind.kind == scene::ModelKind::kPosition ||
                            kind.kind == scene::ModelKind::kRanger;
      if (kind.entity != scene::EntityForm::kModel || !kind.simulated || is_there) continue;
      scene::MemoryFiles none({});
      const auto loaded =
          scene::load_world_text(std::string(kind.name) + "( size [0.1 0.1 0.1] )", "t.world", none);
      scene::ModelDesc model = loaded.value().models.at(0);  // with the words of its kind
      model.parent = 0;
      model.joules = 5;
      place = scene.models.insert(place, model) + 1;
    }
    return scene;
  }
  /// Controllers read every part of the robot.
  static void control_parts(World& w) {
    for (std::uint32_t row = 1; row < w.models.size(); ++row)
      if (w.models.parent[row] == 0) subscribe_controller(w, {row});
  }

  const scene::SceneDesc scene = make_scene();
  World world{scene, 1};
};

TEST_F(EveryColumn, has_a_row_to_change_and_a_name_of_its_own) {
  std::set<std::string> names;
  each_column(
      [&](const auto& column, const auto& values) {
        EXPECT_FALSE(values.empty()) << column.name;
        EXPECT_TRUE(names.insert(column.name).second) << column.name;
      },
      world);
}

/// Changes each part of the first value of a column.
template <typename Values>
PLAYHOUSE_PER_TYPE void expect_seen_by(World& world, const char* name, Values& values, bool by_hash,
                                       bool by_sensed_hash) {
  const std::uint64_t hash = world.hash(), sensed_hash = world.sensed_hash();
  const auto before = values;
  for (int part = 0; change(first_of(values), part); ++part, values = before) {
    EXPECT_EQ(world.hash() != hash, by_hash) << name << ", part " << part;
    EXPECT_EQ(world.sensed_hash() != sensed_hash, by_sensed_hash) << name << ", part " << part;
  }
  values = before;
}

TEST_F(EveryColumn, is_seen_by_the_hash_that_its_role_names) {
  const auto expect_seen = [&](bool controlled) {
    each_column(
        [&](const auto& column, auto& values) {
          if (column.role == Role::kDerived) return;            // what it follows from is seen
          if (controlled && column.role == Role::kUse) return;  // it says who is controlled
          const bool in_done = is_done(column.role) || (column.role == Role::kSensed && controlled);
          const bool is_id = std::string_view(column.name) == "models.id";  // every hash of a model has it
          const bool in_sensed = column.role == Role::kSensed || column.role == Role::kUse || is_id;
          expect_seen_by(world, column.name, values, in_done, in_sensed);
        },
        world);
  };
  expect_seen(false);
  control_parts(world);
  expect_seen(true);
  const std::uint64_t before = world.hash();
  world.tick_ = 1;
  EXPECT_NE(world.hash(), before);
}

TEST_F(EveryColumn, says_its_unit_and_frame_where_it_has_one) {
  each_column(
      [](const auto& column, const auto& values) {
        using Value = typename std::remove_cvref_t<decltype(values)>::value_type;
        const bool is_pose = std::is_same_v<Value, geom::Pose> || std::is_same_v<Value, geom::Twist> ||
                             std::is_same_v<Value, geom::Tilt> || std::is_same_v<Value, geom::Vec3> ||
                             std::is_same_v<Value, geom::SpatialVelocity>;
        EXPECT_EQ(is_pose, std::string_view(column.frame).size() > 0 && !kIsList<Value>) << column.name;
        if (is_pose || std::is_same_v<Value, float>) EXPECT_STRNE(column.unit, "") << column.name;
      },
      world);
}

/// For every column and every part of its first value: save, load and comparison keep what the role says.
class SavedColumn : public EveryColumn {
 protected:
  SavedColumn() {
    prepare(world);
    prepare(original);
    see_one_thing(original);
  }
  static void prepare(World& w) {
    control_parts(w);
    w.upright = false;
    w.tick_ = 5;
  }

  /// Changes each part of the first value of a column; `column_in` is the column in a loaded world.
  template <typename Values>
  PLAYHOUSE_PER_TYPE void expect_kept(const char* name, Values& values, bool kept,
                                      const std::function<const Values&(const World&)>& column_in) {
    const auto before = values;
    for (int part = 0; change(first_of(values), part); ++part, values = before) {
      std::vector<std::byte> bytes;
      ASSERT_TRUE(save_state(world, bytes));
      World loaded(scene, 1);
      prepare(loaded);
      const Result<void> result = load_state(loaded, bytes);
      if (!result) {  // a mode that is none, a sensor of the future
        EXPECT_TRUE(result.error().text.starts_with("is damaged")) << result.error().text;
        continue;
      }
      EXPECT_EQ(column_in(loaded) == values, kept) << name << ", part " << part;
      const std::optional<Difference> difference = first_difference(loaded, original);
      EXPECT_EQ(difference.has_value(), kept) << name << ", part " << part;
      if (difference) EXPECT_EQ(difference->column, name) << part;
    }
    values = before;
  }

  World original{scene, 1};
};

TEST_F(SavedColumn, is_saved_loaded_and_compared_as_its_role_says) {
  each_column(
      [&](const auto& column, auto& values) {
        if (column.role == Role::kPopulation) return;  // population_test.cc
        using Values = std::remove_cvref_t<decltype(values)>;
        expect_kept<Values>(column.name, values, is_saved(column.role),
                            [&](const World& w) -> const Values& { return column_of(w, column); });
      },
      world);
}

TEST_F(EveryColumn, returns_to_the_start_if_it_says_how_things_move) {
  const World start(scene, 1);
  each_column(
      [](const auto& column, auto& values) {
        if (column.role != Role::kPopulation && column.role != Role::kDerived) change(first_of(values), 0);
      },
      world);
  return_to_start(world);
  each_column(
      [](const auto& column, const auto& values, const auto& first_values) {
        const bool changed =
            column.role == Role::kMark || column.role == Role::kSensed || column.role == Role::kUse;
        EXPECT_EQ(values == first_values, !changed) << column.name;
      },
      world, start);
}

TEST_F(EveryColumn, counts_as_memory) {
  each_column(
      [&](const auto& column, auto& values) {
        const std::size_t before = world.bytes(), more = 1000;
        if constexpr (kIsShared<std::remove_cvref_t<decltype(values)>>) {
          values.reserve(values.bytes() + more);  // more rows than it has bytes
          EXPECT_GT(world.bytes(), before + more * sizeof(std::uint32_t)) << column.name;
        } else {
          values.reserve(values.capacity() + more);
          EXPECT_EQ(world.bytes(), before + more * sizeof(values[0])) << column.name;
        }
      },
      world);
  std::vector<FiducialHit>& hits = world.fiducials.hits[0];
  const std::size_t before = world.bytes(), room = hits.capacity();
  std::string& say = world.models.say.own(0);
  const std::size_t with_own = world.bytes();
  EXPECT_GE(with_own, before + sizeof(std::string));
  say.assign(99, 'x');
  hits.reserve(room + 50);
  EXPECT_EQ(world.bytes(), with_own + say.capacity() + 1 + 50 * sizeof(FiducialHit));
}

TEST(World, models_carry_neither_less_than_no_flag_nor_more_than_can_be_counted) {
  const scene::SceneDesc scene = small_scene();
  World world(scene, 1);
  add_flags(world, {1}, 3);
  add_flags(world, {1}, -1);
  EXPECT_EQ(world.models.flags[1], 2);
  add_flags(world, {1}, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(world.models.flags[1], 0);
  add_flags(world, {1}, 5);
  add_flags(world, {1}, std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(world.models.flags[1], std::numeric_limits<std::int32_t>::max());
}

TEST(World, whoever_watches_changes_the_hash_of_what_is_sensed_alone) {
  const scene::SceneDesc scene = small_scene();
  World watched(scene, 1), alone(scene, 1);
  for (const std::uint32_t model : {0u, 1u}) subscribe(watched, {model});
  watched.sensors.ranges[0] = 2;
  watched.rangers.measured_tick[0] = 1;
  EXPECT_EQ(watched.hash(), alone.hash());
  EXPECT_NE(watched.sensed_hash(), alone.sensed_hash());
}

TEST(Workers, cover_every_row_once) {
  for (const unsigned count : {1u, 2u, 4u}) {
    Workers workers(count);
    std::vector<int> touched(1001, 0);
    std::atomic<bool> numbered = true;
    workers.run(touched.size(), 10, [&](std::size_t begin, std::size_t end) {
      if (workers.current() >= workers.count()) numbered = false;
      for (std::size_t i = begin; i < end; ++i) ++touched[i];
    });
    EXPECT_TRUE(numbered);
    EXPECT_EQ(touched, std::vector<int>(1001, 1));
  }
}

}  // namespace
}  // namespace playhouse::world
