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
  EXPECT_EQ((*guests)[0].role, server::GuestRole::kAdmin);
  EXPECT_EQ((*guests)[0].token, "secret-12");
  EXPECT_EQ((*guests)[0].name, "Ada");
  EXPECT_EQ((*guests)[1].role, server::GuestRole::kHuman);
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
  EXPECT_EQ(fault("admin short"), "g.txt:1: invalid token: 8 to 32 letters, digits, - and _ are valid");
  EXPECT_EQ(fault("admin with/slash"), "g.txt:1: invalid token: 8 to 32 letters, digits, - and _ are valid");
  EXPECT_EQ(
      fault("human abcdefgh 7up"),
      "g.txt:1: invalid name \"7up\": valid are 1 to 24 letters, digits, - and _, the first one a letter");
  EXPECT_EQ(fault("human abcdefgh Bob Smith"), "g.txt:1: more than role, token and name");
  EXPECT_EQ(fault("observer * Bob"),
            "g.txt:1: * is for everybody without a token, who cannot all have one name");
  EXPECT_EQ(fault("human abcdefgh\nadmin abcdefgh"), "g.txt:2: another line has this token");
  EXPECT_EQ(fault("# nobody\n"), "g.txt: no guest is listed: a line is role token [name]");
}

}  // namespace
}  // namespace playhouse::web_server
