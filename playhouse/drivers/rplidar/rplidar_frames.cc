#include "playhouse/drivers/rplidar/rplidar_frames.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace playhouse::drivers::rplidar {
namespace {

constexpr std::byte kRequestStart{0xA5}, kAnswerStart{0x5A};
constexpr std::uint8_t kWithParameters = 0x80;
constexpr double kFullTurn = 360;
constexpr int kUnitsOfDegree = 64, kOffsetUnits = 8;
constexpr int kRangeUnits = 4;  // of a millimetre, in nodes
constexpr int kMost15 = 0x7FFF;

std::uint8_t xor_of(std::span<const std::byte> bytes) {
  std::byte all{};
  for (const std::byte byte : bytes) all ^= byte;
  return static_cast<std::uint8_t>(all);
}

int angle_units(double angle) {
  return static_cast<int>(std::lround(angle * kUnitsOfDegree)) & kMost15;
}

}  // namespace

RawBytes encode_request(std::uint8_t code) {
  RawBytes bytes{kRequestStart};
  put_u8(bytes, code);
  return bytes;
}

RawBytes encode_request(std::uint8_t code, std::span<const std::byte> parameters) {
  RawBytes bytes = encode_request(code);
  put_u8(bytes, static_cast<int>(parameters.size()));
  bytes.insert(bytes.end(), parameters.begin(), parameters.end());
  put_u8(bytes, xor_of(bytes));
  return bytes;
}

RawBytes encode_descriptor(std::size_t length, bool is_repeated, std::uint8_t type) {
  RawBytes bytes{kRequestStart, kAnswerStart};
  put_16_le(bytes, static_cast<int>(length));
  put_u8(bytes, 0);
  put_u8(bytes, is_repeated ? 0x40 : 0);
  put_u8(bytes, type);
  return bytes;
}

RawBytes encode_answer(std::uint8_t type, std::span<const std::byte> answer) {
  RawBytes bytes = encode_descriptor(answer.size(), false, type);
  bytes.insert(bytes.end(), answer.begin(), answer.end());
  return bytes;
}

void LidarRequests::add(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<LidarRequest> LidarRequests::next() {
  while (true) {
    bytes_.erase(bytes_.begin(), std::ranges::find(bytes_, kRequestStart));
    if (bytes_.size() < 2) return std::nullopt;
    LidarRequest request{u8(bytes_, 1), {}};
    std::size_t length = 2;
    bool is_good = true;
    if ((request.code & kWithParameters) != 0) {
      if (bytes_.size() < 3 || bytes_.size() < 4u + u8(bytes_, 2)) return std::nullopt;
      length = 4u + u8(bytes_, 2);
      is_good = xor_of(std::span(bytes_).first(length - 1)) == u8(bytes_, length - 1);
      const auto parameters = std::span(bytes_).subspan(3, length - 4);
      request.parameters.assign(parameters.begin(), parameters.end());
    }
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(is_good ? length : 1));
    if (is_good) return request;
  }
}

void LidarAnswers::expect(std::uint8_t type, std::size_t length, bool is_repeated) {
  bytes_.clear();
  descriptor_ = encode_descriptor(length, is_repeated, type);
  length_ = length;
  type_ = type;
  is_repeated_ = is_repeated;
  has_begun_ = false;
}

void LidarAnswers::add(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

/// A slip of a byte in nodes may pass their check bits: another one must follow.
bool LidarAnswers::is_sound(std::span<const std::byte> piece) const {
  if (!is_repeated_) return true;
  return type_ == kNodes ? is_node(piece) && is_node(piece.subspan(kNodeBytes)) : is_capsule(piece);
}

std::optional<RawBytes> LidarAnswers::next() {
  if (!has_begun_) {
    const auto found = std::search(bytes_.begin(), bytes_.end(), descriptor_.begin(), descriptor_.end());
    if (found == bytes_.end()) {
      const std::size_t kept = std::min(bytes_.size(), descriptor_.size());
      bytes_.erase(bytes_.begin(), bytes_.end() - static_cast<std::ptrdiff_t>(kept));
      return std::nullopt;
    }
    bytes_.erase(bytes_.begin(), found + static_cast<std::ptrdiff_t>(descriptor_.size()));
    has_begun_ = true;
  }
  const std::size_t needed = length_ + (is_repeated_ && type_ == kNodes ? kNodeBytes : 0);
  std::size_t at = 0;
  while (bytes_.size() >= at + needed && !is_sound(std::span(bytes_).subspan(at, needed))) ++at;
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(at));
  if (bytes_.size() < needed) return std::nullopt;
  RawBytes piece(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(length_));
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(length_));
  return piece;
}

