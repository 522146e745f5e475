#include "finite.h"

#include <cmath>
#include <limits>
#include <string>

namespace playhouse::client {

namespace {

Result<void> at_most(double largest, const Device& device, std::string_view what,
                     std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    if (std::abs(number) <= largest) continue;
    const char* name = std::isnan(number) ? "nan" : std::isinf(number) ? "infinity" : "one beyond float";
    return Error{"", device.name() + ": " + std::string(what) + " takes finite numbers, not " + name};
  }
  return {};
}

}  // namespace

Result<void> finite(const Device& device, std::string_view what, std::initializer_list<double> numbers) {
  return at_most(std::numeric_limits<double>::max(), device, what, numbers);
}

Result<void> finite_floats(const Device& device, std::string_view what,
                           std::initializer_list<double> numbers) {
  return at_most(std::numeric_limits<float>::max(), device, what, numbers);
}

Result<std::vector<float>> floats(const Device& device, std::string_view what,
                                  std::span<const double> numbers) {
  std::vector<float> floats;
  for (const double number : numbers) {
    if (const auto sound = finite_floats(device, what, {number}); !sound) return sound.error();
    floats.push_back(static_cast<float>(number));
  }
  return floats;
}

}  // namespace playhouse::client
