#include "playhouse/scene/robot_file.h"

#include <gtest/gtest.h>

namespace playhouse::scene {
namespace {

std::vector<RobotDesc> robots(const std::string& text) {
  const Result<std::vector<RobotDesc>> read = read_robots(text, "my.toml");
  EXPECT_TRUE(read) << (read ? "" : read.error().line());
  return read ? *read : std::vector<RobotDesc>(1);
}

std::string fault(const std::string& text) {
  const Result<std::vector<RobotDesc>> read = read_robots(text, "my.toml");
  return read ? "" : read.error().line();
}

TEST(RobotFile, a_file_is_one_robot) {
  const std::vector<RobotDesc> read = robots(R"(type = "pioneer2dx"
name = "bob"
pose = [1, -2.5, 90]
port = 7000
color = "light blue"
sensors = ["sicklaser", {type = "fancysonar", pose = [0.1, 0, 180]}]
devices = {laser = 3}
)");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].type, "pioneer2dx");
  EXPECT_EQ(read[0].name, "bob");
  EXPECT_EQ(read[0].X_WR.x, 1);
  EXPECT_EQ(read[0].X_WR.y, -2.5);
  EXPECT_NEAR(read[0].X_WR.a, geom::kPi / 2, 1e-12);
  EXPECT_EQ(read[0].port, 7000);
  EXPECT_EQ(read[0].color, "light blue");
  ASSERT_EQ(read[0].sensors.size(), 2u);
  EXPECT_EQ(read[0].sensors[0].type, "sicklaser");
  EXPECT_FALSE(read[0].sensors[0].X_RS);
  EXPECT_EQ(read[0].sensors[1].type, "fancysonar");
  EXPECT_EQ(read[0].sensors[1].X_RS->x, 0.1);
  EXPECT_EQ(read[0].first_index, (std::map<std::string, int>{{"laser", 3}}));
}

TEST(RobotFile, or_has_several) {
  const std::vector<RobotDesc> read =
      robots("[[robot]]\ntype = \"a\"\npose = [0, 0, 0]\n\n[[robot]]\ntype = \"b\"\npose = [1, 0, 0]\n");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].type, "a");
  EXPECT_EQ(read[1].where, "my.toml:5");
  EXPECT_FALSE(read[1].port);
}

TEST(RobotFile, what_is_wrong_is_told_with_its_line_and_the_nearest_word) {
  EXPECT_EQ(fault("type = \"a\"\npose = [0, 0, 0]\nsensor = []\n"),
            "my.toml:3: \"sensor\" is unknown (did you mean \"sensors\"?)");
  EXPECT_EQ(fault("type = \"a\"\npose = [0, 0]\n"),
            "my.toml:2: a pose is [x, y, heading], three numbers in metres and degrees");
  EXPECT_EQ(fault("type = \"a\"\npose = [0, nan, 0]\n"),
            "my.toml:2: a pose is [x, y, heading], three numbers in metres and degrees");
  EXPECT_EQ(fault("type = \"a\"\npose = [0, 0, 0]\nport = 70000\n"),
            "my.toml:3: \"port\" is a whole number from 0 to 65535");
  EXPECT_EQ(fault("pose = [0, 0, 0]\n"), "my.toml:1: a robot has a type, as type = \"pioneer2dx\"");
  EXPECT_EQ(fault("type = \"a\"\n"), "my.toml:1: a robot has a pose, as pose = [x, y, heading]");
  EXPECT_EQ(fault("type = \"\"\n"), "my.toml:1: \"type\" is a text that is not empty");
  EXPECT_EQ(fault("type = \"a\"\npose = [0, 0, 0]\n[, 0]\n").substr(0, 11), "my.toml:3: ");
  EXPECT_EQ(fault("robot = 3\n"), "my.toml:1: robots are written as [[robot]] tables");
  EXPECT_EQ(fault("type = \"a\"\n[[robot]]\ntype = \"b\"\npose = [0, 0, 0]\n"),
            "my.toml:1: \"type\" is outside of the [[robot]] tables");
  EXPECT_EQ(fault("type = \"a\"\npose = [0, 0, 0]\nsensors = [\"two words\"]\n").substr(0, 21),
            "my.toml:3: a sensor i");
  EXPECT_EQ(fault("type = \"a\"\npose = [0, 0, 0]\nsensors = [{typ = \"b\"}]\n"),
            "my.toml:3: \"typ\" is unknown (did you mean \"type\"?)");
  EXPECT_EQ(fault("type = \"a\"\npose = [0, 0, 0]\ndevices = {lazer = 1}\n"),
            "my.toml:3: \"lazer\" is unknown (did you mean \"laser\"?)");
  EXPECT_EQ(fault("type = \"a\"\npose = [0, 0, 0]\ndevices = {position2d = 1, power = 0, speech = 2}\n"), "");
  EXPECT_EQ(fault("type = \"a\n").substr(0, 9), "my.toml:1");
}

}  // namespace
}  // namespace playhouse::scene
