#pragma once

/// The .cfg driver "khepera_emulator": a Khepera at the far end of a line, for devices of this server.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/emulator.h"
#include "playhouse/drivers/hardware/wheel_odometry.h"
#include "playhouse/drivers/khepera/khepera_lines.h"
#include "playhouse/wire/generated/ir.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

extern const DriverDefinition kKheperaEmulatorDriver;

struct KheperaEmulatorOptions {
  EmulatorPlace place;
  double axle = khepera::kAxle;  // m
};

class KheperaEmulator final : public Emulator {
 public:
  enum KheperaUsed : std::size_t { kWheels, kIr };

  KheperaEmulator(std::string name, Site& site, const KheperaEmulatorOptions& options, UsedDevices used);

 private:
  void reset() override { drive(0, 0); }
  struct WheelPair {
    double left = 0, right = 0;
  };

  void line_received(std::span<const std::byte> bytes) override;

  void obey(const khepera::KheperaLine& line);
  void answer(char letter, std::initializer_list<std::int64_t> numbers = {});
  void refuse(const std::string& why);
  void drive(double left, double right);
  void cycle();
  void approach();
  void tell_sensors();
  WheelPair counters() const;
  WheelPair speeds();

  const KheperaEmulatorOptions options_;
  khepera::KheperaReader reader_;
  WheelSteps steps_;
  WheelPair ways_, origin_;          // pulses: gone, and where the counters are 0
  WheelPair wanted_;                 // units of speed
  std::optional<WheelPair> target_;  // pulses of the counters
  std::unique_ptr<net::Timer> cycle_;

  Latest<wire::position2d::Data> base_{*this, kWheels, wire::position2d::kDataState};
  Latest<wire::ir::Data> ranges_{*this, kIr, wire::ir::kDataRanges};
};

}  // namespace playhouse::drivers
