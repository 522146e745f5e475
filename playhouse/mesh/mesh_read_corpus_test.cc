/// Makes the corpus of mesh_read_fuzz where it is asked to, and reads all of it as the fuzzer does.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "playhouse/mesh/packed.h"
#include "playhouse/mesh/testing_meshes.h"

namespace playhouse::mesh {
namespace {

std::map<std::string, std::string> corpus() {
  TestCollada physics;
  physics.libraries =
      "<library_physics_models><physics_model id=\"p\"><rigid_body sid=\"b\"><technique_common><mass>2</mass>"
      "<shape><box><half_extents>1 1 1</half_extents></box></shape><shape><capsule><height>1</height>"
      "<radius>.2 .2</radius></capsule></shape><shape><instance_geometry url=\"#box\"/></shape>"
      "</technique_common></rigid_body></physics_model></library_physics_models><library_physics_scenes>"
      "<physics_scene id=\"s\"><instance_physics_model url=\"#p\"><instance_rigid_body body=\"b\" "
      "target=\"#n\"/></instance_physics_model></physics_scene></library_physics_scenes>";
  const Result<MeshFile> file = read_mesh("a.dae", test_files({{"a.dae", test_collada(physics)}}));
  std::string bytes = "p";
  if (file)
    for (const std::byte byte : packed(*file)) bytes += static_cast<char>(byte);
  std::string buffer = "data:application/octet-stream;base64,";
  const std::string raw = test_gltf_buffer();
  append_base64(buffer, {reinterpret_cast<const std::uint8_t*>(raw.data()), raw.size()});
  return {{"collada", "d" + test_collada()},
          {"physics", "c" + test_collada(physics)},
          {"gltf", "g" + test_gltf(buffer)},
          {"obj", "o" + test_obj()},
          {"packed", bytes},
          {"stl", "s" + test_binary_stl()},
          {"stl_text", "s" + test_stl()}};
}

TEST(MeshReadCorpus, is_checked_in_as_it_is_made) {
  const std::filesystem::path folder = std::string(PLAYHOUSE_SOURCE_DIR) + "/tests/fuzz/mesh_read";
  for (const auto& [name, bytes] : corpus()) {
    if (std::getenv("PLAYHOUSE_MAKE_CORPUS") != nullptr) {
      std::filesystem::create_directories(folder);
      std::ofstream(folder / name, std::ios::binary) << bytes;
    }
    std::ifstream kept(folder / name, std::ios::binary);
    const std::string as_kept{std::istreambuf_iterator<char>(kept), {}};
    // The order of corners is that of the installed Assimp.
    if (name == "packed") {
      EXPECT_TRUE(unpacked(std::as_bytes(std::span(as_kept)).subspan(1)));
    } else {
      EXPECT_EQ(as_kept, bytes) << name;
    }
  }
}

TEST(Packed, comes_back_as_it_was) {
  const Result<MeshFile> file =
      read_mesh("box.gltf", test_files({{"box.gltf", test_gltf()}, {"box.bin", test_gltf_buffer()}}));
  ASSERT_TRUE(file) << file.error().line();
  const std::vector<std::byte> bytes = packed(*file);
  const auto again = unpacked(bytes);
  ASSERT_TRUE(again);
  EXPECT_EQ(packed(*again), bytes);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(unpacked(std::span(bytes).first(size))) << size;
}

}  // namespace
}  // namespace playhouse::mesh
