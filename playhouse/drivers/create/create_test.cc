// Against a script that says what a robot said to the original driver.

#include "playhouse/drivers/create/create.h"

#include <gtest/gtest.h>

#include "playhouse/drivers/hardware/testing_hardware.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {
namespace {

namespace p2d = wire::position2d;
using testing::FarEnd;
using testing::from_hex;
using testing::to_hex;

class CreateScript : public testing::HardwareTest {
 protected:
  FarEnd robot{network_, "/dev/robot", {.baud = 57600}};
  std::unique_ptr<server::TestClient> client;

  std::string begin(const std::string& more = "") {
    EXPECT_EQ(
        build(R"(driver( name "create" port "/dev/robot" provides ["position2d:1" "opaque:1"])" + more + ")"),
        "");
    client = client_of(p2d::kCode, 1);
    return to_hex(robot.take(0.25));
  }
};

TEST_F(CreateScript, starts_as_the_original_does) {
  EXPECT_TRUE(begin().starts_with("80 83 8e 00"));
}

TEST_F(CreateScript, without_safety_it_starts_in_full_mode) {
  EXPECT_TRUE(begin(" safe 0").starts_with("80 84 8e 00"));
}

/// 11 degrees each, which the original added up as degrees, too.
TEST_F(CreateScript, angles_are_degrees) {
  begin();
  for (int packet = 0; packet < 3; ++packet) {
    robot.take(0.1);
    robot.send(from_hex("00 00 00 00 00 00 00 00 00 00 ff 00 00 00 00 0b 00 3e 80 fe a2 19 09 60 0a 8c"));
    network_.run_for(0.04);
  }
  EXPECT_NEAR(latest<p2d::Data>(*client, p2d::kCode, p2d::kDataState, 0).pos.pa, 22 * 3.14159265 / 180, 1e-6)
      << "from the second packet on";
}

TEST_F(CreateScript, demos_are_started_as_by_the_original) {
  begin();
  const auto other = client_of(wire::opaque::kCode, 1);
  robot.take(0.1);
  other->ask(command(wire::opaque::kCode, wire::opaque::kCmdData, wire::opaque::Data{{3, 4}}, 1));
  EXPECT_EQ(to_hex(robot.take(0.05)).substr(0, 5), "88 04");
}

}  // namespace
}  // namespace playhouse::drivers
