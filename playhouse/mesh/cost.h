#pragma once

#include <algorithm>
#include <cstddef>

#include "playhouse/base/mesh_limits.h"

namespace playhouse::mesh {

/// What reading a mesh may cost, by the bytes of its files: a small file that unpacks to much (textures,
/// sparse accessors) ends early. Meshes of robots' makers take 15 B for each byte; the pixels below, 2 KiB.
struct Cost {
  std::size_t memory = 0;  // B
  unsigned seconds = 0;    // of a processor
};

constexpr Cost cost_of(std::size_t bytes) {
  constexpr std::size_t kMemory = 256u << 20, kMemoryEach = 2048, kSeconds = 10, kBytesASecond = 256u << 10;
  const std::size_t most = std::min(bytes, limits::kMeshFileBytes);
  return {
      std::min(limits::kMeshMemoryBytes, kMemory + kMemoryEach * most),
      static_cast<unsigned>(std::min<std::size_t>(limits::kMeshSeconds, kSeconds + most / kBytesASecond))};
}

/// Pixels of textures, by the bytes of the mesh file and of theirs.
class PixelBudget {
 public:
  explicit PixelBudget(std::size_t mesh_bytes) : bytes_(std::min(mesh_bytes, limits::kMeshFileBytes)) {}
  /// The most pixels of the next texture, of a file of this size.
  std::size_t most(std::size_t bytes) {
    constexpr std::size_t kPixels = 1u << 22, kPixelsEach = 256;
    bytes_ += std::min(bytes, limits::kMeshFileBytes);
    const std::size_t all = std::min(limits::kMeshPixels, kPixels + kPixelsEach * bytes_);
    return all - std::min(all, used_);
  }
  void use(std::size_t pixels) { used_ += pixels; }

 private:
  std::size_t bytes_, used_ = 0;
};

}  // namespace playhouse::mesh
