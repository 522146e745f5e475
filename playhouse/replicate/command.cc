#include "playhouse/replicate/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/json.hpp>
#include <cmath>
#include <string>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::replicate {
namespace {

namespace json = boost::json;

constexpr std::array<std::string_view, 19> kWords = {
    "pause", "resume", "step", "speed", "rewind", "drag",    "drive",  "copy", "add", "join",
    "say",   "remove", "mute", "kick",  "save",   "physics", "select", "look", "ack"};

/// Reads the members of one object; the first fault sticks. Done with nothing left over.
class Members {
 public:
  explicit Members(const json::object& object) : object_(object) {}

  std::string_view word(std::string_view key) {
    const json::value* value = find(key);
    if (value && value->is_string()) return value->get_string();
    fault(in_quotes(key) + " must be a string");
    return {};
  }

  double number(std::string_view key, double least, double most) {
    const json::value* value = find(key);
    const double number = value && value->is_number() ? value->to_number<double>() : std::nan("");
    if (number >= least && number <= most) return number;
    fault(in_quotes(key) + " must be a number within its range");
    return 0;
  }

  std::uint32_t count(std::string_view key) { return static_cast<std::uint32_t>(whole(key, 4294967294.0)); }

  std::uint32_t count_or_none(std::string_view key) { return object_.contains(key) ? count(key) : 0; }

  std::uint64_t tick(std::string_view key) { return static_cast<std::uint64_t>(whole(key, kTickMost)); }

  world::ModelId model(std::string_view key) { return {count(key)}; }

  std::optional<world::ModelId> model_or_null(std::string_view key) {
    const json::value* value = object_.if_contains(key);
    if (!value || !value->is_null()) return model(key);
    ++read_;
    return std::nullopt;
  }

  bool truth(std::string_view key) {
    const json::value* value = find(key);
    if (value && value->is_bool()) return value->get_bool();
    fault(in_quotes(key) + " must be true or false");
    return false;
  }

  void fault(std::string text) {
    if (fault_.empty()) fault_ = std::move(text);
  }

  Result<Command> finish(Command command) {
    if (fault_.empty() && read_ != object_.size()) fault("a key that \"do\" has no use for");
    if (!fault_.empty()) return Error{"", fault_};
    return command;
  }

 private:
  double whole(std::string_view key, double most) {
    const double value = number(key, 0, most);
    if (value != std::floor(value)) fault(in_quotes(key) + " must be a whole number");
    return value;
  }

  const json::value* find(std::string_view key) {
    const json::value* value = object_.if_contains(key);
    if (value) ++read_;
    return value;
  }

  const json::object& object_;
  std::size_t read_ = 0;
  std::string fault_;
};

/// What a person may be called: a word that names of models and clients can have.
bool is_name(std::string_view name) {
  const auto is_letter = [](unsigned char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; };
  const auto fits = [&](unsigned char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_';
  };
  return !name.empty() && name.size() <= limits::kPersonNameBytes &&
         is_letter(static_cast<unsigned char>(name[0])) && std::ranges::all_of(name, fits);
}

/// The place of a Drag, Copy, Add or Join.
template <typename Placed>
void place(Members& in, Placed& placed) {
  placed.x = in.number("x", -kPlaceMost, kPlaceMost);
  placed.y = in.number("y", -kPlaceMost, kPlaceMost);
  placed.a = in.number("a", -kPlaceMost, kPlaceMost);
}

Drag drag(Members& in) {
  Drag drag;
  drag.model = in.model("model");
  place(in, drag);
  return drag;
}

Copy copy(Members& in) {
  Copy copy;
  copy.model = in.model("model");
  place(in, copy);
  return copy;
}

Add add(Members& in) {
  Add add;
  add.robot = in.count("robot");
  place(in, add);
  return add;
}

Join join(Members& in) {
  Join join;
  join.name = in.word("name");
  if (!is_name(join.name))
    in.fault("\"name\" must be 1 to 24 letters, digits, - and _, the first one a letter");
  place(in, join);
  return join;
}

Drive drive(Members& in) {
  Drive drive;
  drive.model = in.model("model");
  drive.velocity.x = in.number("forward", -kDriveMost, kDriveMost);
  drive.velocity.y = in.number("sideways", -kDriveMost, kDriveMost);
  drive.velocity.a = in.number("turn", -kDriveMost, kDriveMost);
  drive.input = in.count_or_none("input");
  return drive;
}

Mute mute(Members& in) {
  Mute mute;
  mute.viewer = in.count("viewer");
  mute.on = in.truth("on");
  return mute;
}

Look look(Members& in) {
  Look look;
  look.view.x_min = in.number("x_min", -kPlaceMost, kPlaceMost);
  look.view.y_min = in.number("y_min", -kPlaceMost, kPlaceMost);
  look.view.x_max = in.number("x_max", -kPlaceMost, kPlaceMost);
  look.view.y_max = in.number("y_max", -kPlaceMost, kPlaceMost);
  look.sensors = in.truth("sensors");
  return look;
}

Result<Command> read(const json::object& object) {
  Members in(object);
  const std::string_view what = in.word("do");
  if (what == "pause") return in.finish(Pause{});
  if (what == "resume") return in.finish(Resume{});
  if (what == "step") return in.finish(Step{});
  if (what == "speed") return in.finish(SetSpeed{in.number("times_real_time", 0, kSpeedMost)});
  if (what == "rewind") return in.finish(Rewind{in.tick("tick")});
  if (what == "drag") return in.finish(drag(in));
  if (what == "drive") return in.finish(drive(in));
  if (what == "copy") return in.finish(copy(in));
  if (what == "add") return in.finish(add(in));
  if (what == "join") return in.finish(join(in));
  if (what == "say") return in.finish(Say{std::string(in.word("text"))});
  if (what == "remove") return in.finish(Remove{in.model("model")});
  if (what == "mute") return in.finish(mute(in));
  if (what == "kick") return in.finish(Kick{in.count("viewer")});
  if (what == "save") return in.finish(Save{});
  if (what == "physics") return in.finish(ShowPhysics{});
  if (what == "select") return in.finish(Select{in.model_or_null("model")});
  if (what == "look") return in.finish(look(in));
  if (what == "ack") return in.finish(Acknowledge{in.count("frame")});
  in.fault("no such command" + did_you_mean(what, kWords));
  return in.finish(Pause{});
}

}  // namespace

Result<Command> parse_command(std::string_view text) {
  if (text.size() > limits::kViewerCommandBytes)
    return Error{"", fmt::format("a command of more than {} bytes", limits::kViewerCommandBytes)};
  json::parse_options options;
  options.max_depth = 2;
  json::error_code error;
  const json::value value = json::parse(text, error, {}, options);
  if (error) return Error{"", "not JSON: " + error.message()};
  if (!value.is_object()) return Error{"", "a command is a JSON object"};
  return read(value.get_object());
}

}  // namespace playhouse::replicate
