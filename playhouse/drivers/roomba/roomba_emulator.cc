#include "playhouse/drivers/roomba/roomba_emulator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/wire/generated/gripper.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;

namespace {

using irobot::OiSensors;
using irobot::RobotGeneration;

constexpr double kOiPeriod = 0.015;     // s, of the robot's cycle
constexpr double kBodyRadius = 165;     // mm
constexpr double kCount = 0.000444564;  // m, of a wheel of the 500 series: 72 mm across, 508.8 counts a turn
constexpr int kOiCapacity = 2700;       // mAh
constexpr int kCharges = 2;             // value of packet 21
constexpr double kNoteUnit = 1.0 / 64;  // s
constexpr std::size_t kWallPlace = 0, kCliffPlace = 1, kVirtualPlace = 5, kDirtPlace = 6, kDropPlace = 8,
                      kPlaces = 11;  // in ir; sensors of distances are not as many

constexpr DeviceText kRoombaEmulatorUses[] = {
    {"position2d", {}, HowMany::kOne, "the robot's wheels"},
    {"bumper", {}, HowMany::kOneOrNone, "from left to right"},
    {"power", {}, HowMany::kOneOrNone},
    {"ir",
     {},
     HowMany::kOneOrNone,
     "wall, cliffs, virtual wall, dirt and wheel drops as its 11 ranges, as driver roomba has them; another "
     "ir is of no use"},
    {"gripper", {}, HowMany::kOneOrNone, "opened while brushes or vacuum run"},
};

RoombaEmulatorOptions roomba_emulator_options(SectionFields& fields) {
  RoombaEmulatorOptions options;
  const std::string wanted = fields.text(
      {"generation", "Which robot it is: roomba (SCI), roomba500 (its 500 series) or create.", {}, "roomba"});
  constexpr std::pair<std::string_view, RobotGeneration> kNames[] = {{"roomba", RobotGeneration::kSci},
                                                                     {"roomba500", RobotGeneration::k500},
                                                                     {"create", RobotGeneration::kCreate}};
  const auto* const found =
      std::ranges::find(kNames, wanted, &std::pair<std::string_view, RobotGeneration>::first);
  fields.expect(wanted.empty() || found != std::end(kNames), "generation",
                "is roomba, roomba500 or create, not " + in_quotes(wanted));
  if (found != std::end(kNames)) options.generation = found->second;
  int baud = fields.integer(
      {"baud", "Of the robot's line; a host at another speed is not understood; 0: that of the robot.",
       "baud"},
      0, 0, 4000000);
  if (baud == 0) baud = irobot::speed_of_line(options.generation);
  options.place = read_emulator_place(fields, {.baud = baud});
  return options;
}

std::int16_t word(const RawBytes& data, std::size_t at) {
  return s16_be(data, at);
}

int whole_units(double value) {
  constexpr double kMost = 1e9;  // packets cut it further
  return static_cast<int>(std::lround(value > -kMost ? std::min(value, kMost) : -kMost));
}

/// Cut where a reading is not asked for in time; the fraction stays for the next.
int take_whole(double& value) {
  constexpr double kMost = 32767;
  const double whole = std::trunc(std::clamp(value, -kMost, kMost));
  value = std::fabs(value) > kMost ? 0 : value - whole;
  return static_cast<int>(whole);
}

}  // namespace

RoombaEmulator::RoombaEmulator(std::string name, Site& site, const RoombaEmulatorOptions& options,
                               UsedDevices used)
    : Emulator(std::move(name), site, options.place, std::move(used)),
      generation_(options.generation),
      reader_(options.generation) {}

void RoombaEmulator::line_received(std::span<const std::byte> bytes) {
  reader_.add(bytes);
  while (const std::optional<irobot::OiCommand> command = reader_.next()) obey(*command);
}

// --- commands

