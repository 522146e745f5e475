#include "playhouse/web_server/mesh_files.h"

#include <fmt/format.h>

#include "playhouse/base/hash.h"
#include "playhouse/mesh/glb_writer.h"
#include "playhouse/replicate/prototypes.h"

namespace playhouse::web_server {

MeshFiles::MeshFiles(std::span<const std::shared_ptr<const mesh::Mesh>> meshes) : meshes_(meshes) {
  for (std::size_t row = 0; row < meshes.size(); ++row) rows_["/" + replicate::mesh_address(row)] = row;
}

const MeshFiles::File* MeshFiles::find(std::string_view path) {
  const auto row = rows_.find(path);
  if (row == rows_.end()) return nullptr;
  const auto [entry, is_new] = made_.try_emplace(row->second);
  File& file = entry->second;
  if (!is_new) return &file;
  file.bytes = std::make_shared<const std::string>(mesh::write_glb(*meshes_[row->second]));
  Hash hash;
  for (const char c : *file.bytes) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  file.etag = fmt::format("\"{:016x}\"", hash.value());
  return &file;
}

}  // namespace playhouse::web_server
