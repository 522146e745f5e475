#include "playhouse/replicate/command.h"

#include <gtest/gtest.h>

#include <string>

namespace playhouse::replicate {
namespace {

TEST(Command, every_command_is_read) {
  EXPECT_TRUE(std::holds_alternative<Pause>(*parse_command(R"({"do":"pause"})")));
  EXPECT_TRUE(std::holds_alternative<Resume>(*parse_command(R"({"do":"resume"})")));
  EXPECT_TRUE(std::holds_alternative<Step>(*parse_command(R"({"do":"step"})")));
  EXPECT_EQ(std::get<SetSpeed>(*parse_command(R"({"do":"speed","times_real_time":2.5})")).times_real_time,
            2.5);
  EXPECT_EQ(std::get<Rewind>(*parse_command(R"({"do":"rewind","tick":12345678901})")).tick, 12345678901u);
  const auto drag = std::get<Drag>(*parse_command(R"({"do":"drag","model":3,"x":1,"y":-2.5,"a":0.5})"));
  EXPECT_EQ(drag.model.value, 3u);
  EXPECT_EQ(drag.y, -2.5);
  const auto drive =
      std::get<Drive>(*parse_command(R"({"do":"drive","model":3,"forward":0.4,"sideways":-0.1,"turn":1.5})"));
  EXPECT_EQ(drive.model.value, 3u);
  EXPECT_EQ(velocity_of(drive), (geom::Twist{0.4, -0.1, 0, 1.5}));
  EXPECT_EQ(drive.input, 0u);
  EXPECT_EQ(
      std::get<Drive>(
          *parse_command(R"({"do":"drive","model":3,"forward":0,"sideways":0,"turn":0,"input":4294967294})"))
          .input,
      4294967294u);
  EXPECT_TRUE(std::holds_alternative<ShowPhysics>(*parse_command(R"({"do":"physics"})")));
  EXPECT_EQ(std::get<Select>(*parse_command(R"({"do":"select","model":4})")).model, world::ModelId{4});
  EXPECT_EQ(std::get<Select>(*parse_command(R"({"do":"select","model":null})")).model, std::nullopt);
  const auto copy = std::get<Copy>(*parse_command(R"({"do":"copy","model":3,"x":1,"y":-2.5,"a":0.5})"));
  EXPECT_EQ(copy.model.value, 3u);
  EXPECT_EQ(copy.a, 0.5);
  const auto join = std::get<Join>(*parse_command(R"({"do":"join","name":"Ada-7","x":1,"y":2,"a":3})"));
  EXPECT_EQ(join.name, "Ada-7");
  EXPECT_EQ(join.y, 2);
  EXPECT_EQ(std::get<Say>(*parse_command(R"({"do":"say","text":"hello"})")).text, "hello");
  const auto add = std::get<Add>(*parse_command(R"({"do":"add","robot":2,"x":1,"y":-2.5,"a":0.5})"));
  EXPECT_EQ(add.robot, 2u);
  EXPECT_EQ(add.x, 1);
  EXPECT_EQ(std::get<Remove>(*parse_command(R"({"do":"remove","model":9})")).model.value, 9u);
  EXPECT_TRUE(std::holds_alternative<Save>(*parse_command(R"({"do":"save"})")));
  const auto look = std::get<Look>(
      *parse_command(R"({"do":"look","x_min":-1,"y_min":-2,"x_max":3,"y_max":4,"sensors":true})"));
  EXPECT_EQ(look.y_max, 4);
  EXPECT_TRUE(look.sensors);
  EXPECT_EQ(std::get<Acknowledge>(*parse_command(R"({"do":"ack","frame":17})")).frame, 17u);
}

struct Refusal {
  const char* text;
  const char* why;
};

TEST(Command, what_cannot_be_is_refused_with_a_reason) {
  const Refusal refusals[] = {
      {"", "not JSON"},
      {"{\"do\":\"pause\"", "not JSON"},
      {"{\"do\":\"pause\"} x", "not JSON"},
      {"[1]", "a command is a JSON object"},
      {"{}", "\"do\" must be a string"},
      {R"({"do":1})", "\"do\" must be a string"},
      {R"({"do":"pasue"})", "did you mean \"pause\"?"},
      {R"({"do":"pause","now":true})", "an unknown key"},
      {R"({"do":"speed"})", "\"times_real_time\" must be a number"},
      {R"({"do":"speed","times_real_time":-1})", "within its range"},
      {R"({"do":"speed","times_real_time":1e9})", "within its range"},
      {R"({"do":"drag","model":1.5,"x":0,"y":0,"a":0})", "whole number"},
      {R"({"do":"drag","model":-1,"x":0,"y":0,"a":0})", "within its range"},
      {R"({"do":"drag","model":1,"x":1e99,"y":0,"a":0})", "within its range"},
      {R"({"do":"drive","model":1,"forward":101,"sideways":0,"turn":0})",
       "\"forward\" must be a number within"},
      {R"({"do":"drive","model":1,"forward":0,"sideways":0,"turn":1e400})",
       "\"turn\" must be a number within"},
      {R"({"do":"drive","model":1,"forward":0,"sideways":NaN,"turn":0})", "not JSON"},
      {R"({"do":"drive","model":1,"forward":0,"sideways":null,"turn":0})", "\"sideways\" must be a number"},
      {R"({"do":"drive","model":1,"forward":0,"turn":0})", "\"sideways\" must be a number"},
      {R"({"do":"drive","model":1,"forward":0,"sideways":0,"turn":0,"input":-1})", "within its range"},
      {R"({"do":"drive","model":1,"forward":0,"sideways":0,"turn":0,"input":"7"})", "\"input\" must be"},
      {R"({"do":"physics","model":1})", "an unknown key"},
      {R"({"do":"copy","model":1})", "\"x\" must be a number"},
      {R"({"do":"join","name":"","x":0,"y":0,"a":0})", "\"name\" must be"},
      {R"({"do":"join","name":"a.b","x":0,"y":0,"a":0})", "\"name\" must be"},
      {R"({"do":"join","name":"abcdefghijklmnopqrstuvwxyz","x":0,"y":0,"a":0})", "\"name\" must be"},
      {R"({"do":"say"})", "\"text\" must be a string"},
      {R"({"do":"add","robot":-1,"x":0,"y":0,"a":0})", "within its range"},
      {R"({"do":"remove"})", "\"model\" must be a number"},
      {R"({"do":"select"})", "\"model\" must be a number"},
      {R"({"do":"look","x_min":-1,"y_min":-2,"x_max":3,"y_max":4,"sensors":1})", "true or false"},
      {R"({"do":"ack","frame":[[[1]]]})", "not JSON"},
  };
  for (const Refusal& refusal : refusals) {
    const Result<Command> command = parse_command(refusal.text);
    ASSERT_FALSE(command.ok()) << refusal.text;
    EXPECT_NE(command.error().text.find(refusal.why), std::string::npos)
        << refusal.text << " -> " << command.error().text;
  }
  EXPECT_FALSE(parse_command(std::string(5000, ' ') + R"({"do":"pause"})").ok());
}

}  // namespace
}  // namespace playhouse::replicate
