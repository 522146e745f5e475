#pragma once

/// Mesh: what a file of a modelling program says, in metres with z up: surfaces with their materials and
/// textures, lights, and, where it says so, shapes and masses for physics. Frame: F the file's own, x ahead,
/// y to the left, z up.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/geom/orientation.h"

namespace playhouse::mesh {

/// Red, green and blue as light, not as a screen's values: linear, from 0.
using Light3 = std::array<float, 3>;

/// Pixels row by row from the top, from left to right; red, green, blue and opacity as sRGB.
struct Image {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // height x width x 4
};

/// What the opacity of a surface means, as glTF's alphaMode has it.
enum class Opacity : std::uint8_t {
  kSolid,  // nothing
  kHoles,  // what is below Material::least_opacity is not there, the rest is solid
  kClear,  // one sees through it
};

/// How a surface looks: metallic-roughness, as glTF 2.0 defines it.
struct Material {
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::string name;
  std::array<float, 4> base = {1, 1, 1, 1};  // linear red, green, blue, and opacity; times the texture
  float metallic = 0;                        // 0 to 1
  float roughness = 1;                       // 0 to 1
  Light3 emission = {0, 0, 0};
  std::uint32_t texture = kNone;  // row of Mesh::images
  Opacity opacity = Opacity::kHoles;
  float least_opacity = 0.5f;  // of kHoles
  bool is_two_sided = false;
};

/// Triangles of one material. Corners that differ in a normal or a place on the texture are corners of their
/// own.
struct Surface {
  std::uint32_t material = 0;                // row of Mesh::materials
  std::vector<std::array<float, 3>> p;       // m, in F                                 (corners)
  std::vector<std::array<float, 3>> normal;  // unit vectors, outwards                  (corners)
  std::vector<std::array<float, 2>> uv;      // u to the right, v down, 1 is the image's size  (corners)
  std::vector<std::array<std::uint32_t, 3>> corners;  // counter-clockwise seen from outside     (triangles)
};

enum class LightKind : std::uint8_t { kPoint, kDirection, kSpot };

struct Light {
  LightKind kind = LightKind::kPoint;
  geom::Vec3 p;                // m, in F
  geom::Vec3 d = {0, 0, -1};   // where it shines; unit
  Light3 color = {1, 1, 1};    // candela where it has a place, lux where it has a direction only
  float inner = 0, outer = 0;  // rad from d: full light, and none, of a spot
};

enum class ShapeKind : std::uint8_t { kBox, kSphere, kCapsule, kCylinder, kHull, kTriangles };

/// A shape for physics, at p turned by q in F.
struct Shape {
  ShapeKind kind = ShapeKind::kBox;
  geom::Vec3 p;
  geom::Quaternion q;
  /// Of a box half its edges. Of the others x is the radius; z of cylinders, and of capsules without their
  /// caps, is half their length along z. Nothing of hulls and triangles.  [m]
  geom::Vec3 half;
  std::vector<geom::Vec3> points;                     // of hulls and triangles  [m]
  std::vector<std::array<std::uint32_t, 3>> corners;  // of triangles: rows of points
};

/// What a file says of a body for physics.
struct Physics {
  std::vector<Shape> shapes;
  std::optional<double> mass;                   // kg
  std::optional<double> friction, restitution;  // coefficients
  bool is_fixed = false;
};

struct Mesh {
  std::vector<Surface> surfaces;
  std::vector<Material> materials;
  std::vector<Image> images;
  std::vector<Light> lights;
  std::optional<Physics> physics;
  geom::Vec3 low, high;  // the box that holds all surfaces  [m]
};

}  // namespace playhouse::mesh
