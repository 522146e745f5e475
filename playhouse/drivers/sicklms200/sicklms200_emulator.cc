#include "playhouse/drivers/sicklms200/sicklms200_emulator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "playhouse/drivers/hardware/scanner_driver.h"

namespace playhouse::drivers {
namespace {

constexpr double kHundredthOfLms = std::numbers::pi / 18000;  // rad
constexpr int kDeliveredBaud = 9600;
constexpr std::size_t kBlockBytes = 33;
constexpr std::uint8_t kModeFault = 2, kWrongPassword = 1;
constexpr double kResetTime = 2;  // s; of the real one, up to a minute
constexpr std::string_view kUsualType = "LMS200;30106;V02.10 ";

constexpr DeviceText kLmsUses[] = {{"laser", {}, HowMany::kOne, "what it sees"}};

SickLms200EmulatorOptions sick_lms200_emulator_options(SectionFields& fields) {
  SickLms200EmulatorOptions options;
  const int baud =
      fields.integer({"baud", "At which it begins; hosts set another: 9600, 19200, 38400 or 500000.", "baud"},
                     kDeliveredBaud, kDeliveredBaud, 500000);
  fields.expect(sick::mode_of_baud(baud).has_value(), "baud", "is 9600, 19200, 38400 or 500000");
  options.place = read_emulator_place(fields, {.baud = baud});
  options.type = fields.text({"type", "Type, number and version that it tells.", {}, kUsualType});
  if (options.type.empty()) options.type = kUsualType;
  constexpr std::size_t kLongestType = 100;
  fields.expect(options.type.size() <= kLongestType, "type", "has at most 100 letters");
  return options;
}

/// As it is delivered: centimetres, up to 80 m.
RawBytes delivered_block() {
  RawBytes block(kBlockBytes);
  block[2] = std::byte{0x46};
  block[11] = block[10] = std::byte{2};
  return block;
}

std::string_view version_of(std::string_view type) {
  constexpr std::size_t kVersionLetters = 7;
  const std::size_t at = type.rfind(';');
  std::string_view version = at == std::string_view::npos ? type : type.substr(at + 1);
  return version.substr(0, kVersionLetters);
}

}  // namespace

SickLms200Emulator::SickLms200Emulator(std::string name, Site& site, const SickLms200EmulatorOptions& options,
                                       UsedDevices used)
    : Emulator(std::move(name), site, options.place, std::move(used)),
      options_(options),
      baud_(options.place.serial.baud),
      block_(delivered_block()) {}

void SickLms200Emulator::line_received(std::span<const std::byte> bytes) {
  reader_.add(bytes);
  while (const std::optional<RawBytes> telegram = reader_.next()) take(*telegram);
  if (std::exchange(damaged_, reader_.damaged()) != reader_.damaged())
    send(std::span(&sick::kNotTakenByte, 1));
}

// --- answers

void SickLms200Emulator::answer(std::span<const std::byte> telegram) {
  send(std::span(&sick::kTakenByte, 1));
  send(sick::from_laser(telegram));
}

void SickLms200Emulator::answer(std::uint8_t code, std::uint8_t what) {
  RawBytes telegram;
  put_u8(telegram, code);
  put_u8(telegram, what);
  answer(telegram);
}

void SickLms200Emulator::take(std::span<const std::byte> telegram) {
  RawBytes told;
  switch (u8(telegram, 0)) {
    case sick::kSetMode:
      return take_mode(telegram.subspan(1));
    case sick::kAskType:
      put_u8(told, sick::kType);
      put_text(told, options_.type);
      return answer(told);
    case sick::kAskStatus:
      return answer(sick::encode_state({.version = version_of(options_.type),
                                        .mode = mode_,
                                        .measuring_mode = in_block(sick::kMeasuringModeAt),
                                        .variant = variant_}));
    case sick::kSetVariant:
      return set_variant(telegram);
    case sick::kAskBlock:
      put_u8(told, sick::kBlock);
      told.insert(told.end(), block_.begin(), block_.end());
      return answer(told);
    case sick::kSetBlock:
      return set_block(telegram.subspan(1));
    case sick::kAskScan:
      if (telegram.size() == 2 && u8(telegram, 1) == 1)
        return answer(sick::encode_scan(scan(1, variant_.values())));
      break;
    case sick::kReset:
      return restart();
    default:
      break;
  }
  put_u8(told, sick::kRefused);
  answer(told);
}

void SickLms200Emulator::take_mode(std::span<const std::byte> telegram) {
  if (telegram.empty()) return answer(sick::kModeSet, kModeFault);
  const std::uint8_t mode = u8(telegram, 0);
  const std::span<const std::byte> parameters = telegram.subspan(1);
  if (const auto baud = sick::baud_of_mode(mode)) {
    answer(sick::kModeSet, 0);
    return change_baud(*baud);
  }
  set_mode(mode, parameters);
}

void SickLms200Emulator::set_mode(std::uint8_t mode, std::span<const std::byte> parameters) {
  RawBytes password;
  put_text(password, sick::kLmsPassword);
  if (mode == sick::kConfigures && !std::ranges::equal(parameters, password))
    return answer(sick::kModeSet, kWrongPassword);
  int first = 1, last = variant_.values();
  if (mode == sick::kStreamsPart && parameters.size() == 4) {
    first = u16_le(parameters, 0);
    last = u16_le(parameters, 2);
  }
  const bool is_known = mode == sick::kConfigures || mode == sick::kStreams || mode == sick::kOnRequest ||
                        (mode == sick::kStreamsPart && parameters.size() == 4);
  if (!is_known || first < 1 || last < first || last > variant_.values())
    return answer(sick::kModeSet, kModeFault);
  mode_ = mode;
  first_ = first;
  last_ = last;
  turn_.reset();
  answer(sick::kModeSet, 0);
  if (mode == sick::kStreams || mode == sick::kStreamsPart) stream();
}

/// The answer goes out at the speed before.
void SickLms200Emulator::change_baud(int baud) {
  baud_ = baud;
  net::SerialSettings serial = options_.place.serial;
  serial.baud = baud;
  speak(serial);
}

void SickLms200Emulator::restart() {
  RawBytes told;
  put_u8(told, sick::kResets);
  answer(told);
  turn_ = after(kResetTime, [this] {
    RawBytes ready;
    put_u8(ready, sick::kPowerOn);
    put_text(ready, options_.type);
    send(sick::from_laser(ready));
  });
  mode_ = sick::kOnRequest;
  change_baud(kDeliveredBaud);
}

void SickLms200Emulator::set_variant(std::span<const std::byte> telegram) {
  const auto wanted = sick::read_variant(telegram);
  const bool is_good = wanted && wanted->is_valid();
  if (is_good) {
    variant_ = *wanted;
    turn_.reset();  // a stream ends
    if (mode_ != sick::kConfigures) mode_ = sick::kOnRequest;
  }
  RawBytes told;
  put_u8(told, sick::kVariantSet);
  put_u8(told, is_good ? 1 : 0);
  const RawBytes now = sick::encode_variant(variant_);
  told.insert(told.end(), now.begin() + 1, now.end());
  answer(told);
}

/// Hosts send all of it, or the first bytes.
void SickLms200Emulator::set_block(std::span<const std::byte> block) {
  constexpr std::uint8_t kMostMeasuringMode = 6, kImmediate = 0x0F;
  bool is_good = mode_ == sick::kConfigures && block.size() >= sick::kLeastBlock;
  if (is_good) {
    const std::uint8_t measuring = u8(block, sick::kMeasuringModeAt);
    is_good = (measuring <= kMostMeasuringMode || measuring == kImmediate) &&
              u8(block, sick::kUnitAt) <= sick::kDecimetre;
  }
  if (is_good) std::ranges::copy(block.first(std::min(block.size(), block_.size())), block_.begin());
  RawBytes told;
  put_u8(told, sick::kBlockSet);
  put_u8(told, is_good ? 1 : 0);
  told.insert(told.end(), block_.begin(), block_.end());
  answer(told);
}

// --- scans

/// It begins to send when its laser has seen something.
void SickLms200Emulator::stream() {
  const int count = last_ - first_ + 1;
  turn_ = after(sick::scan_period(variant_, count, baud_), [this] {
    if (!beams_.value().ranges.empty()) send(sick::from_laser(sick::encode_scan(scan(first_, last_))));
    stream();
  });
}

sick::LmsScan SickLms200Emulator::scan(int first, int last) {
  sick::LmsScan scan{
      .first = first, .is_part = mode_ == sick::kStreamsPart, .unit = in_block(sick::kUnitAt), .values = {}};
  for (int number = first; number <= last; ++number) scan.values.push_back(value_at(number));
  if ((in_block(sick::kAvailabilityAt) & sick::kRealTimeIndex) != 0) scan.index = index_++;
  return scan;
}

/// Bits above the distance are the echo's intensity in the modes that have such, and else fields, in which nothing is.
int SickLms200Emulator::value_at(int number) {
  const double angle = (100.0 * -variant_.width / 2 + (number - 1) * variant_.resolution) * kHundredthOfLms;
  const BeamEcho echo = echo_at(beams_.value(), angle);
  const std::uint8_t mode = in_block(sick::kMeasuringModeAt);
  const int bits = sick::distance_bits(mode), special = sick::first_special(bits);
  const double distance = echo.range / sick::metres_of(in_block(sick::kUnitAt));
  if (!echo.is_hit || !(distance < special - 0.5)) return special;
  const bool has_intensity = mode == 1 || mode == 3 || mode == 5;
  const int most = (1 << (16 - bits)) - 1;
  return static_cast<int>(std::lround(distance)) |
         (has_intensity ? std::min<int>(echo.intensity, most) << bits : 0);
}

constinit const DriverDefinition kSickLms200EmulatorDriver{
    .name = "sicklms200_emulator",
    .doc = "A SICK LMS 2xx at the far end of a line, for a laser of this server.",
    .provides = {},
    .uses = kLmsUses,
    .read_options = reading<sick_lms200_emulator_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_emulator<SickLms200Emulator>(section, site, sick_lms200_emulator_options, kLmsUses);
    },
};

}  // namespace playhouse::drivers
