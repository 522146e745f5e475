#pragma once

/// The .cfg driver "khepera": K-Team's Khepera and Khepera II.
///
/// One command is out at a time, until its answer or a tenth of a second. Wheel speeds come first, then the counters, the
/// speeds and the sensors in turn.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/wheel_odometry.h"
#include "playhouse/drivers/hardware/wheeled_driver.h"
#include "playhouse/drivers/khepera/khepera_lines.h"

namespace playhouse::drivers {

extern const DriverDefinition kKheperaDriver;

struct KheperaOptions {
  HardwareOptions hardware;
  double scale = 1;                 // of all lengths
  double axle = khepera::kAxle;     // m
  double pulse = khepera::kPulse;   // m
  double calib_a = 0, calib_b = 0;  // range in mm: a * light ^ b; 0: the curve of white paper
};

class Khepera final : public WheeledDriver {
 public:
  enum KheperaDevice : std::size_t { kWheels, kIr };

  Khepera(std::string name, Site& site, const KheperaOptions& options);

 private:
  struct WheelUnits {
    int left = 0, right = 0;
  };
  struct WheelCounts {
    std::int64_t left = 0, right = 0;
  };

  bool starts_up() const override { return true; }
  void began() override;
  void received(std::span<const std::byte> bytes) override;
  void closed(std::size_t device) override;
  void ending() override;
  void forgot() override;
  void drive(const geom::Twist& wanted) override;
  wire::position2d::Geom geometry() const override;
  void set_pose(const geom::Pose& X_OR) override { odometry_.set(X_OR); }

  void greet();
  void ask_next();
  void say(char letter, std::initializer_list<std::int64_t> numbers = {});
  void lose_answer();
  void take(const khepera::KheperaLine& line);
  void take_counts(const khepera::KheperaLine& line);
  void take_speeds(const khepera::KheperaLine& line);
  void take_light(const khepera::KheperaLine& line);
  double range_of(double light) const;

  const KheperaOptions options_;
  khepera::KheperaReader reader_;
  char out_ = 0;          // letter of the command that is out; 0: none
  bool runs_ = false;     // it has answered
  int lost_ = 0;          // answers, since the last one
  std::size_t turn_ = 0;  // of what is asked in turn
  std::optional<WheelUnits> wanted_;
  std::optional<WheelCounts> counts_;
  WheelOdometry odometry_;
  geom::Twist speed_;
  std::unique_ptr<net::Timer> wait_, patience_;
};

}  // namespace playhouse::drivers
