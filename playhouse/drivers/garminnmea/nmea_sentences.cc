#include "playhouse/drivers/garminnmea/nmea_sentences.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>

namespace playhouse::drivers::nmea {
namespace {

constexpr std::size_t kLongest = 200;  // letters; the standard has 82, of which receivers make more
constexpr std::int64_t kTenMillionths = 10'000'000;  // of a degree
constexpr int kFirstOf1900 = 80;                     // years without their century, from this on

bool is_digit(char letter) {
  return letter >= '0' && letter <= '9';
}

/// Without a field that is empty it is good, and has no value.
template <typename T>
struct ReadField {
  bool is_good = true;
  std::optional<T> value;
};

std::string_view field(const NmeaFields& fields, std::size_t number) {
  return number < fields.size() ? std::string_view(fields[number]) : std::string_view();
}

ReadField<double> number(const NmeaFields& fields, std::size_t at) {
  const std::string_view text = field(fields, at);
  if (text.empty()) return {};
  constexpr double kMost = 1e8;
  double value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != text.data() + text.size() || !(std::fabs(value) < kMost))
    return {false, {}};
  return {true, value};
}

/// Of `digits` digits from a place on; none if there are not so many.
std::optional<int> digits(std::string_view text, std::size_t at, std::size_t count) {
  if (text.size() < at + count || !std::ranges::all_of(text.substr(at, count), is_digit)) return std::nullopt;
  int value = 0;
  for (const char letter : text.substr(at, count)) value = 10 * value + (letter - '0');
  return value;
}

/// hhmmss, and a fraction.
ReadField<DayTime> time(const NmeaFields& fields, std::size_t at) {
  const std::string_view text = field(fields, at);
  if (text.empty()) return {};
  const auto hours = digits(text, 0, 2), minutes = digits(text, 2, 2), seconds = digits(text, 4, 2);
  if (!hours || !minutes || !seconds || *hours > 23 || *minutes > 59 || *seconds > 60) return {false, {}};
  std::int64_t micros = 0, unit = 100'000;
  if (text.size() > 6 && text[6] != '.') return {false, {}};
  for (const char letter : text.substr(std::min<std::size_t>(7, text.size()))) {
    if (!is_digit(letter)) return {false, {}};
    micros += (letter - '0') * unit;
    unit /= 10;
  }
  return {true, ((*hours * 60 + *minutes) * 60 + *seconds) * 1'000'000LL + micros};
}

std::optional<DayStart> day(int year, int month, int day_of_month) {
  using namespace std::chrono;
  const year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                            std::chrono::day(static_cast<unsigned>(day_of_month))};
  if (!date.ok()) return std::nullopt;
  return sys_days(date).time_since_epoch().count() * kDay;
}

/// ddmmyy
ReadField<DayStart> date(const NmeaFields& fields, std::size_t at) {
  const std::string_view text = field(fields, at);
  if (text.empty()) return {};
  const auto day_of_month = digits(text, 0, 2), month = digits(text, 2, 2), year = digits(text, 4, 2);
  if (!day_of_month || !month || !year || text.size() != 6) return {false, {}};
  const auto start = day(*year + (*year >= kFirstOf1900 ? 1900 : 2000), *month, *day_of_month);
  return {start.has_value(), start};
}

/// ddmm.mmm or dddmm.mmm, and a letter for the direction.  [1e-7 deg]
ReadField<std::int32_t> angle(const NmeaFields& fields, std::size_t at, std::size_t degree_digits,
                              std::string_view letters, int most) {
  const std::string_view text = field(fields, at), side = field(fields, at + 1);
  if (text.empty()) return {};
  const auto degrees = digits(text, 0, degree_digits);
  const ReadField<double> minutes =
      number({std::string(text.substr(std::min(degree_digits, text.size())))}, 0);
  if (!degrees || !minutes.value || !(*minutes.value >= 0 && *minutes.value < 60)) return {false, {}};
  if (side.size() != 1 || letters.find(side) == std::string_view::npos) return {false, {}};
  const std::int64_t value = *degrees * kTenMillionths + std::llround(*minutes.value / 60 * kTenMillionths);
  if (value > most * kTenMillionths) return {false, {}};
  return {true, static_cast<std::int32_t>(side[0] == letters[0] ? value : -value)};
}

