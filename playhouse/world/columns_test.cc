#include "playhouse/world/columns.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "playhouse/scene/kinds.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/population.h"
#include "playhouse/world/state.h"
#include "playhouse/world/testing_scene.h"
#include "playhouse/world/values.h"

namespace playhouse::world {
namespace {

using testing::small_scene;

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

}  // namespace
}  // namespace playhouse::world
