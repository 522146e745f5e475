#pragma once

/// Strict parsing of a command's members (generated/read_commands.cc).

#include <fmt/format.h>

#include <boost/json.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/result.h"
#include "playhouse/replicate/generated/commands.h"
#include "playhouse/replicate/generated/person_name.h"

namespace playhouse::replicate {

inline constexpr double kWholeMost = 9007199254740992.0;  // whole numbers are exact up to here

/// Reads the members of one object; the first error sticks. finish() rejects unread members.
class Members {
 public:
  explicit Members(const boost::json::object& object) : object_(object) {}

  std::string_view word(std::string_view key) {
    const boost::json::value* value = find(key);
    if (value && value->is_string()) return value->get_string();
    fault(in_quotes(key) + " must be a string");
    return {};
  }

  std::string text(std::string_view key) { return std::string(word(key)); }

  std::string person(std::string_view key) {
    std::string name = text(key);
    if (!is_person_name(name)) fault(fmt::format("{} must be {}", in_quotes(key), kPersonNameRule));
    return name;
  }

  double within(std::string_view key, double most) { return number(key, -most, most); }
  double up_to(std::string_view key, double most) { return number(key, 0, most); }

  std::uint32_t count(std::string_view key) { return static_cast<std::uint32_t>(whole(key, 4294967294.0)); }

  std::uint32_t count_or_none(std::string_view key) { return object_.contains(key) ? count(key) : 0; }

  std::uint64_t tick(std::string_view key) { return static_cast<std::uint64_t>(whole(key, kWholeMost)); }

  world::ModelId model(std::string_view key) { return {count(key)}; }

  std::optional<world::ModelId> model_or_null(std::string_view key) {
    const boost::json::value* value = object_.if_contains(key);
    if (!value || !value->is_null()) return model(key);
    ++read_;
    return std::nullopt;
  }

  bool truth(std::string_view key) {
    const boost::json::value* value = find(key);
    if (value && value->is_bool()) return value->get_bool();
    fault(in_quotes(key) + " must be true or false");
    return false;
  }

  void fault(std::string text) {
    if (fault_.empty()) fault_ = std::move(text);
  }

  Result<Command> finish(Command command) {
    if (fault_.empty() && read_ != object_.size()) fault("\"do\" has an unknown key");
    if (!fault_.empty()) return Error{"", fault_};
    return command;
  }

 private:
  double number(std::string_view key, double least, double most) {
    const boost::json::value* value = find(key);
    const double number = value && value->is_number() ? value->to_number<double>() : std::nan("");
    if (number >= least && number <= most) return number;
    fault(in_quotes(key) + " must be a number within its range");
    return 0;
  }

  double whole(std::string_view key, double most) {
    const double value = number(key, 0, most);
    if (value != std::floor(value)) fault(in_quotes(key) + " must be a whole number");
    return value;
  }

  const boost::json::value* find(std::string_view key) {
    const boost::json::value* value = object_.if_contains(key);
    if (value) ++read_;
    return value;
  }

  const boost::json::object& object_;
  std::size_t read_ = 0;
  std::string fault_;
};

/// Dispatches on "do"; errors are kept in `in`.
Command read_command(Members& in);

}  // namespace playhouse::replicate
