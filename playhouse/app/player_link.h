#pragma once

#include <span>

namespace playhouse::app {

/// The program under the name `player`: takes the options of Player's own server (-p, -d, -q, -l, -h,
/// file), serves the file, and says "Listening on ports: 6665 " on standard output as scripts wait for.
/// `words` are those after the program's name.
int player_link(std::span<const char* const> words);

}  // namespace playhouse::app
