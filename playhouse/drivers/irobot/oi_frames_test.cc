// Bytes as the original drivers sent them, and as they took them from a robot; tables of the maker.

#include <gtest/gtest.h>

#include <algorithm>

#include "playhouse/base/rng.h"
#include "playhouse/drivers/hardware/testing_hardware.h"
#include "playhouse/drivers/irobot/oi_packets.h"

namespace playhouse::drivers::irobot {
namespace {

using drivers::testing::from_hex;
using drivers::testing::to_hex;
using enum RobotGeneration;

std::string drive_bytes(double speed, double turn_rate) {
  const OiDrive drive = drive_of(speed, turn_rate, half_axle(kSci));
  RawBytes bytes = encode_command(kDrive);
  put_16_be(bytes, drive.velocity);
  put_16_be(bytes, drive.radius);
  return to_hex(bytes);
}

TEST(OiFrames, straight_drives_are_those_of_the_original_and_turns_are_as_wide_and_fast_as_asked) {
  EXPECT_EQ(drive_bytes(0.2, 0), "89 00 c8 80 00");
  EXPECT_EQ(drive_bytes(2, 0), "89 01 f4 80 00");
  EXPECT_EQ(drive_bytes(0, 0), "89 00 00 80 00");
  EXPECT_EQ(drive_bytes(0, 0.5), "89 00 41 00 01") << "half of the original's 81, which turns twice too fast";
  EXPECT_EQ(drive_bytes(0, -0.5), "89 00 41 ff ff");
  EXPECT_EQ(drive_bytes(0.2, 0.5), "89 00 c8 01 90") << "400 mm, where the original has 200";
  EXPECT_EQ(drive_bytes(-0.1, 0.5), "89 ff 9c ff 38");
  EXPECT_EQ(drive_bytes(0.2, 0.08), "89 00 c8 07 d0") << "no arc is wider than 2 m";
  EXPECT_EQ(drive_bytes(0.2, 0.01), "89 00 c8 80 00") << "20 m are nearer to a line";
  EXPECT_EQ(drive_bytes(0.4, 2), "89 01 30 00 c8") << "304 mm/s on 200 mm: the outer wheel goes at 500";
}

TEST(OiFrames, wheels_go_as_the_command_says_and_500_mm_a_second_at_most) {
  const double h = half_axle(kCreate);
  const auto wheels = [h](int velocity, int radius) { return wheels_of({velocity, radius}, h); };
  EXPECT_EQ(wheels(200, -0x8000).left, 200);
  EXPECT_EQ(wheels(200, 0x7FFF).right, 200);
  EXPECT_EQ(wheels(129, 1).right, 129);
  EXPECT_EQ(wheels(129, 1).left, -129);
  EXPECT_EQ(wheels(129, -1).right, -129);
  EXPECT_NEAR(wheels(200, 400).right, 264.5, 1e-9);
  EXPECT_NEAR(wheels(200, 400).left, 135.5, 1e-9);
  EXPECT_EQ(wheels(500, 200).right, 500);
}

TEST(OiFrames, an_answer_is_what_the_original_took_it_for) {
  const RawBytes answer =
      from_hex("03 00 00 00 00 00 00 00 00 00 ff 00 00 28 00 00 00 3e 80 fe a2 19 09 60 0a 8c");
  const auto sensors = read_early_group(answer);
  ASSERT_TRUE(sensors);
  EXPECT_EQ((*sensors)[kBumpsAndDrops], kBumpLeft | kBumpRight);
  EXPECT_EQ((*sensors)[kRemote], kNoRemote);
  EXPECT_EQ((*sensors)[kDistance], 40);
  EXPECT_EQ((*sensors)[kVoltage], 16000);
  EXPECT_EQ((*sensors)[kCurrent], -350);
  EXPECT_EQ((*sensors)[kTemperature], 25);
  EXPECT_EQ((*sensors)[kCharge], 2400);
  EXPECT_EQ((*sensors)[kCapacity], 2700);
  RawBytes again;
  put_packets(again, *packets_of(kSci, kEarlyGroup), *sensors);
  EXPECT_EQ(again, answer);
}

TEST(OiFrames, answers_that_are_cut_or_shifted_are_none) {
  const RawBytes answer =
      from_hex("03 00 00 00 00 00 00 00 00 00 ff 00 00 28 00 00 00 3e 80 fe a2 19 09 60 0a 8c");
  EXPECT_FALSE(read_early_group(std::span(answer).first(25)));
  EXPECT_FALSE(read_early_group({}));
  RawBytes shifted(answer.begin() + 1, answer.end());
  shifted.push_back(answer[0]);
  EXPECT_FALSE(read_early_group(shifted)) << "a virtual wall or charging state that no robot has";
}

TEST(OiFrames, groups_have_the_lengths_of_the_maker) {
  const auto bytes = [](RobotGeneration generation, std::uint8_t number) {
    const auto packets = packets_of(generation, number);
    return packets ? static_cast<int>(bytes_of(*packets)) : -1;
  };
  for (const RobotGeneration generation : {kSci, k500, kCreate}) {
    EXPECT_EQ(bytes(generation, 0), 26);
    EXPECT_EQ(bytes(generation, 1), 10);
    EXPECT_EQ(bytes(generation, 2), 6);
    EXPECT_EQ(bytes(generation, 3), 10);
  }
  EXPECT_EQ(bytes(kCreate, 4), 14);
  EXPECT_EQ(bytes(kCreate, 5), 12);
  EXPECT_EQ(bytes(kCreate, 6), 52);
  EXPECT_EQ(bytes(kCreate, 25), 2);
  EXPECT_EQ(bytes(k500, 100), 80);
  EXPECT_EQ(bytes(k500, 101), 28);
  EXPECT_EQ(bytes(k500, 106), 12);
  EXPECT_EQ(bytes(k500, 107), 9);
  EXPECT_EQ(bytes(kSci, 4), -1);
  EXPECT_EQ(bytes(kSci, 7), -1) << "the SCI has groups alone";
  EXPECT_EQ(bytes(kCreate, 100), -1);
  EXPECT_EQ(bytes(kCreate, 43), -1);
  EXPECT_EQ(bytes(k500, 59), -1);
  EXPECT_EQ(bytes(k500, 255), -1);
}

TEST(OiFrames, a_frame_of_the_stream_adds_up_to_nothing) {
  EXPECT_EQ(to_hex(stream_frame(from_hex("1d 02 19 0d 00"))), "13 05 1d 02 19 0d 00 b6");
}

TEST(OiFrames, angles_have_the_unit_of_the_generation) {
  EXPECT_NEAR(radians_of(kCreate, 90), 1.5707963, 1e-6);
  EXPECT_NEAR(radians_of(kSci, 258), 2, 1e-9) << "mm of each wheel, 129 mm from the middle";
  EXPECT_NEAR(angle_of(kSci, radians_of(kSci, 17)), 17, 1e-9);
}

TEST(OiFrames, commands_are_found_however_they_come_and_whatever_lies_between) {
  const RawBytes all = from_hex(
      "80 82 84 07 8e 00 89 00 c8 80 00 8c 02 02 3c 10 3e 10 ff 8b 25 80 ff 8d 02 8c 00 ff 80 8e 00 88");
  OiCommandReader reader(kSci);
  std::string found;
  for (const std::byte byte : all) {
    reader.add(std::span(&byte, 1));
    while (const auto command = reader.next())
      found += std::to_string(command->opcode) + ":" + std::to_string(command->data.size()) + " ";
  }
  EXPECT_EQ(found, "128:0 130:0 132:0 142:1 137:4 140:6 139:3 141:1 128:0 142:1 136:0 ")
      << "a song of 255 notes is none";
}

TEST(OiFrames, generations_differ_in_their_commands) {
  const auto first = [](RobotGeneration generation, std::string_view hex) {
    OiCommandReader reader(generation);
    reader.add(from_hex(hex));
    const auto command = reader.next();
    return command ? std::to_string(command->opcode) + ":" + std::to_string(command->data.size()) : "none";
  };
  EXPECT_EQ(first(kCreate, "88 04"), "136:1");
  EXPECT_EQ(first(k500, "88 04"), "136:0");
  EXPECT_EQ(first(kCreate, "94 02 07 08"), "148:3");
  EXPECT_EQ(first(kSci, "94 02 07 08"), "none");
  EXPECT_EQ(first(kCreate, "98 03 89 00 c8"), "152:4");
  EXPECT_EQ(first(kCreate, "98 03 89 00"), "none") << "not whole";
  EXPECT_EQ(first(k500, "92 00 ff 00 ff"), "146:4");
  EXPECT_EQ(first(kCreate, "94 ff 07"), "none") << "255 packets are more than a robot has";
}

}  // namespace
}  // namespace playhouse::drivers::irobot
