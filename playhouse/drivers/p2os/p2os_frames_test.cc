// Bytes as the original driver sent them, and as it took them from a robot.

#include "playhouse/drivers/p2os/p2os_frames.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "playhouse/base/rng.h"
#include "playhouse/drivers/hardware/testing_hardware.h"

namespace playhouse::drivers::p2os {
namespace {

using drivers::testing::from_hex;
using drivers::testing::to_hex;

TEST(P2osFrames, commands_are_those_of_the_original) {
  EXPECT_EQ(to_hex(encode_command(kSync0)), "fa fb 03 00 00 00");
  EXPECT_EQ(to_hex(encode_command(kSync2)), "fa fb 03 02 00 02");
  EXPECT_EQ(to_hex(encode_command(kSonar, 0)), "fa fb 06 1c 3b 00 00 1c 3b");
  EXPECT_EQ(to_hex(encode_command(kEnable, 0)), "fa fb 06 04 3b 00 00 04 3b");
  EXPECT_EQ(to_hex(encode_command_of_bytes(kWheels, 10, 10)), "fa fb 06 20 3b 0a 0a 2a 45");
  EXPECT_EQ(to_hex(encode_command_of_bytes(kWheels, -7, -2)), "fa fb 06 20 3b f9 fe 1a 39");
  EXPECT_EQ(to_hex(encode_command(kVelocity, -150)).substr(9, 11), "0b 1b 96 00");
  EXPECT_EQ(to_hex(encode_command(kTurnRate, 23)).substr(9, 11), "15 3b 17 00");
  EXPECT_EQ(to_hex(encode_names({"Emu", "Pioneer", "p3dx-sh"})),
            "fa fb 17 02 45 6d 75 00 50 69 6f 6e 65 65 72 00 70 33 64 78 2d 73 68 00 cc b9");
}

TEST(P2osFrames, a_packet_of_the_robot_is_what_the_original_took_it_for) {
  FrameReader reader;
  reader.add(
      from_hex("fa fb 1b 33 78 00 00 00 22 00 64 00 18 01 7c 00 00 00 00 00 00 b5 00 00 00 66 0f 00 51 11"));
  reader.add(
      from_hex("fa fb 1b 33 14 00 00 00 00 00 c8 00 c8 00 7c 00 00 00 00 00 00 b5 00 00 00 66 0f 00 50 2f"));
  const auto data = reader.next();
  ASSERT_TRUE(data);
  EXPECT_EQ(reader.damaged(), 1u) << "the first one has a wrong checksum";
  const std::optional<Sip> sip = read_sip(*data);
  ASSERT_TRUE(sip);
  EXPECT_EQ(*sip, (Sip{.type = kMoving,
                       .x = 20,
                       .left = 200,
                       .right = 200,
                       .battery = 124,
                       .sonars = {},
                       .analog_port = 0,
                       .analog = 0x66,
                       .digital_in = 0x0F}));
  EXPECT_EQ(encode_sip(*sip), frame(*data));
}

TEST(P2osFrames, what_a_robot_reads_is_what_a_host_wrote) {
  FrameReader reader;
  reader.add(encode_command(kVelocity, -150));
  reader.add(encode_command(kPulse));
  reader.add(from_hex("fa fb 04 07 3b 07 3b"));  // SETO as the original sends it
  const std::optional<ReadCommand> speed = read_command(*reader.next());
  EXPECT_EQ(speed->number, kVelocity);
  EXPECT_EQ(speed->argument, -150);
  EXPECT_EQ(read_command(*reader.next())->argument, std::nullopt);
  EXPECT_EQ(read_command(*reader.next())->number, kSetOrigin);
}

/// A slow and obvious reader finds the same frames in bytes with noise between them and cut at any place.
TEST(P2osFrames, frames_are_found_whatever_lies_between_and_however_bytes_come) {
  Rng rng(1);
  RawBytes all;
  std::vector<RawBytes> sent;
  for (int k = 0; k < 500; ++k) {
    RawBytes data;
    for (std::uint64_t byte = 0; byte < 1 + rng.bits() % 30; ++byte)
      put_u8(data, static_cast<int>(rng.bits() & 0xFF));
    sent.push_back(data);
    const RawBytes whole = frame(data);
    all.insert(all.end(), whole.begin(), whole.end());
    for (std::uint64_t byte = 0; byte < rng.bits() % 5; ++byte)
      put_u8(all, static_cast<int>(rng.bits() % 0xFA));
  }
  FrameReader reader;
  std::vector<RawBytes> found;
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t count = std::min<std::size_t>(1 + rng.bits() % 50, all.size() - at);
    reader.add(std::span(all).subspan(at, count));
    at += count;
    while (std::optional<RawBytes> data = reader.next()) found.push_back(std::move(*data));
  }
  EXPECT_EQ(found, sent);
  EXPECT_EQ(reader.damaged(), 0u);
}

TEST(P2osFrames, short_packets_are_none) {
  const RawBytes whole = encode_sip({.sonars = {{1, 1000}, {2, 2000}}});
  const std::span<const std::byte> data = std::span(whole).subspan(3, whole.size() - 5);
  EXPECT_TRUE(read_sip(data));
  for (std::size_t bytes = 0; bytes < 26; ++bytes) EXPECT_FALSE(read_sip(data.first(bytes))) << bytes;
  EXPECT_TRUE(read_sip(data.first(26))) << "what comes after the sonars may be missing";
}

}  // namespace
}  // namespace playhouse::drivers::p2os
