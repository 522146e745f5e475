#pragma once

/// Mesh: contents of a 3D model file, in metres, z up: surfaces
/// with materials and textures, lights, and optionally collision
/// shapes and mass. Frame: F the file's own, x ahead, y left, z up.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/geom/orientation.h"

namespace playhouse::mesh {

/// Linear RGB, from 0.
using Light3 = std::array<float, 3>;

/// Pixels in rows from the top, left to right; sRGB with alpha.
struct Image {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // height x width x 4
};

/// Use of alpha, like glTF's alphaMode.
enum class Opacity : std::uint8_t {
  kSolid,  // ignored
  kHoles,  // alpha test against Material::least_opacity
  kClear,  // alpha blending
};

/// Metallic-roughness material, as in glTF 2.0.
struct Material {
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::string name;
  std::array<float, 4> base = {1, 1, 1, 1};  // linear RGB and alpha; factor on the texture
  float metallic = 0;                        // 0 to 1
  float roughness = 1;                       // 0 to 1
  Light3 emission = {0, 0, 0};
  std::uint32_t texture = kNone;  // row of Mesh::images
  Opacity opacity = Opacity::kHoles;
  float least_opacity = 0.5f;  // of kHoles
  bool is_two_sided = false;
};

/// Triangles of one material. Vertices are split
/// where normals or texture coordinates differ.
struct Surface {
  std::uint32_t material = 0;                // row of Mesh::materials
  std::vector<std::array<float, 3>> p;       // m, in F                                 (vertices)
  std::vector<std::array<float, 3>> normal;  // unit vectors, outwards                  (vertices)
  std::vector<std::array<float, 2>> uv;      // u to the right, v down, 1: the size of the image (vertices)
  std::vector<std::array<std::uint32_t, 3>> corners;  // counter-clockwise seen from outside     (triangles)
};

enum class LightKind : std::uint8_t { kPoint, kDirection, kSpot };

struct Light {
  LightKind kind = LightKind::kPoint;
  geom::Vec3 p;                // m, in F
  geom::Vec3 d = {0, 0, -1};   // direction of emission; unit
  Light3 color = {1, 1, 1};    // candela for point and spot, lux for directional lights
  float inner = 0, outer = 0;  // rad from d: cone angles of full and of no light, of a spot
};

enum class ShapeKind : std::uint8_t { kBox, kSphere, kCapsule, kCylinder, kHull, kTriangles };

/// A collision shape, at p, q in F.
struct CollisionShape {
  ShapeKind kind = ShapeKind::kBox;
  geom::Vec3 p;
  geom::Quaternion q;
  /// Half extents of a box. Otherwise x is the radius, z half the length of cylinders,
  /// and of capsules without caps, along z. Unused by hulls and triangles. [m]
  geom::Vec3 half;
  std::vector<geom::Vec3> points;                     // of hulls and triangles  [m]
  std::vector<std::array<std::uint32_t, 3>> corners;  // of triangles: rows of points
};

/// Rigid-body properties in a file.
struct PhysicalProperties {
  std::vector<CollisionShape> shapes;
  std::optional<double> mass;                   // kg
  std::optional<double> friction, restitution;  // coefficients
  bool is_fixed = false;
};

struct Mesh {
  std::vector<Surface> surfaces;
  std::vector<Material> materials;
  std::vector<Image> images;
  std::vector<Light> lights;
  std::optional<PhysicalProperties> physics;
  geom::Vec3 low, high;  // bounding box of all surfaces  [m]
};

}  // namespace playhouse::mesh
