#include "playhouse/world/columns.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "playhouse/scene/kinds.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/state.h"
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

/// A column of a world, whatever the type of its values: tests loop over these, and are compiled once.
class AnyColumn {
 public:
  template <typename Table, typename Of>
  explicit AnyColumn(const Column<Table, Of>& column)
      : name(column.name), unit(column.unit), frame(column.frame), role(column.role) {}
  virtual ~AnyColumn() = default;

  virtual bool empty() const = 0;
  /// Changes one part of the first value; false: it has no such part.
  virtual bool change_part(int part) = 0;
  /// Undoes what has been changed.
  virtual void restore() = 0;
  virtual bool equals_in(const World& other) const = 0;
  /// Reserves room for more values. Returns the number of bytes that this takes, at least.
  virtual std::size_t reserve_more(std::size_t values) = 0;

  const char *name, *unit, *frame;
  Role role;
  bool is_float = false, is_list = false, is_pose = false, is_shared = false;  // of its values
};

/// One type for each type of values, whatever their table: the column of another world is in the same place.
template <typename Values>
class TypedColumn : public AnyColumn {
 public:
  template <typename Table, typename Of>
  TypedColumn(const Column<Table, Of>& column, const World& world, Values& values)
      : AnyColumn(column), values_(values), before_(values), offset_(place_of(values) - place_of(world)) {
    using Value = typename Values::value_type;
    is_float = std::is_same_v<Value, float>;
    is_list = kIsList<Value>;
    is_pose = std::is_same_v<Value, geom::Pose> || std::is_same_v<Value, geom::Twist> ||
              std::is_same_v<Value, geom::Tilt> || std::is_same_v<Value, geom::Vec3> ||
              std::is_same_v<Value, geom::SpatialVelocity>;
    is_shared = kIsShared<Values>;
  }

  bool empty() const override { return values_.empty(); }
  bool change_part(int part) override { return change(first_of(values_), part); }
  void restore() override { values_ = before_; }
  bool equals_in(const World& other) const override {
    return *reinterpret_cast<const Values*>(place_of(other) + offset_) == values_;
  }
  std::size_t reserve_more(std::size_t more) override {
    if constexpr (kIsShared<Values>) {
      values_.reserve(values_.bytes() + more);  // more rows than it has bytes
      return more * sizeof(std::uint32_t);
    } else {
      values_.reserve(values_.capacity() + more);
      return more * sizeof(values_[0]);
    }
  }

 private:
  template <typename T>
  static const std::byte* place_of(const T& object) {
    return reinterpret_cast<const std::byte*>(&object);
  }

  Values& values_;
  const Values before_;
  const std::ptrdiff_t offset_;
};

std::vector<std::unique_ptr<AnyColumn>> columns_of(World& world) {
  std::vector<std::unique_ptr<AnyColumn>> columns;
  each_column(
      [&]<typename Values>(const auto& column, Values& values) {
        columns.push_back(std::make_unique<TypedColumn<Values>>(column, world, values));
      },
      world);
  return columns;
}

/// small_scene() with a model of every further kind on the robot, of which each list has one thing.
class EveryColumn : public ::testing::Test {
 protected:
  EveryColumn() { see_one_thing(world); }

  static void see_one_thing(World& world) {
    each_column(
        [](const auto&, auto& values) {
          using Value = typename std::remove_cvref_t<decltype(values)>::value_type;
          if constexpr (kIsList<Value> && !std::is_same_v<Value, std::string>)
            first_of(values).emplace_back();
        },
        world);
    world.wifis.incoming[{0}][0].size = world.wifis.outgoing[{0}][0].size =
        1;  // as the lists of bytes have it
  }

