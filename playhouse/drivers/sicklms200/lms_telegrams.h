#pragma once

/// Telegrams of SICK LMS 200, 211, 220, 221 and 291: both ends use these.
///
/// 02, address (of the laser, + 80 hex if it speaks), L = bytes that follow, L bytes, CRC. What follows begins with a code; the
/// answer's code is that + 80 hex, and its last byte is a status. Numbers are little-endian. Before an answer comes a
/// byte 06: taken, or alone 15: the CRC was wrong.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "playhouse/drivers/hardware/bytes.h"

namespace playhouse::drivers::sick {

enum LmsCode : std::uint8_t {
  kReset = 0x10,
  kSetMode = 0x20,
  kAskScan = 0x30,
  kAskStatus = 0x31,
  kAskType = 0x3A,
  kSetVariant = 0x3B,
  kAskBlock = 0x74,
  kSetBlock = 0x77,
  // Answers.
  kPowerOn = 0x90,
  kResets = 0x91,
  kRefused = 0x92,
  kModeSet = 0xA0,
  kWholeScan = 0xB0,
  kStatus = 0xB1,
  kPartOfScan = 0xB7,
  kType = 0xBA,
  kVariantSet = 0xBB,
  kBlock = 0xF4,
  kBlockSet = 0xF7,
};

/// Operating modes, the byte after kSetMode.
enum LmsMode : std::uint8_t {
  kConfigures = 0x00,  // with a password of 8 letters
  kStreams = 0x24,
  kOnRequest = 0x25,
  kStreamsPart = 0x27,  // with the first and the last value, counted from 1
  k38400 = 0x40,
  k19200 = 0x41,
  k9600 = 0x42,
  k500000 = 0x48,
};
/// Of a speed that the laser has; none of others.
std::optional<std::uint8_t> mode_of_baud(int baud);
std::optional<int> baud_of_mode(std::uint8_t mode);

inline constexpr std::byte kTakenByte{0x06}, kNotTakenByte{0x15};
inline constexpr std::string_view kLmsPassword = "SICK_LMS";

std::uint16_t crc(std::span<const std::byte> bytes);
RawBytes to_laser(std::span<const std::byte> telegram);
RawBytes from_laser(std::span<const std::byte> telegram);  // adds the status "all well"
/// A code, and one byte after it, to the laser.
RawBytes ask(std::uint8_t code);
RawBytes ask(std::uint8_t code, std::uint8_t what);
RawBytes ask_for_part(int first, int last);

/// Takes telegrams of one end out of bytes: what comes between two, and what has a wrong CRC, is left out.
class LmsReader {
 public:
  enum class LmsEnd : std::uint8_t { kHost, kLaser };
  explicit LmsReader(LmsEnd from) : from_(from) {}

  void add(std::span<const std::byte> bytes);
  /// The next one, from its code on, without the status.
  std::optional<RawBytes> next();
  void clear() { bytes_.clear(); }
  /// Telegrams with a wrong CRC.
  std::size_t damaged() const { return damaged_; }

 private:
  const LmsEnd from_;
  RawBytes bytes_;
  std::size_t damaged_ = 0;
};

/// Degrees, and hundredths of a degree.
struct LmsVariant {
  int width = 180, resolution = 100;

  int values() const { return 100 * width / resolution + 1; }
  bool is_valid() const;
  friend bool operator==(const LmsVariant&, const LmsVariant&) = default;
};
RawBytes encode_variant(const LmsVariant& variant);
/// Of kSetVariant, or of kVariantSet behind the byte that says whether.
std::optional<LmsVariant> read_variant(std::span<const std::byte> telegram);

/// What is used of kStatus.
struct LmsState {
  std::string_view version;  // 7 letters
  std::uint8_t mode = kOnRequest;
  std::uint8_t measuring_mode = 0;
  LmsVariant variant;
};
RawBytes encode_state(const LmsState& state);
std::optional<LmsVariant> read_state(std::span<const std::byte> telegram);

/// Places in the configuration block, behind the code.
inline constexpr std::size_t kAvailabilityAt = 4, kMeasuringModeAt = 5, kUnitAt = 6, kLeastBlock = 7;
inline constexpr std::uint8_t kHighAvailability = 1, kRealTimeIndex = 2;  // bits of availability
enum LmsUnit : std::uint8_t { kCentimetre, kMillimetre, kDecimetre };
double metres_of(std::uint8_t unit);

/// Bits of a value for its distance; the others are for intensity or fields.
int distance_bits(std::uint8_t measuring_mode);
/// Distances from this one on say why there is none: the largest number is an invalid one.
inline int first_special(int bits) {
  return (1 << bits) - 9;
}

struct LmsScan {
  int first = 1;                  // of the values, counted from 1
  bool is_part = false;           // kPartOfScan
  std::uint8_t unit = 0;          // LmsUnit
  std::vector<int> values;        // 16 bits each
  std::optional<int> index = {};  // with kRealTimeIndex
};
RawBytes encode_scan(const LmsScan& scan);
/// None if it is none, or is cut short. An index is not read.
std::optional<LmsScan> read_scan(std::span<const std::byte> telegram);

/// s from one scan to the next: the mirror turns 75 times a second, finer scans need several turns, and slow lines skip some.
double scan_period(const LmsVariant& variant, int values, int baud);

}  // namespace playhouse::drivers::sick
