#pragma once

/// The .cfg driver "urglaser_emulator": a Hokuyo scanner at the far end of a line, that sees what a laser of this server sees.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/emulator.h"
#include "playhouse/drivers/urglaser/scip_frames.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

extern const DriverDefinition kUrglaserEmulatorDriver;

struct UrglaserEmulatorOptions {
  EmulatorPlace place;
  const scip::ScipModel* model = nullptr;
  std::string serial_number;
  bool begins_in_scip1 = false;
};

class UrglaserEmulator final : public Emulator {
 public:
  UrglaserEmulator(std::string name, Site& site, const UrglaserEmulatorOptions& options, UsedDevices used);

 private:
  /// What is asked of it until it has seen the next turn, or without end.
  struct ScipOrder {
    std::string line;  // as it was said
    std::string code;  // "MD"
    scip::ScipRequest request;
    int left = 0;     // scans to come
    int skipped = 0;  // since the last one
  };

  void line_received(std::span<const std::byte> bytes) override;

  void take(const std::string& line);
  void take_scip1(const std::string& line);
  void answer(const std::string& line, std::string_view status, const std::vector<std::string>& lines = {});
  std::string fault_of(const std::string& text) const;
  void switch_laser(const std::string& line);
  void end_scans(const std::string& line, bool resets);
  void tell_time(const std::string& line);
  void set_speed(const std::string& line, const std::string& digits);
  void order(const std::string& line, const std::string& text);
  void order_scip1(const std::string& line);
  std::vector<std::string> version(bool has_checks) const;
  std::string_view state_number() const;
  std::vector<std::string> state() const;

  void turn();
  void carry_out(ScipOrder& order);
  void send_scan(std::span<const std::byte> bytes);
  std::vector<std::string> scan(const ScipOrder& order, int characters, bool has_checks);
  int range_at(int step) const;
  std::string clock() const;

  const UrglaserEmulatorOptions options_;
  const scip::ScipModel& model_;
  scip::ScipLines lines_;
  int baud_;
  bool is_scip1_, laser_on_ = false, tells_time_ = false;
  double zero_ = 0;     // s, of its clock
  double is_sent_ = 0;  // s, when the last scan has gone out
  std::optional<ScipOrder> once_, always_;
  wire::laser::Data seen_;  // of this turn
  std::unique_ptr<net::Timer> turn_;

  Latest<wire::laser::Data> beams_{*this, 0, wire::laser::kDataScan};
};

}  // namespace playhouse::drivers
