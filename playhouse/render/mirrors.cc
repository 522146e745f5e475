#include "playhouse/render/mirrors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <tuple>

#include "playhouse/geom/convex_hull.h"
#include "playhouse/mesh/opacity.h"

namespace playhouse::render {
namespace {

using geom::Vec3;

constexpr float kLeastMetal = 0.5f, kMostRoughness = 0.05f;
constexpr double kFlat = 0.9999;  // cosine between the normals of a corner and of its triangle
constexpr double kLeastShare = 0.01;
constexpr std::size_t kMostFaces = 16, kMostFacets = 1u << 16;
constexpr double kLeastPixels = 1;
// Planes that are one: their normals (one less the cosine), and how far one is off the other.  [m]
constexpr double kParallel = 1e-8, kApart = 1e-3;

/// Triangles in planes of one raster are one face.
struct Facet {
  std::tuple<bool, std::int64_t, std::int64_t, std::int64_t, std::int64_t> plane;
  std::array<Vec3, 3> corner;
  Vec3 n;  // times twice its area
};

Vec3 vec(const std::array<float, 3>& v) {
  return {v[0], v[1], v[2]};
}

bool is_flat(const mesh::Surface& surface, const std::array<std::uint32_t, 3>& corners, const Vec3& n) {
  return std::ranges::all_of(corners, [&](std::uint32_t i) {
    return i < surface.normal.size() && dot(vec(surface.normal[i]), n) > kFlat;
  });
}

/// Of a flat triangle.
std::optional<Facet> facet_of(const mesh::Surface& surface, const std::array<std::uint32_t, 3>& corners,
                              bool is_two_sided) {
  const Vec3 a = vec(surface.p[corners[0]]), b = vec(surface.p[corners[1]]), c = vec(surface.p[corners[2]]);
  const Vec3 n2 = cross(b - a, c - a);
  const double length = std::sqrt(dot(n2, n2));
  if (!(length > 0)) return std::nullopt;
  const Vec3 n = (1 / length) * n2;
  if (!is_flat(surface, corners, n)) return std::nullopt;
  const auto raster = [](double value, double per_one) { return std::llround(value * per_one); };
  const double off = std::clamp(dot(n, (1.0 / 3) * (a + b + c)), -1e9, 1e9);
  return Facet{
      {is_two_sided, raster(n.x, 1e4), raster(n.y, 1e4), raster(n.z, 1e4), raster(off, 1e3)}, {a, b, c}, n2};
}

template <typename Take>
void for_each_facet(const mesh::Mesh& mesh, const Take& take) {
  for (const mesh::Surface& surface : mesh.surfaces) {
    if (surface.material >= mesh.materials.size()) continue;
    const mesh::Material& material = mesh.materials[surface.material];
    if (!is_mirror(material) || mesh::is_see_through(mesh, material) || mesh::is_all_hole(material)) continue;
    for (const auto& corners : surface.corners)
      if (const std::optional<Facet> facet = facet_of(surface, corners, material.is_two_sided)) take(*facet);
  }
}

double area_of(std::span<const Facet> facets) {
  double area = 0;
  for (const Facet& facet : facets) area += 0.5 * std::sqrt(dot(facet.n, facet.n));
  return area;
}

/// One face of facets in a plane.
FlatFace face_of(std::span<const Facet> facets) {
  FlatFace face;
  face.area = area_of(facets);
  face.is_two_sided = std::get<0>(facets.front().plane);
  Vec3 sum, middle;
  for (const Facet& facet : facets) {
    sum = sum + facet.n;
    for (const Vec3& p : facet.corner) middle = middle + (1.0 / (3 * static_cast<double>(facets.size()))) * p;
  }
  face.n = (1 / std::sqrt(dot(sum, sum))) * sum;
  const Vec3 aside = std::fabs(face.n.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 across = cross(aside, face.n), x = (1 / std::sqrt(dot(across, across))) * across;
  const Vec3 y = cross(face.n, x);
  std::vector<geom::Vec2> in_plane;
  for (const Facet& facet : facets)
    for (const Vec3& p : facet.corner) in_plane.push_back({dot(x, p - middle), dot(y, p - middle)});
  for (const geom::Vec2& p : geom::convex_hull(std::move(in_plane)))
    face.corner.push_back(middle + p.x * x + p.y * y);
  return face;
}

/// The part of a convex polygon that is inside.
void clip(const Planes::Plane& plane, const std::vector<Vec3>& from, std::vector<Vec3>& to) {
  to.clear();
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec3 &a = from[i], &b = from[(i + 1) % from.size()];
    const double in_a = dot(plane.n, a) + plane.d, in_b = dot(plane.n, b) + plane.d;
    if (in_a >= 0) to.push_back(a);
    if ((in_a >= 0) != (in_b >= 0)) to.push_back(a + (in_a / (in_a - in_b)) * (b - a));
  }
}

Window joined(const Window& a, const Window& b) {
  return {std::min(a.left, b.left), std::min(a.high, b.high), std::max(a.right, b.right),
          std::max(a.low, b.low)};
}

bool are_one(const Mirror& a, const Mirror& b) {
  return dot(a.n, b.n) > 1 - kParallel && std::fabs(dot(a.n, b.at) + a.d) < kApart;
}

}  // namespace

bool is_mirror(const mesh::Material& material) {
  return material.metallic >= kLeastMetal && material.roughness <= kMostRoughness;
}

std::vector<FlatFace> mirror_faces(const mesh::Mesh& mesh) {
  std::size_t count = 0;
  for_each_facet(mesh, [&](const Facet&) { ++count; });
  if (count > kMostFacets) return {};
  std::vector<Facet> facets;
  facets.reserve(count);
  for_each_facet(mesh, [&](const Facet& facet) { facets.push_back(facet); });
  std::ranges::stable_sort(facets, {}, &Facet::plane);
  const double least = kLeastShare * area_of(facets);
  std::vector<std::pair<double, std::span<const Facet>>> runs;  // with minus the area
  for (std::size_t begin = 0, end = 0; begin < facets.size(); begin = end) {
    while (end < facets.size() && facets[end].plane == facets[begin].plane) ++end;
    const std::span<const Facet> run(facets.data() + begin, end - begin);
    if (const double area = area_of(run); area >= least) runs.emplace_back(-area, run);
  }
  std::ranges::stable_sort(runs, {}, [](const auto& run) { return run.first; });
  if (runs.size() > kMostFaces) runs.resize(kMostFaces);
  std::vector<FlatFace> faces;
  for (const auto& [area, run] : runs) faces.push_back(face_of(run));
  std::erase_if(faces, [](const FlatFace& face) { return face.corner.size() < 3; });
  return faces;
}

void MirrorList::begin(const View& view, const Axes& axes) {
  view_ = view;
  axes_ = axes;
  planes_ = planes_of(view, axes);
  found_.clear();
  chosen_.clear();
}

void MirrorList::add(const Vec3& p_E, const geom::Quaternion& q, std::span<const FlatFace> faces) {
  for (const FlatFace& face : faces) {
    Mirror plane;
    plane.n = q * face.n;
    plane.at = p_E + q * face.corner.front();
    plane.d = -dot(plane.n, plane.at);
    if (face.is_two_sided && plane.d < 0) {
      plane.n = -1 * plane.n;
      plane.d = -plane.d;
    }
    if (!(plane.d > kApart)) continue;
    corners_.clear();
    for (const Vec3& corner : face.corner) corners_.push_back(p_E + q * corner);
    add_face(plane);
  }
}

/// Adds the mirror with corners_ in a plane, if the view shows any of it.
void MirrorList::add_face(const Mirror& plane) {
  for (const Planes::Plane& side : planes_.planes) {
    clip(side, corners_, clipped_);
    corners_.swap(clipped_);
  }
  if (corners_.size() < 3) return;
  Mirror mirror = plane;
  mirror.depth = 1e300;
  const double width = view_.width, height = view_.height;
  double left = width, right = 0, high = height, low = 0, x_before = 0, y_before = 0, twice = 0;
  for (std::size_t i = 0; i <= corners_.size(); ++i) {
    const Vec3& p = corners_[i % corners_.size()];
    const double depth = dot(axes_.ahead, p);
    const double x = 0.5 * width * (1 - dot(axes_.left, p) / (depth * view_.half_width));
    const double y = 0.5 * height * (1 - dot(axes_.up, p) / (depth * view_.half_height));
    if (i > 0) twice += x_before * y - x * y_before;
    x_before = x;
    y_before = y;
    mirror.depth = std::min(mirror.depth, depth);
    left = std::min(left, x);
    right = std::max(right, x);
    high = std::min(high, y);
    low = std::max(low, y);
  }
  mirror.pixels = 0.5 * std::fabs(twice);
  if (!(mirror.pixels >= kLeastPixels)) return;
  // A pixel more on each side, for what the card rounds.
  const auto within = [](double at, double most) {
    return static_cast<std::uint32_t>(std::clamp(at, 0.0, most));
  };
  mirror.window = {within(std::floor(left) - 1, width), within(std::floor(high) - 1, height),
                   within(std::ceil(right) + 1, width), within(std::ceil(low) + 1, height)};
  found_.push_back(mirror);
}

void MirrorList::finish() {
  std::ranges::stable_sort(found_, std::greater(), &Mirror::pixels);
  for (const Mirror& mirror : found_) {
    const auto same = std::ranges::find_if(chosen_, [&](const Mirror& has) { return are_one(has, mirror); });
    if (same != chosen_.end()) {
      same->window = joined(same->window, mirror.window);
      same->depth = std::min(same->depth, mirror.depth);
    } else if (chosen_.size() < kMostMirrors) {
      chosen_.push_back(mirror);
    }
  }
}

View reflected(const View& view, const Mirror& mirror) {
  View other = view;
  other.eye = view.eye - 2 * mirror.d * mirror.n;
  other.hides = kNoGroup;
  return other;
}

Axes reflected(const Axes& axes, const Mirror& mirror) {
  const auto across = [&](const Vec3& v) { return v - 2 * dot(mirror.n, v) * mirror.n; };
  return {across(axes.ahead), across(axes.left), across(axes.up)};
}

}  // namespace playhouse::render
