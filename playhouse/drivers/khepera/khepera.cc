#include "playhouse/drivers/khepera/khepera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "playhouse/drivers/shapes.h"
#include "playhouse/wire/generated/ir.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;

namespace {

constexpr double kGreetingSeconds = 0.1, kKheperaPatience = 0.1, kBetweenCommands = 0.01;  // s
constexpr int kMostGreetings = 10, kMostLostLines = 20;
constexpr double kKheperaBody = 0.057;      // m, across
constexpr std::int64_t kMostPulses = 5000;  // from one reading to the next; more is a fault of the line
constexpr std::string_view kAskedInTurn = "HEN";

constexpr DeviceText kKheperaProvides[] = {
    {"position2d", {}, HowMany::kSomeOfThese, "its wheels and odometry"},
    {"ir",
     {},
     HowMany::kSomeOfThese,
     "its eight sensors, clockwise from the left; as voltages what they measure, 0 to 1023"},
};

KheperaOptions khepera_options(SectionFields& fields) {
  KheperaOptions options;
  const int baud = fields.integer({"baud", "Of the robot, as it is set: 9600, 19200 or 38400.", "baud"},
                                  38400, 9600, 38400);
  fields.expect(baud == 9600 || baud == 19200 || baud == 38400, "baud", "is 9600, 19200 or 38400");
  const LinePlace place = read_line_place(
      fields, {"port", "Serial port of the robot, or a TCP port that passes its bytes on: tcp:lab:8101."},
      "/dev/ttyUSB0", {.baud = baud});
  options.hardware = read_hardware_options(fields, place, true);
  options.scale =
      fields.number({"scale_factor",
                     "By which all lengths are multiplied, those of commands divided; the original has 10."},
                    1, 0.001);
  options.pulse =
      fields.number({"encoder_res", "Way of a wheel in a pulse of its counter.", "mm"}, 0.08, 0.0001) / 1000;
  options.axle = fields.length({"axle", "Between the wheels."}, khepera::kAxle, 0.001);
  options.calib_a =
      fields.number({"ir_calib_a", "A range in mm is a * value ^ b; 0: that of white paper."}, 0);
  options.calib_b = fields.number({"ir_calib_b", "The b of that."}, -0.1238, SectionFields::kAnyNumber);
  return options;
}

}  // namespace

Khepera::Khepera(std::string name, Site& site, const KheperaOptions& options)
    : WheeledDriver(std::move(name), site, options.hardware, kWheels), options_(options) {
  on_question(kIr, wire::ir::kReqPose, [this]() -> AnswerBody {
    wire::ir::Pose poses;
    for (const khepera::KheperaSensor& sensor : khepera::sensors())
      poses.poses.push_back({sensor.x / 1000 * options_.scale, sensor.y / 1000 * options_.scale, 0, 0, 0,
                             sensor.direction * std::numbers::pi / 180});
    return wire::encode(poses);
  });
}

// --- one command at a time

/// What the robot says to the empty line, as when it is switched on, is dropped.
void Khepera::began() {
  const std::string empty = "\r\n";
  send(std::as_bytes(std::span(empty)));
  wait_ = after(kGreetingSeconds, [this] { greet(); });
}

void Khepera::greet() {
  line().drop_input();
  reader_.clear();
  say('E');
}

void Khepera::say(char letter, std::initializer_list<std::int64_t> numbers) {
  out_ = letter;
  const std::string text = khepera::encode_line(letter, numbers);
  send(std::as_bytes(std::span(text)));
  patience_ = after(kKheperaPatience, [this] { lose_answer(); });
}

void Khepera::lose_answer() {
  out_ = 0;
  if (++lost_ == (runs_ ? kMostLostLines : kMostGreetings)) return give_up("the robot does not answer");
  if (runs_)
    ask_next();
  else
    greet();
}

void Khepera::ask_next() {
  if (out_ != 0) return;
  if (wanted_) {
    const WheelUnits units = *std::exchange(wanted_, std::nullopt);
    return say('D', {units.left, units.right});
  }
  char next = kAskedInTurn[turn_++ % kAskedInTurn.size()];
  if (next == 'N' && !is_open(kIr)) next = kAskedInTurn[turn_++ % kAskedInTurn.size()];
  say(next);
}

void Khepera::received(std::span<const std::byte> bytes) {
  reader_.add(bytes);
  while (const std::optional<khepera::KheperaLine> line = reader_.next()) take(*line);
}

