#include "playhouse/mesh/fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/geom/trig.h"
#include "playhouse/mesh/affine.h"
#include "playhouse/mesh/check_mesh.h"

namespace playhouse::mesh {
namespace {

using geom::Vec3;

/// p_B = stretch (p_F - middle).
struct Fit {
  Vec3 stretch{1, 1, 1}, middle;
  Vec3 scaled(const Vec3& v) const { return {stretch.x * v.x, stretch.y * v.y, stretch.z * v.z}; }
  Vec3 operator()(const Vec3& p) const { return scaled(p - middle); }
};

std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
Vec3 vec(const std::array<float, 3>& v) {
  return {v[0], v[1], v[2]};
}

/// Moves the corners by `place`, and turns normals by `axes`, its linear part.
template <typename Place>
void move(Surface& surface, const Affine& axes, const Place& place) {
  const Affine X_normal = for_normals(axes);
  for (auto& p : surface.p) p = floats(place(vec(p)));
  for (auto& normal : surface.normal) normal = floats(unit(X_normal.turn(vec(normal)), {0, 0, 1}));
  if (axes.volume() < 0)
    for (auto& corner : surface.corners) std::swap(corner[1], corner[2]);
}

void fit(Surface& surface, const Fit& fit) {
  move(surface, {{{{fit.stretch.x, 0, 0}, {0, fit.stretch.y, 0}, {0, 0, fit.stretch.z}}}, {}}, fit);
}

/// Point shapes from files are never rotated: they have no orientation of their own.
bool has_points(const CollisionShape& shape) {
  return shape.kind == ShapeKind::kHull || shape.kind == ShapeKind::kTriangles;
}

/// Scales a shape without points by these factors along its own axes.
void widen(CollisionShape& shape, const Vec3& by) {
  if (shape.kind == ShapeKind::kBox) {
    shape.half = {by.x * shape.half.x, by.y * shape.half.y, by.z * shape.half.z};
  } else {
    const bool is_ball = shape.kind == ShapeKind::kSphere;
    const double across = is_ball ? std::max({by.x, by.y, by.z}) : std::max(by.x, by.y);
    shape.half = {across * shape.half.x, across * shape.half.y, (is_ball ? across : by.z) * shape.half.z};
  }
}

void fit(CollisionShape& shape, const Fit& fit) {
  shape.p = fit(shape.p);
  if (has_points(shape)) {
    for (Vec3& p : shape.points) p = fit.scaled(p);
    return;
  }
  widen(shape, {length(fit.scaled(shape.q * Vec3{1, 0, 0})), length(fit.scaled(shape.q * Vec3{0, 1, 0})),
                length(fit.scaled(shape.q * Vec3{0, 0, 1}))});
}

/// Without the rounding that makes the cosine of a right angle 6e-17: corners that coincide still do.
geom::SinCos sincos_of(double angle) {
  constexpr double kNone = 2e-15;
  geom::SinCos turn = geom::sincos(angle);
  for (double* part : {&turn.sin, &turn.cos})
    if (std::fabs(*part) < kNone) *part = 0;
  return turn;
}

/// R = Rz(yaw) Ry(pitch) Rx(roll), then the scale on its columns.
Affine affine_of(const Placement& at) {
  const geom::SinCos r = sincos_of(at.turn.x), p = sincos_of(at.turn.y), y = sincos_of(at.turn.z);
  const Vec3 ahead{y.cos * p.cos, y.sin * p.cos, -p.sin},
      left{y.cos * p.sin * r.sin - y.sin * r.cos, y.sin * p.sin * r.sin + y.cos * r.cos, p.cos * r.sin},
      up{y.cos * p.sin * r.cos + y.sin * r.sin, y.sin * p.sin * r.cos - y.cos * r.sin, p.cos * r.cos};
  return {{at.scale.x * ahead, at.scale.y * left, at.scale.z * up}, at.p};
}

void place(CollisionShape& shape, const Affine& X) {
  shape.p = X * shape.p;
  if (has_points(shape)) {
    for (Vec3& p : shape.points) p = X.turn(p);
    if (X.volume() < 0)
      for (auto& corner : shape.corners) std::swap(corner[1], corner[2]);
    return;
  }
  const Affine axes{
      {X.turn(shape.q * Vec3{1, 0, 0}), X.turn(shape.q * Vec3{0, 1, 0}), X.turn(shape.q * Vec3{0, 0, 1})},
      {}};
  shape.q = rotation_of(axes);  // also of a mirrored one: these shapes are their own mirror images
  widen(shape, {length(axes.axes[0]), length(axes.axes[1]), length(axes.axes[2])});
}

void place(Light& light, const Affine& X) {
  light.p = X * light.p;
  light.d = unit(X.turn(light.d), light.d);
}

}  // namespace

Mesh fitted(Mesh mesh, const Vec3& size) {
  const Vec3 extent = mesh.high - mesh.low;
  const auto ratio = [](double wanted, double is) { return is > 0 && wanted > 0 ? wanted / is : 1; };
  const Fit to{{ratio(size.x, extent.x), ratio(size.y, extent.y), ratio(size.z, extent.z)},
               {0.5 * (mesh.low.x + mesh.high.x), 0.5 * (mesh.low.y + mesh.high.y), mesh.low.z}};
  for (Surface& surface : mesh.surfaces) fit(surface, to);
  for (Light& light : mesh.lights) light.p = to(light.p);
  if (mesh.physics)
    for (CollisionShape& shape : mesh.physics->shapes) fit(shape, to);
  measure(mesh);
  return mesh;
}

Mesh placed(Mesh mesh, const Placement& at) {
  const Affine X = affine_of(at);
  for (Surface& surface : mesh.surfaces) move(surface, X, [&X](const Vec3& p) { return X * p; });
  for (Light& light : mesh.lights) place(light, X);
  if (mesh.physics)
    for (CollisionShape& shape : mesh.physics->shapes) place(shape, X);
  measure(mesh);
  return mesh;
}

}  // namespace playhouse::mesh
