#pragma once

/// Options of a section of a configuration file, with their ranges, and what is told of them: the line that
/// reads an option is its only definition (`playhouse drivers NAME`).

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"

namespace playhouse::drivers {

/// What the reader of an option says about it besides its type, its default and its range.
struct OptionText {
  std::string_view name;
  std::string_view doc = {};        // one sentence, or more if they are short
  std::string_view unit = {};       // where it is not m of a length or deg of an angle
  std::string_view otherwise = {};  // its default in words, where that is no constant
};

/// An option as its reader defines it, in the syntax and units of a configuration file.
struct Option {
  std::string name;
  std::string type;       // "length", "[length angle]"; empty: accepted without effect
  std::string unit;       // "m", "m, deg"
  std::string otherwise;  // default: "0.5", "[0.5 10]"; empty if it is `told` in words
  std::string told;
  std::string limits;  // "0 at least"
  std::string doc;
  std::size_t elements = 1;
};

/// Reads fields of a section, in SI units; the first value out of range is kept as fault(). Appends each
/// option to `told`, if that is not null.
class SectionFields {
 public:
  static constexpr double kAnyNumber = -std::numeric_limits<double>::infinity();  // as `least`

  SectionFields(const config::CfgSection& section, std::vector<Option>* told = nullptr)
      : section_(section), told_(told) {}

  /// m or m/s; rad or rad/s; a number, each at least `least`.
  double length(const OptionText& option, double otherwise, double least, std::size_t element = 0);
  double angle(const OptionText& option, double otherwise, std::size_t element = 0, double least = 0);
  double number(const OptionText& option, double otherwise, double least = 0, std::size_t element = 0);
  int integer(const OptionText& option, int otherwise, int least, int most);
  bool flag(const OptionText& option, bool otherwise);
  std::string text(const OptionText& option);
  /// A path, relative to the folder of the configuration file.
  std::string filename(const OptionText& option);
  /// Any number of them; none if the field is absent.
  std::vector<int> integers(const OptionText& option);
  /// An option of the original that is accepted.
  void no_effect(const OptionText& option);
  /// Keeps "KEY WHAT" as the fault unless `good`.
  void expect(bool good, std::string_view key, std::string_view what);
  Result<void> fault() const { return fault_ ? Result<void>(*fault_) : Result<void>(); }

 private:
  double at_least(std::string_view key, double value, double least);
  /// `otherwise`: the default of the element.
  void tell(const OptionText& option, std::size_t element, std::string_view type, std::string_view unit,
            const std::string& otherwise, const std::string& limits);

  const config::CfgSection& section_;
  std::vector<Option>* told_;
  std::optional<Error> fault_;
};

}  // namespace playhouse::drivers
