#pragma once

/// Flat mirrors in colour pictures: which faces of a shape are mirrors, which of them a view shows, and the
/// view as a mirror reflects it. Pure; MirrorList keeps its buffers.
/// Frames: S the shape's own, W and E (view.h).
///
/// In: meshes; instances that a view shows.
/// Out: the kMostMirrors planes that are largest in the picture, also where other bodies hide them.
/// Cost: a sort of a shape's mirror triangles, once; a polygon clipped per face and view.
/// Source: the reflected eye of Diefenbach, "Pipeline rendering: interaction and realism through
///   hardware-based multi-pass rendering", 1996.

#include <span>
#include <vector>

#include "playhouse/mesh/mesh.h"
#include "playhouse/render/view.h"

namespace playhouse::render {

/// Of a view; further ones are drawn like any metal, which reflects the light of sky and floor alone.
inline constexpr std::size_t kMostMirrors = 4;

/// Metallic and smooth.
bool is_mirror(const mesh::Material& material);

/// A flat part of a shape that is a mirror.
struct FlatFace {
  geom::Vec3 n;                    // unit, outwards, in S
  std::vector<geom::Vec3> corner;  // its convex hull  [m, in S]
  double area = 0;                 // m2
  bool is_two_sided = false;
};
/// The largest faces first: those with at least a hundredth of all that is mirror, 16 at most. Triangles
/// whose normals differ between corners are not flat. None of a shape with more than 65,536 flat triangles.
std::vector<FlatFace> mirror_faces(const mesh::Mesh& mesh);

/// Pixels [left, right) x [high, low), rows from the top.
struct Window {
  std::uint32_t left = 0, high = 0, right = 0, low = 0;
};

/// A mirror as a view sees it.
struct Mirror {
  geom::Vec3 n;      // unit, towards the eye
  double d = 0;      // m, from the eye to its plane: n p + d = 0 in it, in E
  geom::Vec3 at;     // a point of it  [m, in E]
  double depth = 0;  // m along the optical axis, of its nearest point
  double pixels = 0;
  Window window;  // all of its pixels
};

class MirrorList {
 public:
  void begin(const View& view, const Axes& axes);
  /// The faces of a shape at p_E with the orientation q.
  void add(const geom::Vec3& p_E, const geom::Quaternion& q, std::span<const FlatFace> faces);
  /// The largest first. Faces in one plane are one mirror.
  void finish();
  std::span<const Mirror> mirrors() const { return chosen_; }

 private:
  void add_face(const Mirror& plane);

  View view_;
  Axes axes_;
  Planes planes_;
  std::vector<Mirror> found_, chosen_;
  std::vector<geom::Vec3> corners_, clipped_;
};

/// What the mirror shows: its eye is behind the plane, its axes are left-handed, and nothing is hidden.
View reflected(const View& view, const Mirror& mirror);
Axes reflected(const Axes& axes, const Mirror& mirror);

}  // namespace playhouse::render
