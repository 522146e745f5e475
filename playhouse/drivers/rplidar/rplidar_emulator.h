#pragma once

/// The .cfg driver "rplidar_emulator": an RPLIDAR at the far end of a line, that sees what a laser of this server sees.

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/emulator.h"
#include "playhouse/drivers/rplidar/rplidar_frames.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

extern const DriverDefinition kRplidarEmulatorDriver;

struct RplidarEmulatorOptions {
  EmulatorPlace place;
  bool is_a2 = false;
  bool has_modes = true;  // firmware 1.29; else 1.20
};

class RplidarEmulator final : public Emulator {
 public:
  RplidarEmulator(std::string name, Site& site, const RplidarEmulatorOptions& options, UsedDevices used);

 private:
  enum class LidarScan : std::uint8_t { kNone, kStandard, kExpress };

  void line_received(std::span<const std::byte> bytes) override;
  void line_paused() override { requests_.clear(); }

  void take(const rplidar::LidarRequest& request);
  void tell_info();
  void tell_rate();
  void tell_configuration(std::span<const std::byte> parameters);
  void tell_mode(std::uint32_t what, std::uint16_t mode);
  void restart();
  void scan(LidarScan kind);
  void measure();
  void send_nodes(const wire::laser::Data& seen);
  void send_capsule(const wire::laser::Data& seen);
  /// mm; 0: none.
  double range_at(const wire::laser::Data& seen, double angle) const;
  double turns_of_second() const { return options_.is_a2 ? 10 : 5.5; }
  double sample_time() const;  // s

  const RplidarEmulatorOptions options_;
  rplidar::LidarRequests requests_;
  LidarScan kind_ = LidarScan::kNone;
  bool motor_on_ = true, is_first_ = false;
  double angle_ = 0;  // deg, of the next sample
  std::unique_ptr<net::Timer> samples_;

  Latest<wire::laser::Data> beams_{*this, 0, wire::laser::kDataScan};
};

}  // namespace playhouse::drivers
