#include "playhouse/drivers/sicklms200/sicklms200.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace playhouse::drivers {
namespace {

constexpr double kHundredthDegree = std::numbers::pi / 18000;
constexpr int kTriesOfStep = 3;
constexpr double kAfterSpeedChange = 1;  // s until it listens
constexpr double kScanPatience = 3;      // s
constexpr int kSlowBaud = 500000;        // at which it needs a pause after each byte
constexpr double kByteSpacing = 60e-6;   // s
constexpr int kUsualRates[] = {9600, 38400, 500000};
/// Of each LmsUnit: centimetres, millimetres, decimetres.
constexpr double kLargestRanges[] = {80, 8, 150};

constexpr geom::Size kLmsSize{0.15, 0.15, 0.18};

std::vector<int> connect_rates(SectionFields& fields) {
  std::vector<int> rates =
      fields.integers({"connect_rate", "Speeds at which the laser is looked for, in this order.", "baud",
                       "[9600 38400 500000]"});
  for (const int rate : rates)
    fields.expect(sick::mode_of_baud(rate).has_value(), "connect_rate",
                  "is a list of 9600, 19200, 38400 and 500000");
  if (rates.empty()) rates.assign(std::begin(kUsualRates), std::end(kUsualRates));
  return rates;
}

SickLms200Options sick_lms200_options(SectionFields& fields) {
  SickLms200Options options;
  LinePlace place = read_line_place(
      fields, {"port", "Serial port of the laser, or a TCP port that passes its bytes on: tcp:lab:8101."},
      "/dev/ttyS1", {});
  options.connect_rates = connect_rates(fields);
  place.serial.baud = options.connect_rates.front();
  options.scanner = read_scanner_options(fields, std::move(place), kLmsSize);
  options.transfer_rate = fields.integer(
      {"transfer_rate", "Speed of the scans: 9600, 19200, 38400, or, by RS-422, 500000.", "baud"}, 38400,
      9600, 500000);
  fields.expect(sick::mode_of_baud(options.transfer_rate).has_value(), "transfer_rate",
                "is 9600, 19200, 38400 or 500000");
  options.retries = fields.integer({"retry", "So often all speeds are tried again."}, 0, 0, 1000);
  options.delay = fields.number(
      {"delay", "Before the first telegram: some robots switch the laser on with the port.", "s"}, 0);
  const int resolution = fields.integer(
      {"resolution", "Between two beams, in hundredths of a degree: 50 and 100 of 180 degrees, 25 of 100."},
      50, 25, 100);
  fields.expect(resolution == 25 || resolution == 50 || resolution == 100, "resolution", "is 25, 50 or 100");
  options.variant = {resolution == 25 ? 100 : 180, resolution};
  const int range_res = fields.integer(
      {"range_res", "Of the ranges: 1, up to 8 m; 10, up to 80 m; 100, up to 150 m.", "mm"}, 1, 1, 100);
  fields.expect(range_res == 1 || range_res == 10 || range_res == 100, "range_res", "is 1, 10 or 100");
  options.unit = range_res == 1 ? sick::kMillimetre : range_res == 10 ? sick::kCentimetre : sick::kDecimetre;
  options.is_highly_available = fields.flag({"high_avail", "1: it measures in fog and rain, too."}, false);
  return options;
}

/// s for its answer. Its memory takes its time.
double patience_of_step(std::uint8_t code) {
  return code == sick::kSetBlock ? 10 : code == sick::kSetMode ? 1 : 5;
}

bool is_about(double value, double wanted) {
  return std::fabs(value - wanted) < 0.01 * wanted;
}

std::optional<std::uint8_t> unit_of(double range_res) {
  for (const std::uint8_t unit : {sick::kCentimetre, sick::kMillimetre, sick::kDecimetre})
    if (is_about(range_res, sick::metres_of(unit))) return unit;
  return std::nullopt;
}

std::optional<sick::LmsVariant> variant_of(double resolution) {
  for (const int hundredths : {25, 50, 100})
    if (is_about(resolution, hundredths * kHundredthDegree))
      return sick::LmsVariant{hundredths == 25 ? 100 : 180, hundredths};
  return std::nullopt;
}

}  // namespace

