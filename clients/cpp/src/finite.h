#pragma once

/// Numbers that mean something to a server: it would drop a command with others without a word.

#include <initializer_list>
#include <string_view>

#include "playhouse_client/device.h"

namespace playhouse::client {

/// An error for the first number that is not finite; `what` is the function that takes them.
Result<void> finite(const Device& device, std::string_view what, std::initializer_list<double> numbers);

/// The same for numbers that travel as float: also for one that is finite as double only.
Result<void> finite_floats(const Device& device, std::string_view what,
                           std::initializer_list<double> numbers);

}  // namespace playhouse::client
