#pragma once

/// 3D model files -> Mesh: COLLADA (.dae), glTF (.gltf, .glb), OBJ (.obj) and STL
/// (.stl), through Assimp; COLLADA physics, which Assimp does not support, by own code.
///
/// In: the bytes of the file, and of the files it refers to: buffers, materials, textures.
///
/// Out: one mesh in metres, z up (frame F), with node transforms applied; or one error
/// with the file name. Recoverable problems, such as a missing texture, are warnings.
///
/// Cost: 2 ms for a child process, and 2 us per triangle.
///
/// Source: Khronos Group, "COLLADA 1.4.1" and "glTF 2.0"; docs/meshes.md lists the supported subset.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

struct MeshFile {
  Mesh mesh;
  std::vector<std::string> warnings;  // without the name of the mesh
};

/// Reads a file by its path; fails with a message that starts with "cannot".
using ReadFile = std::function<Result<std::string>(const std::string& path)>;

/// Reads a mesh in a child process with limits of time and
/// memory, so that a crash in the libraries becomes an error.
Result<MeshFile> read_mesh(const std::string& path, const ReadFile& read);

/// The same in this process, unprotected: for tests, fuzzers and the child process.
Result<MeshFile> read_mesh_here(const std::string& path, const ReadFile& read);

/// From disk; warnings are dropped.
Result<Mesh> read_mesh(const std::string& path);

/// True for file names with a supported extension.
bool is_mesh_name(std::string_view name);

}  // namespace playhouse::mesh
