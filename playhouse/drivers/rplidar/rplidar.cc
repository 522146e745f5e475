#include "playhouse/drivers/rplidar/rplidar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace playhouse::drivers {
namespace {

constexpr double kLidarDegree = std::numbers::pi / 180;
constexpr int kLidarBauds[] = {115200, 256000};
constexpr int kLidarTries = 3;
constexpr double kLidarPatience = 0.5;    // s for an answer
constexpr double kLidarScanPatience = 5;  // s, until the motor has its speed
constexpr double kStopTime = 0.1;         // s until nothing comes any more
constexpr double kLidarResetTime = 2;     // s
constexpr double kFinest = 0.1 * kLidarDegree, kCoarsest = 30 * kLidarDegree;
constexpr geom::Size kLidarSize{0.07, 0.1, 0.06};

RplidarOptions rplidar_options(SectionFields& fields) {
  RplidarOptions options;
  LinePlace place = read_line_place(
      fields, {"port", "Serial port of the lidar, or a TCP port that passes its bytes on: tcp:lab:8101."},
      "/dev/ttyUSB0", {});
  options.baud = fields.integer(
      {"baud", "Speed of the line: 115200 or 256000; if nothing answers, the other one is tried.", "baud"},
      115200, 9600, 4000000);
  place.serial.baud = options.baud;
  options.scanner = read_scanner_options(fields, std::move(place), kLidarSize);
  options.resolution = fields.angle({"resolution", "Between two beams of a scan."}, kLidarDegree, 0, kFinest);
  fields.expect(options.resolution <= kCoarsest, "resolution", "is at most 30");
  options.max_range = fields.length({"max_range", "Of a beam without an echo."}, 12, 0.1);
  options.is_express =
      fields.flag({"express", "0: standard scans, half as many samples, with a quality each."}, true);
  return options;
}

}  // namespace

Rplidar::Rplidar(std::string name, Site& site, const RplidarOptions& options)
    : ScannerDriver(std::move(name), site, options.scanner), options_(options) {
  constexpr double kLeastRange = 0.15, kTurnsOfSecond = 5.5;
  settings_.resolution = options.resolution;
  settings_.min_angle = -std::numbers::pi;
  settings_.max_angle = std::numbers::pi - options.resolution;
  settings_.min_range = kLeastRange;
  settings_.max_range = options.max_range;
  settings_.range_res = 0.001;
  settings_.frequency = kTurnsOfSecond;
  settings_.intensity = !options.is_express;
}

/// Any part of a turn, in any resolution.
bool Rplidar::configure(const ScanSettings& wanted) {
  if (wanted.resolution < kFinest || wanted.resolution > kCoarsest || wanted.min_angle > wanted.max_angle ||
      std::fabs(wanted.range_res - settings_.range_res) > 1e-6)
    return false;
  const bool had_power = settings_.power;
  settings_.resolution = wanted.resolution;
  settings_.min_angle = std::clamp(wanted.min_angle, -std::numbers::pi, std::numbers::pi);
  const double last =
      std::min(wanted.max_angle, settings_.min_angle + 2 * std::numbers::pi - wanted.resolution);
  const double beams = std::floor((last - settings_.min_angle) / wanted.resolution + 1e-6);
  settings_.max_angle = settings_.min_angle + std::max(0.0, beams) * wanted.resolution;
  settings_.intensity = wanted.intensity && !is_express_;
  settings_.power = wanted.power;
  is_whole_ = false;
  tell_settings();
  if (had_power != wanted.power && phase_ == LidarPhase::kRuns) stop_scans();
  return true;
}

// --- a step

void Rplidar::say(LidarPhase phase, RawBytes request) {
  phase_ = phase;
  tries_ = 0;
  request_ = std::move(request);
  say_again();
}

