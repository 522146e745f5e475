#pragma once

/// Options of a section of a configuration file, with their ranges.

#include <optional>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

/// Reads fields of a section, in SI units; the first value out of range is kept as fault().
class SectionFields {
 public:
  explicit SectionFields(const scene::CfgSection& section) : section_(section) {}

  /// m or m/s; rad or rad/s, at least 0; a number, at least `least`.
  double length(std::string_view key, double otherwise, double least, std::size_t element = 0) {
    return at_least(key, section_.length(key, otherwise, element), least);
  }
  double angle(std::string_view key, double otherwise, std::size_t element = 0) {
    return at_least(key, section_.angle(key, otherwise, element), 0);
  }
  double number(std::string_view key, double otherwise, double least = 0, std::size_t element = 0) {
    return at_least(key, section_.number(key, otherwise, element), least);
  }
  int integer(std::string_view key, int otherwise, int least, int most);
  /// Keeps "KEY WHAT" as the fault unless `good`.
  void expect(bool good, std::string_view key, std::string_view what);
  Result<void> fault() const { return fault_ ? Result<void>(*fault_) : Result<void>(); }

 private:
  double at_least(std::string_view key, double value, double least);

  const scene::CfgSection& section_;
  std::optional<Error> fault_;
};

}  // namespace playhouse::drivers
