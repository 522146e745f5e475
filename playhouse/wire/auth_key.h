#pragma once

#include <cstddef>

namespace playhouse::wire {

/// The longest key of AUTH (interfaces/001_player.toml).
inline constexpr std::size_t kAuthKeyBytes = 32;

}  // namespace playhouse::wire
