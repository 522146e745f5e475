#pragma once

/// Commands to iRobot's robots, by the Roomba's Serial Command Interface (SCI) and the Open Interface (OI) of its 500 series
/// and of the Create: both ends use these.
///
/// An opcode from 128 on, then its data, whose length follows from the opcode, or from a count in it. Numbers are
/// big-endian. There is no checksum and no answer.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>

#include "playhouse/drivers/hardware/bytes.h"

namespace playhouse::drivers::irobot {

enum class RobotGeneration : std::uint8_t { kSci, k500, kCreate };

/// Baud.
int speed_of_line(RobotGeneration generation);
/// From the middle of the robot to a wheel.  [m]
double half_axle(RobotGeneration generation);

enum Opcode : std::uint8_t {
  kStart = 128,
  kBaud = 129,
  kControl = 130,
  kSafe = 131,
  kFull = 132,
  kPower = 133,
  kSpot = 134,
  kClean = 135,  // COVER of the Create
  kMax = 136,    // DEMO of the Create
  kDrive = 137,
  kMotors = 138,  // low side drivers of the Create
  kLeds = 139,
  kSong = 140,
  kPlay = 141,
  kSensors = 142,
  kDock = 143,
  kMotorPowers = 144,
  kDriveDirect = 145,
  kDrivePowers = 146,
  kDigitalOutputs = 147,
  kStream = 148,
  kQueryList = 149,
  kPauseStream = 150,
  kSendIr = 151,
  kScript = 152,
  kPlayScript = 153,
  kShowScript = 154,
  kWaitTime = 155,
  kWaitDistance = 156,
  kWaitAngle = 157,
  kWaitEvent = 158,
  kScheduleLeds = 162,
  kDigitLeds = 163,
  kDigitText = 164,
  kPressButtons = 165,
  kSchedule = 167,
  kSetClock = 168,
  kStop = 173,
};

inline constexpr std::size_t kMostNotes = 16;  // of a song

RawBytes encode_command(Opcode opcode, std::initializer_list<int> data = {});

/// A command as the robot reads it.
struct OiCommand {
  std::uint8_t opcode = 0;
  RawBytes data;
};

/// Takes commands out of bytes; what is no command of the robot is left out, byte by byte.
class OiCommandReader {
 public:
  explicit OiCommandReader(RobotGeneration generation) : generation_(generation) {}
  void add(std::span<const std::byte> bytes);
  /// The next whole command.
  std::optional<OiCommand> next();
  void clear() { bytes_.clear(); }

 private:
  /// Of the command at the front: none if it is no command; more than there are bytes if it is not whole.
  std::optional<std::size_t> data_length() const;

  const RobotGeneration generation_;
  RawBytes bytes_;
};

/// Of command DRIVE.
struct OiDrive {
  static constexpr int kStraight = -0x8000, kStraightToo = 0x7FFF, kMostSpeed = 500, kMostRadius = 2000;
  int velocity = 0;        // mm/s, of the robot's middle, or of a wheel where it turns on the spot
  int radius = kStraight;  // mm, positive to the left; 1 and -1: on the spot, to the left and to the right
};
/// mm/s
struct OiWheels {
  double right = 0, left = 0;
};

/// What comes nearest to a speed and a turn rate, m/s and rad/s. Too fast for a wheel: both are slower, on the same curve.
OiDrive drive_of(double speed, double turn_rate, double half_axle);
OiWheels wheels_of(const OiDrive& drive, double half_axle);

}  // namespace playhouse::drivers::irobot
