#pragma once

/// Limits of meshes, separate from limits.h as only readers of meshes need them.

#include <cstddef>
#include <cstdint>

namespace playhouse::limits {
// Meshes; heeded by arena, mesh, scene.
inline constexpr std::size_t kMeshBytes = 256u
                                          << 20;  // of the files of all meshes of a world, textures included
inline constexpr std::size_t kMeshFileBytes = 64u << 20;  // of one mesh, textures included
inline constexpr std::size_t kMeshTriangles = 1u << 21;   // of one mesh, and of all physics shapes of one
inline constexpr std::size_t kMeshCorners = 1u << 22;     // of one mesh
inline constexpr std::size_t kMeshNodes = 1u << 16;       // of one mesh
inline constexpr int kMeshDepth = 128;                    // nodes inside each other, and elements of COLLADA
inline constexpr std::size_t kMeshImages = 256;           // of one mesh
inline constexpr std::uint32_t kMeshImageSide = 8192;     // px of a texture
inline constexpr std::size_t kMeshPixels = 1u << 26;      // of all textures of a mesh
inline constexpr std::size_t kMeshLights = 256;           // of one mesh
inline constexpr std::size_t kMeshShapes = 4096;          // for physics, of one mesh
inline constexpr std::size_t kMeshParts = 64;  // that are bodies of their own; of more, each surface is one
inline constexpr std::size_t kMeshCopies = 1u << 23;  // corners of all meshes of a world, once for each size
inline constexpr unsigned kMeshSeconds = 60;          // of a processor, to read one
inline constexpr std::size_t kMeshMemoryBytes = std::size_t{3} << 30;  // to read one
inline constexpr double kMeshReach = 1e5;                              // m from its origin to any corner
inline constexpr double kMeshMass = 1e9;                               // kg, as world files allow
inline constexpr double kMeshCoefficient = 1e9;                        // of friction and restitution

}  // namespace playhouse::limits