void Rplidar::say_again() {
  if (++tries_ > kLidarTries) {
    if (phase_ == LidarPhase::kAsksInfo) return connect();
    if (phase_ != LidarPhase::kStarts || !std::exchange(is_express_, false))
      return give_up("the lidar has stopped answering");
    return start_scans();  // old ones have standard scans alone
  }
  patience_ = after(kLidarPatience, [this] { say_again(); });
  line().drop_input();
  switch (phase_) {
    case LidarPhase::kAsksInfo:
      answers_.expect(rplidar::kInfo, rplidar::kInfoBytes, false);
      break;
    case LidarPhase::kAsksHealth:
      answers_.expect(rplidar::kHealth, rplidar::kHealthBytes, false);
      break;
    default:
      is_express_ ? answers_.expect(rplidar::kCapsules, rplidar::kCapsuleBytes, true)
                  : answers_.expect(rplidar::kNodes, rplidar::kNodeBytes, true);
  }
  send(request_);
}

void Rplidar::rest(double seconds, void (Rplidar::*then)()) {
  phase_ = LidarPhase::kWaits;
  patience_ = after(seconds, [this, then] { (this->*then)(); });
}

// --- the steps

void Rplidar::began() {
  bauds_ = 0;
  was_reset_ = false;
  is_express_ = options_.is_express;
  connect();
}

/// At its own speed first, then at the others.
void Rplidar::connect() {
  constexpr int kOtherBauds = static_cast<int>(std::size(kLidarBauds));
  if (bauds_ > (is_serial() ? kOtherBauds : 0)) return give_up("nothing answers: is the lidar on?");
  const int baud = bauds_ == 0 ? options_.baud : kLidarBauds[bauds_ - 1];
  ++bauds_;
  if (set_baud(baud)) stop_scans();
}

void Rplidar::stop_scans() {
  send(rplidar::encode_request(rplidar::kStop));
  rest(kStopTime, &Rplidar::introduce);
}

void Rplidar::introduce() {
  say(LidarPhase::kAsksInfo, rplidar::encode_request(rplidar::kGetInfo));
}

void Rplidar::set_motor(int power) {
  if (!has_motor_power_) return;
  RawBytes parameters;
  put_16_le(parameters, power);
  send(rplidar::encode_request(rplidar::kSetMotor, parameters));
}

void Rplidar::start_scans() {
  set_motor(settings_.power ? rplidar::kUsualMotor : 0);
  before_.reset();
  is_whole_ = false;
  if (!settings_.power) {
    phase_ = LidarPhase::kRuns;
    return patience_.reset();
  }
  if (!is_express_) return say(LidarPhase::kStarts, rplidar::encode_request(rplidar::kScan));
  settings_.intensity = false;
  constexpr std::size_t kExpressParameters = 5;
  say(LidarPhase::kStarts, rplidar::encode_request(rplidar::kExpressScan, RawBytes(kExpressParameters)));
}

void Rplidar::expect_scan() {
  patience_ = after(kLidarScanPatience, [this] {
    warn(fmt::format("{}: no scan for {} s: it is started again", line().name(), kLidarScanPatience));
    bauds_ = 0;
    connect();
  });
}

void Rplidar::ending() {
  if (phase_ == LidarPhase::kClosed) return;
  send(rplidar::encode_request(rplidar::kStop));
  set_motor(0);
}

void Rplidar::forgot() {
  phase_ = LidarPhase::kClosed;
  patience_.reset();
}

// --- what the lidar says

void Rplidar::received(std::span<const std::byte> bytes) {
  if (phase_ == LidarPhase::kClosed || phase_ == LidarPhase::kWaits) return;
  answers_.add(bytes);
  while (phase_ != LidarPhase::kClosed && phase_ != LidarPhase::kWaits) {
    const std::optional<RawBytes> piece = answers_.next();
    if (phase_ == LidarPhase::kStarts && answers_.has_begun()) {
      phase_ = LidarPhase::kRuns;
      expect_scan();
    }
    if (!piece) return;
    take(*piece);
  }
}

