#include "playhouse/scene/forms/mesh_bodies.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/mesh_limits.h"
#include "playhouse/geom/convex_hull.h"
#include "playhouse/mesh/check_mesh.h"
#include "playhouse/mesh/fit.h"
#include "playhouse/mesh/parts.h"
#include "playhouse/scene/forms/body.h"

namespace playhouse::scene {
namespace {

using geom::Vec2;

std::vector<Block> box_of(const mesh::Mesh& mesh) {
  const auto size = body_size({mesh.high.x - mesh.low.x, mesh.high.y - mesh.low.y, mesh.high.z - mesh.low.z});
  if (!size) return {};
  return {box_block(*size)};
}

std::size_t corners_of(const mesh::Mesh& mesh) {
  std::size_t corners = 0;
  for (const mesh::Surface& surface : mesh.surfaces) corners += surface.p.size();
  return corners;
}

/// Sizes are not negative: one that is stands for a mesh's own.
std::array<double, 13> key_of(const geom::Size* size, const mesh::Placement& at) {
  const geom::Size said = size ? *size : geom::Size{-1, -1, -1};
  return {said.x,
          said.y,
          said.z,
          at.p.x,
          at.p.y,
          at.p.z,
          at.turn.x,
          at.turn.y,
          at.turn.z,
          at.scale.x,
          at.scale.y,
          at.scale.z,
          at.is_fitted ? 1.0 : 0.0};
}

/// The mesh of a file, scaled, turned and moved; not fitted yet.
Result<mesh::Mesh> in_body(const mesh::Mesh& file, const mesh::Placement& at) {
  if (at == mesh::Placement{.is_fitted = at.is_fitted}) return file;
  mesh::Mesh mesh = mesh::placed(file, at);
  if (const Result<void> checked = mesh::check_mesh(mesh); !checked) return checked.error();
  return mesh;
}

}  // namespace

std::vector<Block> outlines_of(const mesh::Mesh& mesh) {
  std::vector<Block> blocks;
  for (const std::vector<geom::Vec3>& part : mesh::parts_of(mesh, limits::kMeshParts)) {
    std::vector<Vec2> points;
    for (const geom::Vec3& p : part) points.push_back({p.x, p.y});
    Block block{geom::convex_hull(std::move(points)), std::ranges::min(part, {}, &geom::Vec3::z).z,
                std::ranges::max(part, {}, &geom::Vec3::z).z};
    if (block.points.size() >= 3) blocks.push_back(std::move(block));
  }
  return blocks.empty() ? box_of(mesh) : blocks;
}

const MeshBodies::LoadedMesh* MeshBodies::find(const std::string& path) const {
  const auto found = entries_.find(path);
  return found == entries_.end() ? nullptr : &found->second;
}

const MeshBodies::LoadedMesh& MeshBodies::read(const std::string& path, const std::string& bytes,
                                               config::FileReader& files) {
  LoadedMesh& entry = entries_[path];
  entry.path = path;
  Result<mesh::MeshFile> file = mesh::read_mesh(path, [&](const std::string& wanted) {
    Result<std::string> read = wanted == path ? Result<std::string>(bytes) : files.read(wanted);
    if (read) entry.bytes += read->size();
    return read;
  });
  if (!file) {
    entry.why_none = file.error().text;
    return entry;
  }
  entry.mesh = std::make_shared<const mesh::Mesh>(std::move(file->mesh));
  entry.warnings = std::move(file->warnings);
  return entry;
}

const MeshBodies::MeshBody& MeshBodies::body(const LoadedMesh& entry, const geom::Size* size,
                                             const mesh::Placement& at) const {
  const auto [found, is_new] = entry.bodies.try_emplace(key_of(size, at));
  MeshBody& body = found->second;
  body.is_new = is_new;
  if (!is_new) return body;
  Result<mesh::Mesh> whole = in_body(*entry.mesh, at);
  if (!whole) {
    body.why_none = whole.error().text;
    return body;
  }
  const geom::Vec3 extent = whole->high - whole->low;
  body.size = size ? *size : geom::Size{extent.x, extent.y, extent.z};
  body.corners = corners_of(*whole);
  body.mesh = std::make_shared<const mesh::Mesh>(
      at.is_fitted ? mesh::fitted(std::move(*whole), {body.size.x, body.size.y, body.size.z})
                   : std::move(*whole));
  body.blocks = outlines_of(*body.mesh);
  return body;
}

}  // namespace playhouse::scene
