#pragma once

/// The language of Directed Perception's pan-tilt units, PTU-46 and D46: both ends use this.
///
/// Commands are letters and perhaps a number, ended by a blank or CR. Each is answered by a line, "*" and perhaps a value,
/// or "!" and why not; "!P" and "!T" come at any time, also within a line, where an axis has met its limit. Bytes from 129
/// on are commands in binary, with numbers behind them and in their answers, high byte first.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/drivers/hardware/bytes.h"

namespace playhouse::drivers::ptu {

inline constexpr double kArcSeconds = 3600;  // in a degree
inline constexpr std::uint8_t kFirstOpcode = 129, kLastOpcode = 205;

struct PtuReply {
  bool is_good = false;         // "*"
  std::optional<double> value;  // the number at its end
};

/// Takes replies out of bytes: without empty lines, and without what tells of limits.
class PtuReplyReader {
 public:
  void add(std::span<const std::byte> bytes);
  std::optional<PtuReply> next();
  void clear() { text_.clear(); }

 private:
  std::string text_;
};

/// A command as the unit reads it: one in letters, which are capitals here, or one in binary.
struct PtuCommand {
  std::string letters;
  std::optional<double> number;
  std::string text;         // as it was sent, with its end
  std::uint8_t opcode = 0;  // 0: in letters
  RawBytes data;            // of the opcode
};

/// Takes commands out of bytes; ends without one are left out.
class PtuCommandReader {
 public:
  void add(std::span<const std::byte> bytes);
  std::optional<PtuCommand> next();

 private:
  std::optional<PtuCommand> next_binary();

  RawBytes bytes_;
};

/// Bytes after an opcode.
std::size_t data_of(std::uint8_t opcode);

/// "pp222 "; a number is whole.
std::string encode_command(std::string_view letters, std::optional<long> number = std::nullopt);

/// A resolution is arc seconds in a count.
double radians_of(double counts, double resolution);
double counts_of(double radians, double resolution);

}  // namespace playhouse::drivers::ptu
