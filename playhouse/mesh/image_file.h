#pragma once

/// Decoding and encoding of textures, in memory.

#include <cstddef>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// Decodes PNG or JPEG. Fails, without a file name, on other bytes, on sides longer
/// than limits::kMeshImageSide and, before allocating, on more than `most_pixels`.
Result<Image> decode_image(std::string_view bytes, std::size_t most_pixels);

/// Encodes as PNG; empty if out of memory.
std::string png_of(const Image& image);

}  // namespace playhouse::mesh
