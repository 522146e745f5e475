#pragma once

/// The meshes of a world as files for browsers, built
/// on first request and cached. Thread: the web thread.

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::web_server {

class MeshFiles {
 public:
  /// Meshes of a world's prototypes, which must outlive this.
  explicit MeshFiles(std::span<const std::shared_ptr<const mesh::Mesh>> meshes);

  struct File {
    std::shared_ptr<const std::string> bytes;  // binary glTF
    std::string etag;                          // quoted
  };
  /// The file at a path like "/meshes/0.glb"; null if there is
  /// none. Cost: PNG compression of its textures, the first time.
  const File* find(std::string_view path);

 private:
  std::span<const std::shared_ptr<const mesh::Mesh>> meshes_;
  std::map<std::string, std::size_t, std::less<>> rows_;  // by address
  std::map<std::size_t, File> made_;
};

}  // namespace playhouse::web_server
