#pragma once

/// Sensor packets of iRobot's robots: each a number of one or two bytes; groups are some that follow each other. The one
/// table is in oi_packets.cc; both ends use it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "playhouse/drivers/hardware/bytes.h"
#include "playhouse/drivers/irobot/oi_commands.h"

namespace playhouse::drivers::irobot {

enum PacketNumber : std::uint8_t {
  kEarlyGroup = 0,  // all of the SCI
  kBumpsAndDrops = 7,
  kWall,
  kCliffLeft,
  kCliffFrontLeft,
  kCliffFrontRight,
  kCliffRight,
  kVirtualWall,
  kOvercurrents,
  kDirtLeft,
  kDirtRight,
  kRemote,
  kButtons,
  kDistance,  // mm, since it was told last
  kAngle,     // the same; see radians_of()
  kCharging,
  kVoltage,      // mV
  kCurrent,      // mA, positive while charging
  kTemperature,  // deg C
  kCharge,       // mAh
  kCapacity,     // mAh
  kWallSignal,
  kCliffLeftSignal,
  kCliffFrontLeftSignal,
  kCliffFrontRightSignal,
  kCliffRightSignal,
  kDigitalInputs,
  kAnalogInput,
  kChargers,
  kMode,
  kSongNumber,
  kSongPlaying,
  kStreamedPackets,
  kWantedVelocity,
  kWantedRadius,
  kWantedRight,
  kWantedLeft,
  kLeftCounts,
  kRightCounts,
  kPacketNumbers = 59,
};

/// Bits of kBumpsAndDrops, kOvercurrents and kMotors.
inline constexpr int kBumpRight = 1, kBumpLeft = 2, kDropRight = 4, kDropLeft = 8, kDropCaster = 16;
inline constexpr int kSideBrush = 1, kVacuum = 2, kMainBrush = 4, kWheelRight = 8, kWheelLeft = 16;

/// Values of packets, by number.
using OiSensors = std::array<int, kPacketNumbers>;

inline constexpr std::size_t kEarlyBytes = 26;  // of kEarlyGroup
inline constexpr int kNoRemote = 255;

/// First and last of a group, or of a packet alone; none: the robot has no such.
struct PacketRange {
  std::uint8_t first = 0, last = 0;
};
std::optional<PacketRange> packets_of(RobotGeneration generation, std::uint8_t number);
std::size_t bytes_of(const PacketRange& packets);

/// Values beyond what a packet holds are cut.
void put_packets(RawBytes& bytes, const PacketRange& packets, const OiSensors& sensors);

/// The answer of kEarlyGroup; none if it is not as long, or says what no robot says, as one that is shifted by a byte.
std::optional<OiSensors> read_early_group(std::span<const std::byte> answer);

/// A frame of the stream, of (number, data) pairs that are `content`, with its checksum.
RawBytes stream_frame(std::span<const std::byte> content);

/// Of a turn by an angle as kAngle tells it, and back.
double radians_of(RobotGeneration generation, double angle);
double angle_of(RobotGeneration generation, double radians);

}  // namespace playhouse::drivers::irobot