SickLms200::SickLms200(std::string name, Site& site, const SickLms200Options& options)
    : ScannerDriver(std::move(name), site, options.scanner),
      options_(options),
      unit_(options.unit),
      speeds_(options.connect_rates) {
  settle(options.variant, options.unit, 1, options.variant.values());
}

void SickLms200::settle(const sick::LmsVariant& variant, std::uint8_t unit, int first, int last) {
  variant_ = variant;
  unit_ = unit;
  first_ = first;
  last_ = last;
  settings_.resolution = variant.resolution * kHundredthDegree;
  const double rightmost = -50.0 * variant.width * kHundredthDegree;
  settings_.min_angle = rightmost + (first - 1) * settings_.resolution;
  settings_.max_angle = rightmost + (last - 1) * settings_.resolution;
  settings_.range_res = sick::metres_of(unit);
  settings_.max_range = kLargestRanges[unit];
  settings_.frequency = 1 / sick::scan_period(variant, last - first + 1, options_.transfer_rate);
}

/// Angles beyond those of the scan are cut.
bool SickLms200::configure(const ScanSettings& wanted) {
  const auto variant = variant_of(wanted.resolution);
  const auto unit = unit_of(wanted.range_res);
  if (!variant || !unit || wanted.min_angle > wanted.max_angle) return false;
  const double rightmost = -50.0 * variant->width * kHundredthDegree;
  const auto number = [&](double angle) {
    const double step = (angle - rightmost) / (variant->resolution * kHundredthDegree);
    return 1 + static_cast<int>(std::lround(std::clamp(step, 0.0, variant->values() - 1.0)));
  };
  const int first = number(wanted.min_angle), last = number(wanted.max_angle);
  if (options_.is_pls && (*variant != variant_ || *unit != unit_ || first != first_ || last != last_))
    return false;
  settings_.power = wanted.power;
  settings_.intensity = wanted.intensity;
  settle(*variant, *unit, first, last);
  is_changed_ = true;
  tell_settings();
  if (phase_ == LmsPhase::kRuns) options_.is_pls ? start_scans() : log_in();
  return true;
}

// --- a step

void SickLms200::say(LmsPhase phase, RawBytes telegram) {
  phase_ = phase;
  tries_ = 0;
  telegram_ = std::move(telegram);
  say_again();
}

void SickLms200::say_again() {
  if (++tries_ > kTriesOfStep) {
    if (phase_ == LmsPhase::kStops) return listen_at_next_speed();
    return give_up("the laser has stopped answering");
  }
  constexpr std::size_t kCodeAt = 4;
  patience_ = after(patience_of_step(u8(telegram_, kCodeAt)), [this] { say_again(); });
  reader_.clear();
  line().drop_input();
  spacing_.reset();
  if (baud() != kSlowBaud) return send(telegram_);
  sent_ = 0;
  send_next_byte();
}

void SickLms200::send_next_byte() {
  if (sent_ == telegram_.size()) return;
  send(std::span(telegram_).subspan(sent_++, 1));
  spacing_ = after(kByteSpacing, [this] { send_next_byte(); });
}

void SickLms200::rest(double seconds, void (SickLms200::*then)()) {
  phase_ = LmsPhase::kWaits;
  patience_ = after(seconds, [this, then] { (this->*then)(); });
}

// --- the steps

void SickLms200::began() {
  retries_ = 0;
  if (options_.delay > 0) return rest(options_.delay, &SickLms200::connect);
  connect();
}

void SickLms200::connect() {
  speed_ = 0;
  stop_scans();
}

void SickLms200::stop_scans() {
  if (set_baud(speeds_[speed_])) say(LmsPhase::kStops, sick::ask(sick::kSetMode, sick::kOnRequest));
}

