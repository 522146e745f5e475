#include "playhouse/world/changes/packed_change.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace playhouse::world {
namespace {

using testing::HasSubstr;

std::vector<std::byte> packed(const Change& change) {
  std::vector<std::byte> bytes;
  pack(change, bytes);
  return bytes;
}

/// Values that are another in each field.
class Filler {
 public:
  void operator()(const char*, bool& value) { value = true; }
  void operator()(const char*, double& value) { value = 0.5 + ++count_; }
  void operator()(const char*, GripperCommand& value) { value = GripperCommand::kLower; }
  void operator()(const char*, ModelId& value) { value.value = ++count_; }
  void operator()(const char*, std::string& value) { value = std::to_string(++count_) + " \n\""; }
  template <typename Number>
  requires std::is_integral_v<Number>
  void operator()(const char*, Number& value) { value = static_cast<Number>(200 + ++count_); }
  void operator()(const char*, geom::Pose& value) { value = {next(), next(), next(), next()}; }
  void operator()(const char*, geom::Twist& value) { value = {next(), next(), next(), next()}; }
  void operator()(const char*, geom::Vec3& value) { value = {next(), next(), next()}; }
  void operator()(const char*, geom::Tilt& value) { value = {next(), next()}; }
  void operator()(const char*, geom::SpatialPose& value) {
    (*this)("", value.X);
    (*this)("", value.tilt);
  }
  void operator()(const char*, scene::Color& value) {
    for (float* part : {&value.r, &value.g, &value.b, &value.a}) *part = static_cast<float>(next());
  }
  void operator()(const char*, std::shared_ptr<const std::vector<std::byte>>& value) {
    value = std::make_shared<const std::vector<std::byte>>(300, std::byte{7});
  }
  template <typename Value>
  void operator()(const char* name, std::vector<Value>& values) {
    values.resize(3);
    for (Value& value : values) (*this)(name, value);
  }

 private:
  double next() { return -0.25 * ++count_; }
  int count_ = 0;
};

/// One of each, with values in every field.
template <std::size_t... kIndex>
std::vector<Change> all(std::index_sequence<kIndex...>) {
  std::vector<Change> changes;
  (changes.emplace_back(std::in_place_index<kIndex>), ...);
  Filler filler;
  const auto fill = [&](auto& made) {
    made.each_field(made, [&](const char* name, auto& value) { filler(name, value); });
  };
  for (Change& change : changes) std::visit(fill, change);
  return changes;
}

const std::vector<Change>& all_changes() {
  static const std::vector<Change> changes = all(std::make_index_sequence<std::variant_size_v<Change>>());
  return changes;
}

TEST(PackedChange, each_has_a_name_of_its_own_and_comes_back) {
  std::set<std::string_view> names;
  for (const Change& change : all_changes()) {
    EXPECT_TRUE(names.insert(name_of(change)).second) << name_of(change);
    const std::vector<std::byte> bytes = packed(change);
    Unpacker in(bytes);
    const Result<Change> again = unpack_change(in);
    ASSERT_TRUE(again) << name_of(change);
    EXPECT_TRUE(in.at_end()) << name_of(change);
    EXPECT_EQ(again->index(), change.index());
    EXPECT_EQ(packed(*again), bytes);
    EXPECT_EQ(fields_text(*again), fields_text(change)) << "no field is lost in bytes";
    EXPECT_EQ(model_of(*again), model_of(change));
  }
}

TEST(PackedChange, has_all_fields_in_bytes_and_in_text) {
  const Change change = changes::Spawn{7, {1.5, -2, 0, 0.25}, "a \"b\"", 300};
  const std::vector<std::byte> bytes = packed(change);
  Unpacker in(bytes);
  const Change again = *unpack_change(in);
  const auto& spawn = std::get<changes::Spawn>(again);
  EXPECT_EQ(spawn.prototype, 7u);
  EXPECT_EQ(spawn.X_WM, (geom::Pose{1.5, -2, 0, 0.25}));
  EXPECT_EQ(spawn.name, "a \"b\"");
  EXPECT_EQ(spawn.first_id, 300u);
  EXPECT_EQ(fields_text(change),
            R"({"prototype": 7, "X_WM": [1.5, -2, 0, 0.25], "name": "a \"b\"", "first_id": 300})");
  EXPECT_EQ(model_of(change), ModelId{});

  const Change drive = changes::Drive{{3}, {0.1, 0, 0, -1}};
  EXPECT_EQ(model_of(drive), ModelId{3});
  EXPECT_EQ(fields_text(drive), R"({"velocity": [0.1, 0, 0, -1]})");
  EXPECT_EQ(fields_text(changes::Grip{{3}, GripperCommand::kRaise}), R"({"command": "raise"})");
  EXPECT_EQ(fields_text(changes::Attach{{{1}, {2}}, {9}, {{}, {1, 0, 0, 0}}}),
            R"({"children": [1, 2], "parent": 9, "X_PC": [[0, 0, 0, 0], [1, 0, 0, 0]]})");
}

TEST(PackedChange, several_follow_each_other) {
  std::vector<std::byte> bytes = packed(changes::Watch{{1}});
  pack(changes::Say{{2}, "hello"}, bytes);
  Unpacker in(bytes);
  EXPECT_EQ(name_of(*unpack_change(in)), "watch");
  EXPECT_EQ(name_of(*unpack_change(in)), "say");
  EXPECT_TRUE(in.at_end());
}

TEST(PackedChange, that_is_cut_or_unknown_is_refused_with_its_name) {
  for (const Change& change : all_changes()) {
    std::vector<std::byte> bytes = packed(change);
    const std::size_t name = name_of(change).size() + 1;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      Unpacker in(std::span(bytes).first(size));
      const Result<Change> cut = unpack_change(in);
      ASSERT_FALSE(cut) << name_of(change) << " of " << size;
      if (size >= name) EXPECT_THAT(cut.error().text, HasSubstr(std::string(name_of(change))));
    }
  }
  std::vector<std::byte> bytes;
  Packer(bytes).text("fly");
  Unpacker in(bytes);
  EXPECT_THAT(unpack_change(in).error().text, HasSubstr("unknown change \"fly\""));
}

TEST(PackedChange, with_a_list_that_is_longer_than_its_bytes_is_refused) {
  std::vector<std::byte> bytes;
  Packer to(bytes);
  to.text("despawn");
  to.varint(std::uint64_t{1} << 60);
  Unpacker in(bytes);
  EXPECT_FALSE(unpack_change(in));
}

}  // namespace
}  // namespace playhouse::world
