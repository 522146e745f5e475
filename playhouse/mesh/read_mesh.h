#pragma once

/// Files of modelling programs -> Mesh: COLLADA (.dae), glTF (.gltf, .glb) and OBJ (.obj), through Assimp;
/// what COLLADA says for physics, which Assimp leaves out, by a reader of our own.
///
/// In: the bytes of the file, and of those beside it that it names: buffers, materials, textures.
///
/// Out: one mesh in metres, z up (frame F), nodes applied; or one error that names the file. What can be done
/// without, as a texture that is not there, is a warning.
///
/// Cost: a process of its own, 2 ms, and 2 us for a triangle.
///
/// Source: Khronos Group, "COLLADA 1.4.1" and "glTF 2.0"; docs/meshes.md says what of them is read.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

struct MeshFile {
  Mesh mesh;
  std::vector<std::string> warnings;  // texts that name no mesh
};

/// Gives the bytes of a file by its path; fails with a text that starts with "cannot".
using ReadFile = std::function<Result<std::string>(const std::string& path)>;

/// The file at this path, from `read`. It is taken apart in a process of its own, with limits of time and
/// memory, so that one that makes the libraries fail ends in an error and nothing else.
Result<MeshFile> read_mesh(const std::string& path, const ReadFile& read);

/// The same in this process, which the libraries may end: for tests and fuzzers, and for that process.
Result<MeshFile> read_mesh_here(const std::string& path, const ReadFile& read);

/// A file of this machine; its warnings are dropped.
Result<Mesh> read_mesh(const std::string& path);

/// Of a file that can be a mesh.
bool is_mesh_name(std::string_view name);

}  // namespace playhouse::mesh