void Rplidar::take(std::span<const std::byte> piece) {
  if (phase_ == LidarPhase::kAsksInfo) return take_info(piece);
  if (phase_ == LidarPhase::kAsksHealth) return take_health(piece);
  if (phase_ != LidarPhase::kRuns || !settings_.power) return;
  if (is_express_) return take_capsule(rplidar::read_capsule(piece));
  take_sample(rplidar::read_node(piece));
}

void Rplidar::take_info(std::span<const std::byte> info) {
  constexpr int kWithoutMotorPower = 1;  // series A1: its adapter switches the motor by a signal of the line
  const int series = u8(info, 0) >> 4;
  has_motor_power_ = series > kWithoutMotorPower;
  inform(fmt::format("RPLIDAR A{}, firmware {}.{:02}, answers at {}", series, u8(info, 2), u8(info, 1),
                     line().name()));
  say(LidarPhase::kAsksHealth, rplidar::encode_request(rplidar::kGetHealth));
}

void Rplidar::take_health(std::span<const std::byte> health) {
  if (u8(health, 0) < rplidar::kBroken) return start_scans();
  const int fault = u16_le(health, 1);
  if (std::exchange(was_reset_, true)) return give_up(fmt::format("the lidar is broken: fault {}", fault));
  warn(fmt::format("{}: the lidar tells fault {}: it is reset", line().name(), fault));
  send(rplidar::encode_request(rplidar::kReset));
  rest(kLidarResetTime, &Rplidar::introduce);
}

void Rplidar::take_capsule(const rplidar::LidarCapsule& capsule) {
  if (before_ && !capsule.is_first)
    for (const rplidar::LidarSample& sample : rplidar::samples_of(*before_, capsule.angle))
      take_sample(sample);
  before_ = capsule;
}

void Rplidar::take_sample(const rplidar::LidarSample& sample) {
  if (sample.is_first) {
    if (is_whole_) publish_turn();
    is_whole_ = true;
    turn_ = {};
  }
  if (!is_whole_ || sample.range <= 0) return;
  const auto beams = static_cast<std::size_t>(
      std::lround((settings_.max_angle - settings_.min_angle) / settings_.resolution) + 1);
  turn_.ranges.resize(beams);
  if (settings_.intensity) turn_.intensities.resize(beams);
  // Counter-clockwise, from the first beam on.
  double angle = std::fmod(-sample.angle * kLidarDegree - settings_.min_angle, 2 * std::numbers::pi);
  if (angle < -settings_.resolution / 2) angle += 2 * std::numbers::pi;
  if (angle >= 2 * std::numbers::pi - settings_.resolution / 2) angle -= 2 * std::numbers::pi;
  const auto beam = static_cast<std::size_t>(std::max(0L, std::lround(angle / settings_.resolution)));
  if (beam >= beams) return;
  float& range = turn_.ranges[beam];
  const double metres = sample.range / 1000;
  if (range > 0 && static_cast<double>(range) <= metres) return;
  range = static_cast<float>(metres);
  if (settings_.intensity) turn_.intensities[beam] = static_cast<std::uint8_t>(sample.quality);
}

void Rplidar::publish_turn() {
  expect_scan();
  const auto beams = static_cast<std::size_t>(
      std::lround((settings_.max_angle - settings_.min_angle) / settings_.resolution) + 1);
  turn_.ranges.resize(beams);
  if (settings_.intensity) turn_.intensities.resize(beams);
  const auto most = static_cast<float>(settings_.max_range);
  for (float& range : turn_.ranges)
    if (range == 0 || range > most) range = most;
  publish_scan(std::move(turn_));
}

constinit const DriverDefinition kRplidarDriver{
    .name = "rplidar",
    .doc = "Slamtec RPLIDAR A1 and A2.",
    .provides = kScannerProvides,
    .read_options = reading<rplidar_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_hardware<Rplidar>(section, site, rplidar_options, kScannerProvides);
    },
};

}  // namespace playhouse::drivers
