// Bytes as the maker's own host sent them, and as it took them from a lidar.

#include "playhouse/drivers/rplidar/rplidar_frames.h"

#include <gtest/gtest.h>

#include "playhouse/base/rng.h"
#include "playhouse/drivers/hardware/testing_hardware.h"

namespace playhouse::drivers::rplidar {
namespace {

using drivers::testing::from_hex;
using drivers::testing::to_hex;

TEST(RplidarFrames, requests_are_those_of_the_maker) {
  EXPECT_EQ(to_hex(encode_request(kGetInfo)), "a5 50");
  EXPECT_EQ(to_hex(encode_request(kExpressScan, RawBytes(5))), "a5 82 05 00 00 00 00 00 22");
  EXPECT_EQ(to_hex(encode_request(kSetMotor, from_hex("94 02"))), "a5 f0 02 94 02 c1");
  LidarRequests requests;
  requests.add(from_hex("00 a5 50 a5 84 06 75 00 00 00 01 00 53 a5 82 05 00 00 00 00 00 23 a5 25"));
  EXPECT_EQ(requests.next()->code, kGetInfo);
  EXPECT_EQ(to_hex(requests.next()->parameters), "75 00 00 00 01 00");
  EXPECT_EQ(requests.next()->code, kStop) << "one with a wrong check is left out";
  EXPECT_FALSE(requests.next());
}

TEST(RplidarFrames, nodes_are_those_of_the_capture) {
  EXPECT_EQ(to_hex(encode_node({true, 47, 45.5, 1234})), "bd c1 16 48 13");
  EXPECT_EQ(to_hex(encode_node({false, 47, 45.5, 1234})), "be c1 16 48 13");
  LidarAnswers answers;
  answers.expect(kNodes, kNodeBytes, true);
  answers.add(from_hex("00 a5 a5 5a 05 00 00 40 81 bd 01 00 a0 0f be 81 00 a8 0f be 01 01 b0 0f"));
  const LidarSample first = read_node(*answers.next()), second = read_node(*answers.next());
  EXPECT_TRUE(first.is_first);
  EXPECT_EQ(first.range, 1000);
  EXPECT_EQ(first.quality, 47);
  EXPECT_FALSE(second.is_first);
  EXPECT_EQ(second.angle, 1);
  EXPECT_EQ(second.range, 1002);
  EXPECT_FALSE(answers.next()) << "another must follow the last one";
}

TEST(RplidarFrames, capsules_are_those_of_the_capture) {
  LidarCapsule capsule{.is_first = true, .angle = 90};
  for (std::size_t k = 0; k < kSamplesOfCapsule; ++k) {
    capsule.ranges[k] = k % 2 == 0 ? 1000 : 1004;
    capsule.offsets[k] = 1;
  }
  const RawBytes encoded = encode_capsule(capsule);
  EXPECT_EQ(to_hex(std::span(encoded).first(9)), "a6 51 80 96 a0 0f b0 0f 88");

  // Of the capture, whose host printed 1000 mm at 0 degrees, 1001 at 0.5 and 1002 at 1.
  LidarAnswers answers;
  answers.expect(kCapsules, kCapsuleBytes, true);
  answers.add(from_hex(
      "a5 5a 54 00 00 40 82 "
      "aa 58 80 0a f0 10 f4 10 00 f8 10 fc 10 00 00 11 04 11 00 08 11 0c 11 00 10 11 14 11 00 18 11 1c 11 00 "
      "20 11 24 11 00 28 11 2c 11 00 30 11 34 11 00 38 11 3c 11 00 40 11 44 11 00 48 11 4c 11 00 50 11 54 11 "
      "00 58 11 5c 11 00 60 11 64 11 00 68 11 6c 11 00"));
  const auto piece = answers.next();
  ASSERT_TRUE(piece);
  const LidarCapsule read = read_capsule(*piece);
  EXPECT_FALSE(read.is_first);
  EXPECT_EQ(read.angle, 42);
  EXPECT_EQ(read.ranges[0], 1084) << "1000 and twice the angle";
  EXPECT_EQ(to_hex(encode_capsule(read)), to_hex(*piece));
  const auto samples = samples_of(read, 58);
  ASSERT_EQ(samples.size(), 32u);
  EXPECT_EQ(samples[2].angle, 43);
  EXPECT_EQ(samples[2].range, 1086);
}

TEST(RplidarFrames, a_turn_begins_where_the_angle_passes_360) {
  LidarCapsule capsule{.angle = 352};
  const auto samples = samples_of(capsule, 8);
  for (std::size_t k = 0; k < samples.size(); ++k) EXPECT_EQ(samples[k].is_first, k == 16) << k;
}

TEST(RplidarFrames, samples_that_were_damaged_are_left_out_and_the_next_are_read) {
  LidarAnswers answers;
  answers.expect(kCapsules, kCapsuleBytes, true);
  answers.add(encode_descriptor(kCapsuleBytes, true, kCapsules));
  const RawBytes whole = encode_capsule({.angle = 10});
  RawBytes flipped = whole;
  flipped[40] ^= std::byte{1};
  answers.add(flipped);
  answers.add(std::span(whole).first(50));
  answers.add(whole);
  EXPECT_TRUE(answers.next());
  EXPECT_FALSE(answers.next());
}

TEST(RplidarFrames, any_bytes_are_read_without_harm) {
  Rng rng(7);
  LidarRequests requests;
  LidarAnswers answers;
  for (int k = 0; k < 20000; ++k) {
    if (k % 1000 == 0) {
      answers.expect(k % 2000 == 0 ? kNodes : kCapsules, k % 2000 == 0 ? kNodeBytes : kCapsuleBytes, true);
      answers.add(encode_descriptor(k % 2000 == 0 ? kNodeBytes : kCapsuleBytes, true,
                                    k % 2000 == 0 ? kNodes : kCapsules));
    }
    RawBytes bytes;
    for (int each = 0; each < 6; ++each)
      put_u8(bytes, rng.bits() % 4 == 0 ? 0xA5 : static_cast<int>(rng.bits() & 0xFF));
    requests.add(bytes);
    answers.add(bytes);
    while (requests.next()) {
    }
    while (const auto piece = answers.next()) EXPECT_FALSE(piece->empty());
  }
}

}  // namespace
}  // namespace playhouse::drivers::rplidar
