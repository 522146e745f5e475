#include "playhouse/drivers/rplidar/rplidar_emulator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "playhouse/drivers/hardware/scanner_driver.h"

namespace playhouse::drivers {
namespace {

constexpr double kRadOfDegree = std::numbers::pi / 180, kTurnDegrees = 360;
constexpr double kBootTime = 1;                             // s
constexpr double kFarthest = 12;                            // m
constexpr int kStandardSample = 508, kExpressSample = 254;  // us
constexpr std::uint16_t kModes = 2, kExpressMode = 1;
constexpr int kPlainQuality = 47;
constexpr int kUsualRate = 600;  // turns a minute

/// Of GET_LIDAR_CONF.
enum ConfigurationNumber : std::uint8_t {
  kMotorWanted = 0x01,
  kModeCount = 0x70,
  kModeSample = 0x71,
  kModeDistance = 0x74,
  kModeAnswer = 0x75,
  kModeTypical = 0x7C,
  kModeName = 0x7F,
};

constexpr DeviceText kRplidarUses[] = {{"laser", {}, HowMany::kOne, "what it sees"}};

RplidarEmulatorOptions rplidar_emulator_options(SectionFields& fields) {
  RplidarEmulatorOptions options;
  const int baud =
      fields.integer({"baud", "Of the lidar's line; a host at another speed is not understood.", "baud"},
                     115200, 9600, 4000000);
  options.place = read_emulator_place(fields, {.baud = baud});
  std::string model = fields.text({"model", "Which it is: A1 or A2.", {}, "A1"});
  if (model.empty()) model = "A1";
  fields.expect(model == "A1" || model == "A2", "model", "is A1 or A2");
  options.is_a2 = model == "A2";
  options.has_modes = fields.flag({"modes", "0: it has older firmware, without a table of its modes."}, true);
  return options;
}

void put_32_le(RawBytes& bytes, std::uint32_t value) {
  put_16_le(bytes, static_cast<int>(value & 0xFFFF));
  put_16_le(bytes, static_cast<int>(value >> 16));
}

}  // namespace

RplidarEmulator::RplidarEmulator(std::string name, Site& site, const RplidarEmulatorOptions& options,
                                 UsedDevices used)
    : Emulator(std::move(name), site, options.place, std::move(used)), options_(options) {}

void RplidarEmulator::line_received(std::span<const std::byte> bytes) {
  requests_.add(bytes);
  while (const auto request = requests_.next()) take(*request);
}

/// What is not known is not answered. Each request but those of the motor ends the scans.
void RplidarEmulator::take(const rplidar::LidarRequest& request) {
  const std::span<const std::byte> parameters = request.parameters;
  if (request.code == rplidar::kSetMotor || request.code == rplidar::kSetMotorRate) {
    motor_on_ = parameters.size() < 2 || u16_le(parameters, 0) != 0;
    return;
  }
  kind_ = LidarScan::kNone;
  samples_.reset();
  switch (request.code) {
    case rplidar::kScan:
    case rplidar::kForceScan:
      return scan(LidarScan::kStandard);
    case rplidar::kExpressScan:
      return scan(LidarScan::kExpress);
    case rplidar::kReset:
      return restart();
    case rplidar::kGetInfo:
      return tell_info();
    case rplidar::kGetHealth:
      return send(rplidar::encode_answer(rplidar::kHealth, RawBytes(rplidar::kHealthBytes)));
    case rplidar::kGetRate:
      return tell_rate();
    case rplidar::kGetConfiguration:
      return tell_configuration(parameters);
    case rplidar::kGetBoard: {
      RawBytes flags;
      put_32_le(flags, options_.is_a2 ? 1 : 0);
      return send(rplidar::encode_answer(rplidar::kBoard, flags));
    }
    default:
      return;
  }
}

void RplidarEmulator::restart() {
  samples_ = after(kBootTime, [this] {
    RawBytes banner;
    put_text(banner, "RP LIDAR System.\r\n");
    send(banner);
  });
}

void RplidarEmulator::tell_info() {
  RawBytes info;
  put_u8(info, options_.is_a2 ? 0x28 : 0x18);
  put_u8(info, options_.has_modes ? 29 : 20);
  put_u8(info, 1);
  put_u8(info, 5);
  constexpr int kSerialBytes = 16;
  for (int k = 0; k < kSerialBytes; ++k) put_u8(info, k);
  send(rplidar::encode_answer(rplidar::kInfo, info));
}

void RplidarEmulator::tell_rate() {
  RawBytes rate;
  put_16_le(rate, kStandardSample);
  put_16_le(rate, kExpressSample);
  send(rplidar::encode_answer(rplidar::kRate, rate));
}

void RplidarEmulator::tell_configuration(std::span<const std::byte> parameters) {
  if (parameters.size() < 4) return;
  const std::uint32_t what = u32_le(parameters, 0);
  if (what != kMotorWanted && !options_.has_modes) return;
  RawBytes told;
  put_32_le(told, what);
  switch (what) {
    case kMotorWanted:
      put_16_le(told, kUsualRate);
      put_16_le(told, rplidar::kUsualMotor);
      break;
    case kModeCount:
      put_16_le(told, kModes);
      break;
    case kModeTypical:
      put_16_le(told, kExpressMode);
      break;
    default:
      if (parameters.size() >= 6) tell_mode(what, u16_le(parameters, 4));
      return;
  }
  send(rplidar::encode_answer(rplidar::kConfiguration, told));
}

void RplidarEmulator::tell_mode(std::uint32_t what, std::uint16_t mode) {
  if (mode >= kModes) return;
  constexpr std::uint32_t kUnits = 256;
  const bool is_express = mode == kExpressMode;
  RawBytes told;
  put_32_le(told, what);
  if (what == kModeSample)
    put_32_le(told, kUnits * static_cast<std::uint32_t>(is_express ? kExpressSample : kStandardSample));
  else if (what == kModeDistance)
    put_32_le(told, kUnits * static_cast<std::uint32_t>(kFarthest));
  else if (what == kModeAnswer)
    put_u8(told, is_express ? rplidar::kCapsules : rplidar::kNodes);
  else if (what == kModeName)
    put_text(told, is_express ? std::string_view("Express\0", 8) : std::string_view("Standard\0", 9));
  else
    return;
  send(rplidar::encode_answer(rplidar::kConfiguration, told));
}

// --- scans

double RplidarEmulator::sample_time() const {
  return 1e-6 * (kind_ == LidarScan::kExpress ? kExpressSample : kStandardSample);
}

void RplidarEmulator::scan(LidarScan kind) {
  kind_ = kind;
  is_first_ = true;
  send(kind == LidarScan::kExpress
           ? rplidar::encode_descriptor(rplidar::kCapsuleBytes, true, rplidar::kCapsules)
           : rplidar::encode_descriptor(rplidar::kNodeBytes, true, rplidar::kNodes));
  measure();
}

/// So many samples at a time as a capsule has. It begins to measure when its laser has seen something.
void RplidarEmulator::measure() {
  samples_ = after(static_cast<double>(rplidar::kSamplesOfCapsule) * sample_time(), [this] {
    const wire::laser::Data& seen = beams_.value();
    if (motor_on_ && !seen.ranges.empty())
      kind_ == LidarScan::kExpress ? send_capsule(seen) : send_nodes(seen);
    measure();
  });
}

double RplidarEmulator::range_at(const wire::laser::Data& seen, double angle) const {
  const BeamEcho echo = echo_at(seen, -angle * kRadOfDegree);
  return echo.is_hit && echo.range <= kFarthest ? 1000 * echo.range : 0;
}

void RplidarEmulator::send_nodes(const wire::laser::Data& seen) {
  const double step = kTurnDegrees * turns_of_second() * sample_time();
  RawBytes nodes;
  for (std::size_t k = 0; k < rplidar::kSamplesOfCapsule; ++k) {
    const double range = range_at(seen, angle_);
    const bool is_first = std::exchange(is_first_, false);
    const RawBytes node = rplidar::encode_node({is_first, range > 0 ? kPlainQuality : 0, angle_, range});
    nodes.insert(nodes.end(), node.begin(), node.end());
    angle_ += step;
    if (angle_ < kTurnDegrees) continue;
    angle_ -= kTurnDegrees;
    is_first_ = true;
  }
  send(nodes);
}

void RplidarEmulator::send_capsule(const wire::laser::Data& seen) {
  const double step = kTurnDegrees * turns_of_second() * sample_time();
  rplidar::LidarCapsule capsule{.is_first = std::exchange(is_first_, false), .angle = angle_};
  for (int& range : capsule.ranges) {
    range = static_cast<int>(std::lround(range_at(seen, angle_)));
    angle_ = std::fmod(angle_ + step, kTurnDegrees);
  }
  send(rplidar::encode_capsule(capsule));
}

constinit const DriverDefinition kRplidarEmulatorDriver{
    .name = "rplidar_emulator",
    .doc = "An RPLIDAR at the far end of a line, for a laser of this server.",
    .provides = {},
    .uses = kRplidarUses,
    .read_options = reading<rplidar_emulator_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_emulator<RplidarEmulator>(section, site, rplidar_emulator_options, kRplidarUses);
    },
};

}  // namespace playhouse::drivers
