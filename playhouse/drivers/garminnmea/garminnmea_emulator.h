#pragma once

/// The .cfg driver "garminnmea_emulator": a satellite receiver at the far end of a line, for a gps device of this server.

#include <memory>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/emulator.h"
#include "playhouse/wire/generated/gps.h"

namespace playhouse::drivers {

extern const DriverDefinition kGarminNmeaEmulatorDriver;

struct GarminNmeaEmulatorOptions {
  EmulatorPlace place;
  std::string talker;
  double period = 1;  // s
};

class GarminNmeaEmulator final : public Emulator {
 public:
  enum NmeaUsed : std::size_t { kReceiver };

  GarminNmeaEmulator(std::string name, Site& site, const GarminNmeaEmulatorOptions& options,
                     UsedDevices used);

 private:
  /// A receiver may be told corrections; these are left out.
  void line_received(std::span<const std::byte>) override {}
  void cycle();
  std::string sentences(const wire::gps::Data& fix) const;

  const GarminNmeaEmulatorOptions options_;
  std::unique_ptr<net::Timer> cycle_;
  Latest<wire::gps::Data> fix_{*this, kReceiver, wire::gps::kDataState};
};

}  // namespace playhouse::drivers
