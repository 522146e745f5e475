#include "playhouse/drivers/urglaser/urglaser.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace playhouse::drivers {
namespace {

constexpr double kUrgDegree = std::numbers::pi / 180;
constexpr int kUrgBauds[] = {115200, 19200, 38400, 57600};
constexpr int kUrgTries = 3;
constexpr double kEndPatience = 2;      // s for the end of a scan
constexpr double kUrgPatience = 0.5;    // s for an answer
constexpr double kUrgScanPatience = 3;  // s
constexpr geom::Size kUrgSize{0.05, 0.05, 0.07};
constexpr int kRangeCharacters = 3;

UrglaserOptions urglaser_options(SectionFields& fields) {
  UrglaserOptions options;
  LinePlace place = read_line_place(
      fields, {"port", "Serial port of the scanner, or its TCP port: tcp:192.168.0.10:10940."},
      "/dev/ttyACM0", {});
  options.baud = fields.integer(
      {"baud", "Speed of a serial line, which the scanner is set to: 19200, 57600, 115200; USB has none.",
       "baud"},
      115200, 19200, 750000);
  place.serial.baud = options.baud;
  options.scanner = read_scanner_options(fields, std::move(place), kUrgSize);
  options.min_angle = fields.angle({"min_angle", "Of the first beam; at most those that the scanner has."},
                                   -135 * kUrgDegree, 0, SectionFields::kAnyNumber);
  options.max_angle =
      fields.angle({"max_angle", "Of the last beam."}, 135 * kUrgDegree, 0, SectionFields::kAnyNumber);
  fields.expect(options.min_angle < options.max_angle, "max_angle", "is more than min_angle");
  return options;
}

}  // namespace

Urglaser::Urglaser(std::string name, Site& site, const UrglaserOptions& options)
    : ScannerDriver(std::move(name), site, options.scanner), options_(options), speeds_{options.baud} {
  for (const int baud : kUrgBauds)
    if (baud != options.baud) speeds_.push_back(baud);
  settings_.min_angle = options.min_angle;
  settings_.max_angle = options.max_angle;
  settings_.intensity = false;
  settle(settings_);
}

/// Turns angles into steps of the scanner, and back.
void Urglaser::settle(const ScanSettings& wanted) {
  constexpr double kMostOfTwoDigits = 99;
  constexpr double kTolerance = 0.02;
  const double step = model_.step(), turns = model_.speed / 60.0;
  const auto number = [&](double angle) {
    const double at = angle / step + model_.front;
    return static_cast<int>(std::lround(std::clamp<double>(at, model_.first, model_.last)));
  };
  scans_.first = number(wanted.min_angle);
  scans_.last = std::max(scans_.first, number(wanted.max_angle));
  scans_.cluster =
      static_cast<int>(std::clamp(std::floor(wanted.resolution / step + kTolerance), 1.0, kMostOfTwoDigits));
  const double skipped = wanted.frequency > 0 ? std::floor(turns / wanted.frequency + kTolerance) - 1 : 0;
  scans_.skipped = static_cast<int>(std::clamp(skipped, 0.0, 9.0));
  settings_ = wanted;
  // A value of several steps is for the middle of them.
  const int clusters = (scans_.last - scans_.first) / scans_.cluster;
  const double middle = (scans_.cluster - 1) * step / 2;
  settings_.min_angle = model_.angle_of(scans_.first) + middle;
  settings_.max_angle = settings_.min_angle + clusters * scans_.cluster * step;
  settings_.resolution = scans_.cluster * step;
  settings_.min_range = model_.least / 1000.0;
  settings_.max_range = model_.most / 1000.0;
  settings_.range_res = 0.001;
  settings_.frequency = turns / (1 + scans_.skipped);
}

/// Other angles and rates than it has are those next to them.
bool Urglaser::configure(const ScanSettings& wanted) {
  if (wanted.min_angle > wanted.max_angle || wanted.resolution < 0 || wanted.frequency < 0) return false;
  if (std::fabs(wanted.range_res - settings_.range_res) > 1e-6) return false;
  settle(wanted);
  has_intensities_ = true;
  tell_settings();
  if (phase_ == ScipPhase::kRuns || phase_ == ScipPhase::kStarts) end_scans();
  return true;
}

// --- a step

void Urglaser::say(ScipPhase phase, std::string line) {
  phase_ = phase;
  tries_ = 0;
  line_ = std::move(line);
  say_again();
}

void Urglaser::say_again() {
  if (++tries_ > kUrgTries) {
    if (phase_ == ScipPhase::kStops || phase_ == ScipPhase::kSwitches) return listen_at_next_speed();
    return give_up("the scanner has stopped answering");
  }
  patience_ = after(phase_ == ScipPhase::kEnds ? kEndPatience : kUrgPatience, [this] { say_again(); });
  replies_.clear();
  line().drop_input();
  send_line(line_);
}

void Urglaser::send_line(const std::string& line) {
  RawBytes bytes;
  put_text(bytes, line + "\n");
  send(bytes);
}

// --- the steps

void Urglaser::began() {
  connect();
}

void Urglaser::connect() {
  speed_ = 0;
  stop_scans();
}

void Urglaser::stop_scans() {
  if (set_baud(speeds_[speed_])) say(ScipPhase::kStops, "QT");
}

void Urglaser::listen_at_next_speed() {
  if (!is_serial() || ++speed_ == speeds_.size()) return give_up("nothing answers: is the scanner on?");
  stop_scans();
}

void Urglaser::set_speed() {
  if (!is_serial() || baud() == options_.baud) return say(ScipPhase::kAsksModel, "PP");
  say(ScipPhase::kSetsSpeed, fmt::format("SS{:06}", options_.baud));
}

