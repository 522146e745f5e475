#include "playhouse/web_server/guests.h"

#include <gtest/gtest.h>

namespace playhouse::web_server {
namespace {

std::string fault(std::string_view text) {
  const auto guests = parse_guests(text, "g.txt");
  return guests ? "none" : guests.error().line();
}

TEST(Guests, a_line_is_a_role_a_token_and_a_name) {
  const auto guests = parse_guests(
      "# who may come\n\nadmin  secret-12 Ada # the teacher\r\nhuman ?\tBob\nobserver *", "g.txt");
  ASSERT_TRUE(guests) << guests.error().line();
  ASSERT_EQ(guests->size(), 3u);
  EXPECT_EQ((*guests)[0].role, GuestRole::kAdmin);
  EXPECT_EQ((*guests)[0].token, "secret-12");
  EXPECT_EQ((*guests)[0].name, "Ada");
  EXPECT_EQ((*guests)[1].role, GuestRole::kHuman);
  EXPECT_EQ((*guests)[1].token.size(), 26u);
  EXPECT_EQ((*guests)[2].token, "*");
  EXPECT_EQ((*guests)[2].name, "");
  EXPECT_NE(random_token(), random_token());
}

TEST(Guests, faults_name_the_line_and_the_nearest_role) {
  EXPECT_EQ(fault("observer *\nhumam secret-12"),
            "g.txt:2: invalid role \"humam\": observer, driver, human and admin are valid (did you mean "
            "\"human\"?)");
  EXPECT_EQ(fault("admin"),
            "g.txt:1: a token is missing: role token [name]; ? makes one, * is for whoever has no token");
  EXPECT_EQ(fault("admin short"), "g.txt:1: invalid token: 8 to 128 letters, digits, - and _ are valid");
  EXPECT_EQ(fault("admin with/slash"), "g.txt:1: invalid token: 8 to 128 letters, digits, - and _ are valid");
  EXPECT_EQ(
      fault("human abcdefgh 7up"),
      "g.txt:1: invalid name \"7up\": valid are 1 to 24 letters, digits, - and _, the first one a letter");
  EXPECT_EQ(fault("human abcdefgh Bob Smith"), "g.txt:1: more than role, token and name");
  EXPECT_EQ(fault("observer * Bob"),
            "g.txt:1: * is for everybody without a token, who cannot all have one name");
  EXPECT_EQ(fault("human abcdefgh\nadmin abcdefgh"), "g.txt:2: another line has this token");
  EXPECT_EQ(fault("# nobody\n"), "g.txt: no guest is listed: a line is role token [name]");
}

TEST(Guests, who_guesses_waits_for_a_second_and_others_do_not) {
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

TEST(Guests, who_is_sent_out_is_known_by_the_token_or_without_one_by_the_network) {
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

TEST(Guests, rights_follow_from_the_role) {
  EXPECT_FALSE(rights_of(GuestRole::kObserver).drives || rights_of(GuestRole::kObserver).joins);
  EXPECT_TRUE(rights_of(GuestRole::kDriver).drives);
  EXPECT_FALSE(rights_of(GuestRole::kDriver).joins);
  EXPECT_TRUE(rights_of(GuestRole::kHuman).joins);
  EXPECT_FALSE(rights_of(GuestRole::kHuman).drives) << "other than their own body";
  EXPECT_TRUE(rights_of(GuestRole::kAdmin).manages && rights_of(GuestRole::kAdmin).drives &&
              rights_of(GuestRole::kAdmin).joins);
}

}  // namespace
}  // namespace playhouse::web_server
