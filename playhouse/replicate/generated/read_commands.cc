// Generated from viewer/commands.toml by codegen (python3 -m codegen). Do not edit.

#include <string_view>

#include "playhouse/base/nearest_word.h"
#include "playhouse/replicate/command_members.h"

namespace playhouse::replicate {

Command read_command(Members& in) {
  constexpr std::string_view kWords[] = {"ack", "look", "select", "physics", "drive", "join", "say", "pause", "resume", "step", "speed", "rewind", "drag", "add", "copy", "remove", "mute", "kick", "save"};
  const std::string_view word = in.word("do");
  if (word == "ack") {
    Acknowledge out;
    out.frame = in.count("frame");
    return out;
  }
  if (word == "look") {
    Look out;
    out.x_min = in.within("x_min", 1e6);
    out.y_min = in.within("y_min", 1e6);
    out.x_max = in.within("x_max", 1e6);
    out.y_max = in.within("y_max", 1e6);
    out.sensors = in.truth("sensors");
    return out;
  }
  if (word == "select") {
    Select out;
    out.model = in.model_or_null("model");
    return out;
  }
  if (word == "physics") {
    return ShowPhysics{};
  }
  if (word == "drive") {
    Drive out;
    out.model = in.model("model");
    out.forward = in.within("forward", 100);
    out.sideways = in.within("sideways", 100);
    out.turn = in.within("turn", 100);
    out.input = in.count_or_none("input");
    return out;
  }
  if (word == "join") {
    Join out;
    out.name = in.person("name");
    out.x = in.within("x", 1e6);
    out.y = in.within("y", 1e6);
    out.a = in.within("a", 1e6);
    return out;
  }
  if (word == "say") {
    Say out;
    out.text = in.text("text");
    return out;
  }
  if (word == "pause") {
    return Pause{};
  }
  if (word == "resume") {
    return Resume{};
  }
  if (word == "step") {
    return Step{};
  }
  if (word == "speed") {
    SetSpeed out;
    out.times_real_time = in.up_to("times_real_time", 1000);
    return out;
  }
  if (word == "rewind") {
    Rewind out;
    out.tick = in.tick("tick");
    return out;
  }
  if (word == "drag") {
    Drag out;
    out.model = in.model("model");
    out.x = in.within("x", 1e6);
    out.y = in.within("y", 1e6);
    out.a = in.within("a", 1e6);
    return out;
  }
  if (word == "add") {
    Add out;
    out.robot = in.count("robot");
    out.x = in.within("x", 1e6);
    out.y = in.within("y", 1e6);
    out.a = in.within("a", 1e6);
    return out;
  }
  if (word == "copy") {
    Copy out;
    out.model = in.model("model");
    out.x = in.within("x", 1e6);
    out.y = in.within("y", 1e6);
    out.a = in.within("a", 1e6);
    return out;
  }
  if (word == "remove") {
    Remove out;
    out.model = in.model("model");
    return out;
  }
  if (word == "mute") {
    Mute out;
    out.viewer = in.count("viewer");
    out.on = in.truth("on");
    return out;
  }
  if (word == "kick") {
    Kick out;
    out.viewer = in.count("viewer");
    return out;
  }
  if (word == "save") {
    return Save{};
  }
  in.fault("no such command" + did_you_mean(word, kWords));
  return Acknowledge{};
}

}  // namespace playhouse::replicate
