#pragma once

#include <span>

namespace playhouse::app {

/// Compatibility mode under the name `player`: accepts the options of Player's own
/// server (-p, -d, -q, -l, -h, file), serves the file, and prints "Listening on ports:
/// 6665 " on standard output, which scripts wait for. `words` are the arguments.
int player_link(std::span<const char* const> words);

}  // namespace playhouse::app
