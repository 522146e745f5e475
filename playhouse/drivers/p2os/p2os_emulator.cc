#include "playhouse/drivers/p2os/p2os_emulator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "playhouse/base/in_quotes.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;

namespace {

constexpr double kRadPerDegree = std::numbers::pi / 180;
constexpr std::size_t kNameLetters = 19;   // as hosts have room for
constexpr double kCycle = 0.1;             // s between two packets
constexpr std::size_t kSonarsOfCycle = 4;  // that fire
constexpr int kCounterBits = 0x7FFF;       // of x and y
constexpr std::uint16_t kMotorsFlag = 1, kSonarsFlag = 2;

constexpr DeviceText kP2osEmulatorUses[] = {
    {"position2d", {}, HowMany::kOne, "the robot's wheels"},
    {"sonar", {}, HowMany::kOneOrNone, "in the order of the robot's own"},
    {"power", {}, HowMany::kOneOrNone},
    {"bumper", {}, HowMany::kOneOrNone, "those in front from left to right, then those behind"},
    {"gripper", {}, HowMany::kOneOrNone},
    {"dio", {}, HowMany::kOneOrNone},
};

P2osEmulatorOptions p2os_emulator_options(SectionFields& fields) {
  P2osEmulatorOptions options;
  const int baud = fields.integer(
      {"baud", "Of the robot's line; a host at another speed is not understood.", "baud"}, 9600, 50, 4000000);
  options.place = read_emulator_place(fields, {.baud = baud});
  std::string model =
      fields.text({"robot", "Subclass that it tells, which its units follow from.", {}, "p3dx-sh"});
  if (model.empty()) model = "p3dx-sh";
  options.model = p2os::find_robot_model(model);
  fields.expect(options.model != nullptr, "robot",
                "is a subclass such as p3dx-sh, p3at-sh or amigo-sh, not " + in_quotes(model));
  if (options.model == nullptr) options.model = p2os::robot_models().data();
  options.robot_name = fields.text({"robot_name", "Name that it tells.", {}, "Playhouse"});
  if (options.robot_name.empty()) options.robot_name = "Playhouse";
  fields.expect(options.robot_name.size() <= kNameLetters, "robot_name", "has 19 letters at most");
  options.watchdog =
      fields.number({"watchdog", "It stops when the host has said nothing for so long.", "s"}, 2, 0.1);
  fields.expect(options.watchdog <= 3600, "watchdog", "is 3600 s at most");
  options.needs_motors_on = fields.flag(
      {"needs_motors_on", "0: it drives without ENABLE, as hosts expect that do not send it."}, true);
  return options;
}

std::int16_t units(double value, double unit) {
  return static_cast<std::int16_t>(std::lround(std::clamp(value / unit, -32767.0, 32767.0)));
}

/// Of a counter that wraps.
std::uint16_t counts(double metres, double unit) {
  constexpr double kMost = 1e9;
  const auto whole = std::llround(std::clamp(1000 * metres / unit, -kMost, kMost));
  return static_cast<std::uint16_t>(whole & kCounterBits);
}

}  // namespace

P2osEmulator::P2osEmulator(std::string name, Site& site, const P2osEmulatorOptions& options, UsedDevices used)
    : Emulator(std::move(name), site, options.place, std::move(used)), options_(options) {}

void P2osEmulator::line_received(std::span<const std::byte> bytes) {
  reader_.add(bytes);
  while (const std::optional<RawBytes> data = reader_.next())
    if (const auto command = p2os::read_command(*data)) take(*command);
}

void P2osEmulator::take(const p2os::ReadCommand& command) {
  if (!is_open_) return static_cast<void>(take_sync(command));
  watchdog_ = after(options_.watchdog, [this] { drive(0, 0); });
  obey(command);
}

