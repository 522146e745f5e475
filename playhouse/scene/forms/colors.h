#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// The colour of an X11 name ("light blue", "LightBlue", "gray30"), case-insensitive,
/// ignoring spaces. Opaque. Eight CSS names ("silver", "lime", ...) are supported too.
std::optional<Color> color_by_name(std::string_view name);

/// 0xRRGGBBAA; components are clamped to 0..1, non-finite ones are 0.
std::uint32_t rgba8(const Color& color);

/// The shortest name that color_by_name() maps to exactly this colour,
/// in X11 spelling, or "". Names that are not X11's only with `others`.
std::string color_name(const Color& color, bool others = false);

/// Suggestion for an unknown name: ` (did you mean "red"?)`, or "".
std::string color_hint(std::string_view name);

}  // namespace playhouse::scene