/// A robot that is off knows START alone.
void RoombaEmulator::obey(const irobot::OiCommand& command) {
  if (mode_ == OiMode::kOff && command.opcode != irobot::kStart) return;
  obey_mode(command.opcode);
  obey_question(command);
  if (command.opcode == irobot::kSong) keep_song(command.data);
  if (mode_ == OiMode::kSafe || mode_ == OiMode::kFull) obey_actuator(command);
}

void RoombaEmulator::obey_mode(std::uint8_t opcode) {
  const bool is_sci = generation_ == RobotGeneration::kSci;
  switch (opcode) {
    case irobot::kStart:
    case irobot::kSpot:
    case irobot::kClean:
    case irobot::kMax:
    case irobot::kDock:
      return set_mode(OiMode::kPassive);
    case irobot::kControl:
      if (!is_sci || mode_ == OiMode::kPassive) set_mode(OiMode::kSafe);
      return;
    case irobot::kSafe:
      if (!is_sci || mode_ == OiMode::kFull) set_mode(OiMode::kSafe);
      return;
    case irobot::kFull:
      if (!is_sci || mode_ == OiMode::kSafe) set_mode(OiMode::kFull);
      return;
    case irobot::kPower:
    case irobot::kStop:
      return turn_off();
    default:
      return;
  }
}

void RoombaEmulator::set_mode(OiMode mode) {
  if (mode_ == OiMode::kOff) cycle();
  if (mode == OiMode::kPassive) {
    drive({});
    bare_command(kBrushes, wire::gripper::kCmdClose);
  }
  mode_ = mode;
}

void RoombaEmulator::turn_off() {
  set_mode(OiMode::kPassive);
  mode_ = OiMode::kOff;
  streams_ = false;
  cycle_.reset();
  playing_.reset();
}

void RoombaEmulator::obey_actuator(const irobot::OiCommand& command) {
  const RawBytes& data = command.data;
  switch (command.opcode) {
    case irobot::kDrive:
      return drive({word(data, 0), word(data, 2)});
    case irobot::kDriveDirect:
      return turn_wheels({static_cast<double>(word(data, 0)), static_cast<double>(word(data, 2))});
    case irobot::kDrivePowers: {
      constexpr double kMostPower = 255;
      const double unit = irobot::OiDrive::kMostSpeed / kMostPower;
      return turn_wheels({word(data, 0) * unit, word(data, 2) * unit});
    }
    case irobot::kMotors:
    case irobot::kMotorPowers: {
      const bool runs = std::ranges::any_of(data, [](std::byte each) { return each != std::byte{}; });
      return bare_command(kBrushes, runs ? wire::gripper::kCmdOpen : wire::gripper::kCmdClose);
    }
    case irobot::kPlay:
      return play(u8(data, 0));
    default:
      return;
  }
}

void RoombaEmulator::drive(const irobot::OiDrive& wanted) {
  turn_wheels(irobot::wheels_of(wanted, irobot::half_axle(generation_)));
  wanted_ = wanted;
}

void RoombaEmulator::turn_wheels(irobot::OiWheels wheels) {
  constexpr double kMost = irobot::OiDrive::kMostSpeed;
  wheels_ = {std::clamp(wheels.right, -kMost, kMost), std::clamp(wheels.left, -kMost, kMost)};
  wanted_ = {0, 0};
  const double speed = (wheels_.right + wheels_.left) / 2000;
  const double turn_rate = (wheels_.right - wheels_.left) / 2000 / irobot::half_axle(generation_);
  command_device(kWheels, p2d::kCmdVel, p2d::CmdVel{{speed, 0, turn_rate}, 1});
}

void RoombaEmulator::keep_song(std::span<const std::byte> data) {
  double seconds = 0;
  for (std::size_t at = 3; at < data.size(); at += 2) seconds += u8(data, at) * kNoteUnit;
  if (const std::size_t number = u8(data, 0); number < songs_.size()) songs_[number] = seconds;
}

void RoombaEmulator::play(std::uint8_t song) {
  if (song >= songs_.size() || songs_[song] == 0 || playing_ != nullptr) return;
  song_ = song;
  playing_ = after(songs_[song], [this] { playing_.reset(); });
}

