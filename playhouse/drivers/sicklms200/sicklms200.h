#pragma once

/// The .cfg driver "sicklms200": SICK LMS 200, 211, 220, 221 and 291 by a serial line, and, as "sickpls", the PLS.
///
/// Start-up: at each speed in turn the stream is stopped; the first answer shows the laser's speed. Then the speed of the
/// transfer is set, the type asked, the password told, the scan variant and the configuration set if they differ, and
/// the stream started.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/scanner_driver.h"
#include "playhouse/drivers/sicklms200/lms_telegrams.h"

namespace playhouse::drivers {

extern const DriverDefinition kSickLms200Driver;

struct SickLms200Options {
  ScannerOptions scanner;
  std::vector<int> connect_rates;
  int transfer_rate = 38400;
  int retries = 0;   // of all speeds
  double delay = 0;  // s
  sick::LmsVariant variant;
  std::uint8_t unit = sick::kMillimetre;
  bool is_highly_available = false;
  bool is_pls = false;
};

class SickLms200 final : public ScannerDriver {
 public:
  SickLms200(std::string name, Site& site, const SickLms200Options& options);

 private:
  enum class LmsPhase : std::uint8_t {
    kClosed,
    kWaits,
    kStops,
    kChangesSpeed,
    kAsksType,
    kLogsIn,
    kAsksState,
    kSetsVariant,
    kAsksBlock,
    kSetsBlock,
    kStarts,
    kRuns
  };

  void began() override;
  void received(std::span<const std::byte> bytes) override;
  void ending() override;
  void forgot() override;
  const ScanSettings& settings() const override { return settings_; }
  bool configure(const ScanSettings& wanted) override;

  // Of a step: what it says, again if there is no answer.
  void say(LmsPhase phase, RawBytes telegram);
  void say_again();
  void send_next_byte();
  void rest(double seconds, void (SickLms200::*then)());

  // The steps.
  void connect();
  void listen_at_next_speed();
  void stop_scans();
  void change_speed();
  void introduce();
  void log_in();
  void start_scans();
  void run();
  void expect_scan();

  // What the laser says.
  void take(std::span<const std::byte> telegram);
  void take_mode(std::span<const std::byte> telegram);
  void take_type(std::span<const std::byte> telegram);
  void take_state(std::span<const std::byte> telegram);
  void take_block(std::span<const std::byte> telegram);
  void take_scan(std::span<const std::byte> telegram);

  void settle(const sick::LmsVariant& variant, std::uint8_t unit, int first, int last);
  bool is_whole() const { return first_ == 1 && last_ == variant_.values(); }

  const SickLms200Options options_;
  // What is wanted of the laser.
  ScanSettings settings_;
  sick::LmsVariant variant_;
  std::uint8_t unit_;
  int first_ = 1, last_ = 1;  // of the values, counted from 1

  sick::LmsReader reader_{sick::LmsReader::LmsEnd::kLaser};
  LmsPhase phase_ = LmsPhase::kClosed;
  bool is_changed_ = false;  // since it was told
  std::vector<int> speeds_;  // in the order in which they are tried
  std::size_t speed_ = 0;
  int tries_ = 0, retries_ = 0;
  std::string type_;
  RawBytes telegram_;     // of this step
  std::size_t sent_ = 0;  // bytes of it, if it is sent slowly
  std::unique_ptr<net::Timer> patience_, spacing_;
};

}  // namespace playhouse::drivers
