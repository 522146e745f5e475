#include "playhouse/drivers/irobot/oi_commands.h"

#include <algorithm>
#include <cmath>

namespace playhouse::drivers::irobot {
namespace {

using enum RobotGeneration;

constexpr std::uint8_t kFirstOpcode = 128;
constexpr std::size_t kMostOfScript = 100;

struct OpcodeLength {
  Opcode opcode;
  std::size_t bytes;
};
constexpr OpcodeLength kOfAll[] = {
    {kStart, 0}, {kBaud, 1},  {kControl, 0}, {kSafe, 0}, {kFull, 0}, {kPower, 0},   {kSpot, 0}, {kClean, 0},
    {kMax, 0},   {kDrive, 4}, {kMotors, 1},  {kLeds, 3}, {kPlay, 1}, {kSensors, 1}, {kDock, 0},
};
constexpr OpcodeLength kOf500[] = {
    {kMotorPowers, 3},  {kDriveDirect, 4}, {kDrivePowers, 4}, {kPauseStream, 1},
    {kScheduleLeds, 2}, {kDigitLeds, 4},   {kDigitText, 4},   {kPressButtons, 1},
    {kSchedule, 15},    {kSetClock, 3},    {kStop, 0},
};
constexpr OpcodeLength kOfCreate[] = {
    {kMotorPowers, 3},  {kDriveDirect, 4}, {kDigitalOutputs, 1}, {kPauseStream, 1},
    {kSendIr, 1},       {kPlayScript, 0},  {kShowScript, 0},     {kWaitTime, 1},
    {kWaitDistance, 2}, {kWaitAngle, 2},   {kWaitEvent, 1},
};

std::optional<std::size_t> length_in(std::span<const OpcodeLength> lengths, std::uint8_t opcode) {
  const auto found = std::ranges::find(lengths, opcode, &OpcodeLength::opcode);
  return found == lengths.end() ? std::nullopt : std::optional(found->bytes);
}

std::optional<std::size_t> fixed_length(RobotGeneration generation, std::uint8_t opcode) {
  if (generation == kCreate && opcode == kMax) return 1;
  if (const auto length = length_in(kOfAll, opcode)) return length;
  if (generation == k500) return length_in(kOf500, opcode);
  return generation == kCreate ? length_in(kOfCreate, opcode) : std::nullopt;
}

int whole_speed(double value) {
  return static_cast<int>(std::lround(value));
}

}  // namespace

int speed_of_line(RobotGeneration generation) {
  return generation == k500 ? 115200 : 57600;
}

double half_axle(RobotGeneration generation) {
  return generation == k500 ? 0.235 / 2 : 0.258 / 2;
}

RawBytes encode_command(Opcode opcode, std::initializer_list<int> data) {
  RawBytes bytes;
  put_u8(bytes, opcode);
  for (const int value : data) put_u8(bytes, value);
  return bytes;
}

void OiCommandReader::add(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<OiCommand> OiCommandReader::next() {
  while (!bytes_.empty()) {
    const std::optional<std::size_t> length = data_length();
    if (length && *length >= bytes_.size()) return std::nullopt;
    const auto begin = bytes_.begin() + 1;
    if (!length) {
      bytes_.erase(bytes_.begin(), begin);
      continue;
    }
    const auto end = begin + static_cast<std::ptrdiff_t>(*length);
    OiCommand command{u8(bytes_, 0), RawBytes(begin, end)};
    bytes_.erase(bytes_.begin(), end);
    return command;
  }
  return std::nullopt;
}

std::optional<std::size_t> OiCommandReader::data_length() const {
  const std::uint8_t opcode = u8(bytes_, 0);
  if (opcode < kFirstOpcode) return std::nullopt;
  const bool is_list = opcode == kStream || opcode == kQueryList;
  if (opcode == kSong) {
    if (bytes_.size() < 3) return 2;
    const std::size_t notes = u8(bytes_, 2);
    return notes > kMostNotes ? std::nullopt : std::optional(2 + 2 * notes);
  }
  if ((is_list && generation_ != kSci) || (opcode == kScript && generation_ == kCreate)) {
    if (bytes_.size() < 2) return 1;
    const std::size_t count = u8(bytes_, 1);
    return count > kMostOfScript ? std::nullopt : std::optional(1 + count);
  }
  return fixed_length(generation_, opcode);
}

OiDrive drive_of(double speed, double turn_rate, double half_axle) {
  constexpr double kLeastArc = 1.5,
                   kMostArc = 2.0 * OiDrive::kMostRadius;         // nearer to a turn on the spot, to a line
  double v = 1000 * speed, wheel = 1000 * half_axle * turn_rate;  // mm/s
  const double fastest = std::fabs(v) + std::fabs(wheel);
  if (fastest > OiDrive::kMostSpeed) {
    v *= OiDrive::kMostSpeed / fastest;
    wheel *= OiDrive::kMostSpeed / fastest;
  }
  if (std::fabs(v) * 1000 * half_axle >= kMostArc * std::fabs(wheel))
    return {whole_speed(v), OiDrive::kStraight};
  const double radius = v * 1000 * half_axle / wheel;
  if (std::fabs(radius) < kLeastArc) return {whole_speed(std::fabs(wheel)), wheel > 0 ? 1 : -1};
  constexpr double kMost = OiDrive::kMostRadius;
  return {whole_speed(v), whole_speed(std::clamp(radius, -kMost, kMost))};
}

OiWheels wheels_of(const OiDrive& drive, double half_axle) {
  const double v = drive.velocity, h = 1000 * half_axle;
  OiWheels wheels{v, v};
  if (drive.radius == 1 || drive.radius == -1) {
    wheels = {v * drive.radius, -v * drive.radius};
  } else if (drive.radius != 0 && drive.radius != OiDrive::kStraight &&
             drive.radius != OiDrive::kStraightToo) {
    wheels = {v * (1 + h / drive.radius), v * (1 - h / drive.radius)};
  }
  constexpr double kMost = OiDrive::kMostSpeed;
  return {std::clamp(wheels.right, -kMost, kMost), std::clamp(wheels.left, -kMost, kMost)};
}

}  // namespace playhouse::drivers::irobot
