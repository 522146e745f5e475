#pragma once

/// The .cfg driver "sicklms200_emulator": a SICK LMS 2xx at the far end of a line, that sees what a laser of this server sees.

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/emulator.h"
#include "playhouse/drivers/sicklms200/lms_telegrams.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

extern const DriverDefinition kSickLms200EmulatorDriver;

struct SickLms200EmulatorOptions {
  EmulatorPlace place;
  std::string type;
};

class SickLms200Emulator final : public Emulator {
 public:
  SickLms200Emulator(std::string name, Site& site, const SickLms200EmulatorOptions& options,
                     UsedDevices used);

 private:
  void line_received(std::span<const std::byte> bytes) override;
  void line_paused() override { reader_.clear(); }

  void take(std::span<const std::byte> telegram);
  void take_mode(std::span<const std::byte> telegram);
  void set_mode(std::uint8_t mode, std::span<const std::byte> parameters);
  void change_baud(int baud);
  void restart();
  void set_variant(std::span<const std::byte> telegram);
  void set_block(std::span<const std::byte> telegram);
  void answer(std::span<const std::byte> telegram);
  void answer(std::uint8_t code, std::uint8_t what);
  void stream();
  sick::LmsScan scan(int first, int last);
  int value_at(int number);
  std::uint8_t in_block(std::size_t at) const { return u8(block_, at); }

  const SickLms200EmulatorOptions options_;
  sick::LmsReader reader_{sick::LmsReader::LmsEnd::kHost};
  std::size_t damaged_ = 0;  // telegrams, that it has complained of
  int baud_;
  std::uint8_t mode_ = sick::kOnRequest;
  sick::LmsVariant variant_;
  int first_ = 1, last_ = 1;  // of a stream of parts
  RawBytes block_;            // its configuration
  std::uint8_t index_ = 0;    // of scans
  std::unique_ptr<net::Timer> turn_;

  Latest<wire::laser::Data> beams_{*this, 0, wire::laser::kDataScan};
};

}  // namespace playhouse::drivers
