#pragma once

/// Validation of numbers: servers silently drop commands with numbers that are not finite.

#include <initializer_list>
#include <string_view>

#include "playhouse_client/device.h"

namespace playhouse::client {

/// An error for the first number that is not finite; `what` names the calling function.
Result<void> finite(const Device& device, std::string_view what, std::initializer_list<double> numbers);

/// The same for numbers sent as float: also an error if a finite double overflows float.
Result<void> finite_floats(const Device& device, std::string_view what,
                           std::initializer_list<double> numbers);

}  // namespace playhouse::client
