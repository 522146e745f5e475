#include "playhouse/mesh/import/collada_physics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/mesh_limits.h"
#include "playhouse/mesh/import/collada_document.h"

namespace playhouse::mesh {
namespace {

using geom::Vec3;

/// Points and, on request, triangles.
struct Geometry {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> corners;
};

pugi::xml_node input_of(const pugi::xml_node& element, std::string_view semantic) {
  for (const pugi::xml_node& input : element.children("input"))
    if (input.attribute("semantic").value() == semantic) return input;
  return {};
}

class PhysicsReader {
 public:
  explicit PhysicsReader(const ColladaDocument& document) : document_(document) {}

  Result<std::optional<PhysicalProperties>> read();

 private:
  void add_instances(const pugi::xml_node& model_instance);
  /// A body at X, with overrides of its instance.
  void add_body(const pugi::xml_node& body, const Affine& X_FB, const pugi::xml_node& instance);
  void add_shape(const pugi::xml_node& element, const Affine& X_FB);
  void add_round(const pugi::xml_node& element, ShapeKind kind, const Affine& X_FS);
  void add_geometry(const pugi::xml_node& instance, const Affine& X_FS);
  void read_rub(const pugi::xml_node& common);
  Geometry geometry_of(const pugi::xml_node& element, bool triangles);
  std::vector<Vec3> points_of(const pugi::xml_node& mesh);
  void add_triangles(const pugi::xml_node& primitive, Geometry& geometry);
  void fail(std::string text) {
    if (!error_) error_ = Error{{}, std::move(text)};
  }

