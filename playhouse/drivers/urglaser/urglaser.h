#pragma once

/// The .cfg driver "urglaser": Hokuyo's scanners, which speak SCIP 2.0, by USB, a serial line or TCP.
///
/// Start-up: at each speed in turn QT, whose answer shows the speed; one that speaks SCIP 1.1 is told to speak 2.0. Then
/// the speed is set, the scanner's parameters and version asked, and scans without end are asked for.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/scanner_driver.h"
#include "playhouse/drivers/urglaser/scip_frames.h"

namespace playhouse::drivers {

extern const DriverDefinition kUrglaserDriver;

struct UrglaserOptions {
  ScannerOptions scanner;
  int baud = 115200;
  double min_angle = 0, max_angle = 0;  // rad
};

class Urglaser final : public ScannerDriver {
 public:
  Urglaser(std::string name, Site& site, const UrglaserOptions& options);

 private:
  enum class ScipPhase : std::uint8_t {
    kClosed,
    kStops,
    kSwitches,
    kSetsSpeed,
    kAsksModel,
    kAsksVersion,
    kEnds,
    kStarts,
    kRuns
  };

  void began() override;
  void received(std::span<const std::byte> bytes) override;
  void ending() override;
  void forgot() override;
  const ScanSettings& settings() const override { return settings_; }
  bool configure(const ScanSettings& wanted) override;

  void say(ScipPhase phase, std::string line);
  void say_again();
  void send_line(const std::string& line);
  void connect();
  void listen_at_next_speed();
  void stop_scans();
  void set_speed();
  void end_scans();
  void start_scans();
  void expect_scan();

  void take(const scip::ScipReply& reply);
  void take_stopped(const scip::ScipReply& reply);
  void take_speed(const scip::ScipReply& reply);
  void take_model(const scip::ScipReply& reply);
  void take_version(const scip::ScipReply& reply);
  void take_started(const scip::ScipReply& reply);
  void take_scan(const scip::ScipReply& reply);
  void settle(const ScanSettings& wanted);

  const UrglaserOptions options_;
  ScanSettings settings_;  // wanted, and of the model as soon as it is known
  scip::ScipModel model_;
  bool knows_model_ = false;
  bool has_intensities_ = true;  // until it refuses
  scip::ScipRequest scans_;
  scip::ScipReplies replies_;
  ScipPhase phase_ = ScipPhase::kClosed;
  std::vector<int> speeds_;
  std::size_t speed_ = 0;
  int tries_ = 0;
  std::string line_;  // of this step
  std::unique_ptr<net::Timer> patience_;
};

}  // namespace playhouse::drivers