void SickLms200::listen_at_next_speed() {
  if (is_serial() && ++speed_ < speeds_.size()) return stop_scans();
  if (++retries_ > options_.retries) return give_up("nothing answers: is the laser on?");
  connect();
}

/// A bridge to the laser keeps its speed.
void SickLms200::change_speed() {
  if (!is_serial() || baud() == options_.transfer_rate) return introduce();
  say(LmsPhase::kChangesSpeed, sick::ask(sick::kSetMode, *sick::mode_of_baud(options_.transfer_rate)));
}

void SickLms200::introduce() {
  if (options_.is_pls) return start_scans();
  say(LmsPhase::kAsksType, sick::ask(sick::kAskType));
}

void SickLms200::log_in() {
  is_changed_ = false;
  RawBytes telegram;
  put_u8(telegram, sick::kSetMode);
  put_u8(telegram, sick::kConfigures);
  put_text(telegram, sick::kLmsPassword);
  say(LmsPhase::kLogsIn, sick::to_laser(telegram));
}

void SickLms200::start_scans() {
  if (options_.is_pls) is_changed_ = false;
  if (!settings_.power) return say(LmsPhase::kStarts, sick::ask(sick::kSetMode, sick::kOnRequest));
  constexpr int kUsualResolution = 50;
  if (is_whole() && variant_.resolution == kUsualResolution)
    return say(LmsPhase::kStarts, sick::ask(sick::kSetMode, sick::kStreams));
  say(LmsPhase::kStarts, sick::ask_for_part(first_, last_));
}

/// Next time it is looked for at this speed first.
void SickLms200::run() {
  phase_ = LmsPhase::kRuns;
  if (is_changed_) return options_.is_pls ? start_scans() : log_in();
  speeds_ = options_.connect_rates;
  std::erase(speeds_, baud());
  speeds_.insert(speeds_.begin(), baud());
  expect_scan();
}

void SickLms200::expect_scan() {
  patience_.reset();
  if (!settings_.power) return;
  patience_ = after(kScanPatience, [this] {
    warn(fmt::format("{}: no scan for {} s: it is started again", line().name(), kScanPatience));
    connect();
  });
}

void SickLms200::ending() {
  if (phase_ != LmsPhase::kClosed) send(sick::ask(sick::kSetMode, sick::kOnRequest));
}

void SickLms200::forgot() {
  phase_ = LmsPhase::kClosed;
  patience_.reset();
  spacing_.reset();
  reader_.clear();
}

// --- what the laser says

void SickLms200::received(std::span<const std::byte> bytes) {
  reader_.add(bytes);
  while (const std::optional<RawBytes> telegram = reader_.next()) take(*telegram);
}

void SickLms200::take(std::span<const std::byte> telegram) {
  const auto is = [&](LmsPhase phase, std::uint8_t code) {
    return phase_ == phase && u8(telegram, 0) == code;
  };
  const bool is_done = telegram.size() > 1 && u8(telegram, 1) == 1;
  if (is(LmsPhase::kRuns, sick::kWholeScan) || is(LmsPhase::kRuns, sick::kPartOfScan))
    return take_scan(telegram);
  if (u8(telegram, 0) == sick::kModeSet) return take_mode(telegram);
  if (is(LmsPhase::kAsksType, sick::kType)) return take_type(telegram);
  if (is(LmsPhase::kAsksState, sick::kStatus)) return take_state(telegram);
  if (is(LmsPhase::kAsksBlock, sick::kBlock)) return take_block(telegram);
  if (is(LmsPhase::kSetsVariant, sick::kVariantSet)) {
    if (!is_done) return give_up("the laser refuses its resolution");
    return say(LmsPhase::kAsksBlock, sick::ask(sick::kAskBlock));
  }
  if (is(LmsPhase::kSetsBlock, sick::kBlockSet))
    return is_done ? start_scans() : give_up("the laser refuses its configuration");
  if (u8(telegram, 0) == sick::kRefused && phase_ > LmsPhase::kStops && phase_ < LmsPhase::kRuns)
    give_up("the laser refuses what it is asked");
}

