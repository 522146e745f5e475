#include "playhouse/drivers/sicklms200/lms_telegrams.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace playhouse::drivers::sick {
namespace {

constexpr std::byte kStart{0x02};
constexpr int kOfLaser = 0x80, kAllWell = 0x10;
constexpr std::size_t kBeforeCode = 4, kCrcBytes = 2;
constexpr std::size_t kLongestFromHost = 256, kLongestFromLaser = 1024;
constexpr int kCountBits = 0x3FF;
constexpr std::size_t kStateBytes = 152, kModeInState = 8, kMeasuringModeInState = 102, kVariantInState = 107;
constexpr std::pair<std::uint8_t, int> kBauds[] = {
    {k38400, 38400}, {k19200, 19200}, {k9600, 9600}, {k500000, 500000}};

RawBytes telegram_of(int address, std::span<const std::byte> telegram, int more) {
  RawBytes bytes{kStart};
  put_u8(bytes, address);
  put_16_le(bytes, static_cast<int>(telegram.size()) + more);
  bytes.insert(bytes.end(), telegram.begin(), telegram.end());
  if (more > 0) put_u8(bytes, kAllWell);
  put_16_le(bytes, crc(bytes));
  return bytes;
}

}  // namespace

std::optional<std::uint8_t> mode_of_baud(int baud) {
  for (const auto& [mode, speed] : kBauds)
    if (speed == baud) return mode;
  return std::nullopt;
}

std::optional<int> baud_of_mode(std::uint8_t mode) {
  for (const auto& [number, speed] : kBauds)
    if (number == mode) return speed;
  return std::nullopt;
}

/// Polynomial 8005 over pairs of neighbouring bytes.
std::uint16_t crc(std::span<const std::byte> bytes) {
  unsigned sum = 0, before = 0;
  for (const std::byte each : bytes) {
    const auto byte = static_cast<unsigned>(each);
    sum = (sum & 0x8000) != 0 ? ((sum & 0x7FFF) << 1) ^ 0x8005 : sum << 1;
    sum ^= byte | before << 8;
    before = byte;
  }
  return static_cast<std::uint16_t>(sum);
}

RawBytes to_laser(std::span<const std::byte> telegram) {
  return telegram_of(0, telegram, 0);
}

RawBytes from_laser(std::span<const std::byte> telegram) {
  return telegram_of(kOfLaser, telegram, 1);
}

RawBytes ask(std::uint8_t code) {
  RawBytes telegram;
  put_u8(telegram, code);
  return to_laser(telegram);
}

RawBytes ask(std::uint8_t code, std::uint8_t what) {
  RawBytes telegram;
  put_u8(telegram, code);
  put_u8(telegram, what);
  return to_laser(telegram);
}

RawBytes ask_for_part(int first, int last) {
  RawBytes telegram;
  put_u8(telegram, kSetMode);
  put_u8(telegram, kStreamsPart);
  put_16_le(telegram, first);
  put_16_le(telegram, last);
  return to_laser(telegram);
}

void LmsReader::add(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

/// Within a telegram with a wrong CRC a whole one may begin, if it was cut short.
std::optional<RawBytes> LmsReader::next() {
  const bool of_laser = from_ == LmsEnd::kLaser;
  const std::byte address{static_cast<std::uint8_t>(of_laser ? kOfLaser : 0)};
  const std::size_t longest = of_laser ? kLongestFromLaser : kLongestFromHost, least = of_laser ? 2 : 1;
  std::size_t at = 0;
  std::optional<RawBytes> found;
  for (; at < bytes_.size() && !found; ++at) {
    if (bytes_[at] != kStart) continue;
    const std::span<const std::byte> rest = std::span(bytes_).subspan(at);
    if (rest.size() > 1 && rest[1] != address) continue;
    if (rest.size() < kBeforeCode) break;
    const std::size_t length = u16_le(rest, 2);
    if (length < least || length > longest) continue;
    if (rest.size() < kBeforeCode + length + kCrcBytes) break;
    if (crc(rest.first(kBeforeCode + length)) != u16_le(rest, kBeforeCode + length)) {
      ++damaged_;
      continue;
    }
    const auto telegram = rest.subspan(kBeforeCode, of_laser ? length - 1 : length);
    found.emplace(telegram.begin(), telegram.end());
    at += kBeforeCode + length + kCrcBytes - 1;
  }
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(at));
  return found;
}

