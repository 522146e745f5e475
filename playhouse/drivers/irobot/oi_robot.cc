#include "playhouse/drivers/irobot/oi_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "playhouse/drivers/shapes.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/gripper.h"
#include "playhouse/wire/generated/ir.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/power.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;

namespace {

using irobot::OiSensors;

constexpr double kModeSeconds = 0.02,
                 kFirstSeconds = 0.1;    // after a change of the mode, and before the first question
constexpr double kOiCycle = 0.1;         // s between two questions
constexpr double kSettleSeconds = 0.02;  // nothing follows an answer
constexpr double kOiSilence = 3;         // s without an answer
constexpr double kBodyDiameter = 0.33;   // m
constexpr int kAllBrushes = irobot::kSideBrush | irobot::kVacuum | irobot::kMainBrush;
constexpr int kDrops = irobot::kDropRight | irobot::kDropLeft | irobot::kDropCaster;
constexpr std::uint8_t kCommandPlay = 0, kCommandSong = 1, kCommandLeds = 2, kCommandDemo = 3;  // of opaque
constexpr std::size_t kOpaqueLeds = 8;                                                          // bytes

bool is_on(int bits, int bit) {
  return (bits & bit) != 0;
}

/// Notes are two bytes each, as many as it says and as a robot takes.
bool is_song(std::span<const std::byte> opaque) {
  if (opaque.size() < 3) return false;
  const std::size_t notes = u8(opaque, 2);
  return notes <= irobot::kMostNotes && opaque.size() == 3 + 2 * notes;
}

bool has_cliff(const OiSensors& sensors) {
  return std::any_of(&sensors[irobot::kCliffLeft], &sensors[irobot::kCliffRight] + 1,
                     [](int cliff) { return cliff != 0; });
}

}  // namespace

void read_oi_options(SectionFields& fields, OiRobotOptions& options) {
  const LinePlace place = read_line_place(
      fields, {"port", "Serial port of the robot, or a TCP port that passes its bytes on: tcp:lab:8101."},
      "/dev/ttyS0", {.baud = irobot::speed_of_line(options.generation)});
  options.hardware = read_hardware_options(fields, place, true);
  options.is_safe = fields.flag({"safe", "1: it stops by itself at cliffs and when a wheel drops."}, true);
  options.locks_bump =
      fields.flag({"bumplock", "1: it stops when a bumper is pressed, and then goes back alone."}, false);
}

OiRobot::OiRobot(std::string name, Site& site, const OiRobotOptions& options)
    : WheeledDriver(std::move(name), site, options.hardware, kWheels), options_(options) {
  register_others();
}

// --- start-up, and questions

void OiRobot::began() {
  patience_ = after(kOiSilence, [this] {
    give_up(fmt::format("no sensor packet came: is the robot on, and at {} baud?",
                        irobot::speed_of_line(options_.generation)));
  });
  std::vector<irobot::Opcode> commands = commands_of_mode();
  commands.insert(commands.begin(), irobot::kStart);
  start_up(std::move(commands));
}

/// The SCI has the full mode behind the safe one.
std::vector<irobot::Opcode> OiRobot::commands_of_mode() const {
  if (options_.generation == irobot::RobotGeneration::kCreate)
    return {options_.is_safe ? irobot::kSafe : irobot::kFull};
  if (options_.is_safe) return {irobot::kControl};
  return {irobot::kControl, irobot::kFull};
}

void OiRobot::start_up(std::vector<irobot::Opcode> commands) {
  send(irobot::encode_command(commands.front()));
  commands.erase(commands.begin());
  if (commands.empty()) {
    cycle_ = after(kFirstSeconds, [this] {
      runs_ = true;
      wanted_.allow();
      started();
      ask();
    });
  } else {
    cycle_ = after(kModeSeconds, [this, commands = std::move(commands)] { start_up(commands); });
  }
}

void OiRobot::ask() {
  answer_.clear();
  settle_.reset();
  line().drop_input();
  wanted_.allow();
  send_wanted();
  send(irobot::encode_command(irobot::kSensors, {irobot::kEarlyGroup}));
  if (cycles_ > 0) ++cycles_;
  cycle_ = after(kOiCycle, [this] { ask(); });
}

void OiRobot::received(std::span<const std::byte> bytes) {
  if (answer_.size() <= irobot::kEarlyBytes) answer_.insert(answer_.end(), bytes.begin(), bytes.end());
  settle_.reset();
  if (answer_.size() == irobot::kEarlyBytes) settle_ = after(kSettleSeconds, [this] { judge(); });
}

