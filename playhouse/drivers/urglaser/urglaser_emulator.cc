#include "playhouse/drivers/urglaser/urglaser_emulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/drivers/hardware/scanner_driver.h"

namespace playhouse::drivers {
namespace {

constexpr int kRs232Baud = 19200;
constexpr std::string_view kScip2 = "SCIP2.0";
constexpr int kClockCharacters = 4, kClockMask = 0xFFFFFF;  // ms
constexpr int kMostOfTwoCharacters = 4095;
constexpr std::size_t kLongestString = 16;

constexpr DeviceText kUrglaserUses[] = {{"laser", {}, HowMany::kOne, "what it sees"}};

UrglaserEmulatorOptions urglaser_emulator_options(SectionFields& fields) {
  UrglaserEmulatorOptions options;
  const int baud = fields.integer({"baud",
                                   "Of an RS-232 line, at which it begins; hosts set another. 0: it is a USB "
                                   "port, at which every speed does.",
                                   "baud"},
                                  0, 0, 750000);
  options.place = read_emulator_place(fields, {.baud = baud == 0 ? kRs232Baud : baud});
  options.place.at_any_speed = baud == 0;
  std::string name = fields.text(
      {"model", "Which it is: URG-04LX, UTM-30LX, UST-10LX, UST-20LX or UXM-30LX-EW.", {}, "URG-04LX"});
  if (name.empty()) name = "URG-04LX";
  options.model = scip::scip_models().data();
  const auto found = std::ranges::find(scip::scip_models(), name, &scip::ScipModel::name);
  fields.expect(found != scip::scip_models().end(), "model",
                "is URG-04LX, UTM-30LX, UST-10LX, UST-20LX or UXM-30LX-EW, not " + in_quotes(name));
  if (found != scip::scip_models().end()) options.model = &*found;
  options.serial_number =
      fields.text({"serial_number", "That it tells: a letter and digits.", {}, "H0000001"});
  if (options.serial_number.empty()) options.serial_number = "H0000001";
  options.begins_in_scip1 =
      fields.flag({"scip1", "1: it speaks SCIP 1.1 until it is told SCIP2.0, as old ones do."}, false);
  return options;
}

bool are_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char each) { return each >= '0' && each <= '9'; });
}

int number_said(std::string_view digits) {
  int number = 0;
  for (const char digit : digits) number = 10 * number + (digit - '0');
  return number;
}

/// Without the string that hosts may add behind a semicolon.
std::string without_string(const std::string& line) {
  return line.substr(0, line.find(';'));
}

}  // namespace

UrglaserEmulator::UrglaserEmulator(std::string name, Site& site, const UrglaserEmulatorOptions& options,
                                   UsedDevices used)
    : Emulator(std::move(name), site, options.place, std::move(used)),
      options_(options),
      model_(*options.model),
      baud_(options.place.serial.baud),
      is_scip1_(options.begins_in_scip1),
      zero_(now()) {}

void UrglaserEmulator::line_received(std::span<const std::byte> bytes) {
  lines_.add(bytes);
  while (const std::optional<std::string> line = lines_.next()) is_scip1_ ? take_scip1(*line) : take(*line);
}

void UrglaserEmulator::answer(const std::string& line, std::string_view status,
                              const std::vector<std::string>& lines) {
  send(scip::encode_reply(line, status, lines, !is_scip1_));
}

// --- SCIP 2.0

