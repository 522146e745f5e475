#pragma once

/// Meshes as bodies of models: each file read once, each size of it made once. In the plane a mesh is the
/// outlines of its parts: of each, the convex hull seen from above, from its lowest to its highest corner.

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/mesh/read_mesh.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/scene/source_text.h"

namespace playhouse::scene {

class MeshBodies {
 public:
  /// A mesh of this size, in B.
  struct Body {
    std::shared_ptr<const mesh::Mesh> mesh;
    geom::Size size;
    std::vector<Block> blocks;
    std::size_t corners = 0;  // of the mesh
    bool is_new = true;       // until it is asked for again
  };
  struct Entry {
    std::string path;
    std::shared_ptr<const mesh::Mesh> mesh;  // in F; null: it cannot be read
    std::string why_none;
    std::vector<std::string> warnings;
    std::size_t bytes = 0;                                 // of its files
    mutable std::map<std::array<double, 3>, Body> bodies;  // by size
  };

  /// One that was read, well or not.
  const Entry* find(const std::string& path) const;
  /// The mesh of these bytes at `path`, which is not read yet; what it names comes from `files`.
  const Entry& read(const std::string& path, const std::string& bytes, FileReader& files);
  /// Of a mesh that was read well; null: as large as it is.
  const Body& body(const Entry& entry, const geom::Size* size) const;

 private:
  std::map<std::string, Entry> entries_;
};

/// What a mesh in B is in the plane. Where no part has an area, its box.
std::vector<Block> outlines_of(const mesh::Mesh& mesh);

}  // namespace playhouse::scene
