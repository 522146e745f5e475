#include "playhouse/arena/physics/mesh_solids.h"

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <set>

#include "playhouse/arena/physics/round_solids.h"
#include "playhouse/base/mesh_limits.h"
#include "playhouse/geom/trig.h"
#include "playhouse/mesh/mesh.h"
#include "playhouse/mesh/parts.h"

namespace playhouse::arena {
namespace {

constexpr std::size_t kFew = 64;  // hulls with at most this many corners are kept; others
constexpr int kDirections = 256;  // keep the extreme corners in this many directions

Vec3 turned(const geom::Pose& X_FB, const Vec3& p) {
  const geom::Vec2 q = geom::Rotation::of(X_FB.a) * geom::Vec2{p.x, p.y};
  return {X_FB.x + q.x, X_FB.y + q.y, X_FB.z + p.z};
}

/// Fibonacci sphere. Source: Saff, Kuijlaars, "Distributing many points on a sphere", 1997.
Vec3 direction(int k) {
  constexpr double kTurn = 2.39996322972865332;  // rad, the golden angle
  const double z = 1 - (2 * k + 1.0) / kDirections, r = std::sqrt(1 - z * z);
  const geom::SinCos a = geom::sincos(geom::normalize(k * kTurn));
  return {r * a.cos, r * a.sin, z};
}

/// Simplifies a hull to its extreme corners.
Hull simplified(const Hull& hull) {
  if (hull.size() <= kFew) return hull;
  std::set<std::size_t> kept;
  for (int k = 0; k < kDirections; ++k) {
    const Vec3 d = direction(k);
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < hull.size(); ++i)
      if (dot(d, hull[i]) > dot(d, hull[farthest])) farthest = i;
    kept.insert(farthest);
  }
  Hull few;
  for (const std::size_t i : kept) few.push_back(hull[i]);
  return few;
}

Hull box(const Vec3& half) {
  Hull hull;
  for (const double x : {-half.x, half.x})
    for (const double y : {-half.y, half.y})
      for (const double z : {-half.z, half.z}) hull.push_back({x, y, z});
  return hull;
}

/// The hull of a collision shape, in B.
Hull hull_of(const mesh::CollisionShape& shape) {
  Hull hull;
  switch (shape.kind) {
    case mesh::ShapeKind::kBox:
      hull = box(shape.half);
      break;
    case mesh::ShapeKind::kSphere:
      hull = round_hull(shape.half.x, 0);
      break;
    case mesh::ShapeKind::kCapsule:
      hull = round_hull(shape.half.x, shape.half.z);
      break;
    case mesh::ShapeKind::kCylinder:
      hull = cylinder_hull(shape.half.x, shape.half.z);
      break;
    case mesh::ShapeKind::kHull:
    case mesh::ShapeKind::kTriangles:
      hull = simplified(shape.points);
      break;
  }
  for (Vec3& p : hull) p = shape.p + shape.q * p;
  return hull;
}

bool is_solid(const Hull& hull) {
  return hull_content(hull).volume > 1e-12;
}

/// False for a point and a line.
bool has_area(const Hull& hull) {
  constexpr double kNoArea2 = 1e-16;  // m^4
  const auto from_first = [&](const Vec3& p) { return p - hull.front(); };
  Vec3 longest;
  for (const Vec3& p : hull)
    if (const Vec3 arm = from_first(p); dot(arm, arm) > dot(longest, longest)) longest = arm;
  return std::ranges::any_of(hull, [&](const Vec3& p) {
    const Vec3 area = cross(longest, from_first(p));
    return dot(area, area) > kNoArea2;
  });
}

}  // namespace

const mesh::Mesh* mesh_of(const world::World& world, world::ModelRow model) {
  return world.desc(model).mesh.get();
}

geom::Pose body_in(const world::World& world, world::ModelRow model, const geom::Pose& X_FM) {
  return geom::compose(X_FM, world.desc(model).X_MB);
}

void add_surfaces(Triangles& triangles, const mesh::Mesh& mesh, const geom::Pose& X_FB) {
  for (const mesh::Surface& surface : mesh.surfaces) {
    const auto first = static_cast<std::uint32_t>(triangles.p.size());
    for (const auto& p : surface.p) triangles.p.push_back(turned(X_FB, {p[0], p[1], p[2]}));
    for (const auto& [a, b, c] : surface.corners)
      triangles.corner.push_back({first + a, first + b, first + c});
  }
}

