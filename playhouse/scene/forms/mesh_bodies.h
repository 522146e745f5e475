#pragma once

/// Meshes as bodies of models, cached by file, size and placement. In 2D a mesh is the outlines of its
/// parts: for each the convex hull of its projection, from its lowest to its highest corner.

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/config/text/source_text.h"
#include "playhouse/mesh/read_mesh.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

class MeshBodies {
 public:
  /// A mesh in B: as placed, and if it is fitted, scaled to a size.
  struct MeshBody {
    std::shared_ptr<const mesh::Mesh> mesh;  // null: not possible
    std::string why_none;
    geom::Size size;  // its extent, unless one is given
    std::vector<Block> blocks;
    std::size_t corners = 0;  // of the mesh
    bool is_new = true;       // not yet requested
  };
  struct LoadedMesh {
    std::string path;
    std::shared_ptr<const mesh::Mesh> mesh;  // in F; null: unreadable
    std::string why_none;
    std::vector<std::string> warnings;
    std::size_t bytes = 0;                                      // of all its files
    mutable std::map<std::array<double, 13>, MeshBody> bodies;  // by size and placement
  };

  /// A cached entry, readable or not; null if there is none.
  const LoadedMesh* find(const std::string& path) const;
  /// Parses the mesh in these bytes, read from `path`, not cached yet; references are read from `files`.
  const LoadedMesh& read(const std::string& path, const std::string& bytes, config::FileReader& files);
  /// A readable mesh, placed and, if it is fitted, scaled to a size; null: at its own size.
  const MeshBody& body(const LoadedMesh& entry, const geom::Size* size, const mesh::Placement& at) const;

 private:
  std::map<std::string, LoadedMesh> entries_;
};

/// 2D outlines of a mesh in B; its bounding box if no part has an area.
std::vector<Block> outlines_of(const mesh::Mesh& mesh);

}  // namespace playhouse::scene
