#include "playhouse/mesh/read_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <new>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/mesh_limits.h"
#include "playhouse/mesh/check_mesh.h"
#include "playhouse/mesh/import/collada_document.h"
#include "playhouse/mesh/import/collada_physics.h"
#include "playhouse/mesh/import/import.h"
#include "playhouse/mesh/import/trimmed.h"
#include "playhouse/mesh/own_process.h"
#include "playhouse/mesh/packed.h"

namespace playhouse::mesh {
namespace {

/// Messages between parent and child.
enum Message : char { kWants = 'w', kBytes = 'b', kNone = 'n', kMesh = 'm', kError = 'e' };

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}
std::string text_of(const Pipe::PipeMessage& message) {
  return {reinterpret_cast<const char*>(message.bytes.data()), message.bytes.size()};
}

Error error_of(const std::string& path, std::string text) {
  return {escaped(path), std::move(text)};
}

/// Requests a file from the parent.
Result<std::string> ask(Pipe& pipe, Allowance& allowance, const std::string& path) {
  if (!pipe.send(kWants, bytes_of(path))) ::abort();
  const std::optional<Pipe::PipeMessage> answer = pipe.receive(limits::kMeshFileBytes);
  if (!answer) ::abort();
  allowance.grow(answer->bytes.size());
  if (answer->kind == kBytes) return text_of(*answer);
  return Error{{}, text_of(*answer)};
}

void take_apart(Pipe& pipe, Allowance& allowance, const std::string& path) {
  const Result<MeshFile> file =
      read_mesh_here(path, [&](const std::string& wanted) { return ask(pipe, allowance, wanted); });
  if (file) {
    pipe.send(kMesh, packed(*file));
  } else {
    pipe.send(kError, bytes_of(file.error().text));
  }
}

/// Serves file requests until there is a result.
Result<MeshFile> serve(OwnProcess& process, const std::string& path, const ReadFile& read) {
  Pipe& pipe = *process.pipe();
  std::size_t given = 0;  // B
  while (const std::optional<Pipe::PipeMessage> message = pipe.receive(limits::kMeshMemoryBytes)) {
    if (message->kind == kError) return error_of(path, text_of(*message));
    if (message->kind == kMesh) {
      std::optional<MeshFile> file = unpacked(message->bytes);
      if (!file || !check_mesh(file->mesh)) break;
      return std::move(*file);
    }
    Result<std::string> bytes = read(text_of(*message));
    if (bytes && bytes->size() > limits::kMeshFileBytes) bytes = Error{{}, "cannot be read: it is too large"};
    given += bytes ? bytes->size() : 0;
    if (bytes ? !pipe.send(kBytes, bytes_of(*bytes)) : !pipe.send(kNone, bytes_of(bytes.error().text))) break;
  }
  return error_of(path, "cannot be read: it " + process.end(cost_of(given)));
}

/// Limits total bytes read.
class Budget {
 public:
  explicit Budget(const ReadFile& read) : read_(read) {}
  Result<std::string> operator()(const std::string& path) {
    Result<std::string> bytes = read_(path);
    if (bytes && bytes->size() > left_)
      return Error{{}, "cannot be read: it is too large with what it names"};
    if (bytes) left_ -= bytes->size();
    return bytes;
  }

 private:
  const ReadFile& read_;
  std::size_t left_ = limits::kMeshFileBytes;
};

Result<MeshFile> read_checked(const std::string& path, const ReadFile& read) {
  Result<std::string> bytes = read(path);
  if (!bytes) return bytes.error();
  std::optional<PhysicalProperties> physics;
  if (is_collada(path)) {
    Result<std::optional<PhysicalProperties>> said = collada_physics(*bytes);  // validates more than Assimp
    if (!said) return said.error();
    physics = std::move(*said);
    bytes = with_trimmed_colors(*bytes);
  }
  Result<MeshFile> file = import(path, *bytes, read);
  if (!file) return file;
  file->mesh.physics = std::move(physics);
  measure(file->mesh);
  if (const Result<void> checked = check_mesh(file->mesh); !checked) return checked.error();
  return file;
}

Result<std::string> read_disk(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{{}, std::string("cannot be opened: ") + std::strerror(errno)};
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) return Error{{}, "cannot be read"};
  return bytes;
}

}  // namespace

Result<MeshFile> read_mesh_here(const std::string& path, const ReadFile& read) {
  try {
    Result<MeshFile> file = read_checked(path, Budget(read));
    if (!file) return error_of(path, file.error().text);
    return file;
  } catch (const std::bad_alloc&) {
    return error_of(path, "cannot be read: it takes too much memory");
  } catch (const std::exception& fault) {
    return error_of(path, "cannot be read: " + escaped(fault.what()));
  }
}

Result<MeshFile> read_mesh(const std::string& path, const ReadFile& read) {
  if (!is_mesh_name(path))
    return error_of(path, "is not a mesh: its name ends in none of .dae, .gltf, .glb, .obj and .stl");
  OwnProcess process([&](Pipe& pipe, Allowance& allowance) { take_apart(pipe, allowance, path); });
  if (process.pipe() == nullptr) return error_of(path, "cannot be read: no process can be made for it");
  return serve(process, path, read);
}

Result<Mesh> read_mesh(const std::string& path) {
  Result<MeshFile> file = read_mesh(path, read_disk);
  if (!file) return file.error();
  return std::move(file->mesh);
}

bool is_mesh_name(std::string_view name) {
  const std::string ending = lower(name.substr(std::min(name.rfind('.'), name.size())));
  constexpr std::array<std::string_view, 5> kEndings{".dae", ".gltf", ".glb", ".obj", ".stl"};
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

}  // namespace playhouse::mesh
