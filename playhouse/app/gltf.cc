#include "playhouse/app/gltf.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "playhouse/app/prisms.h"
#include "playhouse/base/limits.h"
#include "playhouse/wire/json.h"

namespace playhouse::app {
namespace {

using geom::Vec2;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

/// Numbers of the glTF 2.0 specification.
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kFloat = 5126, kUnsignedInt = 5125, kVertices = 34962, kIndices = 34963;

struct Vec3 {
  float x, y, z;
};

/// Triangles, counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vec3> points, normals;
  std::vector<std::uint32_t> corners;

  void add_quad(const std::array<Vec3, 4>& quad, Vec3 normal) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), quad.begin(), quad.end());
    normals.insert(normals.end(), 4, normal);
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) corners.push_back(first + k);
  }
};

Vec3 at(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

void add_side(Mesh& mesh, Vec2 a, Vec2 b, const Prism& prism) {
  const double length = std::sqrt(geom::dot(b - a, b - a));
  if (length == 0) return;
  mesh.add_quad({at(a.x, a.y, prism.z_min), at(b.x, b.y, prism.z_min), at(b.x, b.y, prism.z_max),
                 at(a.x, a.y, prism.z_max)},
                at((b.y - a.y) / length, (a.x - b.x) / length, 0));
}

Mesh mesh_of(const scene::ModelDesc& desc) {
  Mesh mesh;
  for (const Prism& prism : prisms_of(desc)) {
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

/// From what screens show to what light does (IEC 61966-2-1).
double linear(float channel) {
  return channel <= 0.04045f ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

/// Joins the elements of a JSON array.
class List {
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

class Writer {
 public:
  explicit Writer(const world::World& world) : world_(world) {}

  Result<std::string> write();

 private:
  /// What of a mesh does not depend on its color; none where a description has no body.
  struct Accessors {
    std::size_t points = 0, normals = 0, corners = 0;
    bool any = false;
  };

  void add_node(std::uint32_t row);
  const Accessors& accessors_of(std::uint32_t desc);
  std::size_t mesh_of_model(std::uint32_t row, const Accessors& accessors);
  std::size_t material_of(const scene::Color& color);
  template <typename Element>
  std::size_t add_view(const std::vector<Element>& elements, int target);
  std::string json() const;

  const world::World& world_;
  std::string binary_;
  List nodes_, meshes_, materials_, accessors_, views_, tops_;
  std::map<std::uint32_t, Accessors> by_desc_;
  std::map<std::pair<std::uint32_t, std::size_t>, std::size_t> mesh_by_look_;  // by description and material
  std::map<std::array<float, 4>, std::size_t> material_by_color_;
};

template <typename Element>
std::size_t Writer::add_view(const std::vector<Element>& elements, int target) {
  const std::size_t bytes = elements.size() * sizeof(Element), offset = binary_.size();
  binary_.append(reinterpret_cast<const char*>(elements.data()), bytes);
  return views_.add(R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":{}}})", offset, bytes, target);
}

const Writer::Accessors& Writer::accessors_of(std::uint32_t desc) {
  const auto [entry, is_new] = by_desc_.try_emplace(desc);
  Accessors& made = entry->second;
  if (!is_new) return made;
  const Mesh mesh = mesh_of(world_.scene().models[desc]);
  if (mesh.points.empty()) return made;
  constexpr float kFar = std::numeric_limits<float>::max();
  Vec3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  for (const Vec3& p : mesh.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  made.any = true;
  made.points = accessors_.add(
      R"({{"bufferView":{},"componentType":{},"count":{},"type":"VEC3","min":[{},{},{}],"max":[{},{},{}]}})",
      add_view(mesh.points, kVertices), kFloat, mesh.points.size(), low.x, low.y, low.z, high.x, high.y,
      high.z);
  made.normals = accessors_.add(R"({{"bufferView":{},"componentType":{},"count":{},"type":"VEC3"}})",
                                add_view(mesh.normals, kVertices), kFloat, mesh.normals.size());
  made.corners = accessors_.add(R"({{"bufferView":{},"componentType":{},"count":{},"type":"SCALAR"}})",
                                add_view(mesh.corners, kIndices), kUnsignedInt, mesh.corners.size());
  return made;
}

std::size_t Writer::material_of(const scene::Color& color) {
  const auto [entry, is_new] =
      material_by_color_.try_emplace({color.r, color.g, color.b, color.a}, materials_.size());
  if (is_new)
    materials_.add(
        R"({{"pbrMetallicRoughness":{{"baseColorFactor":[{:.6g},{:.6g},{:.6g},{:.6g}],"metallicFactor":0,"roughnessFactor":0.8}}{}}})",
        linear(color.r), linear(color.g), linear(color.b), color.a,
        color.a < 1 ? R"(,"alphaMode":"BLEND")" : "");
  return entry->second;
}

std::size_t Writer::mesh_of_model(std::uint32_t row, const Accessors& accessors) {
  const std::size_t material = material_of(world_.models.color[row]);
  const auto [entry, is_new] = mesh_by_look_.try_emplace({world_.models.desc[row], material}, meshes_.size());
  if (is_new)
    meshes_.add(
        R"({{"primitives":[{{"attributes":{{"POSITION":{},"NORMAL":{}}},"indices":{},"material":{}}}]}})",
        accessors.points, accessors.normals, accessors.corners, material);
  return entry->second;
}

/// Nodes have the numbers of the models' rows.
void Writer::add_node(std::uint32_t row) {
  const geom::Pose& X_PM = world_.models.X_PM[row];
  std::string name, rest;
  wire::json_text(name, world_.name({row}));
  const Accessors& accessors = accessors_of(world_.models.desc[row]);
  if (accessors.any) rest = fmt::format(R"(,"mesh":{})", mesh_of_model(row, accessors));
  List children;
  for (const std::uint32_t child : world_.children({row})) children.add("{}", child);
  if (children.size() > 0) rest += fmt::format(R"(,"children":[{}])", children.text());
  const geom::SinCos half = geom::sincos(X_PM.a / 2);
  nodes_.add(R"({{"name":{},"translation":[{},{},{}],"rotation":[0,0,{},{}]{}}})", name, X_PM.x, X_PM.y,
             X_PM.z, half.sin, half.cos, rest);
  if (world_.models.parent[row] == world::ModelRow::kNone) tops_.add("{}", row);
}

std::string Writer::json() const {
  std::string name;
  wire::json_text(name, world_.scene().name.empty() ? "world" : world_.scene().name);
  const auto array = [](std::string_view key, const List& list) {  // none may be empty
    return list.size() == 0 ? "" : fmt::format(R"(,"{}":[{}])", key, list.text());
  };
  const std::string buffer =
      binary_.empty() ? "" : fmt::format(R"(,"buffers":[{{"byteLength":{}}}])", binary_.size());
  return fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"playhouse"}},"scene":0,"scenes":[{{"nodes":[{}]}}])"
      R"(,"nodes":[{}{}{{"name":{},"rotation":[-0.7071067811865475,0,0,0.7071067811865476]{}}}]{}{}{}{}{}}})",
      nodes_.size(), nodes_.text(), nodes_.size() > 0 ? "," : "", name, array("children", tops_),
      array("meshes", meshes_), array("materials", materials_), array("accessors", accessors_),
      array("bufferViews", views_), buffer);
}

void append(std::string& out, std::uint32_t number) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  out.append(bytes, sizeof number);
}

/// A chunk ends at a multiple of four bytes.
void append_chunk(std::string& out, std::uint32_t type, std::string chunk, char fill) {
  chunk.resize((chunk.size() + 3) / 4 * 4, fill);
  append(out, static_cast<std::uint32_t>(chunk.size()));
  append(out, type);
  out += chunk;
}

Result<std::string> Writer::write() {
  for (std::uint32_t row = 0; row < world_.models.size(); ++row) {
    add_node(row);
    if (binary_.size() + nodes_.text().size() > limits::kGlbBytes)
      return Error{"", fmt::format("would be more than {} MiB as glTF", limits::kGlbBytes >> 20)};
  }
  std::string chunks;
  append_chunk(chunks, kJsonChunk, json(), ' ');
  if (!binary_.empty()) append_chunk(chunks, kBinaryChunk, std::move(binary_), '\0');
  constexpr std::uint32_t kHeader = 12;
  std::string file;
  for (const std::uint32_t number : {kMagic, kVersion, kHeader + static_cast<std::uint32_t>(chunks.size())})
    append(file, number);
  return file + chunks;
}

}  // namespace

Result<std::string> glb_of(const world::World& world) {
  return Writer(world).write();
}

}  // namespace playhouse::app
