#include "playhouse/drivers/section_fields.h"

#include <fmt/format.h>

namespace playhouse::drivers {

int SectionFields::integer(std::string_view key, int otherwise, int least, int most) {
  const int value = section_.integer(key, otherwise);
  expect(value >= least && value <= most, key, fmt::format("is from {} to {}", least, most));
  return value;
}

void SectionFields::expect(bool good, std::string_view key, std::string_view what) {
  if (!good && !fault_) fault_ = Error{section_.at(key), fmt::format("{} {}", key, what)};
}

double SectionFields::at_least(std::string_view key, double value, double least) {
  expect(value >= least, key, fmt::format("is {} at least", least));
  return value;
}

}  // namespace playhouse::drivers
