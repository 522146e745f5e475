#pragma once

/// Sentences of satellite receivers, NMEA 0183: both ends use these.
///
/// "$", who talks (two letters: GP, GN ...) and the type (three), fields after commas, "*" and the exclusive-or of what is
/// between both as two hexadecimal digits, CR LF. A field that is not known is empty. Those of a maker begin with "P".

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/drivers/hardware/bytes.h"

namespace playhouse::drivers::nmea {

inline constexpr double kKnot = 1852.0 / 3600;  // m/s

/// The exclusive-or of all letters.
std::uint8_t sum_of(std::string_view text);
/// "GPGGA,..." as a sentence.
std::string sentence_of(std::string_view text);

/// Fields of a sentence; the first one is who talks and the type.
using NmeaFields = std::vector<std::string>;
/// "GGA" of any talker, "PGRME" of a maker; empty: none.
std::string_view type_of(const NmeaFields& fields);

/// Takes sentences out of bytes: what has no sum, or a wrong one, is left out, and so is what is longer than any.
class SentenceReader {
 public:
  void add(std::span<const std::byte> bytes);
  std::optional<NmeaFields> next();
  void clear() { text_.clear(); }

 private:
  std::string text_;  // from a "$" on
};

/// Time of a day.  [us]
using DayTime = std::int64_t;
inline constexpr DayTime kDay = 86'400'000'000;
/// Of the day, since 1970.  [us]
using DayStart = std::int64_t;

/// A place on the earth, 1e-7 deg: positive north and east.
struct NmeaPlace {
  std::int32_t latitude = 0, longitude = 0;
  friend bool operator==(const NmeaPlace&, const NmeaPlace&) = default;
};

/// What may be empty in a sentence is optional here.
struct Gga {
  std::optional<DayTime> time = {};
  std::optional<NmeaPlace> place = {};
  int quality = 0, satellites = 0;
  std::optional<double> hdop = {}, altitude = {},
                        geoid = {};  // m above sea, and of the sea above the ellipsoid
};
struct Rmc {
  std::optional<DayTime> time = {};
  std::optional<DayStart> date = {};
  bool is_valid = false;
  std::optional<NmeaPlace> place = {};
  std::optional<double> speed = {}, course = {};  // m/s, deg clockwise from north
};
struct NmeaDate {
  DayTime time = 0;
  DayStart date = 0;
};
/// Expected errors.  [m]
struct NmeaErrors {
  std::optional<double> horizontal = {}, vertical = {};
};
struct Dilutions {
  std::optional<double> position = {}, horizontal = {}, vertical = {};
};

/// None if a field that is not empty is none of its kind.
std::optional<Gga> read_gga(const NmeaFields& fields);
std::optional<Rmc> read_rmc(const NmeaFields& fields);
std::optional<NmeaDate> read_zda(const NmeaFields& fields);
std::optional<NmeaErrors> read_gst(const NmeaFields& fields);
std::optional<NmeaErrors> read_pgrme(const NmeaFields& fields);
std::optional<Dilutions> read_gsa(const NmeaFields& fields);

/// Sentences of a talker, with the checksum and the end of the line.
std::string encode_gga(std::string_view talker, const Gga& gga);
std::string encode_rmc(std::string_view talker, const Rmc& rmc);
std::string encode_gsa(std::string_view talker, int satellites, const Dilutions& dilutions);
std::string encode_pgrme(const NmeaErrors& errors);

}  // namespace playhouse::drivers::nmea
