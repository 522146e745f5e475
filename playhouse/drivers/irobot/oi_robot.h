#pragma once

/// OiRobot: what the .cfg drivers "roomba" and "create" are.
///
/// It asks for packet group 0 ten times a second. An answer has no frame, so one is taken once 26 bytes have come and no
/// more follow; bytes that are left over are dropped before the next question. A robot in safe mode that has left it, for a
/// cliff or a wheel in the air, is put back into it once that is over.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/drivers/hardware/paced_command.h"
#include "playhouse/drivers/hardware/wheel_odometry.h"
#include "playhouse/drivers/hardware/wheeled_driver.h"
#include "playhouse/drivers/irobot/oi_packets.h"

namespace playhouse::drivers {

struct OiRobotOptions {
  HardwareOptions hardware;
  irobot::RobotGeneration generation = irobot::RobotGeneration::kSci;
  bool is_safe = true;      // stops by itself at cliffs
  bool locks_bump = false;  // goes back alone while a bumper is pressed
};

/// Reads all but the generation.
void read_oi_options(SectionFields& fields, OiRobotOptions& options);

inline constexpr DeviceText kOiProvides[] = {
    {"position2d", {}, HowMany::kSomeOfThese, "its wheels and odometry"},
    {"power", {}, HowMany::kSomeOfThese, "its battery"},
    {"bumper", {}, HowMany::kSomeOfThese, "left and right"},
    {"ir",
     {},
     HowMany::kSomeOfThese,
     "1 or 0 as ranges: wall, cliffs from left to right, virtual wall; dirt right and left; drops of caster, "
     "left and "
     "right wheel"},
    {"opaque",
     {},
     HowMany::kSomeOfThese,
     "buttons max, clean, spot, power, and the remote control's byte; takes 0 N: play song N, 1 N LENGTH "
     "NOTES: set it, "
     "2 and seven bytes: LEDs, 3 N: demo N"},
    {"gripper", {}, HowMany::kSomeOfThese, "brushes and vacuum, which run when it is opened"},
};

class OiRobot final : public WheeledDriver {
 public:
  enum OiDevice : std::size_t { kWheels, kPower, kBumper, kIr, kOpaque, kGripper };

  OiRobot(std::string name, Site& site, const OiRobotOptions& options);

 private:
  bool starts_up() const override { return true; }
  void began() override;
  void received(std::span<const std::byte> bytes) override;
  void closed(std::size_t device) override;
  void ending() override;
  void forgot() override;
  void stop_wheels() override;
  void drive(const geom::Twist& wanted) override;
  wire::position2d::Geom geometry() const override;
  void set_pose(const geom::Pose& X_OR) override { odometry_.set(X_OR); }

  void start_up(std::vector<irobot::Opcode> commands);
  std::vector<irobot::Opcode> commands_of_mode() const;
  void ask();
  void expect_answer();
  void judge();

  // What the robot tells.
  void take(const irobot::OiSensors& sensors);
  void watch_mode(const irobot::OiSensors& sensors);
  void lock_bump(const irobot::OiSensors& sensors);
  void publish_pose(const irobot::OiSensors& sensors);
  void publish_power(const irobot::OiSensors& sensors);
  void publish_switches(const irobot::OiSensors& sensors);
  void publish_gripper(const irobot::OiSensors& sensors);

  // What clients ask.
  void register_others();
  void send_wanted();
  void set_brushes(bool on);
  void carry_out(std::span<const std::byte> opaque);

  const OiRobotOptions options_;
  RawBytes answer_;
  bool runs_ = false;  // the mode is set
  bool brushes_on_ = false;
  bool is_bumped_ = false;  // and locked
  bool has_tripped_ = false;
  int cycles_ = 0;                    // since the last answer that was taken; 0: none yet
  PacedCommand<geom::Twist> wanted_;  // one with each question
  WheelOdometry odometry_;
  std::unique_ptr<net::Timer> cycle_, settle_, patience_;
};

}  // namespace playhouse::drivers
