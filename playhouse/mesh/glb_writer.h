#pragma once

/// Writer of binary glTF files: meshes, materials and images.
/// Source: Khronos Group, "glTF 2.0 Specification".

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "playhouse/geom/pose.h"
#include "playhouse/mesh/mesh.h"

namespace playhouse::mesh {

/// Joins the elements of a JSON array.
class JsonList {
 public:
  template <typename... Arguments>
  std::size_t add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    if (count_ > 0) text_ += ',';
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    return count_++;
  }
  std::size_t size() const { return count_; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t count_ = 0;
};

/// Each add_... returns the index of what it added.
class GlbWriter {
 public:
  JsonList meshes, materials;

  /// Accessors.
  std::size_t add_points(std::span<const std::array<float, 3>> points);  // at least one
  std::size_t add_normals(std::span<const std::array<float, 3>> normals);
  std::size_t add_corners(std::span<const std::uint32_t> corners);
  /// A mesh transformed by X_FB, with materials and textures, without lights.
  std::size_t add_mesh(const Mesh& mesh, const geom::Pose& X_FB);

  std::size_t bytes() const { return binary_.size() + views_.text().size() + accessors_.text().size(); }
  /// The file; `scene` has its nodes and scenes: top-level JSON members, without braces.
  std::string file(std::string_view scene);

 private:
  std::size_t add_view(std::span<const std::byte> bytes, int target);
  std::size_t add_uv(std::span<const std::array<float, 2>> uv);
  std::size_t add_image(const Image& image);
  std::size_t add_material(const Mesh& mesh, const Material& material, std::size_t first_texture);

  std::string binary_;
  JsonList accessors_, views_, images_, textures_;
};

/// A mesh in B as a file, converted to y-up by its only node.
std::string write_glb(const Mesh& mesh);

}  // namespace playhouse::mesh
