#pragma once

/// SCIP 1.1 and 2.0, the protocol of Hokuyo's scanners: both ends use these.
///
/// The host says a line. The answer is its echo, a status, lines of at most 64 characters, and an empty line. In SCIP 2.0 the
/// status has two characters, and it and each line end with a checksum. Numbers in data are characters of 6 bits each, from '0'
/// on, the highest bits first.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/drivers/hardware/bytes.h"

namespace playhouse::drivers::scip {

inline constexpr int kScipBits = 6;
/// Scanners measure intensities of some thousands, of which the laser interface has a byte.
inline constexpr int kIntensityOfUnit = 16;

/// The character behind a line: the sum of its own, in 6 bits.
char check_of(std::string_view line);
/// `characters` of a number that is not negative; its low bits, if it has more.
std::string encode_number(int number, int characters);
/// None for a character that none of this encoding is.
std::optional<int> decode_number(std::string_view text);

/// Takes lines, as the device gets them, out of bytes. They end with LF or CR; those that are too long are left out.
class ScipLines {
 public:
  void add(std::span<const std::byte> bytes);
  std::optional<std::string> next();
  void clear() { text_.clear(); }

 private:
  std::string text_;
};

/// An answer, as it came.
struct ScipReply {
  std::string echo;
  std::string status;              // without its checksum; of SCIP 1.1 one character
  std::vector<std::string> lines;  // with their checksums
};

/// Takes answers out of bytes. Those with a wrong checksum of the status, and what is too long, are left out.
class ScipReplies {
 public:
  void add(std::span<const std::byte> bytes);
  std::optional<ScipReply> next();
  void clear() { text_.clear(); }

 private:
  std::string text_;
};

/// Of SCIP 2.0 with checksums, of SCIP 1.1 without.
RawBytes encode_reply(std::string_view echo, std::string_view status, const std::vector<std::string>& lines,
                      bool has_checks);
/// "DMAX:5600;_", or without the check.
std::string named_line(std::string_view name, std::string_view value, bool has_check);
/// The lines that data are cut into.
std::vector<std::string> data_lines(std::string_view data, bool has_checks);
/// Put together again; none if a checksum is wrong.
std::optional<std::string> joined_data(std::span<const std::string> lines);
/// The value of a line "DMAX:5600;_" of an answer, if its checksum is right.
std::optional<std::string> value_named(std::string_view name, std::span<const std::string> lines);
std::optional<int> number_named(std::string_view name, std::span<const std::string> lines);

/// What a scanner tells of itself (PP).
struct ScipModel {
  std::string_view name;
  int least = 20, most = 5600;  // mm
  int resolution = 1024;        // steps of a full turn
  int first = 44, last = 725, front = 384,
      end = 768;    // steps: measured, ahead, and the last that may be asked for
  int speed = 600;  // turns a minute
  int no_echo = 0, too_near = 0, elsewhere = 19;  // in place of a range

  double step() const;  // rad
  double angle_of(int step_number) const { return (step_number - front) * step(); }
};
std::span<const ScipModel> scip_models();
std::vector<std::string> parameter_lines(const ScipModel& model);
/// None if a value is missing or impossible; `name`, `end` and what stands in place of a range are not told.
std::optional<ScipModel> read_parameters(std::span<const std::string> lines);

/// GD, GS, GE, MD, MS and ME with what they ask for.
struct ScipRequest {
  int first = 0, last = 0, cluster = 1;
  int skipped = 0, count = 0;  // of MD, MS and ME: scans; 0: until it is stopped

  /// "MD0044072501000"; of G. without the last two.
  std::string line(std::string_view code) const;
};

}  // namespace playhouse::drivers::scip