/// It ends the scan that it is sending before it answers.
void Urglaser::end_scans() {
  say(ScipPhase::kEnds, "QT");
}

void Urglaser::start_scans() {
  if (settings_.power)
    return say(ScipPhase::kStarts, scans_.line(settings_.intensity && has_intensities_ ? "ME" : "MD"));
  phase_ = ScipPhase::kRuns;
  patience_.reset();
}

void Urglaser::expect_scan() {
  patience_ = after(kUrgScanPatience, [this] {
    warn(fmt::format("{}: no scan for {} s: it is started again", line().name(), kUrgScanPatience));
    connect();
  });
}

void Urglaser::ending() {
  if (phase_ != ScipPhase::kClosed) send_line("QT");
}

void Urglaser::forgot() {
  phase_ = ScipPhase::kClosed;
  patience_.reset();
  replies_.clear();
  knows_model_ = false;
}

// --- what the scanner says

void Urglaser::received(std::span<const std::byte> bytes) {
  replies_.add(bytes);
  while (const auto reply = replies_.next()) take(*reply);
}

void Urglaser::take(const scip::ScipReply& reply) {
  switch (phase_) {
    case ScipPhase::kStops:
      return take_stopped(reply);
    case ScipPhase::kSwitches:
      if (reply.echo == line_) say(ScipPhase::kStops, "QT");
      return;
    case ScipPhase::kSetsSpeed:
      return take_speed(reply);
    case ScipPhase::kAsksModel:
      return take_model(reply);
    case ScipPhase::kAsksVersion:
      return take_version(reply);
    case ScipPhase::kEnds:
      if (reply.echo == line_) start_scans();
      return;
    case ScipPhase::kStarts:
      return take_started(reply);
    case ScipPhase::kRuns:
      return take_scan(reply);
    default:
      return;
  }
}

/// One that speaks SCIP 1.1 does not know QT, and answers with one character.
void Urglaser::take_stopped(const scip::ScipReply& reply) {
  if (reply.echo != line_) return;
  if (reply.status.size() == 1) return say(ScipPhase::kSwitches, "SCIP2.0");
  if (reply.status == "00") set_speed();
}

/// 03: it has it; 04 and 0F: there is none to set.
void Urglaser::take_speed(const scip::ScipReply& reply) {
  if (reply.echo != line_) return;
  const bool is_set = reply.status == "00";
  if (!is_set && reply.status != "03" && reply.status != "04" && reply.status != "0F")
    warn(fmt::format("{}: it cannot be set to {} baud", line().name(), options_.baud));
  if (!is_set || set_baud(options_.baud)) say(ScipPhase::kAsksModel, "PP");
}

void Urglaser::take_model(const scip::ScipReply& reply) {
  if (reply.echo != line_) return;
  const auto model = scip::read_parameters(reply.lines);
  if (!model) return;  // it is asked again
  model_ = *model;
  ScanSettings wanted = settings_;
  if (!std::exchange(knows_model_, true)) {
    wanted.resolution = std::min(wanted.resolution, model_.step());
    wanted.frequency = 0;
  }
  settle(wanted);
  say(ScipPhase::kAsksVersion, "VV");
}

void Urglaser::take_version(const scip::ScipReply& reply) {
  if (reply.echo != line_) return;
  inform(fmt::format("{}, {}, answers at {}", scip::value_named("PROD", reply.lines).value_or("a scanner"),
                     scip::value_named("SERI", reply.lines).value_or("without a number"), line().name()));
  start_scans();
}

void Urglaser::take_started(const scip::ScipReply& reply) {
  if (reply.echo != line_) return;
  if (reply.status == "00") {
    phase_ = ScipPhase::kRuns;
    return expect_scan();
  }
  if (!std::exchange(has_intensities_, false) || !settings_.intensity)
    return give_up(fmt::format("the scanner answers {} to {}", reply.status, line_));
  warn(line().name() + ": the scanner measures no intensities");
  settings_.intensity = false;
  start_scans();
}

void Urglaser::take_scan(const scip::ScipReply& reply) {
  constexpr std::size_t kCode = 2;
  if (reply.status != "99" || reply.lines.empty() || reply.echo.substr(0, kCode) != line_.substr(0, kCode))
    return;
  const auto data = scip::joined_data(std::span(reply.lines).subspan(1));  // after its time
  const bool has_intensities = line_.starts_with("ME");
  const std::size_t width = kRangeCharacters * (has_intensities ? 2 : 1);
  const auto count = static_cast<std::size_t>((scans_.last - scans_.first) / scans_.cluster + 1);
  if (!data || data->size() != count * width) return;
  LineScan seen;
  for (std::size_t at = 0; at < data->size(); at += width) {
    const auto number = [&](std::size_t offset) {
      return scip::decode_number(std::string_view(*data).substr(at + offset, kRangeCharacters)).value_or(0);
    };
    const int range = number(0);
    const bool is_range = range >= model_.least && range <= model_.most;
    seen.ranges.push_back(static_cast<float>((is_range ? range : model_.most) / 1000.0));
    if (has_intensities)
      seen.intensities.push_back(
          static_cast<std::uint8_t>(std::min(255, number(kRangeCharacters) / scip::kIntensityOfUnit)));
  }
  expect_scan();
  publish_scan(std::move(seen));
}

constinit const DriverDefinition kUrglaserDriver{
    .name = "urglaser",
    .doc = "Hokuyo scanners that speak SCIP 2.0: URG, UTM, UXM, UST.",
    .provides = kScannerProvides,
    .read_options = reading<urglaser_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_hardware<Urglaser>(section, site, urglaser_options, kScannerProvides);
    },
};

}  // namespace playhouse::drivers
