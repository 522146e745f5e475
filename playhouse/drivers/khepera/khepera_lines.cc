#include "playhouse/drivers/khepera/khepera_lines.h"

#include <algorithm>
#include <charconv>

namespace playhouse::drivers::khepera {
namespace {

constexpr std::size_t kLongestLine = 200;

/// Of white paper, from near to far.
struct LightPoint {
  double range;  // mm
  double light;
};
constexpr LightPoint kCurve[] = {{8, 1023}, {10, 1000}, {20, 450}, {30, 275}, {40, 190}, {50, 150},
                                 {60, 125}, {70, 110},  {80, 100}, {90, 90},  {100, 80}};

constexpr std::array<KheperaSensor, kSensors> kPlaces = {{{10, 24, 90},
                                                          {19, 17, 45},
                                                          {25, 6, 0},
                                                          {25, -6, 0},
                                                          {19, -17, -45},
                                                          {10, -24, -90},
                                                          {-24, -10, 180},
                                                          {-24, 10, 180}}};

std::string text_of(char letter, std::initializer_list<std::int64_t> numbers) {
  std::string text(1, letter);
  for (const std::int64_t number : numbers) text += "," + std::to_string(number);
  return text;
}

/// Letter 0 if a field is no number.
KheperaLine read_line(std::string_view text) {
  KheperaLine line{text[0], {}};
  text.remove_prefix(1);
  while (!text.empty()) {
    if (text[0] != ',') return {};
    text.remove_prefix(1);
    std::int32_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return {};
    line.numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  return line;
}

}  // namespace

std::string encode_line(char letter, std::initializer_list<std::int64_t> numbers) {
  return text_of(letter, numbers) + "\n";
}

std::string encode_answer(char letter, std::initializer_list<std::int64_t> numbers) {
  return text_of(letter, numbers) + "\r\n";
}

void KheperaReader::add(std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) text_.push_back(static_cast<char>(byte));
}

std::optional<KheperaLine> KheperaReader::next() {
  text_.erase(0, std::min(text_.find_first_not_of("\r\n"), text_.size()));
  const std::size_t end = text_.find_first_of("\r\n");
  if (end == std::string::npos) {
    if (text_.size() > kLongestLine) text_.clear();
    return std::nullopt;
  }
  const KheperaLine line =
      end > kLongestLine ? KheperaLine{} : read_line(std::string_view(text_).substr(0, end));
  text_.erase(0, end);
  return line;
}

int light_at(double range) {
  const double millimetres = 1000 * range;
  if (!(millimetres <= kCurve[std::size(kCurve) - 1].range)) return 0;
  const auto* const next =
      std::ranges::find_if(kCurve, [&](const LightPoint& point) { return millimetres <= point.range; });
  if (next == kCurve) return kMostLight;
  const LightPoint &a = next[-1], &b = next[0];
  return static_cast<int>(a.light + (b.light - a.light) * (millimetres - a.range) / (b.range - a.range));
}

double range_of(double light) {
  const auto* const next =
      std::ranges::find_if(kCurve, [&](const LightPoint& point) { return light >= point.light; });
  if (next == std::end(kCurve)) return kCurve[std::size(kCurve) - 1].range / 1000;
  if (next == kCurve) return kCurve[0].range / 1000;
  const LightPoint &a = next[-1], &b = next[0];
  return (a.range + (b.range - a.range) * (light - a.light) / (b.light - a.light)) / 1000;
}

std::span<const KheperaSensor, kSensors> sensors() {
  return kPlaces;
}

}  // namespace playhouse::drivers::khepera
