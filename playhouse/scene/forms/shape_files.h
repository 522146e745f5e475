#pragma once

/// ShapeFiles: the bitmaps and meshes that the models of a world name: found like
/// includes, read once, within the limits of a world. Problems go to the LoadState.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/config/text/file_search.h"
#include "playhouse/scene/budget.h"
#include "playhouse/scene/forms/mesh_bodies.h"
#include "playhouse/scene/images/bitmap.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {

class ShapeFiles {
 public:
  using Loops = std::vector<std::vector<geom::Vec2>>;
  /// Its path and contours, in pixels; none if it could not be read.
  using TracedBitmap = std::map<std::string, Loops>::value_type;

  /// References must outlive this.
  ShapeFiles(LoadState& state, config::FileReader& files, const WorldLimits& limits)
      : state_(state),
        files_(files),
        limits_(limits),
        mesh_bytes_(limits.mesh_bytes, "bytes of mesh files"),
        mesh_copies_(limits.mesh_copies, "corners of meshes, one for each size"),
        bitmap_bytes_(limits.bitmap_bytes, "bytes of bitmap files"),
        pixels_(limits.pixels, "pixels of bitmaps"),
        outlines_(limits.corners, "corners of bitmaps") {}

  /// The bitmap of a model of this size; null if it has none, or the load is aborted.
  const TracedBitmap* bitmap(const Properties& properties, const geom::Size& size);
  /// A mesh with its path; null, with an error, if it cannot be found.
  const MeshBodies::LoadedMesh* mesh(const std::string& name, config::SourceLine where,
                                     const std::string& word = "mesh");
  /// A readable mesh as a body (MeshBodies::body()); null, with an error, if its placement is not possible.
  const MeshBodies::MeshBody* mesh_body(const MeshBodies::LoadedMesh& entry, const geom::Size* size,
                                        const mesh::Placement& at, config::SourceLine where);

 private:
  /// Warns if the file is not where the original would look.
  Result<config::FoundFile> look_for(std::string_view what, const std::string& name, config::SourceLine where,
                                     const std::function<bool(const std::string&)>& is_known,
                                     const std::function<bool(std::string_view)>& fits);
  /// The folders to search for a file named at `where`.
  std::vector<std::string> folders(config::SourceLine where) const;
  const TracedBitmap* trace(const std::string& path, std::string_view bytes, const geom::Size& size,
                            config::SourceLine where);
  void warn_of_margin(const std::string& path, const Bitmap& bitmap, const Loops& loops,
                      const geom::Size& size, config::SourceLine where);
  /// `path` was tried last; the error names `why.where`.
  const TracedBitmap* fail_bitmap(const std::string& path, config::SourceLine where, const Error& why);

  LoadState& state_;
  config::FileReader& files_;
  const WorldLimits& limits_;
  std::map<std::string, Loops> bitmaps_;
  MeshBodies meshes_;
  Budget mesh_bytes_, mesh_copies_;
  Budget bitmap_bytes_, pixels_, outlines_;  // of distinct bitmaps, regardless of uses
};

}  // namespace playhouse::scene