/// An answer that came too late is none to the command that is out.
void Khepera::take(const khepera::KheperaLine& line) {
  if (out_ == 0 || (line.letter != out_ + ('a' - 'A') && line.letter != 'z')) return;
  if (std::exchange(runs_, true) == false) {
    wanted_ = WheelUnits{};
    started();
  }
  lost_ = 0;
  out_ = 0;
  patience_.reset();
  if (line.letter == 'h') take_counts(line);
  if (line.letter == 'e') take_speeds(line);
  if (line.letter == 'n') take_light(line);
  wait_ = after(kBetweenCommands, [this] { ask_next(); });
}

void Khepera::closed(std::size_t device) {
  if (device == kWheels && !is_open(kWheels)) stop_wheels();
}

void Khepera::ending() {
  const std::string stop = khepera::encode_line('D', {0, 0});
  if (runs_) send(std::as_bytes(std::span(stop)));
}

void Khepera::forgot() {
  reader_.clear();
  out_ = 0;
  runs_ = false;
  lost_ = 0;
  wanted_.reset();
  counts_.reset();
  speed_ = {};
  wait_.reset();
  patience_.reset();
}

// --- what the robot tells

/// Counters have 32 bits. A jump is a damaged number, or a robot that was switched off.
void Khepera::take_counts(const khepera::KheperaLine& line) {
  if (line.numbers.size() != 2) return;
  const WheelCounts now{line.numbers[0], line.numbers[1]};
  const WheelCounts before = std::exchange(counts_, now).value_or(now);
  const auto pulses = [](std::int64_t to, std::int64_t from) -> std::int64_t {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from));
  };
  const std::int64_t left = pulses(now.left, before.left), right = pulses(now.right, before.right);
  if (std::abs(left) > kMostPulses || std::abs(right) > kMostPulses) return;
  odometry_.add({static_cast<double>(left + right) / 2 * options_.pulse * options_.scale,
                 static_cast<double>(right - left) * options_.pulse / options_.axle});
  publish(kWheels, p2d::kDataState, p2d::Data{pose2d(odometry_.pose()), pose2d(speed_), 0});
}

void Khepera::take_speeds(const khepera::KheperaLine& line) {
  if (line.numbers.size() != 2) return;
  const double unit = khepera::kPulsesPerSecond * options_.pulse;
  const double left = static_cast<double>(line.numbers[0]) * unit,
               right = static_cast<double>(line.numbers[1]) * unit;
  speed_ = {(left + right) / 2 * options_.scale, 0, 0, (right - left) / options_.axle};
}

void Khepera::take_light(const khepera::KheperaLine& line) {
  const auto is_light = [](std::int64_t value) { return value >= 0 && value <= khepera::kMostLight; };
  if (line.numbers.size() != khepera::kSensors || !std::ranges::all_of(line.numbers, is_light)) return;
  wire::ir::Data data;
  for (const std::int64_t light : line.numbers) {
    data.voltages.push_back(static_cast<float>(light));
    data.ranges.push_back(static_cast<float>(options_.scale * range_of(static_cast<double>(light))));
  }
  publish(kIr, wire::ir::kDataRanges, data);
}

double Khepera::range_of(double light) const {
  if (options_.calib_a == 0) return khepera::range_of(light);
  return options_.calib_a * std::pow(std::max(light, 1.0), options_.calib_b) / 1000;
}

// --- what clients command

p2d::Geom Khepera::geometry() const {
  const double size = kKheperaBody * options_.scale;
  return {{}, {size, size, 0}};
}

/// Too fast for a wheel: both are slower, on the same curve.
void Khepera::drive(const geom::Twist& wanted) {
  if (!runs_) return;
  const double unit = khepera::kPulsesPerSecond * options_.pulse;  // m/s
  const double middle = wanted.x / options_.scale / unit, wheel = wanted.a * options_.axle / 2 / unit;
  const double fastest = std::fabs(middle) + std::fabs(wheel);
  const double scale = fastest > khepera::kMostSpeedUnits ? khepera::kMostSpeedUnits / fastest : 1;
  wanted_ = WheelUnits{static_cast<int>(std::lround(scale * (middle - wheel))),
                       static_cast<int>(std::lround(scale * (middle + wheel)))};
}

constinit const DriverDefinition kKheperaDriver{
    .name = "khepera",
    .doc = "K-Team's Khepera and Khepera II.",
    .provides = kKheperaProvides,
    .read_options = reading<khepera_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_hardware<Khepera>(section, site, khepera_options, kKheperaProvides);
    },
};

}  // namespace playhouse::drivers