void UrglaserEmulator::take(const std::string& line) {
  const std::string text = without_string(line);
  const bool has_string = text.size() < line.size();
  if (has_string && line.size() - text.size() - 1 > kLongestString) return answer(line, "0G");
  if (text == "VV") return answer(line, "00", version(true));
  if (text == "PP") return answer(line, "00", scip::parameter_lines(model_));
  if (text == "II") return answer(line, "00", state());
  if (text == "%ST") return answer(line, "00", scip::data_lines(state_number(), true));
  if (text == "BM") return switch_laser(line);
  if (text == "QT") return end_scans(line, false);
  if (text == "RS" || text == "RT") return end_scans(line, true);
  if (text.starts_with("TM")) return tell_time(line);
  if (text.starts_with("SS")) return set_speed(line, text.substr(2));
  if (text.starts_with("CR") || text.starts_with("HS")) return answer(line, text.size() > 2 ? "00" : "0C");
  for (const std::string_view code : {"GD", "GS", "GE", "MD", "MS", "ME"})
    if (text.starts_with(code)) return order(line, text);
  answer(line, "0E");
}

void UrglaserEmulator::switch_laser(const std::string& line) {
  answer(line, std::exchange(laser_on_, true) ? "02" : "00");
}

void UrglaserEmulator::end_scans(const std::string& line, bool resets) {
  always_.reset();
  once_.reset();
  laser_on_ = false;
  if (resets) zero_ = now();
  answer(line, "00");
}

std::string UrglaserEmulator::clock() const {
  const auto milliseconds = static_cast<long long>(1000 * (now() - zero_));
  return scip::encode_number(static_cast<int>(milliseconds & kClockMask), kClockCharacters);
}

void UrglaserEmulator::tell_time(const std::string& line) {
  const std::string text = without_string(line);
  if (text == "TM0") return answer(line, std::exchange(tells_time_, true) ? "02" : "00");
  if (text == "TM2") return answer(line, std::exchange(tells_time_, false) ? "00" : "03");
  if (text != "TM1") return answer(line, "01");
  if (!tells_time_) return answer(line, "04");
  answer(line, "00", scip::data_lines(clock(), true));
}

/// The answer goes out at the speed before.
void UrglaserEmulator::set_speed(const std::string& line, const std::string& digits) {
  constexpr int kSpeeds[] = {19200, 38400, 57600, 115200, 250000, 500000, 750000};
  constexpr std::size_t kDigits = 6;
  if (place().link.empty()) return answer(line, "0F");
  if (place().at_any_speed) return answer(line, "04");
  if (digits.size() != kDigits || !are_digits(digits)) return answer(line, "01");
  const int baud = number_said(digits);
  if (std::ranges::find(kSpeeds, baud) == std::end(kSpeeds)) return answer(line, "02");
  if (baud == baud_) return answer(line, "03");
  answer(line, "00");
  baud_ = baud;
  net::SerialSettings serial = place().serial;
  serial.baud = baud;
  speak(serial);
}

/// The status of what cannot be carried out; empty: it can.
std::string UrglaserEmulator::fault_of(const std::string& text) const {
  constexpr std::size_t kFirst = 2, kLast = 6, kCluster = 10, kSkipped = 12, kCount = 13;
  const bool is_continuous = text.starts_with('M');
  if (text.size() != (is_continuous ? kCount + 2 : kSkipped)) return "0C";
  const auto digits = [&text](std::size_t at, std::size_t count) {
    return are_digits(std::string_view(text).substr(at, count));
  };
  if (!digits(kFirst, 4)) return "01";
  if (!digits(kLast, 4)) return "02";
  if (!digits(kCluster, 2)) return "03";
  if (is_continuous && !digits(kSkipped, 1)) return "06";
  if (is_continuous && !digits(kCount, 2)) return "07";
  const int first = number_said(text.substr(kFirst, 4)), last = number_said(text.substr(kLast, 4));
  if (last > model_.end) return "04";
  if (last < first) return "05";
  return !is_continuous && !laser_on_ ? "10" : "";
}

void UrglaserEmulator::order(const std::string& line, const std::string& text) {
  if (const std::string fault = fault_of(text); !fault.empty()) return answer(line, fault);
  ScipOrder order{.line = line, .code = text.substr(0, 2), .request = {}};
  order.request = {.first = number_said(text.substr(2, 4)),
                   .last = number_said(text.substr(6, 4)),
                   .cluster = std::max(1, number_said(text.substr(10, 2)))};
  const bool is_continuous = text.starts_with('M');
  if (is_continuous) {
    order.request.skipped = number_said(text.substr(12, 1));
    order.request.count = order.left = number_said(text.substr(13, 2));
    order.skipped = order.request.skipped;
    laser_on_ = true;
    answer(line, "00");
  }
  (is_continuous ? always_ : once_) = std::move(order);
  if (turn_ == nullptr) turn();
}

