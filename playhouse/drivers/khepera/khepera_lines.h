#pragma once

/// Lines of K-Team's Khepera and Khepera II, and what its units are: both ends use these.
///
/// A command is a capital letter, its numbers after commas, and an end of line. The robot answers each by a line with the
/// same letter, small, and the numbers asked for; a wrong one by a line that begins with z.

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/drivers/hardware/bytes.h"

namespace playhouse::drivers::khepera {

inline constexpr double kPulse = 0.08e-3;        // m, of a wheel
inline constexpr double kPulsesPerSecond = 100;  // of a unit of speed
inline constexpr int kMostSpeedUnits = 127;
inline constexpr double kAxle = 0.052;  // m, between the wheels
inline constexpr std::size_t kSensors = 8;
inline constexpr int kMostLight = 1023;  // of a sensor

struct KheperaLine {
  char letter = 0;
  std::vector<std::int64_t> numbers;
};

/// "D,5,-5" and LF, or CR LF as the robot ends its lines.
std::string encode_line(char letter, std::initializer_list<std::int64_t> numbers = {});
std::string encode_answer(char letter, std::initializer_list<std::int64_t> numbers = {});

/// Takes lines out of bytes. Empty ones are left out, and what is longer than any.
class KheperaReader {
 public:
  void add(std::span<const std::byte> bytes);
  /// The next line; letter 0: one that is none.
  std::optional<KheperaLine> next();
  void clear() { text_.clear(); }

 private:
  std::string text_;
};

/// What a sensor measures of white paper at a distance, and back: beyond 100 mm nothing.  [m]
int light_at(double range);
double range_of(double light);

/// On the robot: mm, mm, deg.
struct KheperaSensor {
  double x, y, direction;
};
std::span<const KheperaSensor, kSensors> sensors();

}  // namespace playhouse::drivers::khepera
