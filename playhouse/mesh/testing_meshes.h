#pragma once

/// Mesh files for tests: a box with half extents 1 x 0.5 x 0.25 (x, y, z of F) in each format.

#include <fmt/format.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "playhouse/base/base64.h"
#include "playhouse/mesh/read_mesh.h"

namespace playhouse::mesh {

inline constexpr double kTestHalf[3] = {1, 0.5, 0.25};

/// Faces of a box by corners, counter-clockwise from outside; corner k has bit 0 for x, 1 for y, 2 for z.
inline constexpr int kTestQuads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

/// Corner coordinates "x y z x y z ...", times `scale`, optionally y-up.
inline std::string test_corners(double scale, bool y_up, const char* between = " ") {
  std::string text;
  for (int k = 0; k < 8; ++k) {
    double p[3];
    for (int i = 0; i < 3; ++i) p[i] = scale * ((k >> i & 1) != 0 ? kTestHalf[i] : -kTestHalf[i]);
    text += fmt::format("{}{}{}{}{}{}", k > 0 ? between : "", p[0], between, y_up ? p[2] : p[1], between,
                        y_up ? -p[1] : p[2]);
  }
  return text;
}

inline std::string test_triangles(const char* between = " ") {
  std::string text;
  for (const auto& quad : kTestQuads)
    for (const int k : {0, 1, 2, 0, 2, 3}) text += (text.empty() ? "" : between) + std::to_string(quad[k]);
  return text;
}

/// Variations of the COLLADA test file.
struct TestCollada {
  std::string up = "Z_UP";
  double meter = 1;       // the box keeps its size in metres
  std::string transform;  // of the node
  std::string node;       // inside the node, beside the geometry
  std::string shading = "lambert";
  std::string effect = "<diffuse><color>0.5 0 1 1</color></diffuse>";
  std::string libraries;  // further ones
  std::string scene;      // further elements
  std::string triangles = test_triangles();
};

inline std::string test_collada(const TestCollada& of = {}) {
  return fmt::format(R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><created>2026-01-01T00:00:00</created><modified>2026-01-01T00:00:00</modified><unit name="u" meter="{}"/><up_axis>{}</up_axis></asset>
<library_effects><effect id="fx"><profile_COMMON><technique sid="t"><{}>{}</{}></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="mat" name="mat"><instance_effect url="#fx"/></material></library_materials>
<library_geometries><geometry id="box"><mesh>
<source id="pos"><float_array id="pos-a" count="24">{}</float_array><technique_common><accessor source="#pos-a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="ver"><input semantic="POSITION" source="#pos"/></vertices>
<triangles material="m" count="12"><input semantic="VERTEX" source="#ver" offset="0"/><p>{}</p></triangles>
</mesh></geometry></library_geometries>
{}
<library_visual_scenes><visual_scene id="vs"><node id="n" name="n">{}<instance_geometry url="#box"><bind_material><technique_common><instance_material symbol="m" target="#mat"/></technique_common></bind_material></instance_geometry>{}</node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#vs"/>{}</scene>
</COLLADA>
)",
                     of.meter, of.up, of.shading, of.effect, of.shading,
                     test_corners(1 / of.meter, of.up == "Y_UP"), of.triangles, of.libraries, of.transform,
                     of.node, of.scene);
}

inline std::string test_obj(const std::string& more = {}) {
  std::string text = more;
  for (int k = 0; k < 8; ++k) {
    double p[3];
    for (int i = 0; i < 3; ++i) p[i] = (k >> i & 1) != 0 ? kTestHalf[i] : -kTestHalf[i];
    text += fmt::format("v {} {} {}\n", p[0], p[2], -p[1]);
  }
  for (const auto& quad : kTestQuads)
    text += fmt::format("f {} {} {} {}\n", quad[0] + 1, quad[1] + 1, quad[2] + 1, quad[3] + 1);
  return text;
}

/// The corners of each triangle of the box, z up.
inline std::vector<std::array<std::array<float, 3>, 3>> test_stl_triangles() {
  std::vector<std::array<std::array<float, 3>, 3>> triangles;
  for (const auto& quad : kTestQuads)
    for (const auto& three : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      auto& triangle = triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i)
          triangle[k][i] = static_cast<float>((quad[three[k]] >> i & 1) != 0 ? kTestHalf[i] : -kTestHalf[i]);
    }
  return triangles;
}

/// ASCII, with normals of zero.
inline std::string test_stl() {
  std::string text = "solid a box\n";
  for (const auto& triangle : test_stl_triangles()) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const auto& p : triangle) text += fmt::format("vertex {} {} {}\n", p[0], p[1], p[2]);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid a box\n";
}

