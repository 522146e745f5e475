#pragma once

/// The .cfg driver "roomba_emulator": a Roomba or a Create at the far end of a line, for devices of this server.
///
/// It has the modes of the robots, the sensor packets of their generation, lists and streams of them. Behaviours of the
/// robot's own, as cleaning, are not carried out: it stands, in passive mode. Scripts are kept and shown, not played.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/emulator.h"
#include "playhouse/drivers/hardware/wheel_odometry.h"
#include "playhouse/drivers/irobot/oi_packets.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/ir.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/power.h"

namespace playhouse::drivers {

extern const DriverDefinition kRoombaEmulatorDriver;

struct RoombaEmulatorOptions {
  EmulatorPlace place;
  irobot::RobotGeneration generation = irobot::RobotGeneration::kSci;
};

class RoombaEmulator final : public Emulator {
 public:
  enum RoombaUsed : std::size_t { kWheels, kBumper, kPower, kIr, kBrushes };

  RoombaEmulator(std::string name, Site& site, const RoombaEmulatorOptions& options, UsedDevices used);

 private:
  void reset() override { drive({}); }
  enum class OiMode : std::uint8_t { kOff, kPassive, kSafe, kFull };  // as packet 35 tells them

  void line_received(std::span<const std::byte> bytes) override;
  void line_paused() override { reader_.clear(); }

  void obey(const irobot::OiCommand& command);
  void obey_mode(std::uint8_t opcode);
  void obey_actuator(const irobot::OiCommand& command);
  void obey_question(const irobot::OiCommand& command);
  void set_mode(OiMode mode);
  void turn_off();
  void drive(const irobot::OiDrive& wanted);
  void turn_wheels(irobot::OiWheels wheels);
  void keep_song(std::span<const std::byte> data);
  void play(std::uint8_t song);

  void cycle();
  void count_ways();
  void watch_safety();
  void send_stream();
  void put_answer(RawBytes& bytes, std::uint8_t number);

  irobot::OiSensors sensors();
  void sense_switches(irobot::OiSensors& sensors);
  void sense_battery(irobot::OiSensors& sensors);

  const irobot::RobotGeneration generation_;
  irobot::OiCommandReader reader_;
  OiMode mode_ = OiMode::kOff;
  irobot::OiDrive wanted_;
  irobot::OiWheels wheels_;  // mm/s, wanted
  WheelSteps steps_;
  double distance_ = 0, angle_ = 0;      // since they were told last, in units of the packets
  double left_way_ = 0, right_way_ = 0;  // m, of wheels, since the start
  RawBytes streamed_;                    // numbers of packets
  bool streams_ = false;
  RawBytes script_;
  std::array<double, 16> songs_{};  // s, of each
  std::uint8_t song_ = 0;
  std::unique_ptr<net::Timer> cycle_, playing_;  // null: none is played

  Latest<wire::position2d::Data> base_{*this, kWheels, wire::position2d::kDataState};
  Latest<wire::bumper::Data> bumpers_{*this, kBumper, wire::bumper::kDataState};
  Latest<wire::power::Data> battery_{*this, kPower, wire::power::kDataState};
  Latest<wire::ir::Data> switches_{*this, kIr, wire::ir::kDataRanges};
};

}  // namespace playhouse::drivers
