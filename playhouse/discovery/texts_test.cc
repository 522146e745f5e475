// What a server announces and what is read of what anybody announces.

#include "playhouse/discovery/texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace playhouse::discovery {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;
using Texts = std::vector<std::string>;

TEST(ServerTexts, say_which_robots_there_are_and_what_a_client_needs) {
  EXPECT_THAT(texts_of({true, true, {"r0", "guest=1"}}, "0.3.0"),
              ElementsAre("txtvers=1", "version=0.3.0", "tls=1", "guests=1", "robots=2", "robot0=r0",
                          "robot1=guest=1"));
  EXPECT_THAT(texts_of({}, "0.3.0"), ElementsAre("txtvers=1", "version=0.3.0", "robots=0"));
}

TEST(ServerTexts, are_read_as_they_were_written) {
  for (const ServerTexts& server :
       {ServerTexts{true, false, {"r0", "a b", "\xc3\xa4=\n"}}, ServerTexts{false, true, {}}})
    EXPECT_EQ(from_texts(texts_of(server, "1")), server);
}

TEST(ServerTexts, leave_out_robots_that_do_not_fit_but_not_their_number) {
  ServerTexts server{.robots = {std::string(300, 'x')}};
  for (int i = 0; i < 1000; ++i) server.robots.push_back("robot number " + std::to_string(i));
  const Texts texts = texts_of(server, "1");
  std::size_t bytes = 0;
  for (const std::string& text : texts) {
    EXPECT_LE(text.size(), kOneTextBytes);
    bytes += text.size() + 1;
  }
  EXPECT_LE(bytes, kAllTextBytes);
  EXPECT_THAT(texts, ::testing::Contains("robots=1001"));
  EXPECT_THAT(texts, ::testing::Contains("robot0=robot number 0"));
  for (std::string& robot : server.robots) robot = "r";
  EXPECT_THAT(from_texts(texts_of(server, "1")).robots, SizeIs(kMostRobots));
}

TEST(ServerTexts, of_others_may_be_anything) {
  EXPECT_EQ(
      from_texts(Texts{"", "=", "robot=x", "robotx=y", "robot1", "robot2=", "tls=2", "guests", "other=1"}),
      ServerTexts());
  EXPECT_THAT(from_texts(Texts{"robot7=" + std::string(300, 'x'), "robot8=r8"}).robots, ElementsAre("r8"));
  EXPECT_THAT(from_texts(Texts{"robot1=b", "robot0=a", "robot1=c", "robot99999999999=d"}).robots,
              ElementsAre("a", "b"));
  Texts many;
  for (int i = 0; i < 100000; ++i) many.push_back("robot" + std::to_string(i) + "=r");
  EXPECT_THAT(from_texts(many).robots, SizeIs(kMostRobots));
}

}  // namespace
}  // namespace playhouse::discovery
