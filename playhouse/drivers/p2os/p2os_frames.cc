#include "playhouse/drivers/p2os/p2os_frames.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace playhouse::drivers::p2os {
namespace {

constexpr std::byte kFirst{0xFA}, kSecond{0xFB};
constexpr std::size_t kBefore = 3;                        // bytes of a frame before its data
constexpr std::size_t kLeastCount = 3, kMostCount = 249;  // of N
constexpr int kNotNegative = 0x3B, kNegative = 0x1B;
constexpr std::size_t kUpToSonars = 20;  // bytes of a SIP

}  // namespace

std::uint16_t checksum(std::span<const std::byte> data) {
  unsigned sum = 0;
  std::size_t at = 0;
  for (; at + 1 < data.size(); at += 2) sum += u16_be(data, at);
  if (at < data.size()) sum ^= u8(data, at);
  return static_cast<std::uint16_t>(sum);
}

RawBytes frame(std::span<const std::byte> data) {
  RawBytes bytes{kFirst, kSecond};
  put_u8(bytes, static_cast<int>(data.size()) + 2);
  bytes.insert(bytes.end(), data.begin(), data.end());
  put_16_be(bytes, checksum(data));
  return bytes;
}

RawBytes encode_command(std::uint8_t number) {
  return frame(std::array{static_cast<std::byte>(number)});
}

RawBytes encode_command(std::uint8_t number, int argument) {
  RawBytes data;
  put_u8(data, number);
  put_u8(data, argument < 0 ? kNegative : kNotNegative);
  put_16_le(data, std::min(std::abs(argument), 0xFFFF));
  return frame(data);
}

RawBytes encode_command_of_bytes(std::uint8_t number, int low, int high) {
  RawBytes data;
  put_u8(data, number);
  put_u8(data, kNotNegative);
  put_u8(data, low);
  put_u8(data, high);
  return frame(data);
}

std::optional<ReadCommand> read_command(std::span<const std::byte> data) {
  if (data.empty()) return std::nullopt;
  ReadCommand command{.number = u8(data, 0), .argument = std::nullopt};
  if (data.size() < 4) return command;
  const int type = u8(data, 1);
  command.low = u8(data, 2);
  command.high = u8(data, 3);
  if (type == kNotNegative) command.argument = u16_le(data, 2);
  if (type == kNegative) command.argument = -u16_le(data, 2);
  return command;
}

void FrameReader::add(std::span<const std::byte> bytes) {
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
  at_ = 0;
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<RawBytes> FrameReader::next() {
  for (;; ++at_) {
    const std::span<const std::byte> rest = std::span(bytes_).subspan(at_);
    if (rest.size() < kBefore) return std::nullopt;
    if (rest[0] != kFirst || rest[1] != kSecond) continue;
    const std::size_t count = u8(rest, 2);
    const bool is_count = count >= kLeastCount && count <= kMostCount;
    if (is_count && rest.size() < kBefore + count) return std::nullopt;
    const std::span<const std::byte> data = rest.subspan(kBefore, is_count ? count - 2 : 0);
    if (is_count && checksum(data) == u16_be(rest, kBefore + data.size())) {
      at_ += kBefore + count;
      return RawBytes(data.begin(), data.end());
    }
    ++damaged_;  // a whole frame may begin within it
  }
}

RawBytes encode_sip(const Sip& sip) {
  RawBytes data;
  put_u8(data, sip.type);
  put_16_le(data, sip.x);
  put_16_le(data, sip.y);
  put_16_le(data, sip.heading);
  put_16_le(data, sip.left);
  put_16_le(data, sip.right);
  put_u8(data, sip.battery);
  put_u8(data, sip.left_stall);
  put_u8(data, sip.right_stall);
  put_16_le(data, sip.control);
  put_16_le(data, sip.flags);
  put_u8(data, sip.compass);
  put_u8(data, static_cast<int>(sip.sonars.size()));
  for (const SonarReading& reading : sip.sonars) {
    put_u8(data, reading.number);
    put_16_le(data, reading.range);
  }
  put_u8(data, sip.gripper);
  put_u8(data, sip.analog_port);
  put_u8(data, sip.analog);
  put_u8(data, sip.digital_in);
  put_u8(data, sip.digital_out);
  return frame(data);
}

std::optional<Sip> read_sip(std::span<const std::byte> data) {
  if (data.size() < kUpToSonars || !is_sip(u8(data, 0))) return std::nullopt;
  Sip sip{.type = u8(data, 0),
          .x = u16_le(data, 1),
          .y = u16_le(data, 3),
          .heading = s16_le(data, 5),
          .left = s16_le(data, 7),
          .right = s16_le(data, 9),
          .battery = u8(data, 11),
          .left_stall = u8(data, 12),
          .right_stall = u8(data, 13),
          .control = s16_le(data, 14),
          .flags = u16_le(data, 16),
          .compass = u8(data, 18),
          .sonars = {}};
  std::size_t at = kUpToSonars;
  const std::size_t readings = u8(data, at - 1);
  if (data.size() < at + 3 * readings) return std::nullopt;
  for (std::size_t i = 0; i < readings; ++i, at += 3)
    sip.sonars.push_back({u8(data, at), u16_le(data, at + 1)});
  const auto rest = [&](std::size_t offset) {
    return at + offset < data.size() ? u8(data, at + offset) : std::uint8_t{0};
  };
  sip.gripper = rest(0);
  sip.analog_port = rest(1);
  sip.analog = rest(2);
  sip.digital_in = rest(3);
  sip.digital_out = rest(4);
  return sip;
}

RawBytes encode_names(const RobotNames& names) {
  RawBytes data;
  put_u8(data, kSync2);
  for (const std::string* text : {&names.name, &names.robot_class, &names.subclass}) {
    put_text(data, *text);
    put_u8(data, 0);
  }
  return frame(data);
}

std::optional<RobotNames> read_names(std::span<const std::byte> data) {
  if (data.empty() || u8(data, 0) != kSync2) return std::nullopt;
  RobotNames names;
  std::size_t at = 1;
  for (std::string* text : {&names.name, &names.robot_class, &names.subclass}) {
    for (; at < data.size() && data[at] != std::byte{}; ++at) *text += static_cast<char>(data[at]);
    if (at == data.size()) return std::nullopt;
    ++at;
  }
  return names;
}

}  // namespace playhouse::drivers::p2os
