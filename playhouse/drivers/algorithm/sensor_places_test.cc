// Where a laser or sonars are, from devices that tell it well or badly.

#include "playhouse/drivers/algorithm/sensor_places.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <utility>

#include "playhouse/device/fake_device.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Tells this of its geometry; NACK if there is nothing to tell.
struct Teller final : device::Driver {
  std::string_view name() const override { return "teller"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  void request(const device::Message&, device::Replier replier) override {
    if (told) replier.ack(*told);
  }
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return true; }

  std::optional<std::vector<std::byte>> told;
};

std::vector<geom::Pose> places(ScanSensor sensor, std::optional<std::vector<std::byte>> told) {
  device::FakeDevices devices;
  Teller teller;
  teller.told = std::move(told);
  device::DeviceClient client(devices, teller, 1);
  client.use(0, {7}, teller);
  std::vector<geom::Pose> X_RS{{77, 77, 0, 0}};
  ask_places(client, 0, sensor, [&](std::vector<geom::Pose> heard) { X_RS = std::move(heard); });
  return X_RS;
}

std::vector<geom::Pose> of_sonars(const std::vector<wire::Pose3d>& poses) {
  return places(ScanSensor::kSonar, wire::encode(wire::sonar::Geom{poses}));
}

TEST(SensorPlaces, are_those_of_the_laser_or_of_each_sonar_without_tilts) {
  EXPECT_EQ(places(ScanSensor::kLaser, wire::encode(wire::laser::Geom{{0.1, 0.2, 0.3, 1, 1, 0.5}, {}})),
            (std::vector<geom::Pose>{{0.1, 0.2, 0.3, 0.5}}));
  EXPECT_EQ(of_sonars({{1, 0, 0, 0, 0, 0}, {2, 0, 0, 0, 1, 0}}),
            (std::vector<geom::Pose>{{1, 0, 0, 0}, {2, 0, 0, 0}}));
}

TEST(SensorPlaces, are_none_if_one_is_unusable_lest_ranges_are_taken_for_those_of_others) {
  EXPECT_TRUE(of_sonars({{kNan, 0, 0, 0, 0, 0}, {2, 0, 0, 0, 0, 0}}).empty());
  EXPECT_TRUE(of_sonars({{1, 0, 0, 0, 0, 0}, {2, 1e10, 0, 0, 0, 0}}).empty());
  EXPECT_TRUE(of_sonars({}).empty());
  EXPECT_TRUE(places(ScanSensor::kLaser, wire::encode(wire::laser::Geom{{kNan, 0, 0, 0, 0, 0}, {}})).empty());
  for (const ScanSensor sensor : {ScanSensor::kLaser, ScanSensor::kSonar}) {
    EXPECT_TRUE(places(sensor, std::nullopt).empty());
    EXPECT_TRUE(places(sensor, std::vector<std::byte>(3)).empty());
  }
}

}  // namespace
}  // namespace playhouse::drivers