void OiRobot::judge() {
  const auto sensors = irobot::read_early_group(answer_);
  answer_.clear();
  if (!sensors || !runs_) return;
  patience_ = after(kOiSilence, [this] { give_up("the robot is silent"); });
  take(*sensors);
}

void OiRobot::closed(std::size_t device) {
  if (is_open(device)) return;
  if (device == kWheels) stop_wheels();
  if (device == kGripper && brushes_on_) set_brushes(false);
}

void OiRobot::ending() {
  if (!runs_) return;
  stop_wheels();
  if (brushes_on_) set_brushes(false);
}

void OiRobot::forgot() {
  runs_ = is_bumped_ = has_tripped_ = brushes_on_ = false;
  cycles_ = 0;
  wanted_.clear();
  answer_.clear();
  cycle_.reset();
  settle_.reset();
  patience_.reset();
}

// --- what the robot tells

void OiRobot::take(const OiSensors& sensors) {
  watch_mode(sensors);
  lock_bump(sensors);
  publish_pose(sensors);
  publish_power(sensors);
  publish_switches(sensors);
  publish_gripper(sensors);
  cycles_ = 1;
}

void OiRobot::watch_mode(const OiSensors& sensors) {
  const bool trips = has_cliff(sensors) || is_on(sensors[irobot::kBumpsAndDrops], kDrops);
  if (options_.is_safe && std::exchange(has_tripped_, trips) && !trips)
    for (const irobot::Opcode command : commands_of_mode()) send(irobot::encode_command(command));
}

void OiRobot::lock_bump(const OiSensors& sensors) {
  const bool bumps = is_on(sensors[irobot::kBumpsAndDrops], irobot::kBumpLeft | irobot::kBumpRight);
  if (!std::exchange(is_bumped_, options_.locks_bump && bumps) && is_bumped_) stop_wheels();
}

/// What the robot counted before the first question, or while the line was lost, is left out.
void OiRobot::publish_pose(const OiSensors& sensors) {
  double distance = 0, turn = 0, seconds = kOiCycle;
  if (cycles_ > 0) {
    distance = sensors[irobot::kDistance] / 1000.0;
    turn = irobot::radians_of(options_.generation, sensors[irobot::kAngle]);
    seconds = kOiCycle * (cycles_ - 1);
  }
  odometry_.add({distance, turn});
  const bool stalls =
      is_bumped_ || is_on(sensors[irobot::kOvercurrents], irobot::kWheelLeft | irobot::kWheelRight);
  publish(kWheels, p2d::kDataState,
          p2d::Data{pose2d(odometry_.pose()), {distance / seconds, 0, turn / seconds}, stalls});
}

void OiRobot::publish_power(const OiSensors& sensors) {
  namespace pw = wire::power;
  constexpr double kCoulombs = 3.6;  // in 1 mAh
  constexpr int kFirstCharges = 1, kLastCharges = 3;
  const double volts = sensors[irobot::kVoltage] / 1000.0, charge = sensors[irobot::kCharge];
  const int state = sensors[irobot::kCharging], capacity = sensors[irobot::kCapacity];
  publish(kPower, pw::kDataState,
          pw::Data{.valid = pw::kMaskVolts | pw::kMaskWatts | pw::kMaskJoules | pw::kMaskPercent |
                            pw::kMaskCharging,
                   .volts = static_cast<float>(volts),
                   .percent = static_cast<float>(capacity > 0 ? 100 * charge / capacity : 0),
                   .joules = static_cast<float>(charge * kCoulombs * volts),
                   .watts = static_cast<float>(-volts * sensors[irobot::kCurrent] / 1000),
                   .charging = state >= kFirstCharges && state <= kLastCharges});
}

void OiRobot::publish_switches(const OiSensors& sensors) {
  const int bumps = sensors[irobot::kBumpsAndDrops];
  publish(kBumper, wire::bumper::kDataState,
          wire::bumper::Data{{is_on(bumps, irobot::kBumpLeft), is_on(bumps, irobot::kBumpRight)}});
  wire::ir::Data switches;
  for (std::size_t number = irobot::kWall; number <= irobot::kVirtualWall; ++number)
    switches.ranges.push_back(static_cast<float>(sensors[number]));
  for (const int value : {sensors[irobot::kDirtRight], sensors[irobot::kDirtLeft], bumps >> 4 & 1,
                          bumps >> 3 & 1, bumps >> 2 & 1})
    switches.ranges.push_back(static_cast<float>(value));
  publish(kIr, wire::ir::kDataRanges, switches);
  wire::opaque::Data buttons;
  constexpr int kOpaqueButtons = 4;
  for (int button = 0; button < kOpaqueButtons; ++button)
    buttons.data.push_back(static_cast<std::uint8_t>(sensors[irobot::kButtons] >> button & 1));
  buttons.data.push_back(static_cast<std::uint8_t>(sensors[irobot::kRemote]));
  publish(kOpaque, wire::opaque::kDataState, buttons);
}

