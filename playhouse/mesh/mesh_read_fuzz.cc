/// Any bytes as what is read of meshes in this process, by the first of them: 'c' COLLADA's physics, 'i' an
/// image, 'p' a packed mesh; and, in a process of its own, 'd' a COLLADA file, 'g' a glTF, 'b' a binary one,
/// 'o' an OBJ and 's' an STL. Each gives what keeps to limits.h, or an error in one line.

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/mesh_limits.h"
#include "playhouse/mesh/check_mesh.h"
#include "playhouse/mesh/fit.h"
#include "playhouse/mesh/image_file.h"
#include "playhouse/mesh/import/collada_physics.h"
#include "playhouse/mesh/packed.h"
#include "playhouse/mesh/parts.h"

namespace playhouse::mesh {
namespace {

constexpr std::size_t kPixels = 1 << 16;

void expect_one_line(const Error& error) {
  PLAYHOUSE_ASSERT(!error.text.empty() && error.line().find('\n') == std::string::npos);
}

void read_physics(const std::string& bytes) {
  const Result<std::optional<PhysicalProperties>> physics = collada_physics(bytes);
  if (!physics) return expect_one_line(physics.error());
  PLAYHOUSE_ASSERT(!*physics || (*physics)->shapes.size() <= limits::kMeshShapes);
}

void read_image(const std::string& bytes) {
  const Result<Image> image = decode_image(bytes, kPixels);
  if (!image) return PLAYHOUSE_ASSERT(!image.error().text.empty());
  PLAYHOUSE_ASSERT(image->rgba.size() == std::size_t{4} * image->width * image->height);
  PLAYHOUSE_ASSERT(image->rgba.size() <= 4 * kPixels);
  const Result<Image> again = decode_image(png_of(*image), kPixels);
  PLAYHOUSE_ASSERT(again && again->rgba == image->rgba);
}

void read_packed(const std::string& bytes) {
  const std::optional<MeshFile> file = unpacked(std::as_bytes(std::span(bytes)));
  if (!file) return;
  if (const Result<void> checked = check_mesh(file->mesh); !checked) return expect_one_line(checked.error());
  PLAYHOUSE_ASSERT(!parts_of(file->mesh, 8).empty());
  Mesh mesh = file->mesh;
  measure(mesh);
  mesh = placed(std::move(mesh), {{1, 2, 3}, {1, 2, 3}, {-1, 2, 3}, true});
  const Mesh fit = fitted(std::move(mesh), {1, 1, 1});
  PLAYHOUSE_ASSERT(std::fabs(fit.low.z) < 1e-3);
}

void read_file(const std::string& name, const std::string& bytes) {
  const Result<MeshFile> file = read_mesh(name, [&](const std::string& path) -> Result<std::string> {
    if (path == name) return bytes;
    return Error{{}, "cannot be opened: no such file"};
  });
  if (!file) return expect_one_line(file.error());
  PLAYHOUSE_ASSERT(check_mesh(file->mesh));
}

}  // namespace
}  // namespace playhouse::mesh

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace playhouse::mesh;
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0]) {
    case 'c':
      read_physics(bytes);
      break;
    case 'i':
      read_image(bytes);
      break;
    case 'p':
      read_packed(bytes);
      break;
    case 'd':
      read_file("a.dae", bytes);
      break;
    case 'g':
      read_file("a.gltf", bytes);
      break;
    case 'b':
      read_file("a.glb", bytes);
      break;
    case 'o':
      read_file("a.obj", bytes);
      break;
    case 's':
      read_file("a.stl", bytes);
      break;
    default:
      break;
  }
  return 0;
}
