#include "playhouse/record/sensor_messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "playhouse/record/messages.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::record {
namespace {

constexpr const char* kWorld = R"(
latitude 47 longitude 8 altitude 400
position( name "r"
  ranger( name "lidar" sensor( range [0.5 8] fov 90 samples 3 rings 2 ring_fov [-30 30] size [0 0 0.2] ) )
  ranger( name "sonar" sensor( range [0.1 5] ) sensor( range [0.1 3] ) sensor( range [0.1 4] ) )
  camera( name "eye" resolution [64 48] fov [60 40] image "depth" )
  gps( name "gps" ) gps( name "blind" satellites 3 ) )
)";

class SensorMessagesTest : public testing::Test {
 protected:
  /// Behind the header.
  static CdrReader body_of(const Bytes& message) {
    CdrReader in(message);
    EXPECT_EQ(in.time(), 1'500'000'000u);
    EXPECT_EQ(in.text(), "f");
    return in;
  }
  world::KindRow part(const char* name) { return world_.models.part[world_.find(name)]; }

  config::MemoryFiles files_{{}};
  scene::SceneDesc scene_ = *scene::load_world_text(kWorld, "t.world", files_, {}, nullptr);
  world::World world_{scene_, 1};
  static constexpr std::uint64_t kNs = 1'500'000'000;
};

TEST_F(SensorMessagesTest, of_a_camera_have_the_intrinsics_of_its_present_zoom) {
  world_.cameras.zoom[part("r.eye")] = geom::radians(30);
  const Bytes message = camera_info_message(kNs, "f", world_, world_.find("r.eye"));
  CdrReader in = body_of(message);
  EXPECT_EQ(in.number<std::uint32_t>(), 48u);
  EXPECT_EQ(in.number<std::uint32_t>(), 64u);
  EXPECT_EQ(in.text(), "plumb_bob");
  EXPECT_EQ(in.number<std::uint32_t>(), 5u);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(in.number<double>(), 0);
  const double zoom = std::tan(geom::radians(15)),
               height = zoom * std::tan(geom::radians(20)) / std::tan(geom::radians(30));
  for (const double wanted : {32 / zoom, 0.0, 31.5, 0.0, 24 / height, 23.5, 0.0, 0.0, 1.0})
    EXPECT_NEAR(in.number<double>(), wanted, 1e-9);
}

TEST_F(SensorMessagesTest, of_rings_have_a_point_for_each_beam_and_nan_where_nothing_is) {
  const world::RangerRow ranger = part("r.lidar");
  EXPECT_TRUE(cloud_message(kNs, "f", world_, world_.find("r.lidar"), 0).empty()) << "no rings yet";
  world_.rangers.ring_ranges[ranger] = {2, 8, 0.5f, 4, 4, 4};
  world_.rangers.ring_intensities[ranger] = {1, 0, 1, 1, 1, 1};
  const Bytes message = cloud_message(kNs, "f", world_, world_.find("r.lidar"), 0);
  CdrReader in = body_of(message);
  EXPECT_EQ(in.number<std::uint32_t>(), 2u);
  EXPECT_EQ(in.number<std::uint32_t>(), 3u);
  EXPECT_EQ(in.number<std::uint32_t>(), 5u);
  for (int i = 0; i < 5; ++i) {
    in.text();
    in.number<std::uint32_t>();
    in.number<std::uint8_t>();
    in.number<std::uint32_t>();
  }
  EXPECT_EQ(in.number<std::uint8_t>(), 0);
  EXPECT_EQ(in.number<std::uint32_t>(), 18u);
  EXPECT_EQ(in.number<std::uint32_t>(), 54u);
  const std::span<const std::byte> data = in.bytes();
  ASSERT_EQ(data.size(), 108u);
  EXPECT_EQ(in.number<std::uint8_t>(), 0) << "is_dense";
  const auto number = [&](std::size_t point, std::size_t field) {
    float value = 0;
    std::memcpy(&value, data.data() + 18 * point + 4 * field, sizeof value);
    return static_cast<double>(value);
  };
  const double level = 2 * std::cos(geom::radians(30)) * std::sqrt(0.5);  // to the right, 45 degrees
  EXPECT_NEAR(number(0, 0), level, 1e-6);
  EXPECT_NEAR(number(0, 1), -level, 1e-6);
  EXPECT_NEAR(number(0, 2), 0.1 - 1, 1e-6);
  EXPECT_TRUE(std::isnan(number(1, 0))) << "nothing returned";
  EXPECT_TRUE(std::isnan(number(2, 2))) << "too near";
  EXPECT_NEAR(number(4, 0), 4 * std::cos(geom::radians(30)), 1e-6);
  EXPECT_NEAR(number(4, 2), 0.1 + 2, 1e-6);
  EXPECT_EQ(data[18 * 4 + 16], std::byte{1}) << "the upper ring";
}

TEST_F(SensorMessagesTest, of_a_receiver_without_a_fix_have_no_place) {
  const Bytes fix = fix_message(kNs, "f", world_, world_.find("r.gps"));
  CdrReader in = body_of(fix);
  EXPECT_EQ(in.number<std::int8_t>(), 0);
  EXPECT_EQ(in.number<std::uint16_t>(), 1);
  EXPECT_NEAR(in.number<double>(), 47, 1e-9);
  EXPECT_NEAR(in.number<double>(), 8, 1e-9);
  const Bytes none = fix_message(kNs, "f", world_, world_.find("r.blind"));
  CdrReader blind = body_of(none);
  EXPECT_EQ(blind.number<std::int8_t>(), -1);
  blind.number<std::uint16_t>();
  EXPECT_TRUE(std::isnan(blind.number<double>()));
}

TEST_F(SensorMessagesTest, have_no_value_where_a_number_is_at_its_limit) {
  const world::ModelRow sonar = world_.find("r.sonar");
  const world::BeamRow first =
      world_.sensors.first_beam[world_.rangers.first_sensor[world_.models.part[sonar]]];
  world_.sensors.ranges[first] = 3;
  world_.sensors.ranges[first + 1] = 3;
  world_.sensors.ranges[first + 2] = 0.1f;
  const Bytes message = ranges_message(kNs, world_, sonar);
  CdrReader in(message);
  in.time();
  EXPECT_EQ(in.number<std::uint32_t>(), 3u);
  EXPECT_EQ(in.number<float>(), 3);
  EXPECT_EQ(in.number<float>(), INFINITY);
  EXPECT_EQ(in.number<float>(), -INFINITY);
}

}  // namespace
}  // namespace playhouse::record
