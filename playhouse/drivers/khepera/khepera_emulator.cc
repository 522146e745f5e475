#include "playhouse/drivers/khepera/khepera_emulator.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace playhouse::drivers {

namespace p2d = wire::position2d;

namespace {

constexpr double kKheperaCycle = 0.02;  // s
constexpr double kApproach = 20;        // units of speed, to a position
constexpr double kThere = 15;           // pulses
constexpr std::int64_t kAmbient = 450;  // light of a room

constexpr DeviceText kKheperaEmulatorUses[] = {
    {"position2d", {}, HowMany::kOne, "the robot's wheels"},
    {"ir", {}, HowMany::kOneOrNone, "its eight sensors, clockwise from the left"},
};

KheperaEmulatorOptions khepera_emulator_options(SectionFields& fields) {
  KheperaEmulatorOptions options;
  const int baud =
      fields.integer({"baud", "Of the robot's line; a host at another speed is not understood.", "baud"},
                     38400, 50, 4000000);
  options.place = read_emulator_place(fields, {.baud = baud});
  options.axle = fields.length({"axle", "Between the wheels."}, khepera::kAxle, 0.001);
  return options;
}

/// Numbers of a command.
struct KheperaCommand {
  char letter;
  std::size_t numbers;
};
constexpr KheperaCommand kKheperaCommands[] = {{'A', 3}, {'B', 0}, {'C', 2}, {'D', 2}, {'E', 0}, {'F', 3},
                                               {'G', 2}, {'H', 0}, {'I', 1}, {'J', 4}, {'K', 0}, {'L', 2},
                                               {'N', 0}, {'O', 0}, {'P', 2}, {'R', 1}, {'W', 2}};

/// Of a counter of 32 bits, which wraps.
std::int64_t counted(double pulses) {
  constexpr double kMost = 1e15;
  return static_cast<std::int32_t>(std::llround(std::clamp(pulses, -kMost, kMost)) & 0xFFFFFFFF);
}

}  // namespace

KheperaEmulator::KheperaEmulator(std::string name, Site& site, const KheperaEmulatorOptions& options,
                                 UsedDevices used)
    : Emulator(std::move(name), site, options.place, std::move(used)), options_(options) {}

void KheperaEmulator::line_received(std::span<const std::byte> bytes) {
  if (cycle_ == nullptr) cycle();
  reader_.add(bytes);
  while (const std::optional<khepera::KheperaLine> line = reader_.next()) obey(*line);
}

void KheperaEmulator::answer(char letter, std::initializer_list<std::int64_t> numbers) {
  const std::string text = khepera::encode_answer(letter, numbers);
  send(std::as_bytes(std::span(text)));
}

void KheperaEmulator::refuse(const std::string& why) {
  const std::string text = "z," + why + "\r\n";
  send(std::as_bytes(std::span(text)));
}

void KheperaEmulator::obey(const khepera::KheperaLine& line) {
  const auto* const known = std::ranges::find(kKheperaCommands, line.letter, &KheperaCommand::letter);
  if (known == std::end(kKheperaCommands)) return refuse("Command not found");
  if (line.numbers.size() != known->numbers) return refuse("Protocol error");
  const auto number = [&](std::size_t at) { return static_cast<double>(line.numbers[at]); };
  switch (line.letter) {
    case 'B': {
      const std::string versions = "b,5.02,5.01\r\n";
      return send(std::as_bytes(std::span(versions)));
    }
    case 'C':
      target_ = WheelPair{number(0), number(1)};
      return answer('c');
    case 'D':
      target_.reset();
      drive(number(0), number(1));
      return answer('d');
    case 'E': {
      const WheelPair now = speeds();
      return answer('e', {std::lround(now.left), std::lround(now.right)});
    }
    case 'G':
      cycle();
      origin_ = {ways_.left - number(0), ways_.right - number(1)};
      return answer('g');
    case 'H': {
      cycle();
      const WheelPair now = counters();
      return answer('h', {counted(now.left), counted(now.right)});
    }
    case 'I':
      return answer('i', {0});
    case 'K': {
      const std::int64_t is_there = target_ ? 0 : 1;
      return answer('k', {is_there, 0, 0, is_there, 0, 0});
    }
    case 'N':
      return tell_sensors();
    case 'O':
      return answer('o', {kAmbient, kAmbient, kAmbient, kAmbient, kAmbient, kAmbient, kAmbient, kAmbient});
    case 'P': {
      constexpr double kMostPower = 255;
      target_.reset();
      drive(number(0) * khepera::kMostSpeedUnits / kMostPower,
            number(1) * khepera::kMostSpeedUnits / kMostPower);
      return answer('p');
    }
    case 'R':
      return answer('r', {0});
    default:  // gains, profiles, lights and the extension bus have no effect
      return answer(static_cast<char>(line.letter + ('a' - 'A')));
  }
}

