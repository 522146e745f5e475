#pragma once

/// Stage world files (.world, .inc) -> SceneDesc. Format: docs/worldfile.md.

#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/mesh_limits.h"
#include "playhouse/base/result.h"
#include "playhouse/config/text/source_text.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// Loads a world file. If `path` cannot be opened, its base name is searched in the
/// folders of the environment variable STAGEPATH. Fails with one error, "file:line:
/// what (did you mean "x"?)"; minor problems are warnings. `others`, if given, gets
/// further errors, up to limits::kWarningsOfAKind in total; `sources` gets the files.
Result<SceneDesc> load_world(const std::string& path, config::NamedBy by = config::NamedBy::kPerson,
                             std::vector<Error>* others = nullptr, config::SourceFiles* sources = nullptr);

/// Limits on the size of a world; fuzzers use smaller ones than limits.h.
struct WorldLimits {
  std::size_t models = limits::kSceneModels;
  std::size_t descriptions = limits::kEntities;  // of distinct models
  std::size_t fields = limits::kExpandedFields;
  std::size_t pixels = limits::kBitmapPixels;
  std::size_t bitmap_bytes = limits::kBitmapBytes;
  std::size_t mesh_bytes = limits::kMeshBytes;
  std::size_t mesh_copies = limits::kMeshCopies;  // corners of meshes, for each size
  std::size_t corners = limits::kCorners;
  std::size_t beams = limits::kBeams;
  std::size_t sensors = limits::kSensors;
  std::size_t text_bytes = limits::kTextBytes;  // names and texts of models
};

/// The same for a text read from `path`; includes and bitmaps are read from `files`.
Result<SceneDesc> load_world_text(std::string text, const std::string& path, config::FileReader& files,
                                  const WorldLimits& limits = {}, std::vector<Error>* others = nullptr);

}  // namespace playhouse::scene