  const ColladaDocument& document_;
  PhysicalProperties physics_;
  std::optional<Error> error_;
  bool is_any_dynamic_ = false;
};

Result<std::optional<PhysicalProperties>> PhysicsReader::read() {
  const pugi::xml_node root = document_.root();
  bool has_instances = false;
  for (const pugi::xml_node& scene : root.child("library_physics_scenes").children("physics_scene"))
    for (const pugi::xml_node& instance : scene.children("instance_physics_model")) {
      has_instances = true;
      add_instances(instance);
    }
  // Bodies without an instance are placed as described.
  if (!has_instances)
    for (const pugi::xml_node& model : root.child("library_physics_models").children("physics_model"))
      for (const pugi::xml_node& body : model.children("rigid_body")) add_body(body, document_.X_FC(), {});
  if (error_) return *error_;
  if (physics_.shapes.empty()) return std::optional<PhysicalProperties>();
  physics_.is_fixed = !is_any_dynamic_;
  return std::optional<PhysicalProperties>(std::move(physics_));
}

void PhysicsReader::add_instances(const pugi::xml_node& model_instance) {
  const std::string_view address = model_instance.attribute("url").value();
  const pugi::xml_node model = document_.find(address);
  if (!model)
    return fail(fmt::format("has no physics model {}, of which there is an instance", in_quotes(address)));
  for (const pugi::xml_node& instance : model_instance.children("instance_rigid_body")) {
    const std::string_view sid = instance.attribute("body").value(),
                           target = instance.attribute("target").value();
    const pugi::xml_node body = model.find_child([&](const pugi::xml_node& child) {
      return std::string_view(child.name()) == "rigid_body" && child.attribute("sid").value() == sid;
    });
    if (!body)
      return fail(fmt::format("has no rigid body {}, of which there is an instance", in_quotes(sid)));
    const std::optional<Affine> X_FB = document_.node_in_F(target);
    if (!X_FB) return fail(fmt::format("has no node {}, which a rigid body moves", in_quotes(target)));
    add_body(body, *X_FB, instance.child("technique_common"));
  }
}

void PhysicsReader::add_body(const pugi::xml_node& body, const Affine& X_FB, const pugi::xml_node& instance) {
  const pugi::xml_node common = body.child("technique_common");
  const auto said = [&](const char* name) {
    const pugi::xml_node of_instance = instance.child(name);
    return of_instance ? of_instance : common.child(name);
  };
  const std::string_view dynamic = said("dynamic").text().get();
  is_any_dynamic_ = is_any_dynamic_ || (dynamic != "false" && dynamic != "0");
  read_rub(instance);
  read_rub(common);
  std::optional<double> mass = number_of(said("mass"));
  std::optional<double> of_shapes;
  for (const pugi::xml_node& shape : common.children("shape")) {
    if (physics_.shapes.size() >= limits::kMeshShapes)
      return fail(fmt::format("has too many shapes for physics: up to {} are possible", limits::kMeshShapes));
    add_shape(shape, X_FB);
    read_rub(shape);
    if (const auto own = number_of(shape.child("mass"))) of_shapes = of_shapes.value_or(0) + *own;
  }
  if (!mass) mass = of_shapes;
  if (mass) physics_.mass = physics_.mass.value_or(0) + *mass;
}

void PhysicsReader::read_rub(const pugi::xml_node& common) {
  pugi::xml_node material = common.child("physics_material");
  if (!material)
    material = document_.find(common.child("instance_physics_material").attribute("url").value());
  const pugi::xml_node says = material.child("technique_common");
  if (!physics_.friction) physics_.friction = number_of(says.child("dynamic_friction"));
  if (!physics_.friction) physics_.friction = number_of(says.child("static_friction"));
  if (!physics_.restitution) physics_.restitution = number_of(says.child("restitution"));
}

void PhysicsReader::add_shape(const pugi::xml_node& element, const Affine& X_FB) {
  const Affine X_FS = X_FB * transform_of(element);
  if (const pugi::xml_node box = element.child("box")) {
    const std::vector<double> half = numbers_of(box.child("half_extents"), 3);
    if (half.size() != 3) return fail("has a box without half_extents");
    physics_.shapes.push_back(
        {ShapeKind::kBox,
         X_FS.p,
         rotation_of(X_FS),
         {std::fabs(half[0]) * length(X_FS.axes[0]), std::fabs(half[1]) * length(X_FS.axes[1]),
          std::fabs(half[2]) * length(X_FS.axes[2])},
         {},
         {}});
  }
  if (const pugi::xml_node sphere = element.child("sphere")) {
    const std::optional<double> radius = number_of(sphere.child("radius"));
    if (!radius) return fail("has a sphere without a radius");
    const double stretch = std::max({length(X_FS.axes[0]), length(X_FS.axes[1]), length(X_FS.axes[2])});
    const double r = std::fabs(*radius) * stretch;
    physics_.shapes.push_back({ShapeKind::kSphere, X_FS.p, {}, {r, r, r}, {}, {}});
  }
  if (const pugi::xml_node capsule = element.child("capsule")) add_round(capsule, ShapeKind::kCapsule, X_FS);
  if (const pugi::xml_node cylinder = element.child("cylinder"))
    add_round(cylinder, ShapeKind::kCylinder, X_FS);
  for (const pugi::xml_node& geometry : element.children("instance_geometry")) add_geometry(geometry, X_FS);
}

/// COLLADA's cylinders and capsules are along y, ours along z.
void PhysicsReader::add_round(const pugi::xml_node& element, ShapeKind kind, const Affine& X_FS) {
  const std::vector<double> radius = numbers_of(element.child("radius"), 2);
  const std::optional<double> height = number_of(element.child("height"));
  if (radius.empty() || !height) return fail("has a capsule or a cylinder without radius and height");
  const Affine along{{X_FS.axes[2], X_FS.axes[0], X_FS.axes[1]}, X_FS.p};
  const double r = std::fabs(radius[0]) * std::max(length(along.axes[0]), length(along.axes[1]));
  const double half = 0.5 * std::fabs(*height) * length(along.axes[2]);
  physics_.shapes.push_back({kind, X_FS.p, rotation_of(along), {r, r, half}, {}, {}});
}

void PhysicsReader::add_geometry(const pugi::xml_node& instance, const Affine& X_FS) {
  const std::string_view address = instance.attribute("url").value();
  pugi::xml_node geometry = document_.find(address);
  if (!geometry) return fail(fmt::format("has no geometry {}, which a rigid body has", in_quotes(address)));
  pugi::xml_node convex = geometry.child("convex_mesh");
  if (const pugi::xml_attribute of = convex.attribute("convex_hull_of"))
    if (const pugi::xml_node hull_of = document_.find(of.value())) geometry = hull_of;
  const bool is_hull = !convex.empty();
  const pugi::xml_node mesh = geometry.child("mesh") ? geometry.child("mesh") : geometry.child("convex_mesh");
  Geometry read = geometry_of(mesh, !is_hull);
  for (Vec3& p : read.points) p = X_FS * p;
  if (X_FS.volume() < 0)
    for (auto& corner : read.corners) std::swap(corner[1], corner[2]);
  if (read.points.size() < 4 || (!is_hull && read.corners.empty()))
    return fail(fmt::format("has a geometry {} for physics that is not a solid", in_quotes(address)));
  physics_.shapes.push_back({is_hull ? ShapeKind::kHull : ShapeKind::kTriangles,
                             {},
                             {},
                             {},
                             std::move(read.points),
                             std::move(read.corners)});
}

Geometry PhysicsReader::geometry_of(const pugi::xml_node& mesh, bool triangles) {
  Geometry geometry{points_of(mesh), {}};
  if (!triangles) return geometry;
  for (const char* form : {"triangles", "polylist"})
    for (const pugi::xml_node& primitive : mesh.children(form)) add_triangles(primitive, geometry);
  return geometry;
}

std::vector<Vec3> PhysicsReader::points_of(const pugi::xml_node& mesh) {
  const pugi::xml_node position = input_of(mesh.child("vertices"), "POSITION");
  const pugi::xml_node source = document_.find(position.attribute("source").value());
  const std::vector<double> numbers = numbers_of(source.child("float_array"), 3 * limits::kMeshCorners);
  const std::size_t stride =
      std::max(3u, source.child("technique_common").child("accessor").attribute("stride").as_uint(3));
  std::vector<Vec3> points;
  for (std::size_t i = 0; i + stride <= numbers.size(); i += stride)
    points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return points;
}

/// Polygons as triangle fans. In a polylist, vcount has the corner counts.
void PhysicsReader::add_triangles(const pugi::xml_node& primitive, Geometry& geometry) {
  constexpr std::size_t kMost = 3 * limits::kMeshTriangles;
  std::size_t stride = 1;
  for (const pugi::xml_node& input : primitive.children("input"))
    stride = std::max<std::size_t>(stride, std::min(input.attribute("offset").as_uint(), 255u) + 1);
  const std::size_t offset = input_of(primitive, "VERTEX").attribute("offset").as_uint();
  const std::vector<double> rows = numbers_of(primitive.child("p"), kMost * stride);
  const std::vector<double> counts = numbers_of(primitive.child("vcount"), limits::kMeshTriangles);
  const bool is_list = std::string_view(primitive.name()) == "polylist";
  std::size_t at = 0;
  const auto row = [&](std::size_t corner) -> std::uint32_t {
    const std::size_t place = (at + corner) * stride + offset;
    const double value = place < rows.size() ? rows[place] : -1;
    if (value >= 0 && value < static_cast<double>(geometry.points.size()))
      return static_cast<std::uint32_t>(value);
    fail("is broken: a triangle for physics has a corner that is not there");
    return 0;
  };
  for (std::size_t polygon = 0; !error_; ++polygon) {
    if (is_list ? polygon >= counts.size() : (at + 3) * stride > rows.size()) return;
    const double count = is_list ? counts[polygon] : 3;
    if (!(count >= 3 && count <= 65536)) return fail("is broken: a polygon for physics has no corners");
    for (std::size_t k = 1; k + 1 < static_cast<std::size_t>(count) && !error_; ++k)
      geometry.corners.push_back({row(0), row(k), row(k + 1)});
    at += static_cast<std::size_t>(count);
  }
}

}  // namespace

Result<std::optional<PhysicalProperties>> collada_physics(std::string_view bytes) {
  const Result<ColladaDocument> document = ColladaDocument::parse(bytes);
  if (!document) return document.error();
  return PhysicsReader(*document).read();
}

}  // namespace playhouse::mesh