std::vector<std::string> UrglaserEmulator::version(bool has_checks) const {
  const auto line = [has_checks](std::string_view name, std::string_view value) {
    return scip::named_line(name, value, has_checks);
  };
  // Old hosts read the range and the steps of it, and that its number is 3 or more.
  const std::string firmware = fmt::format(
      "3.3.00,10/Aug/2007({}-{}[mm],{}[deg],{}-{}[step],{}[rpm])", model_.least,
      is_scip1_ ? std::min(model_.most, kMostOfTwoCharacters) : model_.most,
      360 * (model_.last - model_.first + 1) / model_.resolution, model_.first, model_.last, model_.speed);
  return {line("VEND", "Hokuyo Automatic Co.,Ltd."),
          line("PROD", fmt::format("SOKUIKI Sensor {}", model_.name)), line("FIRM", firmware),
          line("PROT", is_scip1_ ? "00003,(SCIP 1.1)" : "00003,(SCIP 2.0)"),
          line("SERI", options_.serial_number)};
}

/// Standby, time adjustment, single scans, scans without end.
std::string_view UrglaserEmulator::state_number() const {
  if (always_) return "004";
  if (laser_on_) return "003";
  return tells_time_ ? "002" : "000";
}

std::vector<std::string> UrglaserEmulator::state() const {
  const auto milliseconds = static_cast<long long>(1000 * (now() - zero_));
  const auto line = [](std::string_view name, const std::string& value) {
    return scip::named_line(name, value, true);
  };
  return {line("MODL", fmt::format("{}(Hokuyo Automatic Co.,Ltd.)", model_.name)),
          line("LASR", laser_on_ ? "ON" : "OFF"),
          line("SCSP", fmt::format("Initial({}[rpm])", model_.speed)),
          line("MESM", "Measuring by Normal Mode"),
          line("SBPS", place().link.empty()   ? std::string("Ethernet 100 [Mbps]")
                       : place().at_any_speed ? std::string("USB only")
                                              : fmt::format("{}[bps]", baud_)),
          line("TIME", fmt::format("{:06X}", milliseconds & kClockMask)),
          line("STAT", "Sensor works well.")};
}

// --- SCIP 1.1

void UrglaserEmulator::take_scip1(const std::string& line) {
  constexpr std::size_t kSpeedLine = 14;
  if (line == kScip2) {
    answer(line, "0");
    is_scip1_ = false;
  } else if (line == "V") {
    answer(line, "0", version(false));
  } else if (line == "L0" || line == "L1") {
    answer(line, "0");
  } else if (line.starts_with('S') && line.size() == kSpeedLine && are_digits(line.substr(1))) {
    answer(line, "0");
    if (place().link.empty() || place().at_any_speed) return;
    baud_ = number_said(line.substr(1, 6));
    net::SerialSettings serial = place().serial;
    serial.baud = baud_;
    speak(serial);
  } else if (line.starts_with('G')) {
    order_scip1(line);
  } else {
    answer(line, "E");
  }
}

void UrglaserEmulator::order_scip1(const std::string& line) {
  constexpr std::size_t kOrderLine = 9;
  if (line.size() != kOrderLine || !are_digits(line.substr(1))) return answer(line, "E");
  ScipOrder order{.line = line, .code = "G", .request = {}};
  order.request = {.first = number_said(line.substr(1, 3)),
                   .last = number_said(line.substr(4, 3)),
                   .cluster = std::max(1, number_said(line.substr(7, 2)))};
  if (order.request.last > model_.end || order.request.last < order.request.first) return answer(line, "E");
  once_ = std::move(order);
  if (turn_ == nullptr) turn();
}