  static scene::SceneDesc make_scene() {
    scene::SceneDesc scene = small_scene();
    auto place = scene.models.begin() + 2;
    for (const scene::Kind& kind : scene::kinds()) {
      const bool is_there = scene::ModelKind::kPlain == kind.kind ||
                            kind.kind == scene::ModelKind::kPosition ||
                            kind.kind == scene::ModelKind::kRanger;
      if (kind.entity != scene::EntityForm::kModel || !kind.simulated || is_there) continue;
      config::MemoryFiles none({});
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
    for (const ModelRow row : w.models.rows())
      if (w.models.parent[row] == ModelRow{0}) subscribe_controller(w, row);
  }

  const scene::SceneDesc scene = make_scene();
  World world{scene, 1};
};

TEST_F(EveryColumn, has_a_row_to_change_and_a_name_of_its_own) {
  std::set<std::string> names;
  for (const auto& column : columns_of(world)) {
    EXPECT_FALSE(column->empty()) << column->name;
    EXPECT_TRUE(names.insert(column->name).second) << column->name;
  }
}

/// Changes each part of the first value of a column.
void expect_seen_by(World& world, AnyColumn& column, bool by_hash, bool by_sensed_hash) {
  const std::uint64_t hash = world.hash(), sensed_hash = world.sensed_hash();
  for (int part = 0; column.change_part(part); ++part, column.restore()) {
    EXPECT_EQ(world.hash() != hash, by_hash) << column.name << ", part " << part;
    EXPECT_EQ(world.sensed_hash() != sensed_hash, by_sensed_hash) << column.name << ", part " << part;
  }
  column.restore();
}

TEST_F(EveryColumn, is_seen_by_the_hash_that_its_role_names) {
  const auto expect_seen = [&](bool controlled) {
    for (const auto& column : columns_of(world)) {
      const Role role = column->role;
      if (role == Role::kDerived) continue;            // what it follows from is seen
      if (controlled && role == Role::kUse) continue;  // it says who is controlled
      const bool in_done = is_done(role) || (role == Role::kSensed && controlled);
      const bool is_id = std::string_view(column->name) == "models.id";  // every hash of a model has it
      expect_seen_by(world, *column, in_done, role == Role::kSensed || role == Role::kUse || is_id);
    }
  };
  expect_seen(false);
  control_parts(world);
  expect_seen(true);
  const std::uint64_t before = world.hash();
  world.tick_ = 1;
  EXPECT_NE(world.hash(), before);
}

TEST_F(EveryColumn, says_its_unit_and_frame_where_it_has_one) {
  for (const auto& column : columns_of(world)) {
    EXPECT_EQ(column->is_pose, std::string_view(column->frame).size() > 0 && !column->is_list)
        << column->name;
    if (column->is_pose || column->is_float) EXPECT_STRNE(column->unit, "") << column->name;
  }
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

  /// The world as it is now, saved and loaded; nothing if a value is refused: an invalid mode, a
  /// sensor of the future.
  std::unique_ptr<World> loaded_again() const {
    std::vector<std::byte> bytes;
    EXPECT_TRUE(save_state(world, bytes));
    auto loaded = std::make_unique<World>(scene, 1);
    prepare(*loaded);
    const Result<void> result = load_state(*loaded, bytes);
    if (result) return loaded;
    EXPECT_TRUE(result.error().text.starts_with("is damaged")) << result.error().text;
    return nullptr;
  }

  World original{scene, 1};
};

TEST_F(SavedColumn, is_saved_loaded_and_compared_as_its_role_says) {
  for (const auto& column : columns_of(world)) {
    if (column->role == Role::kPopulation) continue;  // population_test.cc
    const bool kept = is_saved(column->role);
    for (int part = 0; column->change_part(part); ++part, column->restore()) {
      const std::unique_ptr<World> loaded = loaded_again();
      if (loaded == nullptr) continue;
      EXPECT_EQ(column->equals_in(*loaded), kept) << column->name << ", part " << part;
      const std::optional<Difference> difference = first_difference(*loaded, original);
      EXPECT_EQ(difference.has_value(), kept && column->role != Role::kShown)
          << column->name << ", part " << part;
      if (difference) EXPECT_EQ(difference->column, column->name) << part;
    }
    column->restore();
  }
}

TEST_F(EveryColumn, returns_to_the_start_if_it_says_how_things_move) {
  const World start(scene, 1);
  const auto columns = columns_of(world);
  for (const auto& column : columns)
    if (column->role != Role::kPopulation && column->role != Role::kDerived) column->change_part(0);
  return_to_start(world);
  for (const auto& column : columns) {
    const bool stays = column->role == Role::kMark || column->role == Role::kSetting ||
                       column->role == Role::kShown || column->role == Role::kSensed ||
                       column->role == Role::kUse;
    EXPECT_EQ(column->equals_in(start), !stays) << column->name;
  }
}

TEST_F(EveryColumn, counts_as_memory) {
  for (const auto& column : columns_of(world)) {
    const std::size_t before = world.bytes();
    const std::size_t more = column->reserve_more(1000);
    if (column->is_shared)
      EXPECT_GT(world.bytes(), before + more) << column->name;
    else
      EXPECT_EQ(world.bytes(), before + more) << column->name;
  }
  std::vector<FiducialHit>& hits = world.fiducials.hits[{0}];
  const std::size_t before = world.bytes(), room = hits.capacity();
  std::string& say = world.models.say.own({0});
  const std::size_t with_own = world.bytes();
  EXPECT_GE(with_own, before + sizeof(std::string));
  say.assign(99, 'x');
  hits.reserve(room + 50);
  EXPECT_EQ(world.bytes(), with_own + say.capacity() + 1 + 50 * sizeof(FiducialHit));
}

}  // namespace
}  // namespace playhouse::world