bool LmsVariant::is_valid() const {
  return (width == 100 && (resolution == 25 || resolution == 50 || resolution == 100)) ||
         (width == 180 && (resolution == 50 || resolution == 100));
}

RawBytes encode_variant(const LmsVariant& variant) {
  RawBytes telegram;
  put_u8(telegram, kSetVariant);
  put_16_le(telegram, variant.width);
  put_16_le(telegram, variant.resolution);
  return telegram;
}

std::optional<LmsVariant> read_variant(std::span<const std::byte> telegram) {
  const std::size_t at = !telegram.empty() && u8(telegram, 0) == kVariantSet ? 2 : 1;
  if (telegram.size() < at + 4) return std::nullopt;
  return LmsVariant{u16_le(telegram, at), u16_le(telegram, at + 2)};
}

RawBytes encode_state(const LmsState& state) {
  RawBytes telegram;
  put_u8(telegram, kStatus);
  put_text(telegram, state.version);
  telegram.resize(kStateBytes);
  telegram[kModeInState] = static_cast<std::byte>(state.mode);
  telegram[kMeasuringModeInState] = static_cast<std::byte>(state.measuring_mode);
  RawBytes variant;
  put_16_le(variant, state.variant.width);
  put_16_le(variant, state.variant.resolution);
  std::ranges::copy(variant, telegram.begin() + kVariantInState);
  return telegram;
}

std::optional<LmsVariant> read_state(std::span<const std::byte> telegram) {
  if (telegram.size() < kVariantInState + 4) return std::nullopt;
  return LmsVariant{u16_le(telegram, kVariantInState), u16_le(telegram, kVariantInState + 2)};
}

double metres_of(std::uint8_t unit) {
  return unit == kMillimetre ? 0.001 : unit == kCentimetre ? 0.01 : 0.1;
}

int distance_bits(std::uint8_t measuring_mode) {
  return measuring_mode <= 2 ? 13 : measuring_mode <= 4 ? 14 : 15;
}

RawBytes encode_scan(const LmsScan& scan) {
  RawBytes telegram;
  const int count = static_cast<int>(scan.values.size());
  put_u8(telegram, scan.is_part ? kPartOfScan : kWholeScan);
  if (scan.is_part) {
    put_16_le(telegram, scan.first);
    put_16_le(telegram, scan.first + count - 1);
  }
  put_16_le(telegram, count | scan.unit << 14);
  for (const int value : scan.values) put_16_le(telegram, value);
  if (scan.index) put_u8(telegram, *scan.index);
  return telegram;
}

std::optional<LmsScan> read_scan(std::span<const std::byte> telegram) {
  if (telegram.empty()) return std::nullopt;
  LmsScan scan{.is_part = u8(telegram, 0) == kPartOfScan, .values = {}};
  if (!scan.is_part && u8(telegram, 0) != kWholeScan) return std::nullopt;
  std::size_t at = scan.is_part ? 5 : 1;
  if (telegram.size() < at + 2) return std::nullopt;
  if (scan.is_part) scan.first = u16_le(telegram, 1);
  const std::uint16_t count = u16_le(telegram, at);
  scan.unit = static_cast<std::uint8_t>(count >> 14);
  at += 2;
  if (telegram.size() < at + 2u * (count & kCountBits)) return std::nullopt;
  for (int value = 0; value < (count & kCountBits); ++value, at += 2)
    scan.values.push_back(u16_le(telegram, at));
  return scan;
}

double scan_period(const LmsVariant& variant, int values, int baud) {
  constexpr double kTurn = 1.0 / 75, kBitsOfByte = 10;
  constexpr int kBytesBesides = 14;
  const double measured = kTurn * 100 / std::max(1, variant.resolution);
  const double sent = kBitsOfByte * (2 * values + kBytesBesides) / baud;
  return measured * std::max(1.0, std::ceil(sent / measured));
}

}  // namespace playhouse::drivers::sick
