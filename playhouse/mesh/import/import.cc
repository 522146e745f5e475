#include "playhouse/mesh/import/import.h"

#include <assimp/BaseImporter.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/DefaultLogger.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/mesh/import/beside.h"
#include "playhouse/mesh/import/gltf_text.h"
#include "playhouse/mesh/import/import_look.h"
#include "playhouse/mesh/import/import_surfaces.h"
#include "playhouse/mesh/import/obj_text.h"
#include "playhouse/mesh/import/stl_bytes.h"
#include "playhouse/mesh/import/trimmed.h"

namespace playhouse::mesh {
namespace {

constexpr std::string_view kFolder = "/mesh/";  // the folder of the file as shown to Assimp

/// Strips a UTF-8 byte order mark, which Assimp
/// would take for a part of the first word.
std::string without_mark(std::string bytes, std::string_view name) {
  const std::string small = lower(name);
  if ((small.ends_with(".obj") || small.ends_with(".mtl")) && bytes.starts_with("\xEF\xBB\xBF"))
    bytes.erase(0, 3);
  return bytes;
}

/// Virtual file system for Assimp: the mesh and files beside it.
class Files final : public Assimp::IOSystem {
 public:
  Files(std::string path, std::string_view bytes, const ReadFile& read)
      : folder_(path.substr(0, path.rfind('/') + 1)), read_(read) {
    known_[path.substr(folder_.size())] = without_mark(std::string(bytes), path);
  }

  bool Exists(const char* name) const override { return find(name) != nullptr; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override {
    const std::string* bytes = mode[0] == 'r' ? find(name) : nullptr;
    if (bytes == nullptr) return nullptr;
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size());
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

  const std::string* find(std::string_view name) const {
    if (name.starts_with(kFolder)) name.remove_prefix(kFolder.size());
    for (const std::string& place : places_beside(name)) {
      const auto [entry, is_new] = known_.try_emplace(place);
      if (is_new)
        if (Result<std::string> bytes = read_(folder_ + place))
          entry->second = without_mark(std::move(*bytes), place);
      if (entry->second) return &*entry->second;
    }
    return nullptr;
  }

 private:
  std::string folder_;
  const ReadFile& read_;
  mutable std::map<std::string, std::optional<std::string>> known_;
};

/// Restricts Assimp's format detection to supported formats. The reader of glTF 1.0, which has the same file
/// endings as that of 2.0, is none of them: check_gltf_nodes() would not count what it makes.
void keep_formats(Assimp::Importer& importer) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    Assimp::BaseImporter* reader = importer.GetImporter(i);
    std::set<std::string> endings;
    reader->GetExtensionList(endings);
    const bool is_ours =
        reader->GetInfo()->mName != std::string_view("glTF Importer") &&
        std::ranges::any_of(endings, [](const std::string& ending) { return is_mesh_name("." + ending); });
    if (is_ours) continue;
    importer.UnregisterLoader(reader);
    delete reader;
  }
}

/// Strips the virtual path from Assimp's message.
std::string reason(std::string text) {
  if (text == "std::bad_alloc") return "it takes too much memory";
  if (const std::size_t at = text.find(kFolder); at != text.npos) text.erase(at, kFolder.size());
  return escaped(text.empty() ? "its format is unknown" : text);
}

Colors colors_of(std::string_view path) {
  if (is_collada(path)) return Colors::kCollada;
  return lower(path).ends_with(".obj") || is_stl(path) ? Colors::kObj : Colors::kGltf;
}

/// Captures warnings of Assimp's readers about dropped triangles during its lifetime.
class Listener final : public Assimp::LogStream {
 public:
  /// Sets `heard` on such a warning.
  static void begin(bool& heard) {
    Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(new Listener(heard), Assimp::Logger::Warn);  // takes ownership
  }
  static void end() { Assimp::DefaultLogger::kill(); }
  void write(const char* message) override {
    if (std::string_view(message).find("out-of-range indices") != std::string_view::npos) heard_ = true;
  }