/// Each is echoed; OPEN has the number of SYNC1, after all three.
bool P2osEmulator::take_sync(const p2os::ReadCommand& command) {
  if (synced_ == 3 && command.number == p2os::kOpen) {
    open();
    return true;
  }
  if (command.number == p2os::kSync0) synced_ = 0;
  if (command.number != synced_ || synced_ == 3) return false;
  ++synced_;
  send(command.number == p2os::kSync2
           ? p2os::encode_names({options_.robot_name, "Pioneer", std::string(options_.model->subclass)})
           : p2os::encode_command(command.number));
  return true;
}

void P2osEmulator::open() {
  is_open_ = true;
  motors_on_ = !options_.needs_motors_on;
  sonars_on_ = true;
  next_sonar_ = 0;
  set_origin();
  cycle();
}

void P2osEmulator::close() {
  drive(0, 0);
  is_open_ = false;
  synced_ = 0;
  reader_.clear();
  cycle_.reset();
  watchdog_.reset();
}

void P2osEmulator::cycle() {
  if (!is_told_) drive(speed_, turn_rate_);  // its devices were not open yet
  send(p2os::encode_sip(sip()));
  cycle_ = after(kCycle, [this] { cycle(); });
}

void P2osEmulator::obey(const p2os::ReadCommand& command) {
  const int value = command.argument.value_or(0);
  switch (command.number) {
    case p2os::kClose:
      return close();
    case p2os::kEnable:
      motors_on_ = value != 0 || !options_.needs_motors_on;
      return drive(0, 0);
    case p2os::kSonar:
      sonars_on_ = value != 0;
      return;
    case p2os::kSetOrigin:
      return set_origin();
    case p2os::kVelocity:
      return drive(value / 1000.0, turn_rate_);
    case p2os::kTurnRate:
      return drive(speed_, value * kRadPerDegree);
    case p2os::kWheels:
      return drive_wheels(static_cast<std::int8_t>(command.low), static_cast<std::int8_t>(command.high));
    case p2os::kStop:
    case p2os::kEmergencyStop:
      return drive(0, 0);
    case p2os::kGripper:
      return grip(value);
    case p2os::kDigitalOut:
      outputs_ = static_cast<std::uint8_t>((outputs_ & ~command.high) | (command.low & command.high));
      command_device(kDio, wire::dio::kCmdValues, wire::dio::Cmd{8, outputs_});
      return;
    default:  // as the robot does with what it does not know
      return;
  }
}

void P2osEmulator::drive_wheels(std::int8_t right, std::int8_t left) {
  const double unit = options_.model->wheels_unit;  // mm/s
  drive((right + left) * unit / 2000, (right - left) * unit * options_.model->wheel_factor / 2);
}

void P2osEmulator::drive(double speed, double turn_rate) {
  speed_ = motors_on_ ? speed : 0;
  turn_rate_ = motors_on_ ? turn_rate : 0;
  is_told_ = command_device(kWheels, p2d::kCmdVel, p2d::CmdVel{{speed_, 0, turn_rate_}, motors_on_});
}

void P2osEmulator::set_origin() {
  X_OS_ = pose_of(wheels_.value().pos);
}

void P2osEmulator::grip(int action) {
  namespace gripper = wire::gripper;
  constexpr std::pair<int, std::uint8_t> kCommands[] = {
      {p2os::kGripOpen, gripper::kCmdOpen},   {p2os::kGripClose, gripper::kCmdClose},
      {p2os::kGripStop, gripper::kCmdStop},   {p2os::kGripHalt, gripper::kCmdStop},
      {p2os::kGripStore, gripper::kCmdStore}, {p2os::kGripDeploy, gripper::kCmdRetrieve},
  };
  for (const auto& [number, subtype] : kCommands)
    if (action == number) bare_command(kGripper, subtype);
}

