#pragma once

/// The .cfg driver "p2os": Pioneer, AmigoBot, PeopleBot and other bases with an ActivMedia controller.
///
/// Start-up: SYNC0, SYNC1, SYNC2, each answered by itself, the last with the robot's names, then OPEN; from then on the robot
/// sends a packet every 100 ms. Odometry adds up the differences of its counters, of 12 bits. The wheels get a speed each,
/// WHEELS, or on request the robot a speed and a turn rate.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/paced_command.h"
#include "playhouse/drivers/hardware/wheeled_driver.h"
#include "playhouse/drivers/p2os/p2os_frames.h"
#include "playhouse/drivers/p2os/p2os_robots.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

extern const DriverDefinition kP2osDriver;

struct P2osOptions {
  HardwareOptions hardware;
  double max_speed = 0, max_turn_rate = 0;    // m/s, rad/s
  std::array<int, 2> acceleration = {};       // to be faster, and to be slower; 0: the robot's own  [mm/s^2]
  std::array<int, 2> turn_acceleration = {};  // the same  [deg/s^2]
  std::array<int, 6> gains = {};              // of ROTKP and those after it; -1: the robot's own
  int bump_stall = 0;                         // -1: the robot's own
  double pulse = 0;                           // s; 0: none
  bool takes_joystick = false;
};

class P2os final : public WheeledDriver {
 public:
  enum P2osDevice : std::size_t { kWheels, kCompass, kPower, kSonar, kBumper, kGripper, kDio, kAio };

  P2os(std::string name, Site& site, const P2osOptions& options);

 private:
  enum class Stage : std::uint8_t { kClosed, kSync0, kSync1, kSync2, kRuns };

  bool starts_up() const override { return true; }
  void began() override;
  void received(std::span<const std::byte> bytes) override;
  void opened(std::size_t device) override;
  void closed(std::size_t device) override;
  void ending() override;
  void forgot() override;
  void stop_wheels() override;

  // Start-up.
  void ask_for_sync();
  void ask_again();
  void wait_for_answer();
  void take(std::span<const std::byte> data);
  void take_sync(std::span<const std::byte> data);
  void run(const p2os::RobotNames& names);
  void send_options();
  void send_gains();
  void pulse();

  // What the robot tells.
  void take_sip(const p2os::Sip& sip);
  void add_to_odometry(const p2os::Sip& sip);
  void publish_pose(const p2os::Sip& sip);
  void publish_compass(const p2os::Sip& sip);
  void publish_ranges(const p2os::Sip& sip);
  void publish_bumpers(const p2os::Sip& sip);
  void publish_gripper(const p2os::Sip& sip);
  void publish_inputs(const p2os::Sip& sip);

  // What clients ask.
  void register_sensors();
  void register_gripper();
  void drive(const geom::Twist& wanted) override;
  void send_wanted();
  void turn_wheels(double speed, double difference);
  AnswerBody set_motors(bool on) override;
  wire::position2d::Geom geometry() const override;
  AnswerBody set_velocity_mode(std::uint32_t mode);
  AnswerBody set_sonars(bool on);
  void set_pose(const geom::Pose& X_CR) override;
  void grip(p2os::GripperAction action);

  const P2osOptions options_;
  const p2os::RobotModel* model_;  // of the robot that answered last
  p2os::FrameReader reader_;
  Stage stage_ = Stage::kClosed;
  std::size_t baud_ = 0;  // number of the speed of the line
  int tries_ = 0;         // of SYNC0 at this speed
  bool separate_speeds_ = false;
  bool has_closed_ = false;           // the robot that was still open
  PacedCommand<geom::Twist> wanted_;  // one a packet
  std::unique_ptr<net::Timer> patience_, pulse_;

  std::optional<p2os::Sip> last_;
  double heard_ = 0;  // s, when it came
  geom::Pose X_OR_;   // counted, since the robot was opened
  geom::Pose X_CO_;   // of those counts in the frame that clients have set
  std::vector<float> ranges_;
};

}  // namespace playhouse::drivers