 private:
  explicit Listener(bool& heard) : heard_(heard) {}
  bool& heard_;
};

/// Sets primitive types of meshes: OBJ faces may be lines or points, which the reader does
/// not mark; they are dropped later. Returns whether there are triangles or polygons.
bool mark_primitives(aiScene& scene) {
  bool has_triangles = false;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m)
    for (unsigned i = 0; i < scene.mMeshes[m]->mNumFaces; ++i) {
      const unsigned corners = scene.mMeshes[m]->mFaces[i].mNumIndices;
      if (corners > 0) scene.mMeshes[m]->mPrimitiveTypes |= AI_PRIMITIVE_TYPE_FOR_N_INDICES(corners);
      has_triangles = has_triangles || corners >= 3;
    }
  return has_triangles;
}

/// Loads the scene, owned by the importer: triangulated, with normals, which those of STL are replaced by.
Result<const aiScene*> scene_of(Assimp::Importer& importer, const std::string& name) {
  bool drops_triangles = false;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);  // none in place of missing triangles
  Listener::begin(drops_triangles);
  const aiScene* scene = importer.ReadFile(std::string(kFolder) + name, 0);
  Listener::end();
  if (scene == nullptr) return Error{{}, "cannot be read: " + reason(importer.GetErrorString())};
  if (drops_triangles) return Error{{}, "is broken: a triangle has a corner that is not there"};
  if (scene->mRootNode == nullptr || !mark_primitives(*const_cast<aiScene*>(scene)))
    return Error{{}, "has no triangles"};
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 40);  // degrees
  const unsigned renewed = is_stl(name) ? aiProcess_ForceGenNormals : 0u;
  scene = importer.ApplyPostProcessing(aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                                       aiProcess_SortByPType | aiProcess_GenSmoothNormals | renewed |
                                       aiProcess_JoinIdenticalVertices);
  if (scene == nullptr) return Error{{}, "cannot be read: " + reason(importer.GetErrorString())};
  return scene;
}

}  // namespace

bool is_collada(std::string_view path) {
  return lower(path).ends_with(".dae");
}

Result<MeshFile> import(const std::string& path, std::string_view bytes, const ReadFile& read) {
  std::string stl;
  if (is_stl(path)) {
    Result<std::string> plain = plain_stl(bytes);
    if (!plain) return plain.error();
    stl = std::move(*plain);
    bytes = stl;
  }
  Assimp::Importer importer;
  keep_formats(importer);
  auto* files = new Files(path, bytes, read);
  importer.SetIOHandler(files);  // takes ownership
  const std::string folder = path.substr(0, path.rfind('/') + 1), name = path.substr(folder.size());
  const Colors colors = colors_of(path);
  constexpr std::string_view kFirstGlb("glTF\x01\0\0\0", 8);
  if (bytes.starts_with(kFirstGlb)) return Error{{}, "cannot be read: it is glTF 1.0, and only 2.0 is read"};
  if (colors == Colors::kGltf)
    for (const auto check : {check_gltf_extensions, check_gltf_nodes})
      if (const Result<void> checked = check(bytes); !checked) return checked.error();
  const Result<const aiScene*> scene = scene_of(importer, name);
  if (!scene) return scene.error();

  MeshFile file;
  ObjText obj;
  if (colors == Colors::kObj)
    obj = look_at_obj(name, bytes, [files](std::string_view beside) { return files->find(beside); });
  for (const std::string& missing : obj.missing)
    file.warnings.push_back("material file " + in_quotes(missing) +
                            " is not beside the mesh; its materials are grey");
  const LookImport look(**scene, colors, std::move(obj.colored), bytes.size());
  look.add_materials(file.mesh);
  look.add_textures(file, folder, read);
  look.dim_emission(file, folder, read);
  const Result<Nodes> nodes = nodes_of(**scene, is_stl(path) ? Affine() : from_y_up());
  if (!nodes) return nodes.error();
  const Skins skins = colors == Colors::kGltf ? Skins::kJoints : Skins::kNodes;
  if (const Result<void> added = add_surfaces(**scene, *nodes, skins, file.mesh); !added)
    return added.error();
  look.add_lights(*nodes, file.mesh);
  return file;
}

}  // namespace playhouse::mesh
