#pragma once

/// What a text must be for a model to say it, and what is made of one that is not, whoever has the model say
/// it: a world file, a controller, a client of Player.

#include <string>
#include <string_view>

namespace playhouse::world {

/// One line of UTF-8, at most limits::kSayBytes: up to the first NUL, a control character a space, a byte
/// that is no UTF-8 a question mark, whole characters as far as there is room.
std::string spoken(std::string_view text);

/// Whether spoken() leaves the text as it is.
bool can_be_said(std::string_view text);

}  // namespace playhouse::world