/// `header` is padded to 80 bytes; `colors` are two bytes after each triangle.
inline std::string test_binary_stl(std::string header = "", std::uint16_t colors = 0) {
  header.resize(80, ' ');
  const auto triangles = test_stl_triangles();
  const auto count = static_cast<std::uint32_t>(triangles.size());
  header.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const auto& triangle : triangles) {
    header.append(12, '\0');
    header.append(reinterpret_cast<const char*>(triangle.data()), sizeof triangle);
    header.append(reinterpret_cast<const char*>(&colors), sizeof colors);
  }
  return header;
}

/// Contents of the buffer of test_gltf().
inline std::string test_gltf_buffer() {
  std::string bytes;
  for (int k = 0; k < 8; ++k) {
    float p[3];
    for (int i = 0; i < 3; ++i) p[i] = static_cast<float>((k >> i & 1) != 0 ? kTestHalf[i] : -kTestHalf[i]);
    const float q[3] = {p[0], p[2], -p[1]};
    bytes.append(reinterpret_cast<const char*>(q), sizeof q);
  }
  for (const auto& quad : kTestQuads)
    for (const int k : {0, 1, 2, 0, 2, 3}) {
      const auto row = static_cast<std::uint16_t>(quad[k]);
      bytes.append(reinterpret_cast<const char*>(&row), sizeof row);
    }
  return bytes;
}

/// At half size, doubled by its node. `buffer` is the URI of its bytes, `look` further
/// top-level members: images, textures; `base` further members of the base color.
inline std::string test_gltf(const std::string& buffer = "box.bin", const std::string& node = "",
                             const std::string& look = "", const std::string& base = "") {
  return fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0{}}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1,"material":0}}]}}],
"materials":[{{"name":"red","doubleSided":true,"pbrMetallicRoughness":{{"baseColorFactor":[0.5,0,0,1],"metallicFactor":0.25,"roughnessFactor":0.5{}}}}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,-0.25,-0.5],"max":[1,0.25,0.5]}},
{{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteOffset":0,"byteLength":96}},{{"buffer":0,"byteOffset":96,"byteLength":72}}],
"buffers":[{{"uri":"{}","byteLength":168}}]{}}})",
      node, base, buffer, look);
}

/// Contents of the buffer of test_skinned_gltf().
inline std::string test_skinned_gltf_buffer() {
  std::string bytes = test_gltf_buffer();
  bytes.append(8 * 4, '\0');  // every corner's joints: all of the first
  for (int k = 0; k < 8; ++k)
    for (const float share : {1.0f, 0.0f, 0.0f, 0.0f})
      bytes.append(reinterpret_cast<const char*>(&share), sizeof share);
  const float bind[16] = {0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 1};
  bytes.append(reinterpret_cast<const char*>(bind), sizeof bind);
  return bytes;
}

/// The box as a skin, at twice its size in the bind pose; further members of the joint and of the box node.
inline std::string test_skinned_gltf(const std::string& joint, const std::string& node) {
  return fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0,1]}}],"nodes":[{{"name":"box","mesh":0,"skin":0{}}},{{"name":"joint"{}}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3}},"indices":1}}]}}],
"skins":[{{"joints":[1],"inverseBindMatrices":4}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,-0.25,-0.5],"max":[1,0.25,0.5]}},
{{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}},
{{"bufferView":2,"componentType":5121,"count":8,"type":"VEC4"}},
{{"bufferView":3,"componentType":5126,"count":8,"type":"VEC4"}},
{{"bufferView":4,"componentType":5126,"count":1,"type":"MAT4"}}],
"bufferViews":[{{"buffer":0,"byteOffset":0,"byteLength":96}},{{"buffer":0,"byteOffset":96,"byteLength":72}},
{{"buffer":0,"byteOffset":168,"byteLength":32}},{{"buffer":0,"byteOffset":200,"byteLength":128}},{{"buffer":0,"byteOffset":328,"byteLength":64}}],
"buffers":[{{"uri":"box.bin","byteLength":392}}]}})",
      node, joint);
}

/// A 2 x 1 PNG: red, and half-transparent green.
inline std::string test_png() {
  return *bytes_of_base64(
      "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAD0lEQVR4nGP4z8DwHwgbABB5A359Y87XAAAAAElFTkSuQmCC");
}

/// A reader of files in memory.
inline ReadFile test_files(std::map<std::string, std::string> files) {
  return [files](const std::string& path) -> Result<std::string> {
    const auto found = files.find(path);
    if (found == files.end()) return Error{{}, "cannot be opened: no such file"};
    return found->second;
  };
}

}  // namespace playhouse::mesh
