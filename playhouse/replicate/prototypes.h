#pragma once

/// Prototypes: what viewers are told once of the descriptions of a scene, which never change: kind, shape,
/// size, what the kind tells. Descriptions that look alike are one prototype, and equal shapes are one shape,
/// so that a thousand robots stay small. Made before the first tick, then read by all threads.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::replicate {

/// What a person may add to a world that runs.
struct Addable {
  std::string name;        // for people
  std::uint32_t desc = 0;  // row of SceneDesc::models, a top
};

/// Under which viewers find a mesh, from the address of the page.
std::string mesh_address(std::size_t row);

class Prototypes {
 public:
  explicit Prototypes(const scene::SceneDesc& scene);

  /// The prototype of a row of SceneDesc::models.
  std::uint32_t of(std::uint32_t desc) const { return of_desc_[desc]; }

  /// The prototypes of trees whose top a person may move, in the order of the scene.
  const std::vector<Addable>& addable() const { return addable_; }

  /// The meshes that bodies look as, each once.
  const std::vector<std::shared_ptr<const mesh::Mesh>>& meshes() const { return meshes_; }

  /// Lists of JSON, without the brackets around them.
  const std::string& shapes() const { return shapes_; }
  const std::string& texts() const { return texts_; }

 private:
  std::vector<std::uint32_t> of_desc_;
  std::vector<Addable> addable_;
  std::vector<std::shared_ptr<const mesh::Mesh>> meshes_;
  std::string shapes_, texts_;
};

}  // namespace playhouse::replicate
