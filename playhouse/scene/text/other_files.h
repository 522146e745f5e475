#pragma once

/// Files of other kinds in place of a world: told by their name and contents, with what reads them.

#include <optional>
#include <string>
#include <string_view>

namespace playhouse::scene {

/// What a file is that is no world, as a predicate of its name; none: maybe a world.
std::optional<std::string> what_else(const std::string& path, std::string_view bytes);

}  // namespace playhouse::scene