RawBytes encode_node(const LidarSample& sample) {
  RawBytes node;
  constexpr int kMostQuality = 63, kMostRange = 0xFFFF;
  put_u8(node, std::clamp(sample.quality, 0, kMostQuality) << 2 | (sample.is_first ? 1 : 2));
  put_16_le(node, angle_units(sample.angle) << 1 | 1);
  put_16_le(node, std::clamp(static_cast<int>(std::lround(sample.range * kRangeUnits)), 0, kMostRange));
  return node;
}

bool is_node(std::span<const std::byte> node) {
  const int start = u8(node, 0) & 3;
  return (start == 1 || start == 2) && (u8(node, 1) & 1) != 0;
}

LidarSample read_node(std::span<const std::byte> node) {
  return {(u8(node, 0) & 1) != 0, u8(node, 0) >> 2,
          static_cast<double>(u16_le(node, 1) >> 1) / kUnitsOfDegree,
          static_cast<double>(u16_le(node, 3)) / kRangeUnits};
}

RawBytes encode_capsule(const LidarCapsule& capsule) {
  RawBytes bytes(2);
  put_16_le(bytes, angle_units(capsule.angle) | (capsule.is_first ? 0x8000 : 0));
  for (std::size_t k = 0; k < kSamplesOfCapsule; k += 2) {
    constexpr int kMostOffset = 31, kMostRange = 0x3FFF;
    int low_bits = 0;
    for (const std::size_t sample : {k, k + 1}) {
      const int offset =
          std::clamp(static_cast<int>(std::lround(capsule.offsets[sample] * kOffsetUnits)), 0, kMostOffset);
      put_16_le(bytes, std::clamp(capsule.ranges[sample], 0, kMostRange) << 2 | offset >> 4);
      low_bits |= (offset & 0x0F) << (sample == k ? 0 : 4);
    }
    put_u8(bytes, low_bits);
  }
  const int check = xor_of(std::span(bytes).subspan(2));
  bytes[0] = static_cast<std::byte>(0xA0 | (check & 0x0F));
  bytes[1] = static_cast<std::byte>(0x50 | check >> 4);
  return bytes;
}

bool is_capsule(std::span<const std::byte> capsule) {
  return (u8(capsule, 0) & 0xF0) == 0xA0 && (u8(capsule, 1) & 0xF0) == 0x50 &&
         xor_of(capsule.subspan(2)) == ((u8(capsule, 0) & 0x0F) | (u8(capsule, 1) & 0x0F) << 4);
}

LidarCapsule read_capsule(std::span<const std::byte> capsule) {
  LidarCapsule read{.is_first = (u8(capsule, 3) & 0x80) != 0,
                    .angle = static_cast<double>(u16_le(capsule, 2) & kMost15) / kUnitsOfDegree};
  for (std::size_t k = 0, at = 4; k < kSamplesOfCapsule; k += 2, at += 5)
    for (const std::size_t second : {0u, 1u}) {
      const int word = u16_le(capsule, at + 2 * second);
      const int low_bits = u8(capsule, at + 4) >> (4 * second) & 0x0F;
      read.ranges[k + second] = word >> 2;
      read.offsets[k + second] = static_cast<double>((word & 3) << 4 | low_bits) / kOffsetUnits;
    }
  return read;
}

std::vector<LidarSample> samples_of(const LidarCapsule& capsule, double next_angle) {
  double difference = next_angle - capsule.angle;
  if (difference < 0) difference += kFullTurn;
  std::vector<LidarSample> samples;
  const double step = difference / kSamplesOfCapsule;
  for (std::size_t k = 0; k < kSamplesOfCapsule; ++k) {
    const double at = capsule.angle + step * static_cast<double>(k);
    double angle = std::fmod(at - capsule.offsets[k], kFullTurn);
    if (angle < 0) angle += kFullTurn;
    const bool is_first = std::floor(at / kFullTurn) > std::floor((at - step) / kFullTurn);
    samples.push_back({is_first, 0, angle, static_cast<double>(capsule.ranges[k])});
  }
  return samples;
}

}  // namespace playhouse::drivers::rplidar
