#pragma once

/// The .cfg driver "rplidar": Slamtec's RPLIDAR A1 and A2 by a serial line or TCP, in express or standard scans.
///
/// Start-up: it is stopped, tells what it is and whether it is well, and is asked for scans. Their samples are not evenly
/// spaced: a beam of a scan is the nearest of those of a turn that are next to it.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/scanner_driver.h"
#include "playhouse/drivers/rplidar/rplidar_frames.h"

namespace playhouse::drivers {

extern const DriverDefinition kRplidarDriver;

struct RplidarOptions {
  ScannerOptions scanner;
  int baud = 115200;
  double resolution = 0;  // rad
  double max_range = 12;  // m
  bool is_express = true;
};

class Rplidar final : public ScannerDriver {
 public:
  Rplidar(std::string name, Site& site, const RplidarOptions& options);

 private:
  enum class LidarPhase : std::uint8_t { kClosed, kWaits, kAsksInfo, kAsksHealth, kStarts, kRuns };

  void began() override;
  void received(std::span<const std::byte> bytes) override;
  void ending() override;
  void forgot() override;
  const ScanSettings& settings() const override { return settings_; }
  bool configure(const ScanSettings& wanted) override;

  void say(LidarPhase phase, RawBytes request);
  void say_again();
  void rest(double seconds, void (Rplidar::*then)());
  void connect();
  void stop_scans();
  void introduce();
  void start_scans();
  void expect_scan();
  void set_motor(int power);

  void take(std::span<const std::byte> piece);
  void take_info(std::span<const std::byte> info);
  void take_health(std::span<const std::byte> health);
  void take_capsule(const rplidar::LidarCapsule& capsule);
  void take_sample(const rplidar::LidarSample& sample);
  void publish_turn();

  const RplidarOptions options_;
  ScanSettings settings_;
  rplidar::LidarAnswers answers_;
  LidarPhase phase_ = LidarPhase::kClosed;
  bool is_express_ = true;
  bool has_motor_power_ = false;  // is set by a request
  bool was_reset_ = false;
  int tries_ = 0, bauds_ = 0;
  RawBytes request_;
  std::optional<rplidar::LidarCapsule> before_;
  LineScan turn_;          // of this turn: ranges of 0 are none yet
  bool is_whole_ = false;  // since its first sample
  std::unique_ptr<net::Timer> patience_;
};

}  // namespace playhouse::drivers