ReadField<NmeaPlace> place(const NmeaFields& fields, std::size_t at) {
  const auto latitude = angle(fields, at, 2, "NS", 90), longitude = angle(fields, at + 2, 3, "EW", 180);
  if (!latitude.is_good || !longitude.is_good) return {false, {}};
  if (!latitude.value || !longitude.value) return {};
  return {true, NmeaPlace{*latitude.value, *longitude.value}};
}

/// With the digits of its fraction that are not zero, two at least.
std::string time_text(const std::optional<DayTime>& time) {
  if (!time) return "";
  const std::int64_t seconds = *time / 1'000'000;
  std::string text = fmt::format("{:02}{:02}{:02}.{:06}", seconds / 3600, seconds / 60 % 60, seconds % 60,
                                 *time % 1'000'000);
  constexpr std::size_t kShortest = 9;
  while (text.size() > kShortest && text.back() == '0') text.pop_back();
  return text;
}

std::string date_text(const std::optional<DayStart>& date) {
  if (!date) return "";
  using namespace std::chrono;
  const year_month_day civil{sys_days(days(*date / kDay))};
  return fmt::format("{:02}{:02}{:02}", static_cast<unsigned>(civil.day()),
                     static_cast<unsigned>(civil.month()), static_cast<int>(civil.year()) % 100);
}

/// In minutes of six decimals, which are finer than what is told.
std::string angle_text(std::int32_t angle, int degree_digits, std::string_view letters) {
  const std::int64_t value = std::abs(static_cast<std::int64_t>(angle));
  const std::int64_t millionths = value % kTenMillionths * 6;  // of a minute
  return fmt::format("{:0{}}{:02}.{:06},{}", value / kTenMillionths, degree_digits, millionths / 1'000'000,
                     millionths % 1'000'000, letters[angle < 0 ? 1 : 0]);
}

std::string place_text(const std::optional<NmeaPlace>& place) {
  if (!place) return ",,,";
  return angle_text(place->latitude, 2, "NS") + "," + angle_text(place->longitude, 3, "EW");
}

std::string number_text(const std::optional<double>& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "";
}

}  // namespace

std::uint8_t sum_of(std::string_view text) {
  unsigned sum = 0;
  for (const char letter : text) sum ^= static_cast<unsigned char>(letter);
  return static_cast<std::uint8_t>(sum);
}

std::string sentence_of(std::string_view text) {
  return fmt::format("${}*{:02X}\r\n", text, sum_of(text));
}

std::string_view type_of(const NmeaFields& fields) {
  constexpr std::size_t kTalker = 2, kLetters = 5;
  const std::string_view first = field(fields, 0);
  if (first.starts_with('P')) return first;
  return first.size() == kLetters ? first.substr(kTalker) : std::string_view();
}

void SentenceReader::add(std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) text_.push_back(static_cast<char>(byte));
}

std::optional<NmeaFields> SentenceReader::next() {
  while (true) {
    text_.erase(0, std::min(text_.find('$'), text_.size()));
    const std::size_t end = text_.find_first_of("\r\n$", 1);
    if (end == std::string::npos) {
      if (text_.size() > kLongest) text_.clear();
      return std::nullopt;
    }
    const std::string line = text_.substr(1, std::max<std::size_t>(end, 1) - 1);
    text_.erase(0, end);
    const std::size_t star = line.find('*');
    if (star == std::string::npos || line.size() != star + 3 || line.size() > kLongest) continue;
    unsigned told = 0;
    const auto [rest, error] = std::from_chars(line.data() + star + 1, line.data() + line.size(), told, 16);
    const std::string_view text = std::string_view(line).substr(0, star);
    if (error != std::errc() || rest != line.data() + line.size() || told != sum_of(text)) continue;
    NmeaFields fields(1);
    for (const char letter : text)
      if (letter == ',')
        fields.emplace_back();
      else
        fields.back().push_back(letter);
    return fields;
  }
}

std::optional<Gga> read_gga(const NmeaFields& fields) {
  const auto when = time(fields, 1);
  const auto where = place(fields, 2);
  const auto quality = number(fields, 6), satellites = number(fields, 7), hdop = number(fields, 8),
             altitude = number(fields, 9), geoid = number(fields, 11);
  const auto is_count = [](const ReadField<double>& read) {
    return read.is_good && read.value.value_or(0) >= 0 && read.value.value_or(0) < 1000;
  };
  if (!when.is_good || !where.is_good || !is_count(quality) || !is_count(satellites) || !is_count(hdop) ||
      !altitude.is_good || !geoid.is_good)
    return std::nullopt;
  return Gga{when.value,
             where.value,
             static_cast<int>(quality.value.value_or(0)),
             static_cast<int>(satellites.value.value_or(0)),
             hdop.value,
             altitude.value,
             geoid.value};
}

