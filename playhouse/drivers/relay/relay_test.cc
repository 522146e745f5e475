#include "playhouse/drivers/relay/relay.h"

#include <gtest/gtest.h>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {
namespace {

TEST(OpaqueRelay, each_device_of_a_section_passes_on_what_it_was_told) {
  testing::MemorySite site("");
  ASSERT_EQ(site.build("driver( name \"relay\" provides [\"opaque:0\" \"opaque:7\" \"7000:opaque:0\"] )"),
            "");
  const device::DeviceId second = site.id({6665, wire::opaque::kCode, 7});
  const auto body = wire::encode(wire::opaque::Data{{1, 2, 3}});
  EXPECT_EQ(site.driver({6665, wire::opaque::kCode, 7})
                .command({second, static_cast<std::uint8_t>(wire::MessageType::kCmd), wire::opaque::kCmdData,
                          body}),
            device::Taken::kQueued);
  ASSERT_EQ(site.recorder.published.size(), 1u);
  EXPECT_EQ(site.recorder.published[0].device, second);
  EXPECT_EQ(site.recorder.published[0].body, body);
}

TEST(OpaqueRelay, has_devices_of_opaque_alone) {
  testing::MemorySite site("");
  EXPECT_EQ(site.build("driver( name \"relay\" provides [\"opaque:0\" \"laser:0\"] )"),
            "test.cfg:1: \"laser:0\": driver \"relay\" provides devices of opaque alone");
}

}  // namespace
}  // namespace playhouse::drivers