void KheperaEmulator::drive(double left, double right) {
  constexpr double kMost = khepera::kMostSpeedUnits;
  wanted_ = {std::clamp(left, -kMost, kMost), std::clamp(right, -kMost, kMost)};
  const double unit = khepera::kPulse * khepera::kPulsesPerSecond;  // m/s
  command_device(kWheels, p2d::kCmdVel,
                 p2d::CmdVel{{(wanted_.left + wanted_.right) / 2 * unit, 0,
                              (wanted_.right - wanted_.left) * unit / options_.axle},
                             1});
}

/// Ways are summed up between two questions, too, as arcs.
void KheperaEmulator::cycle() {
  const WheelStep step = steps_.to(pose_of(base_.value().pos));
  const double wheel = step.turn * options_.axle / 2;
  ways_.left += (step.distance - wheel) / khepera::kPulse;
  ways_.right += (step.distance + wheel) / khepera::kPulse;
  if (target_) approach();
  cycle_ = after(kKheperaCycle, [this] { cycle(); });
}

void KheperaEmulator::approach() {
  const WheelPair now = counters();
  const auto towards = [](double from, double to) {
    if (std::fabs(to - from) <= kThere) return 0.0;
    return std::clamp((to - from) / kThere, -kApproach, kApproach);
  };
  const WheelPair next{towards(now.left, target_->left), towards(now.right, target_->right)};
  drive(next.left, next.right);
  if (next.left == 0 && next.right == 0) target_.reset();
}

KheperaEmulator::WheelPair KheperaEmulator::counters() const {
  return {ways_.left - origin_.left, ways_.right - origin_.right};
}

KheperaEmulator::WheelPair KheperaEmulator::speeds() {
  const wire::Pose2d& now = base_.value().vel;
  const double unit = khepera::kPulse * khepera::kPulsesPerSecond, wheel = now.pa * options_.axle / 2;
  const auto units = [unit](double speed) {
    constexpr double kMost = khepera::kMostSpeedUnits;
    return speed > -kMost * unit ? std::min(speed / unit, kMost) : -kMost;
  };
  return {units(now.px - wheel), units(now.px + wheel)};
}

void KheperaEmulator::tell_sensors() {
  const std::vector<float>& ranges = ranges_.value().ranges;
  std::array<std::int64_t, khepera::kSensors> light{};
  for (std::size_t sensor = 0; sensor < std::min(ranges.size(), light.size()); ++sensor)
    light[sensor] = khepera::light_at(static_cast<double>(ranges[sensor]));
  answer('n', {light[0], light[1], light[2], light[3], light[4], light[5], light[6], light[7]});
}

constinit const DriverDefinition kKheperaEmulatorDriver{
    .name = "khepera_emulator",
    .doc = "A Khepera at the far end of a line, for a robot of this server.",
    .provides = {},
    .uses = kKheperaEmulatorUses,
    .read_options = reading<khepera_emulator_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_emulator<KheperaEmulator>(section, site, khepera_emulator_options, kKheperaEmulatorUses);
    },
};

}  // namespace playhouse::drivers
