#pragma once

/// Whether a battery is being charged.

#include <cstdint>

namespace playhouse::client {

/// Whether a battery is being charged.
enum class Charging : std::int8_t { kImpossible = -1, kNo = 0, kYes = 1 };

}  // namespace playhouse::client
