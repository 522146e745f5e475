#pragma once

/// Frames of ActivMedia controllers (P2OS, AROS, ARCOS): both ends use these.
///
/// Frame: FA FB, N = bytes that follow, data, and a checksum of the data, high byte first. Numbers are little-endian. Data of
/// the host: a command, then an argument, whose type is a byte: 3B not negative, 1B negative, 2B text. Data of the robot: a
/// type, then what it tells.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/drivers/hardware/bytes.h"

namespace playhouse::drivers::p2os {

enum CommandNumber : std::uint8_t {
  kSync0 = 0,
  kSync1 = 1,
  kSync2 = 2,
  // The same numbers once it is open.
  kPulse = 0,
  kOpen = 1,
  kClose = 2,
  kEnable = 4,
  kSetAcceleration = 5,
  kSetOrigin = 7,
  kVelocity = 11,
  kTurnRate = 21,
  kSetTurnAcceleration = 23,
  kSonar = 28,
  kStop = 29,
  kDigitalOut = 30,
  kWheels = 32,
  kGripper = 33,
  kGripperValue = 36,
  kBumpStall = 44,
  kJoydrive = 47,
  kEmergencyStop = 55,
  kGyro = 58,
  kRotKp = 82,  // and the five after it: kv, ki of rotation; kp, kv, ki of translation
};

/// Of kGripper.
enum GripperAction : std::uint8_t {
  kGripOpen = 1,
  kGripClose = 2,
  kGripStop = 3,
  kLiftUp = 4,
  kLiftDown = 5,
  kLiftStop = 6,
  kGripStore = 7,
  kGripDeploy = 8,
  kGripHalt = 15,
  kLiftCarry = 17,
};

/// Types of what the robot sends.
inline constexpr std::uint8_t kStopped = 0x32, kMoving = 0x33, kGyroPacket = 0x98;
inline bool is_sip(std::uint8_t type) {
  return type >= 0x30 && type <= 0x34;
}

/// Of the data: words of two bytes added, big-endian, modulo 65536; a byte left over by XOR.
std::uint16_t checksum(std::span<const std::byte> data);

RawBytes frame(std::span<const std::byte> data);
/// A command without an argument, and one with a number from -65535 to 65535.
RawBytes encode_command(std::uint8_t number);
RawBytes encode_command(std::uint8_t number, int argument);
/// One whose argument is two bytes, whatever their sign.
RawBytes encode_command_of_bytes(std::uint8_t number, int low, int high);

/// A command as the robot reads it.
struct ReadCommand {
  std::uint8_t number = 0;
  std::optional<int> argument;  // of a number
  std::uint8_t low = 0, high = 0;
};
/// None if `data` is empty. The original sends an argument's type without a value; that is none.
std::optional<ReadCommand> read_command(std::span<const std::byte> data);

/// Takes frames out of bytes: what comes between two and what has a wrong checksum is left out.
class FrameReader {
 public:
  void add(std::span<const std::byte> bytes);
  /// The data of the next whole frame.
  std::optional<RawBytes> next();
  void clear() {
    bytes_.clear();
    at_ = 0;
  }
  /// Frames that were left out.
  std::size_t damaged() const { return damaged_; }

 private:
  RawBytes bytes_;
  std::size_t at_ = 0;  // what is before was looked at
  std::size_t damaged_ = 0;
};

struct SonarReading {
  std::uint8_t number = 0;
  std::uint16_t range = 0;  // in units of the robot
};

/// The standard packet, "SIP", in units of the robot.
struct Sip {
  std::uint8_t type = kStopped;
  std::uint16_t x = 0, y = 0;  // counters
  std::int16_t heading = 0;
  std::int16_t left = 0, right = 0;              // wheel speeds
  std::uint8_t battery = 0;                      // 0.1 V
  std::uint8_t left_stall = 0, right_stall = 0;  // bit 0: the wheel; the others: bumpers behind, in front
  std::int16_t control = 0;
  std::uint16_t flags = 0;            // bit 0: motors on; 1: sonars on
  std::uint8_t compass = kNoCompass;  // 2 deg
  std::vector<SonarReading> sonars;
  std::uint8_t gripper = 0;
  std::uint8_t analog_port = 0, analog = 0, digital_in = 0, digital_out = 0;

  static constexpr std::uint8_t kNoCompass = 181;
  friend bool operator==(const Sip&, const Sip&) = default;
};
inline bool operator==(const SonarReading& a, const SonarReading& b) {
  return a.number == b.number && a.range == b.range;
}

RawBytes encode_sip(const Sip& sip);
/// None if it is none, or is cut short. What newer firmware adds is left out.
std::optional<Sip> read_sip(std::span<const std::byte> data);

/// Bits of the gripper's byte.
inline constexpr std::uint8_t kIsOpen = 0x01, kIsClosed = 0x02, kGripMoves = 0x04, kIsUp = 0x10,
                              kIsDown = 0x20, kLiftMoves = 0x40;

/// The three texts of the answer to SYNC2.
struct RobotNames {
  std::string name, robot_class, subclass;
};
RawBytes encode_names(const RobotNames& names);
std::optional<RobotNames> read_names(std::span<const std::byte> data);

}  // namespace playhouse::drivers::p2os
