#pragma once

/// The meshes of a world as files for browsers. Each is made when somebody asks for it first, and kept.
/// Thread: the web thread.

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::web_server {

class MeshFiles {
 public:
  /// Of the prototypes of a world, which outlive this.
  explicit MeshFiles(std::span<const std::shared_ptr<const mesh::Mesh>> meshes);

  struct File {
    std::shared_ptr<const std::string> bytes;  // binary glTF
    std::string etag;                          // quoted
  };
  /// The file at an address "/meshes/0.glb"; null: there is none. Cost: that of its textures as PNG, the
  /// first time.
  const File* find(std::string_view path);

 private:
  std::span<const std::shared_ptr<const mesh::Mesh>> meshes_;
  std::map<std::string, std::size_t, std::less<>> rows_;  // by address
  std::map<std::size_t, File> made_;
};

}  // namespace playhouse::web_server
