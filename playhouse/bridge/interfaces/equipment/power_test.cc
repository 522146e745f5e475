// What a battery's device reports and accepts, checked against the world's columns; and who has one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/model_interfaces.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/simulated/simulated_world.h"
#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/wire/generated/power.h"

namespace playhouse::drivers {
namespace {

using ::testing::HasSubstr;
using wire::MessageType;
namespace pow = wire::power;

constexpr const char* kWorld = R"(
interval_sim 100
position( name "r0" joules 50 joules_capacity 200 update_interval 200 model( name "bump" take_watts 10 ) )
position( name "r1" joules 50 )
model( name "station" joules -1 give_watts 100 )
position( name "bare" )
)";

class PowerDevice : public ::testing::Test {
 protected:
  void open(const char* model) {
    driver_.add(kId, make_device(still_.devices, pow::kCode, still_.world().find(model)));
    ASSERT_TRUE(driver_.start(kId));
    still_.run(0);
  }
  pow::Data newest() {
    EXPECT_FALSE(still_.recorder.published.empty());
    return *wire::decode<pow::Data>(still_.recorder.published.back().body);
  }
  bool ask(std::span<const std::byte> body) {
    driver_.request({kId, static_cast<std::uint8_t>(MessageType::kReq), pow::kReqSetChargingPolicy, body},
                    device::Replier(still_.recorder, ++ticket_));
    still_.run(0);
    return still_.recorder.answers.at(ticket_).ack;
  }

  static constexpr device::DeviceId kId{3};
  static constexpr std::uint32_t kKnown = pow::kMaskWatts | pow::kMaskPercent | pow::kMaskCharging;
  testing::StillDevices still_{kWorld};
  SimulatedDriver driver_{still_.devices, "stage"};
  std::uint64_t ticket_ = 0;
};

TEST_F(PowerDevice, says_what_is_in_the_battery_at_the_intervals_of_its_model) {
  open("r0");
  still_.world().packs.watts[{0}] = -2.5;
  still_.world().packs.charging[{0}] = 1;
  still_.run(5);
  EXPECT_EQ(still_.recorder.published.size(), 2u);
  EXPECT_EQ(newest(), (pow::Data{kKnown | pow::kMaskJoules, 0, 25, 50, -2.5f, 1}));
}

TEST_F(PowerDevice, says_where_a_battery_cannot_be_charged) {
  open("r1");
  still_.run(1);
  EXPECT_EQ(newest(), (pow::Data{kKnown | pow::kMaskJoules, 0, 100, 50, 0, -1}));
}

TEST_F(PowerDevice, has_no_number_for_what_never_ends) {
  open("station");
  still_.run(1);
  EXPECT_EQ(newest(), (pow::Data{kKnown, 0, 100, 0, 0, -1}));
}

TEST_F(PowerDevice, decides_until_it_is_closed_what_may_flow) {
  open("r0");
  ASSERT_TRUE(ask(wire::encode(pow::ChargepolicyConfig{0, 0})));
  EXPECT_EQ(still_.world().packs.takes[{0}], 0);
  EXPECT_EQ(still_.world().packs.gives[{0}], 0);
  still_.run(2);
  EXPECT_EQ(newest().charging, -1);
  EXPECT_FALSE(ask({})) << "an invalid body";
  ASSERT_TRUE(ask(wire::encode(pow::ChargepolicyConfig{1, 0})));
  EXPECT_EQ(still_.world().packs.takes[{0}], 1);
  driver_.stop(kId);
  still_.run(0);
  EXPECT_EQ(still_.world().packs.gives[{0}], 1);
}

TEST_F(PowerDevice, belongs_to_models_with_a_battery_alone) {
  const auto has = [&](const char* name) {
    return fits(still_.world(), still_.world().find(name), pow::kCode);
  };
  EXPECT_TRUE(has("r0"));
  EXPECT_TRUE(has("station"));
  EXPECT_FALSE(has("r0.bump")) << "which draws from the robot's";
  EXPECT_FALSE(has("bare"));
  EXPECT_TRUE(is_simulated(pow::kCode));
}

TEST(PowerDevices, of_a_configuration_are_those_of_the_models_that_it_names) {
  const std::string stage = "driver( name \"stage\" provides [\"simulation:0\"] worldfile \"some.world\" )\n";
  testing::MemorySite site(kWorld);
  ASSERT_EQ(site.build(stage + "driver( name \"stage\" provides [\"power:3\"] model \"r1\" )"), "");
  const world::World& world = simulation_of(site.site())->world();
  EXPECT_THAT(device_names(model_devices_of(site.site())->directory(), world.id(world.find("r1")), 6665),
              ::testing::ElementsAre("power:3"));
  testing::MemorySite other(kWorld);
  EXPECT_THAT(other.build(stage + "driver( name \"stage\" provides [\"power:0\"] model \"bare\" )"),
              HasSubstr("nothing left for \"power:0\""));
}

}  // namespace
}  // namespace playhouse::drivers