std::optional<Rmc> read_rmc(const NmeaFields& fields) {
  const auto when = time(fields, 1);
  const auto where = place(fields, 3);
  const auto knots = number(fields, 7), course = number(fields, 8);
  const auto today = date(fields, 9);
  if (!when.is_good || !where.is_good || !knots.is_good || !course.is_good || !today.is_good)
    return std::nullopt;
  Rmc rmc{when.value, today.value, field(fields, 2) == "A", where.value, knots.value, course.value};
  if (rmc.speed) *rmc.speed *= kKnot;
  return rmc;
}

std::optional<NmeaDate> read_zda(const NmeaFields& fields) {
  const ReadField<DayTime> when = time(fields, 1);
  const auto day_of_month = digits(field(fields, 2), 0, 2), month = digits(field(fields, 3), 0, 2),
             year = digits(field(fields, 4), 0, 4);
  if (!when.value || !day_of_month || !month || !year) return std::nullopt;
  const std::optional<DayStart> start = day(*year, *month, *day_of_month);
  return start ? std::optional(NmeaDate{*when.value, *start}) : std::nullopt;
}

std::optional<NmeaErrors> read_gst(const NmeaFields& fields) {
  const auto north = number(fields, 6), east = number(fields, 7), up = number(fields, 8);
  if (!north.value || !east.value || !up.is_good) return std::nullopt;
  return NmeaErrors{std::hypot(*north.value, *east.value), up.value};
}

std::optional<NmeaErrors> read_pgrme(const NmeaFields& fields) {
  const auto horizontal = number(fields, 1), vertical = number(fields, 3);
  if (!horizontal.is_good || !vertical.is_good) return std::nullopt;
  return NmeaErrors{horizontal.value, vertical.value};
}

std::optional<Dilutions> read_gsa(const NmeaFields& fields) {
  const auto position = number(fields, 15), horizontal = number(fields, 16), vertical = number(fields, 17);
  if (!position.is_good || !horizontal.is_good || !vertical.is_good) return std::nullopt;
  return Dilutions{position.value, horizontal.value, vertical.value};
}

std::string encode_gga(std::string_view talker, const Gga& gga) {
  return sentence_of(fmt::format("{}GGA,{},{},{},{:02},{},{},{},{},{},,", talker, time_text(gga.time),
                                 place_text(gga.place), gga.quality, gga.satellites, number_text(gga.hdop, 1),
                                 number_text(gga.altitude, 3), gga.altitude ? "M" : "",
                                 number_text(gga.geoid, 1), gga.geoid ? "M" : ""));
}

std::string encode_rmc(std::string_view talker, const Rmc& rmc) {
  std::optional<double> knots = rmc.speed;
  if (knots) *knots /= kKnot;
  return sentence_of(fmt::format("{}RMC,{},{},{},{},{},{},,,{}", talker, time_text(rmc.time),
                                 rmc.is_valid ? 'A' : 'V', place_text(rmc.place), number_text(knots, 3),
                                 number_text(rmc.course, 2), date_text(rmc.date), rmc.is_valid ? 'A' : 'N'));
}

std::string encode_gsa(std::string_view talker, int satellites, const Dilutions& dilutions) {
  constexpr int kPlaces = 12;
  std::string text = fmt::format("{}GSA,A,{}", talker, dilutions.position ? 3 : 1);
  for (int number = 1; number <= kPlaces; ++number)
    text += number <= satellites ? fmt::format(",{:02}", number) : ",";
  return sentence_of(fmt::format("{},{},{},{}", text, number_text(dilutions.position, 1),
                                 number_text(dilutions.horizontal, 1), number_text(dilutions.vertical, 1)));
}

std::string encode_pgrme(const NmeaErrors& errors) {
  const double horizontal = errors.horizontal.value_or(0), vertical = errors.vertical.value_or(0);
  return sentence_of(fmt::format("PGRME,{:.3f},M,{:.3f},M,{:.3f},M", horizontal, vertical,
                                 std::hypot(horizontal, vertical)));
}

}  // namespace playhouse::drivers::nmea
