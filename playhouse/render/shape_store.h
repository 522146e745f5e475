#pragma once

/// ShapeStore: meshes in GPU memory, in one vertex buffer
/// and one index buffer. Thread: that of a CurrentContext.

#include <vector>

#include "playhouse/mesh/mesh.h"
#include "playhouse/render/gl_objects.h"
#include "playhouse/render/humanoid.h"
#include "playhouse/render/mirrors.h"

namespace playhouse::render {

/// Triangles of one material: a draw call.
struct SurfaceRange {
  std::uint32_t first_index = 0, indices = 0, first_corner = 0;
  std::array<float, 4> base = {1, 1, 1, 1};
  std::array<float, 3> emission = {0, 0, 0};
  float metallic = 0, roughness = 1;
  std::uint32_t texture = 0;  // OpenGL name; 0: none
  float least_opacity = 0;    // alpha test threshold; below 0: no test
  bool is_two_sided = false, is_see_through = false, is_mirror = false;
};

struct ShapeOnCard {
  std::vector<SurfaceRange> surfaces;
  std::vector<FlatFace> mirrors;
  geom::Vec3 middle;  // bounding sphere  [m]
  double radius = 0;  // m
};

class ShapeStore {
 public:
  std::uint32_t add(const mesh::Mesh& mesh);
  const ShapeOnCard& operator[](std::uint32_t shape) const { return shapes_[shape]; }
  std::size_t size() const { return shapes_.size(); }
  /// True once a shape has been added that has mirrors.
  bool has_mirrors() const { return has_mirrors_; }
  /// Uploads the shapes added so far.
  void upload();
  const Buffer& corners() const { return corner_buffer_; }
  const Buffer& indices() const { return index_buffer_; }
  static constexpr GLsizei kCornerBytes = 8 * sizeof(float);  // position, normal, texture coordinates

 private:
  std::vector<std::uint32_t> add_images(const mesh::Mesh& mesh);

  std::vector<ShapeOnCard> shapes_;
  std::vector<float> corners_;
  std::vector<std::uint32_t> indices_;
  Buffer corner_buffer_, index_buffer_;
  std::vector<Texture> textures_;
  bool is_sent_ = false, has_mirrors_ = false;
};

/// The levels of detail of a humanoid, likewise.
class FigureStore {
 public:
  void upload();
  struct DetailLevel {
    std::uint32_t first_index = 0, indices = 0, first_corner = 0;
  };
  const DetailLevel& level(int number) const { return levels_[static_cast<std::size_t>(number)]; }
  const Buffer& corners() const { return corner_buffer_; }
  const Buffer& indices() const { return index_buffer_; }
  static constexpr GLsizei kCornerBytes = 14 * sizeof(float);  // position, normal, paint, bones

 private:
  std::array<DetailLevel, kHumanoidLevels> levels_;
  Buffer corner_buffer_, index_buffer_;
};

}  // namespace playhouse::render