// --- questions

void RoombaEmulator::obey_question(const irobot::OiCommand& command) {
  const RawBytes& data = command.data;
  RawBytes answer;
  switch (command.opcode) {
    case irobot::kSensors:
      put_answer(answer, u8(data, 0));
      return send(answer);
    case irobot::kQueryList:
      for (std::size_t at = 1; at < data.size(); ++at) put_answer(answer, u8(data, at));
      return send(answer);
    case irobot::kStream:
      streamed_.assign(data.begin() + 1, data.end());
      streams_ = !streamed_.empty();
      return;
    case irobot::kPauseStream:
      streams_ = u8(data, 0) != 0 && !streamed_.empty();
      return;
    case irobot::kScript:
      script_ = data;
      return;
    case irobot::kShowScript:
      return send(script_.empty() ? RawBytes{std::byte{}} : script_);
    default:
      return;
  }
}

/// Distance and angle begin anew once they are told.
void RoombaEmulator::put_answer(RawBytes& bytes, std::uint8_t number) {
  const auto packets = irobot::packets_of(generation_, number);
  if (!packets) return;
  count_ways();
  OiSensors values = sensors();
  const auto tells = [&](int packet) { return packets->first <= packet && packet <= packets->last; };
  if (tells(irobot::kDistance)) values[irobot::kDistance] = take_whole(distance_);
  if (tells(irobot::kAngle)) values[irobot::kAngle] = take_whole(angle_);
  irobot::put_packets(bytes, *packets, values);
}

// --- the robot's cycle

void RoombaEmulator::cycle() {
  count_ways();
  watch_safety();
  if (streams_) send_stream();
  cycle_ = after(kOiPeriod, [this] { cycle(); });
}

void RoombaEmulator::count_ways() {
  const WheelStep step = steps_.to(pose_of(base_.value().pos));
  const double wheel = step.turn * irobot::half_axle(generation_);
  distance_ += 1000 * step.distance;
  angle_ += irobot::angle_of(generation_, step.turn);
  left_way_ += step.distance - wheel;
  right_way_ += step.distance + wheel;
}

/// In safe mode it stops at a cliff ahead, with a wheel in the air and at the charger, and obeys no more.
void RoombaEmulator::watch_safety() {
  if (mode_ != OiMode::kSafe) return;
  const OiSensors values = sensors();
  const auto is_set = [&](int packet) { return values[static_cast<std::size_t>(packet)] != 0; };
  const bool at_cliff = is_set(irobot::kCliffLeft) || is_set(irobot::kCliffFrontLeft) ||
                        is_set(irobot::kCliffFrontRight) || is_set(irobot::kCliffRight);
  const double speed = wheels_.right + wheels_.left, turn = std::fabs(wheels_.right - wheels_.left);
  const bool goes_there =
      speed > 0 || turn * kBodyRadius > std::fabs(speed) * 1000 * irobot::half_axle(generation_);
  const bool drops =
      (values[irobot::kBumpsAndDrops] & (irobot::kDropLeft | irobot::kDropRight | irobot::kDropCaster)) != 0;
  if (drops || is_set(irobot::kCharging) || (at_cliff && goes_there)) set_mode(OiMode::kPassive);
}

/// A frame has no place for more than 255 bytes: it ends before a packet that is too much.
void RoombaEmulator::send_stream() {
  constexpr std::size_t kMostContent = 255;
  RawBytes content;
  for (const std::byte number : streamed_) {
    const auto packets = irobot::packets_of(generation_, static_cast<std::uint8_t>(number));
    if (!packets) continue;
    if (content.size() + 1 + irobot::bytes_of(*packets) > kMostContent) break;
    content.push_back(number);
    put_answer(content, static_cast<std::uint8_t>(number));
  }
  send(irobot::stream_frame(content));
}

// --- what it senses

