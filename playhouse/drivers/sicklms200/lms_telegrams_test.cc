// Bytes as the original driver sent them, and as it took them from a laser.

#include "playhouse/drivers/sicklms200/lms_telegrams.h"

#include <gtest/gtest.h>

#include "playhouse/base/rng.h"
#include "playhouse/drivers/hardware/testing_hardware.h"

namespace playhouse::drivers::sick {
namespace {

using drivers::testing::from_hex;
using drivers::testing::to_hex;

TEST(SickTelegrams, what_a_host_says_is_what_the_original_says) {
  EXPECT_EQ(to_hex(ask(kSetMode, kOnRequest)), "02 00 02 00 20 25 35 08");
  EXPECT_EQ(to_hex(ask(kSetMode, k38400)), "02 00 02 00 20 40 50 08");
  EXPECT_EQ(to_hex(ask(kAskType)), "02 00 01 00 3a 1e 12");
  EXPECT_EQ(to_hex(ask(kAskStatus)), "02 00 01 00 31 15 12");
  EXPECT_EQ(to_hex(ask(kAskBlock)), "02 00 01 00 74 50 12");
  EXPECT_EQ(to_hex(to_laser(encode_variant({180, 50}))), "02 00 05 00 3b b4 00 32 00 3b 1f");
  EXPECT_EQ(to_hex(to_laser(encode_variant({100, 25}))), "02 00 05 00 3b 64 00 19 00 e7 72");
  EXPECT_EQ(to_hex(ask_for_part(1, 401)), "02 00 06 00 20 27 01 00 91 01 5b 2d");
  EXPECT_EQ(to_hex(ask_for_part(91, 271)), "02 00 06 00 20 27 5b 00 0f 01 b2 58");
}

TEST(SickTelegrams, what_a_laser_says_is_what_the_original_took) {
  LmsReader reader(LmsReader::LmsEnd::kLaser);
  reader.add(
      from_hex("06 02 80 03 00 a0 00 10 16 0a 06 "
               "02 80 16 00 ba 4c 4d 53 32 30 30 3b 33 30 31 30 36 3b 56 30 32 2e 31 30 20 10 99 ab "
               "06 02 80 07 00 bb 01 b4 00 32 00 10 03 9d"));
  EXPECT_EQ(to_hex(*reader.next()), "a0 00");
  EXPECT_EQ(u8(*reader.next(), 0), kType);
  EXPECT_EQ(read_variant(*reader.next()), (LmsVariant{180, 50}));
  EXPECT_FALSE(reader.next());

  RawBytes mode;
  put_16_le(mode, 0xA0);  // a0 00
  EXPECT_EQ(to_hex(from_laser(mode)), "02 80 03 00 a0 00 10 16 0a");
  const RawBytes state = from_laser(encode_state({.version = "V02.10 ", .mode = 0, .variant = {180, 100}}));
  EXPECT_EQ(state.size(), 159u);
  EXPECT_EQ(to_hex(std::span(state).last(3)), "10 66 a8") << "its CRC in the capture";
}

/// The scan of the capture, of which the original's client read 19 m, 24 m and 25 m at 0, 50 and 60.
TEST(SickTelegrams, a_scan_of_the_capture_has_its_checksum_and_its_values) {
  LmsScan sent{.first = 91, .is_part = true, .unit = kCentimetre, .values = {}};
  for (int k = 0; k < 181; ++k) sent.values.push_back(1900 + 10 * k);
  const RawBytes bytes = from_laser(encode_scan(sent));
  EXPECT_EQ(bytes.size(), 376u);
  EXPECT_EQ(to_hex(std::span(bytes).first(13)), "02 80 72 01 b7 5b 00 0f 01 b5 00 6c 07");
  EXPECT_EQ(to_hex(std::span(bytes).last(3)), "10 32 b1");
  LmsReader reader(LmsReader::LmsEnd::kLaser);
  reader.add(bytes);
  const auto scan = read_scan(*reader.next());
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->first, 91);
  EXPECT_EQ(scan->values, sent.values);
}

TEST(SickTelegrams, of_a_scan_that_was_cut_short_the_next_one_is_not_lost) {
  const RawBytes scan = from_laser(encode_scan({.values = std::vector<int>(181, 1000)}));
  LmsReader reader(LmsReader::LmsEnd::kLaser);
  reader.add(from_hex("00 55 02"));
  reader.add(scan);
  EXPECT_TRUE(reader.next());
  reader.add(std::span(scan).first(200));
  reader.add(scan);
  EXPECT_TRUE(reader.next()) << "the original loses both";
  RawBytes flipped = scan;
  flipped[100] ^= std::byte{1};
  reader.add(flipped);
  reader.add(scan);
  EXPECT_TRUE(reader.next());
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.damaged(), 2u);
}

TEST(SickTelegrams, what_is_cut_short_is_none) {
  const RawBytes whole = encode_scan({.first = 7, .is_part = true, .values = {1, 2, 3}});
  EXPECT_TRUE(read_scan(whole));
  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes)
    EXPECT_FALSE(read_scan(std::span(whole).first(bytes))) << bytes;
  EXPECT_FALSE(read_state(RawBytes(110)));
  EXPECT_FALSE(read_variant(RawBytes(4)));
}

TEST(SickTelegrams, any_bytes_are_read_without_harm) {
  Rng rng(3);
  for (const auto from : {LmsReader::LmsEnd::kHost, LmsReader::LmsEnd::kLaser}) {
    LmsReader reader(from);
    for (int k = 0; k < 20000; ++k) {
      RawBytes bytes;
      constexpr int kLikely[] = {0x02, 0x80, 0x00, 0x06};
      for (int each = 0; each < 4; ++each)
        put_u8(bytes, rng.bits() % 2 == 0 ? kLikely[rng.bits() % 4] : static_cast<int>(rng.bits() & 0xFF));
      reader.add(bytes);
      while (const auto telegram = reader.next()) EXPECT_FALSE(telegram->empty());
    }
  }
}

TEST(SickTelegrams, scans_come_as_often_as_the_mirror_turns_or_the_line_carries_them) {
  EXPECT_NEAR(1 / scan_period({180, 100}, 181, 500000), 75, 1e-9);
  EXPECT_NEAR(1 / scan_period({180, 50}, 361, 500000), 37.5, 1e-9);
  EXPECT_NEAR(1 / scan_period({100, 25}, 401, 500000), 18.75, 1e-9);
  EXPECT_NEAR(1 / scan_period({180, 50}, 361, 38400), 4.69, 0.01);
}

}  // namespace
}  // namespace playhouse::drivers::sick
