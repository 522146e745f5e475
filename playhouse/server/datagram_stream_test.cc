#include "playhouse/server/datagram_stream.h"

#include <gtest/gtest.h>

#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/server/test_client.h"

namespace playhouse::server {
namespace {

Bytes command(std::uint32_t number, std::size_t bytes = 8) {
  return message(wire::MessageType::kCmd, 4, 0, 1, Bytes(bytes), number);
}
Bytes request(std::uint32_t number) {
  return player_request(wire::player::kReqDevlist, {}, number);
}
Bytes joined(const Bytes& first, const Bytes& second) {
  Bytes both = first;
  both.insert(both.end(), second.begin(), second.end());
  return both;
}
Bytes part(const Bytes& bytes, std::size_t from, std::size_t to) {
  return {bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.begin() + static_cast<std::ptrdiff_t>(to)};
}

TEST(DatagramStream, takes_several_messages_of_one_datagram_and_one_message_of_several) {
  DatagramStream stream;
  const Bytes two = joined(request(0), command(0));
  EXPECT_EQ(stream.take(two).messages, two);
  const Bytes whole = command(0, 100);
  EXPECT_TRUE(stream.take(part(whole, 0, 20)).messages.empty());
  EXPECT_TRUE(stream.take(part(whole, 20, 90)).messages.empty());
  const DatagramStream::TakenMessages last = stream.take(part(whole, 90, whole.size()));
  EXPECT_EQ(last.messages, whole);
  EXPECT_FALSE(last.dropped);
}

TEST(DatagramStream, goes_on_with_the_next_whole_message_after_the_rest_of_one_is_lost) {
  DatagramStream stream;
  EXPECT_FALSE(stream.take(part(command(0, 100), 0, 60)).dropped);
  const DatagramStream::TakenMessages next = stream.take(request(0));
  EXPECT_EQ(next.messages, request(0));
  EXPECT_TRUE(next.dropped) << "the beginning of the lost one";
}

TEST(DatagramStream, drops_what_is_no_message) {
  DatagramStream stream;
  EXPECT_TRUE(stream.take(Bytes(40, std::byte{0xFF})).dropped);
  EXPECT_EQ(stream.take(request(0)).messages, request(0));
  const DatagramStream::TakenMessages both = stream.take(joined(request(0), Bytes(50, std::byte{0xFF})));
  EXPECT_EQ(both.messages, request(0));
  EXPECT_TRUE(both.dropped);
}

TEST(DatagramStream, holds_no_more_of_an_unfinished_message_than_the_limit) {
  DatagramStream stream;
  const Bytes endless = part(command(0, 2 * limits::kDatagramWaitingBytes), 0, 60000);
  stream.take(endless);
  std::size_t taken = 60000;
  const Bytes more(60000);
  while (!stream.take(more).dropped) {
    taken += more.size();
    ASSERT_LT(taken, 2 * limits::kDatagramWaitingBytes);
  }
  EXPECT_LE(taken, limits::kDatagramWaitingBytes);
}

TEST(DatagramStream, leaves_out_commands_that_newer_ones_have_overtaken) {
  DatagramStream stream;
  EXPECT_EQ(stream.take(command(7)).messages, command(7));
  EXPECT_EQ(stream.take(command(6)).late, 1u);
  EXPECT_EQ(stream.take(request(5)).messages, request(5)) << "somebody waits for its answer";
  EXPECT_EQ(stream.take(request(900)).messages, request(900));
  EXPECT_EQ(stream.take(command(7)).messages, command(7)) << "requests have numbers of their own";
  EXPECT_EQ(stream.take(command(7)).messages, command(7)) << "some clients give all the same number";
  EXPECT_EQ(stream.take(command(0)).messages, command(0)) << "others none";
  EXPECT_EQ(stream.take(command(0xFFFFFFFF)).late, 1u);
}

TEST(DatagramStream, compares_numbers_that_wrap) {
  DatagramStream stream;
  EXPECT_EQ(stream.take(command(0xFFFFFFFE)).late, 0u);
  EXPECT_EQ(stream.take(command(3)).late, 0u);
  EXPECT_EQ(stream.take(command(0xFFFFFFFF)).late, 1u);
}

}  // namespace
}  // namespace playhouse::server
