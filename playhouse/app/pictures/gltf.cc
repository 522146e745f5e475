#include "playhouse/app/pictures/gltf.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "playhouse/app/pictures/prisms.h"
#include "playhouse/base/limits.h"
#include "playhouse/mesh/color.h"
#include "playhouse/mesh/glb_writer.h"
#include "playhouse/mesh/import/painted.h"
#include "playhouse/wire/json.h"

namespace playhouse::app {
namespace {

using geom::Vec2;

using Float3 = std::array<float, 3>;

/// Triangles, counter-clockwise from outside.
struct Triangles {
  std::vector<Float3> points, normals;
  std::vector<std::uint32_t> corners;

  void add_quad(const std::array<Float3, 4>& quad, Float3 normal) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), quad.begin(), quad.end());
    normals.insert(normals.end(), 4, normal);
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) corners.push_back(first + k);
  }
};

Float3 at(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

void add_side(Triangles& mesh, Vec2 a, Vec2 b, const Extrusion& prism) {
  const double length = std::sqrt(geom::dot(b - a, b - a));
  if (length == 0) return;
  mesh.add_quad({at(a.x, a.y, prism.z_min), at(b.x, b.y, prism.z_min), at(b.x, b.y, prism.z_max),
                 at(a.x, a.y, prism.z_max)},
                at((b.y - a.y) / length, (a.x - b.x) / length, 0));
}

Triangles triangles_of(const scene::ModelDesc& desc) {
  Triangles mesh;
  for (const Extrusion& prism : prisms_of(desc)) {
    for (const std::vector<Vec2>& loop : prism.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        add_side(mesh, loop[i], loop[(i + 1) % loop.size()], prism);
    for (const geom::Trapezoid& t : top_of(prism)) {
      const double up = prism.z_max, down = prism.z_min;
      mesh.add_quad({at(t.left_low, t.y_low, up), at(t.right_low, t.y_low, up),
                     at(t.right_high, t.y_high, up), at(t.left_high, t.y_high, up)},
                    {0, 0, 1});
      mesh.add_quad({at(t.left_low, t.y_low, down), at(t.left_high, t.y_high, down),
                     at(t.right_high, t.y_high, down), at(t.right_low, t.y_low, down)},
                    {0, 0, -1});
    }
  }
  return mesh;
}

class Writer {
 public:
  explicit Writer(const world::World& world) : world_(world) {}

  Result<std::string> write();

 private:
  /// The colour-independent part of a body; none if the description has no body.
  struct Accessors {
    std::size_t points = 0, normals = 0, corners = 0;
    std::optional<std::size_t> mesh;  // if it has colours of its own
    bool is_look = false;             // has some of its own
    bool any = false;
  };

  void add_node(world::ModelRow row);
  const Accessors& accessors_of(std::uint32_t desc);
  std::size_t mesh_of_model(world::ModelRow row, const Accessors& accessors);
  std::size_t look_of_model(world::ModelRow row);
  std::size_t material_of(const scene::Color& color);
  std::string scene() const;

  const world::World& world_;
  mesh::GlbWriter glb_;
  mesh::JsonList nodes_, tops_;
  std::map<std::uint32_t, Accessors> by_desc_;
  std::map<std::pair<std::uint32_t, std::size_t>, std::size_t> mesh_by_look_;  // by description and material
  std::map<std::array<float, 4>, std::size_t> material_by_color_;
  std::map<std::pair<std::uint32_t, std::array<float, 4>>, std::size_t> look_by_color_;  // by description
};

const Writer::Accessors& Writer::accessors_of(std::uint32_t desc) {
  const auto [entry, is_new] = by_desc_.try_emplace(desc);
  Accessors& made = entry->second;
  if (!is_new) return made;
  const scene::ModelDesc& model = world_.scene().models[desc];
  if (model.look) {
    made.any = made.is_look = true;
    return made;
  }
  if (model.mesh) {
    made.any = true;
    made.mesh = glb_.add_mesh(*model.mesh, model.X_MB);
    return made;
  }
  const Triangles triangles = triangles_of(model);
  if (triangles.points.empty()) return made;
  made.any = true;
  made.points = glb_.add_points(triangles.points);
  made.normals = glb_.add_normals(triangles.normals);
  made.corners = glb_.add_corners(triangles.corners);
  return made;
}

std::size_t Writer::material_of(const scene::Color& color) {
  const auto [entry, is_new] =
      material_by_color_.try_emplace({color.r, color.g, color.b, color.a}, glb_.materials.size());
  if (is_new)
    glb_.materials.add(
        R"({{"pbrMetallicRoughness":{{"baseColorFactor":[{:.6g},{:.6g},{:.6g},{:.6g}],"metallicFactor":0,"roughnessFactor":0.8}}{}}})",
        mesh::linear_of_srgb(color.r), mesh::linear_of_srgb(color.g), mesh::linear_of_srgb(color.b), color.a,
        color.a < 1 ? R"(,"alphaMode":"BLEND")" : "");
  return entry->second;
}

/// The look of a model in its colour.
std::size_t Writer::look_of_model(world::ModelRow row) {
  const scene::ModelDesc& model = world_.scene().models[world_.models.desc[row]];
  const scene::Color& color = world_.models.color[row];
  mesh::Mesh painted = *model.look;
  for (mesh::Material& material : painted.materials)
    if (mesh::is_painted(material))
      material.base = {static_cast<float>(mesh::linear_of_srgb(color.r)),
                       static_cast<float>(mesh::linear_of_srgb(color.g)),
                       static_cast<float>(mesh::linear_of_srgb(color.b)), color.a};
  return glb_.add_mesh(painted, model.X_MB);
}

std::size_t Writer::mesh_of_model(world::ModelRow row, const Accessors& accessors) {
  if (accessors.mesh) return *accessors.mesh;
  if (accessors.is_look) {
    const scene::Color& c = world_.models.color[row];
    const auto [entry, is_new] = look_by_color_.try_emplace({world_.models.desc[row], {c.r, c.g, c.b, c.a}});
    if (is_new) entry->second = look_of_model(row);
    return entry->second;
  }
  const std::size_t material = material_of(world_.models.color[row]);
  const auto [entry, is_new] =
      mesh_by_look_.try_emplace({world_.models.desc[row], material}, glb_.meshes.size());
  if (is_new)
    glb_.meshes.add(
        R"({{"primitives":[{{"attributes":{{"POSITION":{},"NORMAL":{}}},"indices":{},"material":{}}}]}})",
        accessors.points, accessors.normals, accessors.corners, material);
  return entry->second;
}

/// Node numbers are model rows.
void Writer::add_node(world::ModelRow row) {
  const geom::Pose& X_PM = world_.models.X_PM[row];
  std::string name, rest;
  wire::json_text(name, world_.name(row));
  const Accessors& accessors = accessors_of(world_.models.desc[row]);
  if (accessors.any) rest = fmt::format(R"(,"mesh":{})", mesh_of_model(row, accessors));
  mesh::JsonList children;
  for (const world::ModelRow child : world_.children(row)) children.add("{}", child.index);
  if (children.size() > 0) rest += fmt::format(R"(,"children":[{}])", children.text());
  const geom::Quaternion q = geom::orientation(X_PM.a, world_.models.tilt_PM[row]);
  nodes_.add(R"({{"name":{},"translation":[{},{},{}],"rotation":[{},{},{},{}]{}}})", name, X_PM.x, X_PM.y,
             X_PM.z, q.x, q.y, q.z, q.w, rest);
  if (!world_.models.parent[row]) tops_.add("{}", row.index);
}

std::string Writer::scene() const {
  std::string name;
  wire::json_text(name, world_.scene().name.empty() ? "world" : world_.scene().name);
  const std::string children =
      tops_.size() == 0 ? "" : fmt::format(R"(,"children":[{}])", tops_.text());  // empty arrays are invalid
  return fmt::format(R"("scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}{}{{"name":{},)"
                     R"("rotation":[-0.7071067811865475,0,0,0.7071067811865476]{}}}])",
                     nodes_.size(), nodes_.text(), nodes_.size() > 0 ? "," : "", name, children);
}

Result<std::string> Writer::write() {
  for (const world::ModelRow row : world_.models.rows()) {
    add_node(row);
    if (glb_.bytes() + nodes_.text().size() > limits::kGlbBytes)
      return Error{"", fmt::format("would be more than {} MiB as glTF", limits::kGlbBytes >> 20)};
  }
  return glb_.file(scene());
}

}  // namespace

Result<std::string> glb_of(const world::World& world) {
  return Writer(world).write();
}

}  // namespace playhouse::app