void OiRobot::publish_gripper(const OiSensors& sensors) {
  namespace grip = wire::gripper;
  grip::Data data{.state = static_cast<std::uint8_t>(brushes_on_ ? grip::kStateOpen : grip::kStateClosed)};
  if (is_on(sensors[irobot::kOvercurrents], kAllBrushes)) data.state = grip::kStateError;
  publish(kGripper, grip::kDataState, data);
}

// --- what clients ask

void OiRobot::register_others() {
  on_question(kBumper, wire::bumper::kReqGetGeom, []() -> AnswerBody {
    constexpr double kRadius = kBodyDiameter / 2, kMiddle = std::numbers::pi / 4;
    wire::bumper::Geom geometry;
    for (const double side : {1.0, -1.0})
      geometry.bumper_def.push_back(
          {{kRadius * std::cos(kMiddle), side * kRadius * std::sin(kMiddle), 0, 0, 0, side * kMiddle},
           static_cast<float>(2 * kMiddle * kRadius),
           static_cast<float>(kRadius)});
    return wire::encode(geometry);
  });
  on_bare_command(kGripper, wire::gripper::kCmdOpen, [this] { set_brushes(true); });
  on_bare_command(kGripper, wire::gripper::kCmdClose, [this] { set_brushes(false); });
  on_command<wire::opaque::Data>(kOpaque, wire::opaque::kCmdData, [this](const wire::opaque::Data& wanted) {
    carry_out(std::as_bytes(std::span(wanted.data)));
  });
}

p2d::Geom OiRobot::geometry() const {
  return {{}, {kBodyDiameter, kBodyDiameter, 0}};
}

void OiRobot::drive(const geom::Twist& wanted) {
  wanted_.want(wanted);
  send_wanted();
}

/// At once.
void OiRobot::stop_wheels() {
  if (!runs_) return;
  wanted_.allow();
  drive({});
}

void OiRobot::send_wanted() {
  std::optional<geom::Twist> wanted = wanted_.take();
  if (!wanted) return;
  if (is_bumped_) wanted = geom::Twist{.x = std::min(wanted->x, 0.0)};
  const irobot::OiDrive drive =
      irobot::drive_of(wanted->x, wanted->a, irobot::half_axle(options_.generation));
  send(irobot::encode_command(irobot::kDrive, {drive.velocity >> 8 & 0xFF, drive.velocity & 0xFF,
                                               drive.radius >> 8 & 0xFF, drive.radius & 0xFF}));
}

void OiRobot::set_brushes(bool on) {
  if (!runs_) return;
  brushes_on_ = on;
  send(irobot::encode_command(irobot::kMotors, {on ? kAllBrushes : 0}));
}

void OiRobot::carry_out(std::span<const std::byte> opaque) {
  if (!runs_ || opaque.size() < 2) return;
  const auto at = [&](std::size_t place) { return static_cast<int>(u8(opaque, place)); };
  const bool is_create = options_.generation == irobot::RobotGeneration::kCreate;
  RawBytes command;
  if (at(0) == kCommandPlay) {
    command = irobot::encode_command(irobot::kPlay, {at(1)});
  } else if (at(0) == kCommandSong && is_song(opaque)) {
    command = irobot::encode_command(irobot::kSong);
    command.insert(command.end(), opaque.begin() + 1, opaque.end());
  } else if (at(0) == kCommandLeds && opaque.size() == kOpaqueLeds) {
    const int bits = (at(1) & 1) | (at(2) & 1) << 1 | (at(3) & 1) << 2 | (at(4) & 1) << 3 | (at(5) & 3) << 4;
    command = irobot::encode_command(irobot::kLeds, {bits, at(6), at(7)});
  } else if (at(0) == kCommandDemo && is_create) {
    command = irobot::encode_command(irobot::kMax, {at(1)});
  }
  if (!command.empty()) send(command);
}

}  // namespace playhouse::drivers
