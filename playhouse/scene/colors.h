#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// The colour of an X11 name ("light blue", "LightBlue", "gray30"); capitals and spaces do not matter.
/// Opaque. Eight names that only the web has ("silver", "lime", ...) are known too.
std::optional<Color> color_by_name(std::string_view name);

/// 0xRRGGBBAA; what is no number, or beyond 0..1, is the nearest that a colour can have.
std::uint32_t rgba8(const Color& color);

/// A name that color_by_name() knows for exactly this colour, as X11 spells it, or "": the shortest. Names
/// that are not X11's only if `others` are wanted.
std::string color_name(const Color& color, bool others = false);

/// Known names near `name` for an error line: ` (did you mean "red"?)`, or "".
std::string color_hint(std::string_view name);

}  // namespace playhouse::scene
