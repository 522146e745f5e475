#pragma once

/// Prototypes: the immutable part of a scene's descriptions, sent once to each viewer: kind, shape, size,
/// kind-specific fields. Descriptions that look alike share a prototype, equal shapes are stored once, so
/// the size does not grow with the number of robots. Built before the first tick, read by all threads.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::replicate {

/// A tree that users may spawn at run time.
struct Addable {
  std::string name;        // display name
  std::uint32_t desc = 0;  // row of SceneDesc::models, a root
};

/// URL of a mesh, relative to the page.
std::string mesh_address(std::size_t row);

class Prototypes {
 public:
  explicit Prototypes(const scene::SceneDesc& scene);

  /// The prototype of a row of SceneDesc::models.
  std::uint32_t of(std::uint32_t desc) const { return of_desc_[desc]; }

  /// The spawnable trees: those whose root users may move, in the order of the scene.
  const std::vector<Addable>& addable() const { return addable_; }

  /// The distinct meshes of bodies and looks.
  const std::vector<std::shared_ptr<const mesh::Mesh>>& meshes() const { return meshes_; }

  /// Items of JSON arrays, without the brackets.
  const std::string& shapes() const { return shapes_; }
  const std::string& texts() const { return texts_; }

 private:
  std::vector<std::uint32_t> of_desc_;
  std::vector<Addable> addable_;
  std::vector<std::shared_ptr<const mesh::Mesh>> meshes_;
  std::string shapes_, texts_;
};

}  // namespace playhouse::replicate
