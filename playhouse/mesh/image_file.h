#pragma once

/// Image files of textures, in and out of memory.

#include <cstddef>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// A PNG or a JPEG. Fails, with a text that names no file, on other bytes, on sides longer than
/// limits::kMeshImageSide and, before it allocates any, on more than `most_pixels`.
Result<Image> decode_image(std::string_view bytes, std::size_t most_pixels);

/// As a PNG file; empty where memory ran out.
std::string png_of(const Image& image);

}  // namespace playhouse::mesh
