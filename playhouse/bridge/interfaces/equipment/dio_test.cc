// Contacts and lamps as digital inputs and outputs, checked against the world's columns.

#include <gtest/gtest.h>

#include "playhouse/bridge/testing/one_device.h"
#include "playhouse/wire/generated/dio.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {
namespace {

namespace dio = wire::dio;

constexpr const char* kDioWorld = R"(
interval_sim 100
position( name "r0"
  blinkenlight( name "left" enabled 0 )
  bumper( name "front" bcount 2 bpose [0.2 0 0 0] blength 0.1 )
  model( name "mast" lightindicator( name "top" ) bumper( name "high" bcount 1 bpose [0 0 0 0] blength 0.1 ) )
  blinkenlight( name "right" enabled 0 ) )
model( name "wall" )
)";

class DioDevice : public testing::OneDevice {
 protected:
  explicit DioDevice(const std::string& world = kDioWorld) : OneDevice(world) {}

  world::World& world() { return still_.world(); }
  world::ModelRow row(const char* name) { return world().find(name); }
  void press(const char* bumper, std::vector<bool> switches) {
    std::vector<world::ModelId>& hits = world().bumpers.hits[world().models.part[row(bumper)]];
    hits.clear();
    for (const bool on : switches) hits.push_back(on ? world().id(row("wall")) : world::ModelId{});
  }
  dio::Data data() {
    still_.run(1);
    return last<dio::Data>(dio::kDataValues);
  }
  device::Taken send(std::uint32_t count, std::uint32_t bits) {
    const std::vector<std::byte> body = wire::encode(dio::Cmd{count, bits});
    const device::Taken taken =
        driver_.command({kId, static_cast<std::uint8_t>(wire::MessageType::kCmd), dio::kCmdValues, body});
    still_.run(0);
    return taken;
  }
  /// left, top, right
  std::string lamps() {
    std::string lit;
    for (const char* name : {"r0.left", "r0.right"})
      lit += world().blinkenlights.enabled[world().models.part[row(name)]] ? '1' : '0';
    return lit.substr(0, 1) + (world().lightindicators.lit[{0}] ? '1' : '0') + lit.substr(1);
  }
};

TEST_F(DioDevice, inputs_of_a_robot_are_its_contacts_in_the_order_of_the_file) {
  open(dio::kCode, "r0");
  EXPECT_EQ(data(), (dio::Data{3, 0}));
  press("r0.front", {false, true});
  EXPECT_EQ(data(), (dio::Data{3, 0b010}));
  press("r0.mast.high", {true});
  EXPECT_EQ(data(), (dio::Data{3, 0b110}));
}

TEST_F(DioDevice, outputs_of_a_robot_are_its_lamps_in_the_order_of_the_file) {
  open(dio::kCode, "r0");
  EXPECT_EQ(lamps(), "000");
  EXPECT_EQ(send(3, 0b110), device::Taken::kQueued);
  EXPECT_EQ(lamps(), "011");
  EXPECT_EQ(send(1, 0b001), device::Taken::kQueued);
  EXPECT_EQ(lamps(), "111") << "one output alone is commanded";
  EXPECT_EQ(send(8, 0b11111000), device::Taken::kQueued);
  EXPECT_EQ(lamps(), "000") << "what there is of eight";
}

TEST_F(DioDevice, of_a_part_has_the_contacts_and_lamps_of_that_part) {
  open(dio::kCode, "r0.mast");
  press("r0.front", {true, true});
  press("r0.mast.high", {true});
  EXPECT_EQ(data(), (dio::Data{1, 1}));
  EXPECT_EQ(send(1, 1), device::Taken::kQueued);
  EXPECT_EQ(lamps(), "010");
}

TEST_F(DioDevice, of_a_lamp_has_no_inputs_and_says_so_at_its_interval) {
  open(dio::kCode, "r0.left");
  EXPECT_EQ(data(), (dio::Data{0, 0}));
  EXPECT_EQ(send(1, 1), device::Taken::kQueued);
  EXPECT_EQ(lamps(), "100");
}

TEST_F(DioDevice, refuses_outputs_that_no_device_has) {
  open(dio::kCode, "r0");
  EXPECT_EQ(send(33, 0), device::Taken::kNo);
  EXPECT_EQ(send(0xffffffff, 0xffffffff), device::Taken::kNo);
  EXPECT_EQ(lamps(), "000");
}

TEST_F(DioDevice, of_a_bumper_has_no_outputs) {
  open(dio::kCode, "r0.front");
  EXPECT_EQ(data(), (dio::Data{2, 0}));
  EXPECT_EQ(send(1, 1), device::Taken::kNo);
}

TEST_F(DioDevice, bumpers_measure_while_it_is_open_and_the_robot_is_not_used) {
  open(dio::kCode, "r0");
  send(1, 1);
  for (const char* name : {"r0.front", "r0.mast.high", "r0.right"})
    EXPECT_EQ(world().models.subscribers[row(name)], 1u) << name;
  EXPECT_FALSE(world::is_used(world(), row("r0")));
  driver_.stop(kId);
  still_.run(0);
  for (const char* name : {"r0", "r0.front", "r0.mast.high", "r0.right"})
    EXPECT_EQ(world().models.subscribers[row(name)], 0u) << name;
  EXPECT_EQ(lamps(), "100") << "a lamp stays as it was switched";
}

struct ManyContacts : DioDevice {
  ManyContacts()
      : DioDevice(
            "interval_sim 100\nposition( name \"r0\" bumper( name \"skirt\" bcount 40 bpose [0.2 0 0 0] "
            "blength 0.1 "
            ") )\nmodel( name \"wall\" )") {}
};

TEST_F(ManyContacts, the_first_32_are_inputs) {
  open(dio::kCode, "r0");
  std::vector<bool> pressed(40);
  pressed[0] = pressed[31] = pressed[32] = true;
  press("r0.skirt", pressed);
  EXPECT_EQ(data(), (dio::Data{32, 0x80000001u}));
}

}  // namespace
}  // namespace playhouse::drivers
