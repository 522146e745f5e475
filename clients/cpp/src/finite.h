#pragma once

/// Validation of numbers: servers silently drop commands with numbers that are not finite.

#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "playhouse_client/device.h"

namespace playhouse::client {

/// An error for the first number that is not finite; `what` names the calling function.
Result<void> finite(const Device& device, std::string_view what, std::initializer_list<double> numbers);

/// The same for numbers sent as float: also an error if a finite double overflows float.
Result<void> finite_floats(const Device& device, std::string_view what,
                           std::initializer_list<double> numbers);

/// As floats; an error as of finite_floats().
Result<std::vector<float>> floats(const Device& device, std::string_view what,
                                  std::span<const double> numbers);

}  // namespace playhouse::client
