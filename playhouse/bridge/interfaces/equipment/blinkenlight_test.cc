// Lamps and lights as Player devices, checked against the world's columns.

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/wire/generated/blinkenlight.h"

namespace playhouse::drivers {
namespace {

namespace bl = wire::blinkenlight;

constexpr const char* kWorld = R"(
interval_sim 100
position(
  blinkenlight( period 500 dutycycle 0.2 enabled 0 color_rgba [0 0.2 1 0.5] update_interval 200 )
  lightindicator( color "blue" ) )
)";

/// A light of kWorld, open.
class LightDevice : public ::testing::Test {
 protected:
  explicit LightDevice(world::ModelRow row) : row_(row), still_(kWorld), driver_(still_.devices, "stage") {
    driver_.add(kId, make_device(still_.devices, bl::kCode, {row}));
    EXPECT_TRUE(driver_.start(kId));
    still_.run(0);
  }

  const scene::Color& color() { return still_.world().models.color[row_]; }
  template <typename Payload>
  device::Taken command(std::uint8_t subtype, const Payload& payload) {
    const std::vector<std::byte> body = wire::encode(payload);
    return driver_.command({kId, static_cast<std::uint8_t>(wire::MessageType::kCmd), subtype, body});
  }
  bl::Data published(std::size_t nth) {
    const device::Publication& data = still_.recorder.published.at(nth);
    EXPECT_EQ(data.subtype, bl::kDataState);
    return *wire::decode<bl::Data>(data.body);
  }

  static constexpr device::DeviceId kId{3};
  world::ModelRow row_;
  testing::StillDevices still_;
  SimulatedDriver driver_;
};

class BlinkenlightDevice : public LightDevice {
 protected:
  BlinkenlightDevice() : LightDevice({1}) {}
  const world::Blinkenlights& lamps() { return still_.world().blinkenlights; }
};

class LightindicatorDevice : public LightDevice {
 protected:
  LightindicatorDevice() : LightDevice({2}) {}
};

TEST_F(BlinkenlightDevice, tells_how_it_is_set_at_its_own_interval) {
  still_.run(4);
  ASSERT_EQ(still_.recorder.published.size(), 2u);
  EXPECT_EQ(published(0), (bl::Data{0, 0.5f, 0.2f, {128, 0, 51, 255}}));
}

TEST_F(BlinkenlightDevice, commands_that_come_together_are_all_carried_out) {
  EXPECT_EQ(command(bl::kCmdPower, bl::CmdPower{0, 1}), device::Taken::kQueued);
  EXPECT_EQ(command(bl::kCmdFlash, bl::CmdFlash{0, 2, 0.25f}), device::Taken::kQueued);
  EXPECT_EQ(command(bl::kCmdColor, bl::CmdColor{0, {0, 255, 0, 51}}), device::Taken::kQueued);
  still_.run(0);
  EXPECT_EQ(lamps().enabled[{0}], 1);
  EXPECT_EQ(lamps().period[{0}], 2);
  EXPECT_EQ(lamps().dutycycle[{0}], 0.25);
  EXPECT_EQ(color(), (scene::Color{1, 0, 0.2f, 0.5f})) << "with the model's own alpha";
}

TEST_F(BlinkenlightDevice, a_state_sets_everything) {
  EXPECT_EQ(command(bl::kCmdState, bl::Cmd{0, 1, 4, 0.5f, {255, 0, 255, 0}}), device::Taken::kQueued);
  still_.run(0);
  EXPECT_EQ(lamps().enabled[{0}], 1);
  EXPECT_EQ(lamps().period[{0}], 4);
  EXPECT_EQ(lamps().dutycycle[{0}], 0.5);
  EXPECT_EQ(color(), (scene::Color{0, 1, 0, 0.5f}));
}

TEST_F(BlinkenlightDevice, refuses_other_lamps_and_flashes_that_cannot_be) {
  const float nan = std::nanf(""), huge = std::numeric_limits<float>::infinity();
  EXPECT_EQ(command(bl::kCmdPower, bl::CmdPower{1, 1}), device::Taken::kNo);
  EXPECT_EQ(command(bl::kCmdColor, bl::CmdColor{1, {}}), device::Taken::kNo);
  for (const auto& [period, share] :
       {std::pair{-1.0f, 0.5f}, {nan, 0.5f}, {huge, 0.5f}, {1.0f, nan}, {1.0f, 1.5f}, {1.0f, -0.5f}}) {
    EXPECT_EQ(command(bl::kCmdFlash, bl::CmdFlash{0, period, share}), device::Taken::kNo);
    EXPECT_EQ(command(bl::kCmdState, bl::Cmd{0, 1, period, share, {}}), device::Taken::kNo);
  }
  still_.run(0);
  EXPECT_EQ(lamps().enabled[{0}], 0);
  EXPECT_EQ(lamps().period[{0}], 0.5);
}

TEST_F(LightindicatorDevice, is_switched_and_coloured_and_burns_steadily) {
  still_.run(1);
  EXPECT_EQ(published(0), (bl::Data{0, 0, 1, {255, 0, 0, 255}}));
  EXPECT_EQ(command(bl::kCmdPower, bl::CmdPower{0, 1}), device::Taken::kQueued);
  EXPECT_EQ(command(bl::kCmdColor, bl::CmdColor{0, {0, 255, 0, 0}}), device::Taken::kQueued);
  EXPECT_EQ(command(bl::kCmdPower, bl::CmdPower{1, 0}), device::Taken::kNo);
  still_.run(1);
  EXPECT_EQ(still_.world().lightindicators.lit[{0}], 1);
  EXPECT_EQ(published(1), (bl::Data{1, 0, 1, {255, 255, 0, 0}}));
}

TEST_F(LightindicatorDevice, makes_no_flashes) {
  EXPECT_EQ(command(bl::kCmdFlash, bl::CmdFlash{0, 1, 0.5f}), device::Taken::kNo);
  EXPECT_EQ(command(bl::kCmdState, bl::Cmd{0, 1, 1, 0.5f, {}}), device::Taken::kNo);
}

}  // namespace
}  // namespace playhouse::drivers