// --- scans

/// It begins to measure when its laser has seen something.
void UrglaserEmulator::turn() {
  turn_ = after(60.0 / model_.speed, [this] {
    seen_ = beams_.value();
    if (!seen_.ranges.empty()) {
      if (std::optional<ScipOrder> order = std::exchange(once_, std::nullopt)) carry_out(*order);
      if (always_ && now() >= is_sent_) carry_out(*always_);
    }
    if (!once_ && !always_) return turn_.reset();
    turn();
  });
}

void UrglaserEmulator::carry_out(ScipOrder& order) {
  if (order.code == "G") return send_scan(scip::encode_reply(order.line, "0", scan(order, 2, false), false));
  const int characters = order.code[1] == 'S' ? 2 : 3;
  if (order.code.starts_with('G'))
    return send_scan(scip::encode_reply(order.line, "00", scan(order, characters, true), true));
  if (order.skipped++ < order.request.skipped) return;
  order.skipped = 0;
  if (order.request.count > 0) --order.left;
  constexpr std::size_t kCount = 13;
  std::string echo = order.line;
  echo.replace(kCount, 2, fmt::format("{:02}", order.left));
  send_scan(scip::encode_reply(echo, "99", scan(order, characters, true), true));
  if (order.request.count == 0 || order.left > 0) return;
  laser_on_ = false;
  always_.reset();
}

/// A slow line misses turns.
void UrglaserEmulator::send_scan(std::span<const std::byte> bytes) {
  constexpr double kBitsOfByte = 10;
  if (!place().link.empty() && !place().at_any_speed)
    is_sent_ = now() + kBitsOfByte * static_cast<double>(bytes.size()) / baud_;
  send(bytes);
}

/// Of several steps the nearest.
std::vector<std::string> UrglaserEmulator::scan(const ScipOrder& order, int characters, bool has_checks) {
  const bool has_intensities = order.code.ends_with('E');
  std::string data;
  for (int step = order.request.first; step <= order.request.last; step += order.request.cluster) {
    int nearest = range_at(step);
    for (int other = step + 1; other < step + order.request.cluster && other <= order.request.last; ++other) {
      const int range = range_at(other);
      if (range >= model_.least && (range < nearest || nearest < model_.least)) nearest = range;
    }
    if (characters == 2 && nearest > kMostOfTwoCharacters) nearest = model_.no_echo;
    data += scip::encode_number(nearest, characters);
    if (!has_intensities) continue;
    const BeamEcho echo = echo_at(seen_, model_.angle_of(step));
    data +=
        scip::encode_number(nearest < model_.least ? 0 : scip::kIntensityOfUnit * echo.intensity, characters);
  }
  std::vector<std::string> lines;
  if (has_checks) lines = scip::data_lines(clock(), true);
  for (std::string& line : scip::data_lines(data, has_checks)) lines.push_back(std::move(line));
  return lines;
}

/// mm, or the number that stands for why there is none.
int UrglaserEmulator::range_at(int step) const {
  if (step < model_.first || step > model_.last) return 0;
  const BeamEcho echo = echo_at(seen_, model_.angle_of(step));
  if (!echo.is_seen) return model_.elsewhere;
  const double range = 1000 * echo.range;
  if (!echo.is_hit || !(range <= model_.most)) return model_.no_echo;
  return range < model_.least ? model_.too_near : static_cast<int>(std::lround(range));
}

constinit const DriverDefinition kUrglaserEmulatorDriver{
    .name = "urglaser_emulator",
    .doc = "A Hokuyo scanner at the far end of a line, for a laser of this server.",
    .provides = {},
    .uses = kUrglaserUses,
    .read_options = reading<urglaser_emulator_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_emulator<UrglaserEmulator>(section, site, urglaser_emulator_options, kUrglaserUses);
    },
};

}  // namespace playhouse::drivers