p2os::Sip P2osEmulator::sip() {
  const p2os::RobotModel& model = *options_.model;
  const p2d::Data& wheels = wheels_.value();
  const geom::Pose X = geom::compose(geom::inverse(X_OS_), pose_of(wheels.pos));
  const double speed = 1000 * wheels.vel.px, difference = wheels.vel.pa / model.wheel_factor;  // mm/s
  p2os::Sip sip{.sonars = {}};
  sip.type = speed != 0 || difference != 0 ? p2os::kMoving : p2os::kStopped;
  sip.x = counts(X.x, model.distance_unit);
  sip.y = counts(X.y, model.distance_unit);
  sip.heading = units(X.a, model.angle_unit);
  sip.left = units(speed - difference, model.speed_unit);
  sip.right = units(speed + difference, model.speed_unit);
  const double volts = uses(kPower) ? static_cast<double>(battery_.value().volts) : 12.4;
  sip.battery = static_cast<std::uint8_t>(std::lround(std::clamp(10 * volts, 0.0, 255.0)));
  sip.left_stall = sip.right_stall = wheels.stall != 0 ? 1 : 0;
  sip.flags = static_cast<std::uint16_t>((motors_on_ ? kMotorsFlag : 0) | (sonars_on_ ? kSonarsFlag : 0));
  if (sonars_on_) add_sonars(sip);
  add_bumpers(sip);
  // The makers' tables differ in which of the two bytes is the gripper's, and hosts read either.
  sip.gripper = sip.analog_port = gripper_bits();
  const std::uint32_t beams = gripper_.value().beams;
  sip.digital_in = uses(kDio) ? static_cast<std::uint8_t>(inputs_.value().bits)
                              : static_cast<std::uint8_t>(0x0F & ~(beams & 0x0C));
  return sip;
}

void P2osEmulator::add_sonars(p2os::Sip& sip) {
  const std::vector<float>& ranges = ranges_.value().ranges;
  const std::size_t count = std::min(ranges.size(), static_cast<std::size_t>(options_.model->sonars));
  for (std::size_t i = 0; i < std::min(count, kSonarsOfCycle); ++i, next_sonar_ = (next_sonar_ + 1) % count) {
    next_sonar_ %= count;
    const auto millimetres = static_cast<double>(1000 * ranges[next_sonar_]);
    sip.sonars.push_back({static_cast<std::uint8_t>(next_sonar_),
                          static_cast<std::uint16_t>(std::lround(
                              std::clamp(millimetres / options_.model->range_unit, 0.0, 65535.0)))});
  }
}

void P2osEmulator::add_bumpers(p2os::Sip& sip) {
  const std::vector<std::uint8_t>& pressed = bumpers_.value().bumpers;
  std::size_t next = 0;
  const auto bits_of = [&](int count) {
    int bits = 0;
    for (int bumper = count; bumper > 0 && next < pressed.size(); --bumper, ++next)
      if (pressed[next] != 0) bits |= 1 << bumper;
    return static_cast<std::uint8_t>(bits);
  };
  sip.right_stall |= bits_of(options_.model->front_bumpers);
  sip.left_stall |= bits_of(options_.model->rear_bumpers);
}

std::uint8_t P2osEmulator::gripper_bits() {
  namespace gripper = wire::gripper;
  if (!uses(kGripper)) return 0;
  switch (gripper_.value().state) {
    case gripper::kStateOpen:
      return p2os::kIsOpen;
    case gripper::kStateClosed:
      return p2os::kIsClosed;
    case gripper::kStateMoving:
      return p2os::kGripMoves;
    default:
      return 0;
  }
}

constinit const DriverDefinition kP2osEmulatorDriver{
    .name = "p2os_emulator",
    .doc = "A Pioneer's controller at the far end of a line, for a robot of this server.",
    .provides = {},
    .uses = kP2osEmulatorUses,
    .read_options = reading<p2os_emulator_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_emulator<P2osEmulator>(section, site, p2os_emulator_options, kP2osEmulatorUses);
    },
};

}  // namespace playhouse::drivers
