// Text as the original driver sent and took it, and binary commands of the maker's list.

#include "playhouse/drivers/ptu46/ptu_text.h"

#include <gtest/gtest.h>

#include "playhouse/drivers/hardware/testing_hardware.h"

namespace playhouse::drivers::ptu {
namespace {

using drivers::testing::from_hex;
using drivers::testing::to_hex;

/// "* 5", "*", "!" of replies; "-" for none.
std::string replies_of(std::string_view text) {
  PtuReplyReader reader;
  std::string found;
  for (const char letter : text) {
    reader.add(std::as_bytes(std::span(&letter, 1)));
    while (const auto reply = reader.next())
      found += (reply->is_good ? "*" : "!") + (reply->value ? fmt::format("{}", *reply->value) : "") + " ";
  }
  return found.empty() ? "-" : found;
}
std::string commands_of(std::string_view text) {
  PtuCommandReader reader;
  reader.add(std::as_bytes(std::span(text)));
  std::string found;
  while (const auto command = reader.next())
    found += command->letters + (command->number ? fmt::format("={}", *command->number) : "") + " ";
  return found;
}

TEST(PtuText, replies_are_read_in_every_form) {
  EXPECT_EQ(replies_of("* 185.1428\r\n* -3090\r\n*\r\n"), "*185.1428 *-3090 * ");
  EXPECT_EQ(replies_of("* 222\r* 0\r"), "*222 *0 ") << "of real units, which end lines by CR";
  EXPECT_EQ(replies_of("* Current Pan position is 17\r\n"), "*17 ");
  EXPECT_EQ(replies_of("! Maximum allowable Pan position is 3090\r\n"), "! ");
  EXPECT_EQ(replies_of("pp * 12\r\n"), "*12 ") << "after an echo";
  EXPECT_EQ(replies_of("* 12"), "-") << "not whole";
  EXPECT_EQ(replies_of("* 1x2\r\n"), "* ");
}

/// In the original each of these shifts every later value by one reply.
TEST(PtuText, limits_are_no_replies) {
  EXPECT_EQ(replies_of("!P\r\n* 1000\r\n"), "*1000 ");
  EXPECT_EQ(replies_of("* 10!T00\r\n"), "*1000 ") << "also within one";
  EXPECT_EQ(replies_of("!T!T!P!P*\r\n"), "* ");
}

TEST(PtuText, commands_are_those_of_the_original) {
  EXPECT_EQ(encode_command("pp", 222), "pp222 ");
  EXPECT_EQ(encode_command("tp", -111), "tp-111 ");
  EXPECT_EQ(encode_command("cv"), "cv ");
  EXPECT_EQ(commands_of("ft ed ci i "), "FT ED CI I ");
  EXPECT_EQ(commands_of(" pp222 TP-111\rps\n\r  "), "PP=222 TP=-111 PS ");
  EXPECT_EQ(commands_of("pp2x pp22"), " ") << "a number that is none, and one that is not whole";
  EXPECT_EQ(commands_of(std::string(10000, 'p') + " "), " ");
}

TEST(PtuText, binary_commands_have_their_lengths) {
  PtuCommandReader reader;
  reader.add(from_hex("81 03 e8 91 c5 01 c9 00 00 07 d0 70 70 20 a5 82 ff"));
  const auto first = reader.next();
  EXPECT_EQ(first->opcode, 129);
  EXPECT_EQ(to_hex(first->data), "03 e8");
  EXPECT_EQ(reader.next()->opcode, 145);
  EXPECT_EQ(to_hex(reader.next()->data), "01");
  EXPECT_EQ(to_hex(reader.next()->data), "00 00 07 d0");
  EXPECT_EQ(reader.next()->letters, "PP");
  EXPECT_EQ(reader.next()->opcode, 165);
  EXPECT_FALSE(reader.next()) << "not whole";
}

TEST(PtuText, counts_are_degrees_by_the_resolution) {
  EXPECT_NEAR(counts_of(0.2, 185.1428), 222.8, 0.05) << "which the original cuts to 222";
  EXPECT_NEAR(radians_of(counts_of(0.7, 46.2857), 46.2857), 0.7, 1e-12);
}

}  // namespace
}  // namespace playhouse::drivers::ptu
