#include "playhouse/mesh/import.h"

#include <assimp/BaseImporter.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/mesh/beside.h"
#include "playhouse/mesh/import_look.h"
#include "playhouse/mesh/import_surfaces.h"

namespace playhouse::mesh {
namespace {

constexpr std::string_view kFolder = "/mesh/";  // what Assimp believes the file's folder to be

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

/// The files that Assimp may open: the mesh and those beside it.
class Files final : public Assimp::IOSystem {
 public:
  Files(std::string path, std::string_view bytes, const ReadFile& read)
      : folder_(path.substr(0, path.rfind('/') + 1)), read_(read) {
    known_[path.substr(folder_.size())] = std::string(bytes);
  }

  bool Exists(const char* name) const override { return find(name) != nullptr; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override {
    const std::string* bytes = mode[0] == 'r' ? find(name) : nullptr;
    if (bytes == nullptr) return nullptr;
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size());
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  const std::string* find(std::string_view name) const {
    if (name.starts_with(kFolder)) name.remove_prefix(kFolder.size());
    for (const std::string& place : places_beside(name)) {
      const auto [entry, is_new] = known_.try_emplace(place);
      if (is_new)
        if (Result<std::string> bytes = read_(folder_ + place)) entry->second = std::move(*bytes);
      if (entry->second) return &*entry->second;
    }
    return nullptr;
  }

  std::string folder_;
  const ReadFile& read_;
  mutable std::map<std::string, std::optional<std::string>> known_;
};

/// Assimp guesses what a file is where its name lies: it may guess among these only.
void keep_formats(Assimp::Importer& importer) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    Assimp::BaseImporter* reader = importer.GetImporter(i);
    std::set<std::string> endings;
    reader->GetExtensionList(endings);
    const bool is_ours =
        std::ranges::any_of(endings, [](const std::string& ending) { return is_mesh_name("." + ending); });
    if (is_ours) continue;
    importer.UnregisterLoader(reader);
    delete reader;
  }
}

/// Without the name that Assimp knows the file by.
std::string reason(std::string text) {
  if (const std::size_t at = text.find(kFolder); at != text.npos) text.erase(at, kFolder.size());
  return escaped(text.empty() ? "it is of no kind that is known" : text);
}

}  // namespace

bool is_collada(std::string_view path) {
  return lower(path).ends_with(".dae");
}

Result<MeshFile> import(const std::string& path, std::string_view bytes, const ReadFile& read) {
  Assimp::Importer importer;
  keep_formats(importer);
  importer.SetIOHandler(new Files(path, bytes, read));  // which owns it
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 40);  // degrees
  const std::string name = std::string(kFolder) + path.substr(path.rfind('/') + 1);
  // The names of formats are known by their endings in small letters.
  const aiScene* scene = importer.ReadFile(name, aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                                                     aiProcess_SortByPType | aiProcess_GenSmoothNormals |
                                                     aiProcess_JoinIdenticalVertices);
  if (scene == nullptr) return Error{{}, "cannot be read: " + reason(importer.GetErrorString())};
  if (scene->mRootNode == nullptr || scene->mNumMeshes == 0) return Error{{}, "has no triangles"};

  MeshFile file;
  const Look look(*scene, is_collada(path)                ? Colors::kCollada
                          : lower(path).ends_with(".obj") ? Colors::kObj
                                                          : Colors::kGltf);
  look.add_materials(file.mesh);
  look.add_textures(file, path.substr(0, path.rfind('/') + 1), read);
  const Result<Nodes> nodes = nodes_of(*scene);
  if (!nodes) return nodes.error();
  if (const Result<void> added = add_surfaces(*scene, *nodes, file.mesh); !added) return added.error();
  look.add_lights(*nodes, file.mesh);
  return file;
}

}  // namespace playhouse::mesh