void SickLms200::take_mode(std::span<const std::byte> telegram) {
  const bool is_set = telegram.size() > 1 && u8(telegram, 1) == 0;
  constexpr double kQuiet = 1;  // s until what it has begun to send has come
  switch (phase_) {
    case LmsPhase::kStops:
      return rest(kQuiet, &SickLms200::change_speed);
    case LmsPhase::kChangesSpeed:
      if (set_baud(options_.transfer_rate)) rest(kAfterSpeedChange, &SickLms200::introduce);
      return;
    case LmsPhase::kLogsIn:
      if (!is_set) return give_up("the laser refuses the password of its maker");
      return say(LmsPhase::kAsksState, sick::ask(sick::kAskStatus));
    case LmsPhase::kStarts:
      return is_set ? run() : give_up("the laser refuses to send scans");
    default:
      return;
  }
}

void SickLms200::take_type(std::span<const std::byte> telegram) {
  type_.clear();
  for (const std::byte letter : telegram.subspan(1))
    if (letter >= std::byte{' '} && letter < std::byte{0x7F}) type_ += static_cast<char>(letter);
  inform(fmt::format("{} answers at {}", type_, line().name()));
  log_in();
}

void SickLms200::take_state(std::span<const std::byte> telegram) {
  if (sick::read_state(telegram) == variant_) return say(LmsPhase::kAsksBlock, sick::ask(sick::kAskBlock));
  say(LmsPhase::kSetsVariant, sick::to_laser(sick::encode_variant(variant_)));
}

void SickLms200::take_block(std::span<const std::byte> telegram) {
  if (telegram.size() <= sick::kLeastBlock) return;
  RawBytes wanted(telegram.begin(), telegram.begin() + 1 + sick::kLeastBlock);
  wanted[0] = std::byte{sick::kSetBlock};
  const auto set = [&wanted](std::size_t at, int value) { wanted[1 + at] = static_cast<std::byte>(value); };
  set(sick::kAvailabilityAt, options_.is_highly_available ? sick::kHighAvailability : 0);
  set(sick::kMeasuringModeAt, settings_.intensity ? 1 : 0);
  set(sick::kUnitAt, unit_);
  if (std::equal(wanted.begin() + 1, wanted.end(), telegram.begin() + 1)) return start_scans();
  say(LmsPhase::kSetsBlock, sick::to_laser(wanted));
}

void SickLms200::take_scan(std::span<const std::byte> telegram) {
  const auto scan = sick::read_scan(telegram);
  if (!scan || scan->first != first_ || scan->values.size() != static_cast<std::size_t>(last_ - first_ + 1))
    return;
  expect_scan();
  constexpr int kLmsBits = 13, kDistance = (1 << kLmsBits) - 1;
  LineScan seen;
  for (const int value : scan->values) {
    const int distance = value & kDistance;
    const double range =
        distance < sick::first_special(kLmsBits) ? distance * settings_.range_res : settings_.max_range;
    seen.ranges.push_back(static_cast<float>(std::min(range, settings_.max_range)));
    if (settings_.intensity) seen.intensities.push_back(static_cast<std::uint8_t>(value >> kLmsBits));
  }
  publish_scan(std::move(seen));
}

constinit const DriverDefinition kSickLms200Driver{
    .name = "sicklms200",
    .doc = "SICK LMS 200, 211, 220, 221 and 291 laser scanners; as sickpls the PLS.",
    .other_name = "sickpls",
    .provides = kScannerProvides,
    .read_options = reading<sick_lms200_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      const auto options_of = [&section](SectionFields& fields) {
        SickLms200Options options = sick_lms200_options(fields);
        options.is_pls = section.name() == "sickpls";
        if (!options.is_pls) return options;
        options.scanner.hardware.place.serial.parity = net::SerialParity::kEven;
        options.variant = {};
        options.variant.resolution = 50;
        options.unit = sick::kCentimetre;
        return options;
      };
      return make_hardware<SickLms200>(section, site, options_of, kScannerProvides);
    },
};

}  // namespace playhouse::drivers
