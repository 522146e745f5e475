#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::images {

enum class PngEffort : std::uint8_t { kSmall, kFast };

/// Encodes 8-bit RGB (3 channels) or RGBA (4), rows from the top. Needs width * height * channels bytes. Fails
/// if libpng runs out of memory.
Result<std::string> png_of(int width, int height, int channels, std::span<const std::uint8_t> samples,
                           PngEffort effort = PngEffort::kSmall);

}  // namespace playhouse::images
