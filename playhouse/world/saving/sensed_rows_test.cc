#include "playhouse/world/saving/sensed_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "playhouse/base/packing.h"
#include "playhouse/config/text/source_text.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::world {
namespace {

constexpr const char* kWorld = R"(
define eye sensor( range [0 5] samples 40 )
define robot position( ranger( eye() ) ranger( eye() eye() ) fiducial() )
robot( name "a" ) robot( name "b" pose [2 0 0 0] ) robot( name "c" pose [4 0 0 0] ) )";

class SensedRows : public testing::Test {
 protected:
  SensedRows() {
    config::MemoryFiles files({}, {});
    Result<scene::SceneDesc> scene = scene::load_world_text(kWorld, "test.world", files);
    scene_ = std::move(*scene);
  }
  /// Whether the measurements of these rangers in `from`, and no others, come to be in a new world.
  void expect_copied(World& from, const std::vector<KindRow>& rows) {
    World to(scene_, 1);
    const World untouched(scene_, 1);
    Bytes bytes;
    pack_sensed(from, scene::ModelKind::kRanger, rows, bytes);
    Unpacker in(bytes);
    ASSERT_TRUE(unpack_sensed(to, scene::ModelKind::kRanger, rows, in));
    EXPECT_TRUE(in.at_end());
    for (const RangerRow ranger : from.rangers.rows()) {
      const bool is_copied = std::ranges::find(rows, ranger.index, &KindRow::index) != rows.end();
      EXPECT_EQ(to.rangers.measured_tick[ranger], is_copied ? from.rangers.measured_tick[ranger] : 0);
      const RowsOf<SensorTable> sensors = sensors_of(from.rangers, ranger);
      const RowsOf<BeamTable> last = beams_of(from.sensors, sensors[sensors.size() - 1]);
      for (const BeamRow beam : RowsOf(from.sensors.first_beam[sensors.front()], *last.end())) {
        const float wanted = (is_copied ? from : untouched).sensors.ranges[beam];
        EXPECT_EQ(std::bit_cast<std::uint32_t>(to.sensors.ranges[beam]),
                  std::bit_cast<std::uint32_t>(wanted));
      }
    }
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      Unpacker cut(std::span(bytes).first(size));
      EXPECT_FALSE(unpack_sensed(to, scene::ModelKind::kRanger, rows, cut)) << size << " of " << bytes.size();
    }
  }

  scene::SceneDesc scene_;
};

TEST_F(SensedRows, come_back_to_the_bit_however_they_are_packed) {
  const float infinite = std::numeric_limits<float>::infinity();
  const std::vector<std::vector<float>> patterns = {{0},
                                                    {5},
                                                    {0, 1},
                                                    {5, 5, 5, 1.25f, 5, 5, 2.5f, 5},
                                                    {1, 2, 3, 4},
                                                    {0.0f, -0.0f},
                                                    {infinite, 1, infinite, 2, infinite}};
  for (const std::vector<float>& pattern : patterns) {
    World world(scene_, 1);
    for (const BeamRow beam : world.sensors.ranges.rows())
      world.sensors.ranges[beam] = pattern[beam.index % pattern.size()];
    for (const RangerRow i : world.rangers.rows()) world.rangers.measured_tick[i] = 7 + i.index;
    for (const std::vector<KindRow>& rows :
         {std::vector<KindRow>{{0}, {1}, {2}, {3}, {4}, {5}}, {{2}}, {{0}, {1}, {4}}, {{1}, {3}, {5}}})
      expect_copied(world, rows);
  }
}

TEST_F(SensedRows, have_lists_of_records) {
  World from(scene_, 1), to(scene_, 1);
  from.fiducials.hits[{1}] = {{{4}, 7, 1.5, 0.25, -0.5, {0.1, 0.2, 0.3}}, {{8}, 9, 2.5, 0, 0, {}}};
  Bytes bytes;
  const std::vector<KindRow> rows{{1}, {2}};
  pack_sensed(from, scene::ModelKind::kFiducial, rows, bytes);
  Unpacker in(bytes);
  ASSERT_TRUE(unpack_sensed(to, scene::ModelKind::kFiducial, rows, in));
  ASSERT_EQ(to.fiducials.hits[{1}].size(), 2u);
  EXPECT_EQ(to.fiducials.hits[{1}][0].range, 1.5);
  EXPECT_EQ(to.fiducials.hits[{1}][1].target, (ModelId{8}));
  EXPECT_TRUE(to.fiducials.hits[{2}].empty());
}

TEST_F(SensedRows, of_beams_that_miss_take_a_bit_each) {
  World world(scene_, 1);
  std::ranges::fill(world.sensors.ranges, 5);
  world.sensors.ranges[{17}] = 1.5f;
  Bytes bytes;
  pack_sensed(world, scene::ModelKind::kRanger, std::vector<KindRow>{{0}, {1}, {2}, {3}, {4}, {5}}, bytes);
  EXPECT_LT(bytes.size(), world.sensors.ranges.size());
}

}  // namespace
}  // namespace playhouse::world
