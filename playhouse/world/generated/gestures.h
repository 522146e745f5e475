// Generated from viewer/commands.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

#include <string_view>

namespace playhouse::world {

/// Text that makes a person wave.
inline constexpr std::string_view kWave = "*waves*";

}  // namespace playhouse::world
