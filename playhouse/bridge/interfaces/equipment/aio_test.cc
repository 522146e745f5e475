// Custom models as Player devices, checked against the world's columns.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/wire/generated/aio.h"
#include "playhouse/world/custom_library.h"

namespace playhouse::drivers {
namespace {

namespace aio = wire::aio;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using wire::MessageType;

struct TwoCommands : world::CustomKind {
  Sizes configure(std::span<const std::string>) override { return {2, 0, 2}; }
};

/// The custom model of a scene, open.
class AioDevice : public ::testing::Test {
 protected:
  AioDevice() : still_("custom( library \"none\" )"), driver_(still_.devices, "stage") {
    auto code = std::make_shared<world::CustomCode>();
    auto kind = std::make_shared<TwoCommands>();
    code->sizes = kind->configure({});
    code->kind = kind;
    still_.world().custom_codes.push_back(code);
    driver_.add(kId, make_device(still_.devices, aio::kCode, {0}));
    EXPECT_TRUE(driver_.start(kId));
    still_.run(0);
  }
  world::Customs& customs() { return still_.world().customs; }
  device::Taken command(std::uint32_t output, float voltage) {
    const std::vector<std::byte> body = wire::encode(aio::Cmd{output, voltage});
    const device::Taken taken =
        driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), aio::kCmdState, body});
    still_.run(0);
    return taken;
  }

  static constexpr device::DeviceId kId{3};
  testing::StillDevices still_;
  SimulatedDriver driver_;
};

TEST_F(AioDevice, sets_one_command_of_the_model_each) {
  EXPECT_EQ(command(1, 2.5f), device::Taken::kQueued);
  EXPECT_THAT(customs().command[{0}], ElementsAre(0, 2.5));
  command(0, -1);
  EXPECT_THAT(customs().command[{0}], ElementsAre(-1, 2.5));
}

TEST_F(AioDevice, ignores_commands_that_make_no_sense) {
  command(1, 2.5f);
  EXPECT_EQ(command(1, std::numeric_limits<float>::infinity()), device::Taken::kNo);
  EXPECT_EQ(command(1u << 31, 1), device::Taken::kNo) << "no model has so many";
  command(2, 1);
  EXPECT_THAT(customs().command[{0}], ElementsAre(0, 2.5));
}

TEST_F(AioDevice, publishes_readings_as_voltages) {
  customs().readings[{0}] = {0.5, -3};
  EXPECT_THAT(still_.recorder.published, IsEmpty());
  still_.run(1);
  ASSERT_EQ(still_.recorder.published.size(), 1u);
  EXPECT_THAT(wire::decode<aio::Data>(still_.recorder.published.back().body)->voltages,
              ElementsAre(0.5f, -3));
}

}  // namespace
}  // namespace playhouse::drivers
