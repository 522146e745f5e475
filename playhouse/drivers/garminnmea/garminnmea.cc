#include "playhouse/drivers/garminnmea/garminnmea.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/drivers/geodesy.h"
#include "playhouse/geom/trig.h"

namespace playhouse::drivers {

namespace gps = wire::gps;

namespace {

constexpr double kNmeaSilence = 10;  // s without a sentence
constexpr double kDegreeUnit = 1e-7;
constexpr int kNmeaBauds[] = {4800, 9600, 19200, 38400, 57600, 115200, 230400};

constexpr DeviceText kGarminNmeaProvides[] = {{"gps"}};

HardwareOptions garminnmea_options(SectionFields& fields) {
  const int baud =
      fields.integer({"baud", "Of the receiver: 4800, 9600, 19200, 38400, 57600, 115200 or 230400.", "baud"},
                     4800, 4800, 230400);
  fields.expect(std::ranges::find(kNmeaBauds, baud) != std::end(kNmeaBauds), "baud",
                "is 4800, 9600, 19200, 38400, 57600, 115200 or 230400");
  const LinePlace place = read_line_place(
      fields, {"port", "Serial port of the receiver, or a TCP port that passes its bytes on: tcp:lab:8101."},
      "/dev/ttyS0", {.baud = baud});
  for (const std::string_view name : {"dgps_enable", "dgps_group", "dgps_port"})
    fields.no_effect({name, "Corrections of the original's multicast group are not passed on."});
  return read_hardware_options(fields, place, false);
}

std::uint32_t tenths(double value) {
  constexpr double kMost = 1e6;
  return static_cast<std::uint32_t>(std::lround(10 * std::clamp(value, 0.0, kMost)));
}

}  // namespace

GarminNmea::GarminNmea(std::string name, Site& site, const HardwareOptions& options)
    : HardwareDriver(std::move(name), site, options), baud_(options.place.serial.baud) {}

void GarminNmea::began() {
  be_patient();
}

void GarminNmea::be_patient() {
  patience_ = after(kNmeaSilence, [this] {
    give_up(fmt::format("no NMEA sentence has come for {} s: is a receiver there, at {} baud?", kNmeaSilence,
                        baud_));
  });
}

void GarminNmea::forgot() {
  reader_.clear();
  patience_.reset();
  fix_ = {};
  date_.reset();
}

void GarminNmea::received(std::span<const std::byte> bytes) {
  reader_.add(bytes);
  while (const std::optional<nmea::NmeaFields> fields = reader_.next()) {
    be_patient();
    take(*fields);
  }
}

void GarminNmea::take(const nmea::NmeaFields& fields) {
  const std::string_view type = nmea::type_of(fields);
  if (type == "GGA") {
    if (const auto gga = nmea::read_gga(fields)) publish_fix(*gga);
  } else if (type == "RMC") {
    if (const auto rmc = nmea::read_rmc(fields)) take_rmc(*rmc);
  } else if (type == "ZDA") {
    if (const auto told = nmea::read_zda(fields)) date_ = told;
  } else if (type == "GST" || type == "PGRME") {
    const auto errors = type == "GST" ? nmea::read_gst(fields) : nmea::read_pgrme(fields);
    if (errors && errors->horizontal) fix_.err_horz = *errors->horizontal;
    if (errors && errors->vertical) fix_.err_vert = *errors->vertical;
  } else if (type == "GSA") {
    if (const auto dilutions = nmea::read_gsa(fields); dilutions && dilutions->vertical)
      fix_.vdop = tenths(*dilutions->vertical);
  }
}

/// While the receiver warns of its own fix, its speed is none.
void GarminNmea::take_rmc(const nmea::Rmc& rmc) {
  if (rmc.date && rmc.time) date_ = nmea::NmeaDate{*rmc.time, *rmc.date};
  if (!rmc.is_valid) return;
  fix_.speed = rmc.speed.value_or(fix_.speed);
  if (rmc.course) fix_.course = geom::radians(*rmc.course);
}

/// A day may have begun since its date was told, or have been told first.
void GarminNmea::put_time(const nmea::Gga& gga) {
  if (!date_ || !gga.time) return;
  std::int64_t micros = date_->date + *gga.time;
  if (*gga.time < date_->time - nmea::kDay / 2) micros += nmea::kDay;
  if (*gga.time > date_->time + nmea::kDay / 2) micros -= nmea::kDay;
  fix_.time_sec = static_cast<std::uint32_t>(micros / 1'000'000);
  fix_.time_usec = static_cast<std::uint32_t>(micros % 1'000'000);
}

/// As in the interface: metres, and a course from north; the original has other units.
void GarminNmea::publish_fix(const nmea::Gga& gga) {
  put_time(gga);
  fix_.num_sats = static_cast<std::uint32_t>(gga.satellites);
  fix_.hdop = tenths(gga.hdop.value_or(0));
  gps::Data fix = fix_;
  if (gga.quality == 0 || !gga.place) {
    fix = {};
    fix.time_sec = fix_.time_sec;
    fix.time_usec = fix_.time_usec;
    fix.num_sats = fix_.num_sats;
    fix.hdop = fix_.hdop;
    return publish(kReceiver, gps::kDataState, fix);
  }
  fix.quality = static_cast<std::uint32_t>(gga.quality);
  fix.latitude = gga.place->latitude;
  fix.longitude = gga.place->longitude;
  constexpr double kMostMetres = 2e6;
  const double height = gga.altitude.value_or(0) + gga.geoid.value_or(0);
  fix.altitude = static_cast<std::int32_t>(std::lround(1000 * std::clamp(height, -kMostMetres, kMostMetres)));
  const Utm utm =
      utm_of({geom::radians(fix.latitude * kDegreeUnit), geom::radians(fix.longitude * kDegreeUnit), height});
  fix.utm_e = utm.easting;
  fix.utm_n = utm.northing;
  publish(kReceiver, gps::kDataState, fix);
}

constinit const DriverDefinition kGarminNmeaDriver{
    .name = "garminnmea",
    .doc = "Satellite receivers that speak NMEA 0183, of any maker.",
    .provides = kGarminNmeaProvides,
    .read_options = reading<garminnmea_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_hardware<GarminNmea>(section, site, garminnmea_options, kGarminNmeaProvides);
    },
};

}  // namespace playhouse::drivers
