#include "playhouse/scene/forms/shape_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/mesh/read_mesh.h"

namespace playhouse::scene {

const ShapeFiles::TracedBitmap* ShapeFiles::bitmap(const Properties& properties, const geom::Size& size) {
  const std::string name = properties.text("bitmap", "");
  const config::SourceLine where = properties.where("bitmap");
  if (name.empty() && properties.has("bitmap"))
    state_.warnings.add(config::Warning::kNoEffect, where, "\"bitmap\" names no file and has no effect");
  if (name.empty() || state_.over) return nullptr;
  const Result<config::FoundFile> found = look_for(
      "bitmap", name, where, [&](const std::string& path) { return bitmaps_.contains(path); }, is_image_name);
  if (!found) return fail_bitmap(config::resolve(folders(where).back(), name), where, found.error());
  if (!found->bytes) return &*bitmaps_.find(found->path);
  return trace(found->path, *found->bytes, size, where);
}

std::vector<std::string> ShapeFiles::folders(config::SourceLine where) const {
  const std::vector<std::string>& names = state_.document.sources.file_names();
  return config::folders_for(names.front(), names[where.file], files_);
}

const MeshBodies::LoadedMesh* ShapeFiles::mesh(const std::string& name, config::SourceLine where,
                                               const std::string& word) {
  const Result<config::FoundFile> found = look_for(
      word, name, where, [&](const std::string& path) { return meshes_.find(path) != nullptr; },
      mesh::is_mesh_name);
  if (!found) {
    state_.fail(where, word + " " + in_quotes(found.error().where) + " " + found.error().text);
    return nullptr;
  }
  if (!found->bytes) return meshes_.find(found->path);
  const MeshBodies::LoadedMesh& entry = meshes_.read(found->path, *found->bytes, files_);
  mesh_bytes_.spend(entry.bytes, where, state_);
  if (!entry.mesh) state_.fail(where, word + " " + in_quotes(found->path) + " " + entry.why_none);
  for (const std::string& warning : entry.warnings)
    state_.warnings.add(config::Warning::kShape, where, word + " " + in_quotes(found->path) + ": " + warning);
  return &entry;
}

const MeshBodies::MeshBody* ShapeFiles::mesh_body(const MeshBodies::LoadedMesh& entry, const geom::Size* size,
                                                  const mesh::Placement& at, config::SourceLine where) {
  const MeshBodies::MeshBody& body = meshes_.body(entry, size, at);
  if (body.is_new) mesh_copies_.spend(body.corners, where, state_);
  if (body.mesh) return &body;
  state_.fail(where,
              "mesh " + in_quotes(entry.path) + ", with its mesh_scale and mesh_pose, " + body.why_none);
  return nullptr;
}

Result<config::FoundFile> ShapeFiles::look_for(std::string_view what, const std::string& name,
                                               config::SourceLine where,
                                               const std::function<bool(const std::string&)>& is_known,
                                               const std::function<bool(std::string_view)>& fits) {
  // Unlike the original, which looks only beside the world, bitmaps are searched like includes.
  const std::string& named_by = state_.document.sources.file_names()[where.file];
  const std::vector<std::string> searched = folders(where);
  Result<config::FoundFile> found = config::find_file(searched, name, files_, is_known, fits);
  if (found && found->bytes && found->folder > 0 && searched[found->folder] != config::folder_of(named_by))
    state_.warnings.add(config::Warning::kShape, where,
                        std::string(what) + " " + in_quotes(config::resolve(searched.front(), name)) +
                            " is not there, so " + in_quotes(found->path) + " is read");
  return found;
}

const ShapeFiles::TracedBitmap* ShapeFiles::trace(const std::string& path, std::string_view bytes,
                                                  const geom::Size& size, config::SourceLine where) {
  bitmap_bytes_.spend(bytes.size(), where, state_);
  if (state_.over) return nullptr;
  const Result<Bitmap> bitmap = decode_bitmap(bytes, limits_.pixels);
  if (!bitmap) return fail_bitmap(path, where, {path, bitmap.error().text});
  pixels_.spend(bitmap->solid.size(), where, state_);
  if (state_.over) return nullptr;
  Result<Loops> loops = trace_contours(*bitmap, limits_.corners);
  if (!loops) return fail_bitmap(path, where, {path, loops.error().text});
  for (const auto& loop : *loops) outlines_.spend(loop.size(), where, state_);
  if (state_.over) return nullptr;
  if (loops->empty())
    state_.warnings.add(config::Warning::kShape, where,
                        "bitmap " + in_quotes(path) + " has no dark pixel, so it has no body");
  else
    warn_of_margin(path, *bitmap, *loops, size, where);
  return &*bitmaps_.emplace(path, std::move(*loops)).first;
}

/// Warns of a margin: dark pixels alone fill the model's size, so a size
/// measured with a margin gives shifted walls and usually non-square pixels.
void ShapeFiles::warn_of_margin(const std::string& path, const Bitmap& bitmap, const Loops& loops,
                                const geom::Size& size, config::SourceLine where) {
  constexpr double kMost = 1, kSquare = 1e-3;  // px of tolerance for drawings; relative
  geom::Box dark;
  for (const auto& loop : loops)
    for (const geom::Vec2 p : loop) dark.add(p);
  const double width = dark.x_max - dark.x_min, height = dark.y_max - dark.y_min;
  const double margin =
      std::max({dark.x_min, bitmap.width - dark.x_max, dark.y_min, bitmap.height - dark.y_max});
  const double x = size.x / width, y = size.y / height;  // m, of a pixel
  if (margin <= kMost || std::fabs(x - y) <= kSquare * std::max(x, y)) return;
  state_.warnings.add(
      config::Warning::kShape, where,
      fmt::format("bitmap {} has a margin: the size is that of its {} x {} dark pixels, not of all "
                  "{} x {}, so a pixel is {:.4g} x {:.4g} m",
                  in_quotes(path), width, height, bitmap.width, bitmap.height, x, y));
}

const ShapeFiles::TracedBitmap* ShapeFiles::fail_bitmap(const std::string& path, config::SourceLine where,
                                                        const Error& why) {
  state_.fail(where, "bitmap " + in_quotes(why.where) + " " + why.text);
  return &*bitmaps_.emplace(path, Loops{}).first;  // not retried for further models
}

}  // namespace playhouse::scene
