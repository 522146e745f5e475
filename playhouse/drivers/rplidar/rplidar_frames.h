#pragma once

/// Slamtec's RPLIDAR: both ends use these.
///
/// A request is A5, a code and, if that has its highest bit, a length, data and their exclusive-or. An answer is a descriptor of
/// 7 bytes, A5 5A, the length of what follows, whether that is repeated, and a type, and then data of that length. Numbers are
/// little-endian, angles clockwise.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/drivers/hardware/bytes.h"

namespace playhouse::drivers::rplidar {

enum RequestCode : std::uint8_t {
  kScan = 0x20,
  kForceScan = 0x21,
  kStop = 0x25,
  kReset = 0x40,
  kGetInfo = 0x50,
  kGetHealth = 0x52,
  kGetRate = 0x59,
  kExpressScan = 0x82,
  kGetConfiguration = 0x84,
  kSetMotorRate = 0xA8,
  kSetMotor = 0xF0,
  kGetBoard = 0xFF,
};

/// Of answers.
enum AnswerType : std::uint8_t {
  kInfo = 0x04,
  kHealth = 0x06,
  kRate = 0x15,
  kConfiguration = 0x20,
  kNodes = 0x81,
  kCapsules = 0x82,
  kBoard = 0xFF,
};

inline constexpr std::size_t kInfoBytes = 20, kHealthBytes = 3, kNodeBytes = 5, kCapsuleBytes = 84;
inline constexpr std::uint8_t kBroken = 2;  // of health
inline constexpr int kUsualMotor = 660;
inline constexpr std::size_t kSamplesOfCapsule = 32;

RawBytes encode_request(std::uint8_t code);
RawBytes encode_request(std::uint8_t code, std::span<const std::byte> parameters);
RawBytes encode_descriptor(std::size_t length, bool is_repeated, std::uint8_t type);
/// An answer of one piece.
RawBytes encode_answer(std::uint8_t type, std::span<const std::byte> answer);

struct LidarRequest {
  std::uint8_t code = 0;
  RawBytes parameters;
};

/// Takes requests out of bytes; those with a wrong check are left out.
class LidarRequests {
 public:
  void add(std::span<const std::byte> bytes);
  std::optional<LidarRequest> next();
  void clear() { bytes_.clear(); }

 private:
  RawBytes bytes_;
};

/// Takes the answer to one request out of bytes: what comes before its descriptor is left out, and so is what no node or
/// capsule begins in, of those that are repeated.
class LidarAnswers {
 public:
  /// From now on.
  void expect(std::uint8_t type, std::size_t length, bool is_repeated);
  void add(std::span<const std::byte> bytes);
  /// One piece of data, or each of those that are repeated.
  std::optional<RawBytes> next();
  bool has_begun() const { return has_begun_; }

 private:
  bool is_sound(std::span<const std::byte> piece) const;

  RawBytes bytes_, descriptor_;
  std::size_t length_ = 0;
  std::uint8_t type_ = 0;
  bool is_repeated_ = false, has_begun_ = false;
};

/// One measurement.
struct LidarSample {
  bool is_first = false;  // of a turn
  int quality = 0;        // 0 to 63
  double angle = 0;       // deg, clockwise, from 0 to 360
  double range = 0;       // mm; 0: none
};
RawBytes encode_node(const LidarSample& sample);
/// Of kNodeBytes.
LidarSample read_node(std::span<const std::byte> node);
bool is_node(std::span<const std::byte> node);

/// 32 samples, at angles that follow from the next capsule's: evenly spaced, less an offset each.
struct LidarCapsule {
  bool is_first = false;                               // since the request
  double angle = 0;                                    // deg, of the first
  std::array<int, kSamplesOfCapsule> ranges = {};      // mm; 0: none
  std::array<double, kSamplesOfCapsule> offsets = {};  // deg, not negative
};
RawBytes encode_capsule(const LidarCapsule& capsule);
/// Of kCapsuleBytes.
LidarCapsule read_capsule(std::span<const std::byte> capsule);
bool is_capsule(std::span<const std::byte> capsule);
/// The samples of one, by the angle of that after it.
std::vector<LidarSample> samples_of(const LidarCapsule& capsule, double next_angle);

}  // namespace playhouse::drivers::rplidar
