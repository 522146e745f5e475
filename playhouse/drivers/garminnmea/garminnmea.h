#pragma once

/// The .cfg driver "garminnmea": satellite receivers that speak NMEA 0183, of any maker.
///
/// A fix is published with each GGA. Its day is that of the last RMC or ZDA; speed and course are those of the last RMC,
/// expected errors those of the last GST or PGRME.

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/garminnmea/nmea_sentences.h"
#include "playhouse/drivers/hardware/hardware_driver.h"
#include "playhouse/wire/generated/gps.h"

namespace playhouse::drivers {

extern const DriverDefinition kGarminNmeaDriver;

class GarminNmea final : public HardwareDriver {
 public:
  enum NmeaDevice : std::size_t { kReceiver };

  GarminNmea(std::string name, Site& site, const HardwareOptions& options);

 private:
  void began() override;
  void received(std::span<const std::byte> bytes) override;
  void ending() override {}
  void forgot() override;

  void be_patient();
  void take(const nmea::NmeaFields& fields);
  void take_rmc(const nmea::Rmc& rmc);
  void publish_fix(const nmea::Gga& gga);
  void put_time(const nmea::Gga& gga);

  const int baud_;
  nmea::SentenceReader reader_;
  wire::gps::Data fix_;                 // what sentences beside GGA told last
  std::optional<nmea::NmeaDate> date_;  // and the time of the day at which it was told
  std::unique_ptr<net::Timer> patience_;
};

}  // namespace playhouse::drivers
