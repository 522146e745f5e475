#include "playhouse/server/guests/guest_book.h"

#include <gtest/gtest.h>

namespace playhouse::server {
namespace {

TEST(GuestBook, who_guesses_waits_for_a_second_and_others_do_not) {
  double now = 0;
  const GuestBook book({{GuestRole::kAdmin, "the-admin", "Ada"}, {GuestRole::kObserver, "*", ""}},
                       [&] { return now; });
  for (int k = 0; k < kGuesses; ++k) EXPECT_FALSE(book.admit("the-admim", "10.0.0.7:4000"));
  EXPECT_FALSE(book.admit("the-admin", "10.0.0.7:4001")) << "also the right one";
  EXPECT_TRUE(book.admit("*", "10.0.0.7:4002")) << "who has none guesses none";
  EXPECT_TRUE(book.admit("the-admin", "10.0.0.8:4000"));
  now += 1;
  EXPECT_TRUE(book.admit("the-admin", "10.0.0.7:4003"));
  EXPECT_FALSE(book.admit("the-admim", "10.0.0.7:4004"));
  EXPECT_FALSE(book.admit("the-admin", "10.0.0.7:4005"));
}

TEST(GuestBook, a_token_that_nobody_guesses_is_not_kept_out_by_those_who_try) {
  const std::string long_one(kUnguessableLetters, 'k');
  const GuestBook book({{GuestRole::kDriver, long_one, ""}, {GuestRole::kDriver, "short-one", ""}},
                       [] { return 0.0; });
  for (int k = 0; k < 2 * kGuesses; ++k) EXPECT_FALSE(book.admit("wrong-one", "10.0.0.7:4000"));
  EXPECT_TRUE(book.admit(long_one, "10.0.0.7:4001"));
  EXPECT_FALSE(book.admit("short-one", "10.0.0.7:4001"));
}

TEST(GuestBook, who_is_sent_out_is_known_by_the_token_or_without_one_by_the_network) {
  GuestBook book({{GuestRole::kHuman, "blue-chair-7", "Bob"},
                  {GuestRole::kHuman, "red-chair-77", "Eve"},
                  {GuestRole::kObserver, "*", ""}});
  GuestBook same_list = book;
  book.send_out("blue-chair-7");
  EXPECT_FALSE(same_list.admit("blue-chair-7", "10.0.0.7:1"));
  EXPECT_TRUE(same_list.admit("*", "10.0.0.7:1"));
  book.send_out_network("10.0.0.7:1");
  EXPECT_FALSE(same_list.admit("*", "10.0.0.7:2"));
  EXPECT_TRUE(same_list.admit("*", "10.0.0.8:2"));
  EXPECT_TRUE(same_list.admit("red-chair-77", "10.0.0.7:2")) << "as another guest";
  GuestBook everybody;
  everybody.send_out_network("10.0.0.7:1");
  for (const char* token : {"*", "invented"}) {
    EXPECT_FALSE(everybody.admit(token, "10.0.0.7:2")) << token;
    EXPECT_TRUE(everybody.is_sent_out(token, "10.0.0.7:2")) << token;
    EXPECT_TRUE(everybody.admit(token, "10.0.0.8:2")) << token;
  }
}

TEST(GuestBook, rights_follow_from_the_role) {
  EXPECT_FALSE(rights_of(GuestRole::kObserver).drives || rights_of(GuestRole::kObserver).joins);
  EXPECT_TRUE(rights_of(GuestRole::kDriver).drives);
  EXPECT_FALSE(rights_of(GuestRole::kDriver).joins);
  EXPECT_TRUE(rights_of(GuestRole::kHuman).joins);
  EXPECT_FALSE(rights_of(GuestRole::kHuman).drives) << "other than their own body";
  EXPECT_TRUE(rights_of(GuestRole::kAdmin).manages && rights_of(GuestRole::kAdmin).drives &&
              rights_of(GuestRole::kAdmin).joins);
}

TEST(GuestBook, who_has_the_key_manages_and_nobody_else_comes) {
  const GuestBook book = book_of_key("the-key-7");
  const std::optional<Guest> guest = book.admit("the-key-7", "10.0.0.7:1");
  ASSERT_TRUE(guest);
  EXPECT_TRUE(rights_of(guest->role).manages);
  EXPECT_FALSE(book.admit("the-key-8", "10.0.0.7:1"));
  EXPECT_FALSE(book.admit("*", "10.0.0.7:1"));
  EXPECT_TRUE(book_of_key("").admit("*", "10.0.0.7:1")) << "without a key everybody is admitted";
  for (const char* const text : {"seven-7", "eight letters", "a-letter-more-than-thirty-two-are"})
    EXPECT_FALSE(is_key(text)) << text;
  EXPECT_TRUE(is_key("just-as-many-as-AUTH-has-room-of"));
}

}  // namespace
}  // namespace playhouse::server
