#include "playhouse/drivers/garminnmea/garminnmea_emulator.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/drivers/garminnmea/nmea_sentences.h"
#include "playhouse/geom/trig.h"

namespace playhouse::drivers {

namespace gps = wire::gps;

namespace {

constexpr DeviceText kGarminNmeaEmulatorUses[] = {{"gps", {}, HowMany::kOne, "the receiver"}};

GarminNmeaEmulatorOptions garminnmea_emulator_options(SectionFields& fields) {
  GarminNmeaEmulatorOptions options;
  const int baud =
      fields.integer({"baud", "Of the receiver's line; a host at another speed is not understood.", "baud"},
                     4800, 50, 4000000);
  options.place = read_emulator_place(fields, {.baud = baud});
  options.talker =
      fields.text({"talker", "Two letters before the types of its sentences: GP, GN, GL ...", {}, "GP"});
  if (options.talker.empty()) options.talker = "GP";
  const bool is_talker = options.talker.size() == 2 &&
                         std::ranges::all_of(options.talker, [](char c) { return c >= 'A' && c <= 'Z'; });
  fields.expect(is_talker, "talker", "is two letters such as GP or GN, not " + in_quotes(options.talker));
  options.period = fields.number({"period", "Time between two fixes.", "s"}, 1, 0.05);
  return options;
}

/// m; the most also of what is no number.
double error_of(double told) {
  constexpr double kMost = 9999;
  return told < kMost ? std::max(told, 0.0) : kMost;
}

}  // namespace

GarminNmeaEmulator::GarminNmeaEmulator(std::string name, Site& site, const GarminNmeaEmulatorOptions& options,
                                       UsedDevices used)
    : Emulator(std::move(name), site, options.place, std::move(used)), options_(options) {
  cycle_ = after(options_.period, [this] { cycle(); });
}

void GarminNmeaEmulator::cycle() {
  const std::string text = sentences(fix_.value());
  send(std::as_bytes(std::span(text)));
  cycle_ = after(options_.period, [this] { cycle(); });
}

/// A receiver that has never had a fix knows no time.
std::string GarminNmeaEmulator::sentences(const gps::Data& fix) const {
  nmea::Gga gga{.quality = static_cast<int>(std::min(fix.quality, 8u)),
                .satellites = static_cast<int>(std::min(fix.num_sats, 99u))};
  nmea::Rmc rmc;
  nmea::Dilutions dilutions;
  if (fix.time_sec != 0 || fix.quality != 0) {
    constexpr std::uint32_t kSecondsOfDay = 86400;
    gga.time = rmc.time = fix.time_sec % kSecondsOfDay * 1'000'000LL + fix.time_usec % 1'000'000;
    rmc.date = fix.time_sec / kSecondsOfDay * nmea::kDay;
  }
  if (fix.quality == 0) {
    constexpr double kNoDilution = 99.9;
    gga.hdop = kNoDilution;
    return nmea::encode_rmc(options_.talker, rmc) + nmea::encode_gga(options_.talker, gga) +
           nmea::encode_gsa(options_.talker, gga.satellites, dilutions);
  }
  gga.place = rmc.place = nmea::NmeaPlace{fix.latitude, fix.longitude};
  gga.hdop = dilutions.horizontal = fix.hdop / 10.0;
  dilutions.vertical = fix.vdop / 10.0;
  dilutions.position = std::hypot(fix.hdop, fix.vdop) / 10;
  gga.altitude = fix.altitude / 1000.0;  // above the ellipsoid, where this sea is
  gga.geoid = 0;
  rmc.is_valid = true;
  constexpr double kMostSpeed = 9999;
  if (std::isfinite(fix.speed)) rmc.speed = std::clamp(fix.speed, 0.0, kMostSpeed);
  if (std::isfinite(fix.course)) {
    const double course = std::fmod(geom::degrees(fix.course), 360);
    rmc.course = course < 0 ? course + 360 : course;
  }
  return nmea::encode_rmc(options_.talker, rmc) + nmea::encode_gga(options_.talker, gga) +
         nmea::encode_gsa(options_.talker, gga.satellites, dilutions) +
         nmea::encode_pgrme({error_of(fix.err_horz), error_of(fix.err_vert)});
}

constinit const DriverDefinition kGarminNmeaEmulatorDriver{
    .name = "garminnmea_emulator",
    .doc = "A satellite receiver at the far end of a line, for a gps device of this server.",
    .provides = {},
    .uses = kGarminNmeaEmulatorUses,
    .read_options = reading<garminnmea_emulator_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_emulator<GarminNmeaEmulator>(section, site, garminnmea_emulator_options,
                                               kGarminNmeaEmulatorUses);
    },
};

}  // namespace playhouse::drivers
