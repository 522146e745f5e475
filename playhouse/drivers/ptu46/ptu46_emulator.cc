#include "playhouse/drivers/ptu46/ptu46_emulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

namespace playhouse::drivers {

namespace ptz = wire::ptz;

namespace {

constexpr double kPtuLook = 0.05;   // s, from one to the next
constexpr int kPtuNear = 2;         // counts
constexpr int kMostStillLooks = 8;  // what stands so long is there
constexpr int kFullSpeed = 2902, kFirstSpeed = 1000, kSlowestPtu = 57,
              kFirstAcceleration = 2000;                               // counts/s, counts/s2
constexpr std::uint8_t kIllegal = 2, kBadPosition = 3, kBadSpeed = 4;  // answers in binary
constexpr int kWordLimit = 32767;

constexpr DeviceText kPtu46EmulatorUses[] = {{"ptz", {}, HowMany::kOne, "the mount"}};

Ptu46EmulatorOptions ptu46_emulator_options(SectionFields& fields) {
  Ptu46EmulatorOptions options;
  const int baud = fields.integer(
      {"baud", "Of the unit's line; a host at another speed is not understood.", "baud"}, 9600, 50, 4000000);
  options.place = read_emulator_place(fields, {.baud = baud});
  options.resolution = fields.number({"resolution", "Arc seconds in a count.", "arcsec"}, 185.1428, 0.1);
  const auto limit = [&](const OptionText& text, double otherwise, std::size_t element) {
    const double angle =
        fields.angle(text, otherwise * std::numbers::pi / 180, element, SectionFields::kAnyNumber);
    return static_cast<int>(
        std::clamp(std::round(ptu::counts_of(angle, options.resolution)), -32767.0, 32767.0));
  };
  constexpr OptionText kPan{"pan_limits", "How far it pans, to the right and to the left."},
      kTilt{"tilt_limits", "How far it tilts, down and up."};
  options.pan = {limit(kPan, -158.9, 0), limit(kPan, 158.9, 1)};
  options.tilt = {limit(kTilt, -46.65, 0), limit(kTilt, 31.06, 1)};
  fields.expect(options.pan[0] < options.pan[1], "pan_limits", "is two angles, the smaller one first");
  fields.expect(options.tilt[0] < options.tilt[1], "tilt_limits", "is two angles, the smaller one first");
  return options;
}

std::string number_of(int value) {
  return fmt::format("{}", value);
}

}  // namespace

Ptu46Emulator::Ptu46Emulator(std::string name, Site& site, const Ptu46EmulatorOptions& options,
                             UsedDevices used)
    : Emulator(std::move(name), site, options.place, std::move(used)), options_(options) {
  restore();
}

void Ptu46Emulator::restore() {
  const auto axis = [](std::string_view name, const std::array<int, 2>& limits) {
    return EmulatedAxis{.name = name,
                        .least = limits[0],
                        .most = limits[1],
                        .speed = kFirstSpeed,
                        .base = kSlowestPtu,
                        .slowest = kSlowestPtu,
                        .fastest = kFullSpeed,
                        .acceleration = kFirstAcceleration,
                        .hold_power = 'R',
                        .move_power = 'R'};
  };
  pan_ = axis("Pan", options_.pan);
  tilt_ = axis("Tilt", options_.tilt);
}

/// The axes are where they are until they are told.
void Ptu46Emulator::line_received(std::span<const std::byte> bytes) {
  if (!std::exchange(has_begun_, true)) {
    pan_.target = position(pan_);
    tilt_.target = position(tilt_);
  }
  reader_.add(bytes);
  obey_waiting();
}

void Ptu46Emulator::obey_waiting() {
  while (waits_.empty()) {
    const std::optional<ptu::PtuCommand> command = reader_.next();
    if (!command) return;
    if (command->opcode != 0)
      obey_binary(*command);
    else
      obey(*command);
  }
}

// --- commands in letters

void Ptu46Emulator::say(const std::string& text) {
  send(std::as_bytes(std::span(text)));
}

void Ptu46Emulator::tell(const std::string& what, const std::string& value) {
  say(is_verbose_ ? fmt::format("* {} is {}\r\n", what, value) : fmt::format("* {}\r\n", value));
}

void Ptu46Emulator::tell(const EmulatedAxis& axis, const std::string& what, int value) {
  tell(fmt::format("{} {}", axis.name, what), number_of(value));
}

void Ptu46Emulator::obey(const ptu::PtuCommand& command) {
  if (echoes_) say(command.text);
  if (command.letters.size() == 2 && command.letters[0] == 'P' && obey_axis(command, pan_)) return;
  if (command.letters.size() == 2 && command.letters[0] == 'T' && obey_axis(command, tilt_)) return;
  if (command.letters.size() == 3 && (command.letters[1] == 'H' || command.letters[1] == 'M')) {
    // Powers, of axes that hold and that move: PHR, TML ...
    EmulatedAxis& axis = command.letters[0] == 'P' ? pan_ : tilt_;
    const char level = command.letters[2];
    if (std::string_view("HRLGO").find(level) == std::string_view::npos) return refuse("Illegal command");
    (command.letters[1] == 'H' ? axis.hold_power : axis.move_power) = level;
    return done();
  }
  if (!obey_unit(command)) refuse("Illegal command");
}

/// A letter that says what, with a number: sets it, without: asks for it.
bool Ptu46Emulator::obey_axis(const ptu::PtuCommand& command, EmulatedAxis& axis) {
  const bool sets = command.number.has_value();
  const auto number = static_cast<int>(std::lround(command.number.value_or(0)));
  const auto answer = [&](const std::string& why) {
    if (why.empty())
      done();
    else
      refuse(why);
  };
  const auto set_or_tell = [&](int& value, const std::string& what) {
    if (!sets) return tell(axis, what, value);
    if (number < 0 || number > 65535) return refuse(what + " is out of range");
    value = number;
    done();
  };
  switch (command.letters[1]) {
    case 'P':
      return sets ? answer(set_target(axis, number))
                  : tell("Current " + std::string(axis.name) + " position", number_of(position(axis))),
             true;
    case 'O':
      return sets ? answer(set_target(axis, position(axis) + number))
                  : tell(axis, "target position", axis.target),
             true;
    case 'R':
      return tell(std::string(axis.name) + " resolution", fmt::format("{:.4f}", options_.resolution)), true;
    case 'N':
      return tell("Minimum " + std::string(axis.name) + " position", number_of(axis.least)), true;
    case 'X':
      return tell("Maximum " + std::string(axis.name) + " position", number_of(axis.most)), true;
    case 'S':
      return sets ? answer(set_speed(axis, number)) : tell(axis, "speed", axis.speed), true;
    case 'D':
      return sets ? answer(set_speed(axis, axis.speed + number))
                  : tell(axis, "current speed", actual_speed(axis)),
             true;
    case 'U':
      return set_or_tell(axis.fastest, "upper speed limit"), true;
    case 'L':
      return set_or_tell(axis.slowest, "lower speed limit"), true;
    case 'B':
      return set_or_tell(axis.base, "base speed"), true;
    case 'A':
      return set_or_tell(axis.acceleration, "acceleration"), true;
    case 'H':
      return tell(std::string(axis.name) + " hold power", std::string(1, axis.hold_power)), true;
    case 'M':
      return tell(std::string(axis.name) + " move power", std::string(1, axis.move_power)), true;
    default:
      return false;
  }
}

bool Ptu46Emulator::obey_unit(const ptu::PtuCommand& command) {
  const std::string& letters = command.letters;
  struct Switch {
    std::string_view letters;
    bool* value;
    bool to;
  };
  const Switch switches[] = {{"EE", &echoes_, true},     {"ED", &echoes_, false},
                             {"FV", &is_verbose_, true}, {"FT", &is_verbose_, false},
                             {"LE", &has_limits_, true}, {"LD", &has_limits_, false},
                             {"S", &is_slaved_, true},   {"I", &is_slaved_, false}};
  for (const Switch& each : switches)
    if (letters == each.letters) {
      *each.value = each.to;
      if (letters == "I") move();
      return done(), true;
    }
  constexpr std::string_view kWithoutEffect[] = {"DS", "DR", "RE", "RD", "RPD", "RTD"};
  if (std::ranges::find(kWithoutEffect, letters) != std::end(kWithoutEffect)) return done(), true;
  if (letters == "CI" || letters == "CV") return set_velocity_mode(letters == "CV"), done(), true;
  if (letters == "C") return tell("Control mode", has_speeds_ ? "V" : "I"), true;
  if (letters == "E") return tell("Echo", echoes_ ? "enabled" : "disabled"), true;
  if (letters == "F") return tell("Feedback", is_verbose_ ? "verbose" : "terse"), true;
  if (letters == "L") return tell("Limit", has_limits_ ? "enabled" : "disabled"), true;
  if (letters == "V") return tell("Firmware", "Playhouse, as PTU-D46 version 2.14"), true;
  if (letters == "O") return tell("Input voltage and temperature", "24.0,25"), true;
  if (letters == "DF") return restore(), done(), true;
  if (letters == "A") {
    if (is_slaved_) move();
    return wait_until_there("*\r\n"), true;
  }
  if (letters == "H" || letters == "HP" || letters == "HT") {
    if (letters != "HT") halt(pan_);
    if (letters != "HP") halt(tilt_);
    return move(), done(), true;
  }
  if (letters == "R" || letters == "RP" || letters == "RT") {
    reset_axes(letters != "RT", letters != "RP");
    const std::string tilted = letters == "RP" ? "" : "!T!T", panned = letters == "RT" ? "" : "!P!P";
    return wait_until_there(tilted + panned + "*\r\n"), true;
  }
  return false;
}

// --- commands in binary

void Ptu46Emulator::answer_byte(int value) {
  RawBytes bytes;
  put_u8(bytes, value);
  send(bytes);
}

void Ptu46Emulator::answer_word(int value) {
  RawBytes bytes;
  put_16_be(bytes, value);
  send(bytes);
}

void Ptu46Emulator::answer_long(std::uint32_t value) {
  RawBytes bytes;
  put_16_be(bytes, static_cast<int>(value >> 16));
  put_16_be(bytes, static_cast<int>(value & 0xFFFF));
  send(bytes);
}

/// Odd opcodes are of the pan axis, even ones of tilt, up to 166.
void Ptu46Emulator::obey_binary(const ptu::PtuCommand& command) {
  const std::uint8_t opcode = command.opcode;
  const bool is_axis = opcode <= 166 || (opcode >= 186 && opcode <= 189) || (opcode >= 197 && opcode <= 202);
  EmulatedAxis& axis = (opcode % 2 == 1) == (opcode <= 166 || opcode >= 197) ? pan_ : tilt_;
  if (is_axis && obey_binary_axis(command, axis)) return;
  if (obey_binary_switch(opcode)) return;
  answer_byte(kIllegal);
}

bool Ptu46Emulator::obey_binary_axis(const ptu::PtuCommand& command, EmulatedAxis& axis) {
  const int number = command.data.size() == 2 ? s16_be(command.data, 0) : 0;
  const int size = command.data.size() == 2 ? u16_be(command.data, 0) : 0;
  const auto answer = [this](const std::string& why, int status) { answer_byte(why.empty() ? 0 : status); };
  switch (command.opcode - (&axis == &pan_ ? 0 : 1)) {
    case 129:
      return answer(set_target(axis, number), kBadPosition), true;
    case 131:
      return answer(set_target(axis, position(axis) + number), kBadPosition), true;
    case 133:
      return answer(set_speed(axis, axis.speed + number), kBadSpeed), true;
    case 135:
      return answer(set_speed(axis, number), kBadSpeed), true;
    case 137:
      return axis.base = size, answer_byte(0), true;
    case 139:
      return axis.fastest = size, answer_byte(0), true;
    case 141:
      return axis.slowest = size, answer_byte(0), true;
    case 145:
      return answer_word(position(axis)), true;
    case 147:
      return answer_word(axis.target), true;
    case 149:
      return answer_word(axis.least), true;
    case 151:
      return answer_word(axis.most), true;
    case 153:
      return answer_word(actual_speed(axis)), true;
    case 155:
      return answer_word(axis.speed), true;
    case 157:
      return answer_word(axis.base), true;
    case 159:
      return answer_word(axis.fastest), true;
    case 161:
      return answer_word(axis.slowest), true;
    case 163:
      return answer_long(static_cast<std::uint32_t>(axis.acceleration)), true;
    case 165:
      return answer_long(static_cast<std::uint32_t>(std::lround(60 * options_.resolution))), true;
    case 201:
      return axis.acceleration = static_cast<int>(u32_be(command.data, 0) & 0xFFFF), answer_byte(0), true;
    default:
      return false;
  }
}

bool Ptu46Emulator::obey_binary_switch(std::uint8_t opcode) {
  const auto set = [this](bool& value, bool to) {
    value = to;
    answer_byte(0);
    return true;
  };
  switch (opcode) {
    case 167:
      if (is_slaved_) move();
      waits_binary_ = true;
      return wait_until_there("*"), true;
    case 168:
    case 169:
    case 170:
      if (opcode != 170) halt(pan_);
      if (opcode != 169) halt(tilt_);
      return move(), answer_byte(0), true;
    case 171:
      return answer_byte(has_limits_ ? 1 : 0), true;
    case 172:
    case 173:
      return set(has_limits_, opcode == 172);
    case 174:
      set(is_slaved_, false);
      return move(), true;
    case 175:
      return set(is_slaved_, true);
    case 176:
      reset_axes(true, true);
      waits_binary_ = true;
      return wait_until_there("*"), true;
    case 180:
      return answer_byte(echoes_ ? 1 : 0), true;
    case 181:
    case 182:
      return set(echoes_, opcode == 181);
    case 183:
    case 184:
      return answer_byte(0), true;
    case 185:
      return restore(), answer_byte(0), true;
    case 190:
      return answer_byte(is_verbose_ ? 1 : 0), true;
    case 191:
    case 192:
      return set(is_verbose_, opcode == 191);
    case 196:
      return say("Playhouse, as PTU-D46 version 2.14\r\n"), true;
    case 203:
      return answer_byte(has_speeds_ ? 2 : 1), true;
    case 204:
    case 205:
      return set_velocity_mode(opcode == 205), answer_byte(0), true;
    default:
      return false;
  }
}

// --- the mount

std::string Ptu46Emulator::set_target(EmulatedAxis& axis, int counts) {
  if (has_limits_ && counts > axis.most)
    return fmt::format("Maximum allowable {} position is {}", axis.name, axis.most);
  if (has_limits_ && counts < axis.least)
    return fmt::format("Minimum allowable {} position is {}", axis.name, axis.least);
  axis.target = std::clamp(counts, -kWordLimit, kWordLimit);
  if (!is_slaved_) move();
  return "";
}

/// In velocity mode it has a sign, and the axis turns at once.
std::string Ptu46Emulator::set_speed(EmulatedAxis& axis, int counts) {
  if (std::abs(counts) > axis.fastest)
    return fmt::format("{} speed cannot exceed {}", axis.name, axis.fastest);
  if (!has_speeds_ && counts < axis.slowest)
    return fmt::format("{} speed cannot be less than {}", axis.name, axis.slowest);
  axis.speed = counts;
  if (has_speeds_) move();
  return "";
}

/// An axis stands when the mode begins, and has its first speed when it ends.
void Ptu46Emulator::set_velocity_mode(bool on) {
  if (std::exchange(has_speeds_, on) == on) return;
  for (EmulatedAxis* const axis : {&pan_, &tilt_}) {
    axis->speed = on ? 0 : kFirstSpeed;
    axis->target = position(*axis);
  }
  ask_device(
      kMount, ptz::kReqControlMode,
      ptz::ReqControlMode{static_cast<std::uint32_t>(on ? ptz::kVelocityControl : ptz::kPositionControl)});
  move();
}

void Ptu46Emulator::halt(EmulatedAxis& axis) {
  axis.target = position(axis);
  if (has_speeds_) axis.speed = 0;
}

void Ptu46Emulator::reset_axes(bool pan, bool tilt) {
  if (has_speeds_) set_velocity_mode(false);
  if (pan) pan_.target = 0;
  if (tilt) tilt_.target = 0;
  move();
}

void Ptu46Emulator::move() {
  const auto angle = [this](int counts) {
    return static_cast<float>(ptu::radians_of(counts, options_.resolution));
  };
  command_device(kMount, ptz::kCmdState,
                 ptz::Cmd{angle(pan_.target), angle(tilt_.target), 0, angle(pan_.speed), angle(tilt_.speed)});
}

void Ptu46Emulator::wait_until_there(const std::string& reply) {
  waits_ = reply;
  still_ = 0;
  watch_ = after(kPtuLook, [this] { watch(); });
}

/// In velocity mode there is nothing to wait for.
void Ptu46Emulator::watch() {
  const std::array<int, 2> now = {position(pan_), position(tilt_)};
  still_ = now == before_ ? still_ + 1 : 0;
  before_ = now;
  const bool is_there =
      std::abs(now[0] - pan_.target) <= kPtuNear && std::abs(now[1] - tilt_.target) <= kPtuNear;
  if (!has_speeds_ && !is_there && still_ < kMostStillLooks) {
    watch_ = after(kPtuLook, [this] { watch(); });
    return;
  }
  const std::string reply = std::exchange(waits_, "");
  if (std::exchange(waits_binary_, false))
    answer_byte(0);
  else
    say(reply);
  obey_waiting();
}

int Ptu46Emulator::position(const EmulatedAxis& axis) {
  const ptz::Data& now = mount_.value();
  const double counts =
      ptu::counts_of(static_cast<double>(&axis == &pan_ ? now.pan : now.tilt), options_.resolution);
  return static_cast<int>(
      std::lround(counts > -kWordLimit ? std::min<double>(counts, kWordLimit) : -kWordLimit));
}

int Ptu46Emulator::actual_speed(const EmulatedAxis& axis) {
  const ptz::Data& now = mount_.value();
  const double counts =
      ptu::counts_of(static_cast<double>(&axis == &pan_ ? now.panspeed : now.tiltspeed), options_.resolution);
  return static_cast<int>(
      std::lround(counts > -kWordLimit ? std::min<double>(counts, kWordLimit) : -kWordLimit));
}

constinit const DriverDefinition kPtu46EmulatorDriver{
    .name = "ptu46_emulator",
    .doc =
        "A pan-tilt unit of Directed Perception at the far end of a line, for a ptz device of this server.",
    .provides = {},
    .uses = kPtu46EmulatorUses,
    .read_options = reading<ptu46_emulator_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_emulator<Ptu46Emulator>(section, site, ptu46_emulator_options, kPtu46EmulatorUses);
    },
};

}  // namespace playhouse::drivers
