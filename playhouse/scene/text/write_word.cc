#include "playhouse/scene/text/write_word.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "playhouse/base/assert.h"
#include "playhouse/scene/forms/colors.h"

namespace playhouse::scene {
namespace {

constexpr int kDigits = 17;     // identify any double
constexpr int kShort = 15;      // likely typed by a person
constexpr int kNeighbours = 3;  // on each side, that may read back exactly if the nearest does not

/// `value` rounded to so many digits.
double rounded(double value, int digits) {
  std::array<char, 32> text;
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1);
  double result = 0;
  std::from_chars(text.data(), end, result);
  return result;
}

/// The shortest number, `least` to `most` digits, near `guess` that reads back as `wanted`.
template <typename Read>
std::optional<double> exact_number(double wanted, double guess, const Read& read, int least = 1,
                                   int most = kDigits) {
  for (int digits = least; digits <= most; ++digits)
    if (const double number = rounded(guess, digits); read(number) == wanted) return number;
  if (most < kDigits) return std::nullopt;
  double below = guess, above = guess;
  for (int step = 0; step < kNeighbours; ++step) {
    below = std::nextafter(below, -HUGE_VAL);
    above = std::nextafter(above, HUGE_VAL);
    if (read(below) == wanted) return below;
    if (read(above) == wanted) return above;
  }
  return std::nullopt;
}

/// The same, or else the guess.
template <typename Read>
double number_for(double wanted, double guess, const Read& read) {
  return exact_number(wanted, guess, read).value_or(guess);
}

double number_for_scaled(double wanted, double unit) {
  if (unit == 1) return wanted;
  return number_for(wanted, wanted / unit, [unit](double number) { return number * unit; });
}

std::string float_text(float value) {
  return number_text(number_for(
      value, value, [](double number) { return static_cast<double>(static_cast<float>(number)); }));
}

}  // namespace

std::string number_text(double value) {
  PLAYHOUSE_ASSERT(std::isfinite(value));
  if (value == 0) return "0";  // -0 reads back the same
  std::array<char, 512> text;
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  return {text.data(), end};
}

std::string quoted_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? '\'' : c == '\n' || c == '\r' ? ' ' : c;
  return quoted + '"';
}

std::string in_brackets(std::span<const std::string> values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "[" : " ") + value;
  return text + "]";
}

void Words::add(std::string_view key, const std::string& value) {
  to_.push_back(std::string(key) + " " + value);
}

std::string Words::scaled(double value, char scale) const {
  switch (scale) {
    case 'L':
      return number_text(number_for_scaled(value, units_.length));
    case 'A':
      return number_text(number_for_scaled(value, units_.angle));
    case 'D':
      return number_text(
          number_for(value, geom::degrees(value), [](double number) { return geom::radians(number); }));
    case 'M':
      return number_text(
          number_for(value, value * 1000, [](double number) { return std::round(number * 1000) / 1e6; }));
    default:
      return number_text(value);
  }
}

void Words::integer(std::string_view key, std::int64_t value) {
  add(key, std::to_string(value));
}

void Words::texts(std::string_view key, std::span<const std::string> values) {
  std::vector<std::string> quoted;
  for (const std::string& value : values) quoted.push_back(quoted_text(value));
  add(key, quoted.size() == 1 ? quoted.front() : in_brackets(quoted));
}

void Words::color(const Color& value) {
  if (const std::string name = color_name(value); !name.empty()) return text("color", name);
  add("color_rgba", in_brackets(std::array{float_text(value.r), float_text(value.g), float_text(value.b),
                                           float_text(value.a)}));
}

void Words::colors(std::string_view key, std::span<const Color> values) {
  std::vector<std::string> names;
  for (const Color& value : values) {
    const std::string name = color_name(value);
    names.push_back(quoted_text(name.empty() ? color_name(value, true) : name));
  }
  add(key, in_brackets(names));
}

void Words::pose(std::string_view key, const geom::Pose& value, double z) {
  const double height = number_for(value.z, (value.z - z) / units_.length,
                                   [&](double number) { return number * units_.length + z; });
  add(key, in_brackets(std::array{scaled(value.x, 'L'), scaled(value.y, 'L'), number_text(height),
                                  number_text(heading(value.a))}));
}

/// Users may write headings with an extra turn: that form
/// is chosen if it is much shorter, or the only exact one.
double Words::heading(double value) const {
  const double near = value / units_.angle, turn = 2 * geom::kPi / units_.angle;
  const double far = value < 0 ? near + turn : near - turn;
  const auto read = [this](double number) { return geom::normalize(number * units_.angle); };
  for (int digits = 1; digits <= kShort; ++digits)
    for (const double guess : {near, far})
      if (const auto number = exact_number(value, guess, read, digits, digits)) return *number;
  for (const double guess : {near, far})
    if (const auto number = exact_number(value, guess, read, kShort + 1)) return *number;
  return near;
}

void Words::size(std::string_view key, const geom::Size& value) {
  tuple(key, "LLL", std::array{value.x, value.y, value.z});
}

void Words::point(std::string_view key, geom::Vec2 value) {
  tuple(key, "NN", std::array{value.x, value.y});
}

void Words::twist(std::string_view key, std::string_view scales, const geom::Twist& value) {
  tuple(key, scales, std::array{value.x, value.y, value.z, value.a});
}

void Words::bounds(std::string_view key, std::string_view scales, std::span<const Interval> values) {
  std::vector<double> numbers;
  for (const Interval& axis : values) numbers.insert(numbers.end(), {axis.min, axis.max});
  tuple(key, scales, numbers);
}

void Words::tuple(std::string_view key, std::string_view scales, std::span<const double> values) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < values.size(); ++i) numbers.push_back(scaled(values[i], scales[i]));
  add(key, in_brackets(numbers));
}

}  // namespace playhouse::scene
