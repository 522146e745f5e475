#pragma once

/// The .cfg driver "p2os_emulator": a Pioneer's controller at the far end of a line, for devices of this server.

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/emulator.h"
#include "playhouse/drivers/p2os/p2os_frames.h"
#include "playhouse/drivers/p2os/p2os_robots.h"
#include "playhouse/geom/pose.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/dio.h"
#include "playhouse/wire/generated/gripper.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/power.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {

extern const DriverDefinition kP2osEmulatorDriver;

struct P2osEmulatorOptions {
  EmulatorPlace place;
  const p2os::RobotModel* model = nullptr;
  std::string robot_name;
  double watchdog = 2;  // s
  bool needs_motors_on = true;
};

class P2osEmulator final : public Emulator {
 public:
  enum P2osUsed : std::size_t { kWheels, kSonar, kPower, kBumper, kGripper, kDio };

  P2osEmulator(std::string name, Site& site, const P2osEmulatorOptions& options, UsedDevices used);

 private:
  void line_received(std::span<const std::byte> bytes) override;
  void line_paused() override { reader_.clear(); }
  void reset() override { close(); }

  void take(const p2os::ReadCommand& command);
  bool take_sync(const p2os::ReadCommand& command);
  void obey(const p2os::ReadCommand& command);
  void open();
  void close();
  void cycle();
  void drive(double speed, double turn_rate);
  void drive_wheels(std::int8_t right, std::int8_t left);
  void set_origin();
  void grip(int action);
  p2os::Sip sip();
  void add_sonars(p2os::Sip& sip);
  void add_bumpers(p2os::Sip& sip);
  std::uint8_t gripper_bits();

  const P2osEmulatorOptions options_;
  p2os::FrameReader reader_;
  int synced_ = 0;        // of the three
  bool is_open_ = false;  // sends packets
  bool motors_on_ = false, sonars_on_ = false;
  std::uint8_t outputs_ = 0;          // digital
  double speed_ = 0, turn_rate_ = 0;  // m/s, rad/s: wanted
  bool is_told_ = true;               // the wheels of what is wanted
  geom::Pose X_OS_;                   // where the robot was at SETO, in its odometry
  std::size_t next_sonar_ = 0;
  std::unique_ptr<net::Timer> cycle_, watchdog_;

  Latest<wire::position2d::Data> wheels_{*this, kWheels, wire::position2d::kDataState};
  Latest<wire::sonar::Data> ranges_{*this, kSonar, wire::sonar::kDataRanges};
  Latest<wire::power::Data> battery_{*this, kPower, wire::power::kDataState};
  Latest<wire::bumper::Data> bumpers_{*this, kBumper, wire::bumper::kDataState};
  Latest<wire::gripper::Data> gripper_{*this, kGripper, wire::gripper::kDataState};
  Latest<wire::dio::Data> inputs_{*this, kDio, wire::dio::kDataValues};
};

}  // namespace playhouse::drivers