OiSensors RoombaEmulator::sensors() {
  OiSensors values{};
  sense_switches(values);
  sense_battery(values);
  values[irobot::kMode] = static_cast<int>(mode_);
  values[irobot::kSongNumber] = song_;
  values[irobot::kSongPlaying] = playing_ != nullptr ? 1 : 0;
  values[irobot::kStreamedPackets] = static_cast<int>(streamed_.size());
  values[irobot::kWantedVelocity] = wanted_.velocity;
  values[irobot::kWantedRadius] = wanted_.radius;
  values[irobot::kWantedRight] = whole_units(wheels_.right);
  values[irobot::kWantedLeft] = whole_units(wheels_.left);
  const auto counts = [](double way) { return static_cast<int>(std::llround(way / kCount) & 0xFFFF); };
  values[irobot::kLeftCounts] = counts(left_way_);
  values[irobot::kRightCounts] = counts(right_way_);
  return values;
}

void RoombaEmulator::sense_switches(OiSensors& values) {
  const std::vector<std::uint8_t>& pressed = bumpers_.value().bumpers;
  int& bumps = values[irobot::kBumpsAndDrops];
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    if (pressed[i] == 0) continue;
    if (2 * i < pressed.size()) bumps |= irobot::kBumpLeft;
    if (2 * i + 1 >= pressed.size()) bumps |= irobot::kBumpRight;
  }
  if (base_.value().stall != 0) values[irobot::kOvercurrents] = irobot::kWheelLeft | irobot::kWheelRight;
  values[irobot::kRemote] = irobot::kNoRemote;
  const std::vector<float>& told = switches_.value().ranges;
  const auto at = [&](std::size_t place) {
    return told.size() == kPlaces ? whole_units(static_cast<double>(told[place])) : 0;
  };
  const auto is_set = [&](std::size_t place) { return at(place) != 0 ? 1 : 0; };
  values[irobot::kWall] = is_set(kWallPlace);
  for (std::size_t cliff = 0; cliff < 4; ++cliff)
    values[irobot::kCliffLeft + cliff] = is_set(kCliffPlace + cliff);
  values[irobot::kVirtualWall] = is_set(kVirtualPlace);
  values[irobot::kDirtRight] = at(kDirtPlace);
  values[irobot::kDirtLeft] = at(kDirtPlace + 1);
  bumps |= is_set(kDropPlace) * irobot::kDropCaster | is_set(kDropPlace + 1) * irobot::kDropLeft |
           is_set(kDropPlace + 2) * irobot::kDropRight;
}

void RoombaEmulator::sense_battery(OiSensors& values) {
  namespace pw = wire::power;
  const pw::Data& battery = battery_.value();
  const auto told = [&](std::uint32_t part, float value, double otherwise) {
    return (battery.valid & part) != 0 ? static_cast<double>(value) : otherwise;
  };
  const double volts = told(pw::kMaskVolts, battery.volts, 16);
  const double watts = told(pw::kMaskWatts, battery.watts, 5.6);
  const bool charges = (battery.valid & pw::kMaskCharging) != 0 && battery.charging == 1;
  values[irobot::kCharging] = charges ? kCharges : 0;
  values[irobot::kChargers] = charges ? 1 : 0;
  values[irobot::kVoltage] = whole_units(1000 * volts);
  values[irobot::kCurrent] = volts > 0 ? whole_units(-1000 * watts / volts) : 0;
  values[irobot::kTemperature] = 25;
  values[irobot::kCharge] = whole_units(told(pw::kMaskPercent, battery.percent, 100) / 100 * kOiCapacity);
  values[irobot::kCapacity] = kOiCapacity;
}

constinit const DriverDefinition kRoombaEmulatorDriver{
    .name = "roomba_emulator",
    .doc = "A Roomba or a Create at the far end of a line, for a robot of this server.",
    .provides = {},
    .uses = kRoombaEmulatorUses,
    .read_options = reading<roomba_emulator_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_emulator<RoombaEmulator>(section, site, roomba_emulator_options, kRoombaEmulatorUses);
    },
};

}  // namespace playhouse::drivers