const std::vector<Hull>& MeshHulls::of(const mesh::Mesh& mesh) {
  const auto [entry, is_new] = known_.try_emplace(&mesh);
  std::vector<Hull>& hulls = entry->second;
  if (!is_new) return hulls;
  if (mesh.physics && !mesh.physics->shapes.empty()) {
    for (const mesh::CollisionShape& shape : mesh.physics->shapes) hulls.push_back(hull_of(shape));
  } else {
    for (const auto& part : mesh::parts_of(mesh, limits::kMeshParts)) hulls.push_back(simplified(part));
  }
  std::erase_if(hulls, [](const Hull& hull) { return !is_solid(hull); });
  if (!hulls.empty()) return hulls;
  // Only sheets: the hull of all of them, or their bounding box with a minimal thickness.
  Hull all;
  for (const auto& part : mesh::parts_of(mesh, 1)) all = simplified(part);
  if (!is_solid(all)) {
    constexpr double kSheet = 0.01;  // m
    const Vec3 extent = mesh.high - mesh.low, middle = 0.5 * (mesh.low + mesh.high);
    all = box(0.5 * Vec3{std::max(extent.x, kSheet), std::max(extent.y, kSheet), std::max(extent.z, kSheet)});
    for (Vec3& p : all) p = p + middle;
  }
  hulls.push_back(std::move(all));
  return hulls;
}

FixedParts fixed_parts(const mesh::Mesh& mesh, const geom::Pose& X_FB) {
  FixedParts parts;
  if (!mesh.physics || mesh.physics->shapes.empty()) {
    add_surfaces(parts.triangles, mesh, X_FB);
    return parts;
  }
  for (const mesh::CollisionShape& shape : mesh.physics->shapes) {
    if (shape.kind != mesh::ShapeKind::kTriangles) {
      Hull hull = hull_of(shape);
      if (!has_area(hull)) continue;
      if (!is_solid(hull)) hull.round = Round::kNot;
      for (Vec3& p : hull) p = turned(X_FB, p);
      parts.hulls.push_back(std::move(hull));
      continue;
    }
    const auto first = static_cast<std::uint32_t>(parts.triangles.p.size());
    for (const Vec3& p : shape.points) parts.triangles.p.push_back(turned(X_FB, shape.p + shape.q * p));
    for (const auto& [a, b, c] : shape.corners)
      parts.triangles.corner.push_back({first + a, first + b, first + c});
  }
  return parts;
}

HullContent hull_content(const Hull& hull) {
  HullContent content;
  if (hull.size() < 4) return content;
  std::vector<double> corners;
  for (const Vec3& p : hull) corners.insert(corners.end(), {p.x, p.y, p.z});
  btConvexHullComputer computed;
  computed.compute(corners.data(), 3 * sizeof(double), static_cast<int>(hull.size()), 0, 0);
  const auto at = [&](int vertex) {
    const btVector3& v = computed.vertices[vertex];
    return Vec3{v.x(), v.y(), v.z()} - hull[0];
  };
  Vec3 sum;
  for (int face = 0; face < computed.faces.size(); ++face) {
    const btConvexHullComputer::Edge* first = &computed.edges[computed.faces[face]];
    const Vec3 a = at(first->getSourceVertex());
    for (const auto* edge = first->getNextEdgeOfFace(); edge->getTargetVertex() != first->getSourceVertex();
         edge = edge->getNextEdgeOfFace()) {
      const Vec3 b = at(edge->getSourceVertex()), c = at(edge->getTargetVertex());
      const double volume = dot(a, cross(b, c)) / 6;
      content.volume += volume;
      sum = sum + (volume / 4) * (a + b + c);
    }
  }
  if (content.volume == 0) return content;
  content.center = (1 / content.volume) * sum + hull[0];
  content.volume = std::fabs(content.volume);
  if (hull.round != Round::kNot) content.center = round_of(hull).center();
  return content;
}

}  // namespace playhouse::arena
