#include "playhouse/mesh/read_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <sys/mman.h>

#include <cmath>
#include <csignal>
#include <fstream>

#include "playhouse/base/testing_folder.h"
#include "playhouse/mesh/import/gltf_text.h"
#include "playhouse/mesh/opacity.h"
#include "playhouse/mesh/own_process.h"
#include "playhouse/mesh/testing_meshes.h"

namespace playhouse::mesh {
namespace {

using testing::HasSubstr;

MeshFile read(const std::string& name, std::map<std::string, std::string> files) {
  const Result<MeshFile> file = read_mesh(name, test_files(std::move(files)));
  if (!file) ADD_FAILURE() << file.error().line();
  return file ? *file : MeshFile();
}

MeshFile read_collada(const TestCollada& of = {}) {
  return read("d/box.dae", {{"d/box.dae", test_collada(of)}});
}

std::string error_of(const std::string& name, const std::string& bytes) {
  const Result<MeshFile> file = read_mesh(name, test_files({{name, bytes}}));
  return file ? "read" : file.error().line();
}

/// The test's box: twelve triangles that look outwards, whose normals are theirs.
void expect_box(const Mesh& mesh) {
  EXPECT_NEAR(mesh.low.x, -1, 1e-6);
  EXPECT_NEAR(mesh.low.y, -0.5, 1e-6);
  EXPECT_NEAR(mesh.low.z, -0.25, 1e-6);
  EXPECT_NEAR(mesh.high.x, 1, 1e-6);
  EXPECT_NEAR(mesh.high.y, 0.5, 1e-6);
  EXPECT_NEAR(mesh.high.z, 0.25, 1e-6);
  ASSERT_EQ(mesh.surfaces.size(), 1u);
  const Surface& surface = mesh.surfaces[0];
  EXPECT_EQ(surface.corners.size(), 12u);
  double volume = 0;
  for (const auto& [a, b, c] : surface.corners) {
    const auto at = [&](std::uint32_t k) {
      return geom::Vec3{surface.p[k][0], surface.p[k][1], surface.p[k][2]};
    };
    const geom::Vec3 normal = cross(at(b) - at(a), at(c) - at(a));
    volume += dot(at(a), normal) / 6;
    for (const std::uint32_t k : {a, b, c}) {
      const auto& n = surface.normal[k];
      EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
      EXPECT_GT(dot(normal, {n[0], n[1], n[2]}), 0);
    }
  }
  EXPECT_NEAR(volume, 1, 1e-6);
}

TEST(ReadMesh, gives_the_same_box_of_each_format_and_up_axis_and_unit) {
  expect_box(read_collada().mesh);
  TestCollada y_up;
  y_up.up = "Y_UP";
  expect_box(read_collada(y_up).mesh);
  TestCollada inches;
  inches.meter = 0.0254;
  expect_box(read_collada(inches).mesh);
  expect_box(read("box.obj", {{"box.obj", test_obj()}}).mesh);
  expect_box(read("a/box.gltf", {{"a/box.gltf", test_gltf()}, {"a/box.bin", test_gltf_buffer()}}).mesh);
}

TEST(ReadMesh, applies_nodes_and_turns_mirrored_triangles) {
  TestCollada moved;
  moved.transform = "<translate>10 20 30</translate><rotate>0 0 1 90</rotate><scale>1 1 -2</scale>";
  const Mesh mesh = read_collada(moved).mesh;
  EXPECT_NEAR(mesh.low.x, 9.5, 1e-5);
  EXPECT_NEAR(mesh.high.y, 21, 1e-5);
  EXPECT_NEAR(mesh.low.z, 29.5, 1e-5);
  double volume = 0;
  for (const auto& corner : mesh.surfaces[0].corners) {
    const auto at = [&](std::size_t k) {
      const auto& p = mesh.surfaces[0].p[corner[k]];
      return geom::Vec3{p[0] - 10.0, p[1] - 20.0, p[2] - 30.0};
    };
    volume += dot(at(0), cross(at(1), at(2))) / 6;
  }
  EXPECT_NEAR(volume, 2, 1e-4);
}

TEST(ReadMesh, has_a_gltf_skin_where_its_joints_are_whatever_its_node) {
  const auto skinned = [](const std::string& joint, const std::string& node) {
    return read("a.gltf",
                {{"a.gltf", test_skinned_gltf(joint, node)}, {"box.bin", test_skinned_gltf_buffer()}})
        .mesh;
  };
  const std::string twice = R"(,"scale":[2,2,2])";
  expect_box(skinned(twice, ""));
  expect_box(skinned(twice, R"(,"scale":[0.5,0.5,0.5],"translation":[7,8,9])"));
  const Mesh moved = skinned(R"(,"scale":[2,2,2],"translation":[3,1,0])", twice);
  EXPECT_NEAR(moved.low.x, 2, 1e-6);
  EXPECT_NEAR(moved.high.z, 1.25, 1e-6);
}

TEST(ReadMesh, has_colors_as_light) {
  const Material of_collada = read_collada().mesh.materials.at(0);
  EXPECT_NEAR(of_collada.base[0], 0.21404, 1e-4);  // 0.5 of what a screen shows
  EXPECT_NEAR(of_collada.base[1], 0, 1e-6);
  EXPECT_NEAR(of_collada.base[2], 1, 1e-5);
  const Mesh gltf = read("box.gltf", {{"box.gltf", test_gltf()}, {"box.bin", test_gltf_buffer()}}).mesh;
  const Material& of_gltf = gltf.materials.at(gltf.surfaces.at(0).material);
  EXPECT_NEAR(of_gltf.base[0], 0.5, 1e-6);
  EXPECT_NEAR(of_gltf.metallic, 0.25, 1e-6);
  EXPECT_NEAR(of_gltf.roughness, 0.5, 1e-6);
  EXPECT_TRUE(of_gltf.is_two_sided);
}

/// The material of the only surface.
Material material_of(const MeshFile& file) {
  if (file.mesh.surfaces.size() != 1) ADD_FAILURE() << file.mesh.surfaces.size() << " surfaces";
  return file.mesh.surfaces.empty() ? Material() : file.mesh.materials.at(file.mesh.surfaces[0].material);
}

/// Of an OBJ file whose faces have material "a" of this MTL file.
MeshFile read_obj(const std::string& mtl) {
  return read("box.obj",
              {{"box.obj", test_obj("mtllib box.mtl\nusemtl a\n")}, {"box.mtl", mtl}, {"t.png", test_png()}});
}

void expect_base(const Material& material, double red, double green, double blue) {
  EXPECT_NEAR(material.base[0], red, 1e-4);
  EXPECT_NEAR(material.base[1], green, 1e-4);
  EXPECT_NEAR(material.base[2], blue, 1e-4);
}

TEST(ReadMesh, shows_the_texture_of_an_obj_without_a_color_as_it_is) {
  const Material blender = material_of(read_obj("newmtl a\nmap_Kd t.png\n"));
  EXPECT_EQ(blender.texture, 0u);
  expect_base(blender, 1, 1, 1);
  expect_base(material_of(read_obj("newmtl a\nKd 0.6 0.6 0.6\nmap_Kd t.png\n")), 0.31855, 0.31855, 0.31855);
  expect_base(material_of(read_obj("\xEF\xBB\xBFnewmtl a\r\nKd 1 0 0 \r\nmap_Kd t.png\r\n")), 1, 0, 0);
  expect_base(material_of(read_obj("newmtl b\nKd 1 0 0\nnewmtl a\nmap_Kd t.png\n")), 1, 1, 1);
}

TEST(ReadMesh, reads_obj_files_that_begin_with_a_mark_of_their_encoding) {
  const std::string mark = "\xEF\xBB\xBF";
  const MeshFile file = read("box.obj", {{"box.obj", mark + test_obj("mtllib box.mtl\nusemtl a\n")},
                                         {"box.mtl", mark + "newmtl a\nKd 1 0 0\n"}});
  expect_base(material_of(file), 1, 0, 0);
}

TEST(ReadMesh, shows_what_has_no_material_in_light_grey) {
  expect_base(material_of(read("box.obj", {{"box.obj", test_obj()}})), 0.6, 0.6, 0.6);
  expect_base(material_of(read_obj("newmtl a\nNs 10\n")), 0.6, 0.6, 0.6);
  expect_base(material_of(read_obj("newmtl a\nKd 0.6 0.6 0.6\n")), 0.31855, 0.31855, 0.31855);
  std::string plain = test_collada();
  const std::size_t first = plain.find("<library_effects>"), last = plain.find("<library_geometries>");
  plain.erase(first, last - first);
  expect_base(material_of(read("box.dae", {{"box.dae", plain}})), 0.6, 0.6, 0.6);
}

TEST(ReadMesh, warns_of_a_file_of_materials_that_is_missing) {
  const MeshFile file = read("box.obj", {{"box.obj", test_obj("mtllib none.mtl\nusemtl a\n")}});
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_THAT(file.warnings[0], HasSubstr(R"(material file "none.mtl" is not beside the mesh)"));
  EXPECT_THAT(read_obj("newmtl a\nKd 1 0 0\n").warnings, testing::IsEmpty());
}

TEST(ReadMesh, shows_a_constant_effect_by_its_emission_alone) {
  TestCollada constant;
  constant.shading = "constant";
  constant.effect = "<emission><color>0 1 0 1</color></emission>";
  const Material material = material_of(read_collada(constant));
  expect_base(material, 0, 0, 0);
  EXPECT_NEAR(material.emission[1], 1, 1e-5);
}

TEST(ReadMesh, reads_colors_of_collada_with_white_space_in_front) {
  TestCollada spaced;
  spaced.effect = "<diffuse><color sid=\"d\">\n\t  0.5 0 1 1  </color></diffuse>";
  const Material plain = material_of(read_collada()), same = material_of(read_collada(spaced));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(same.base[i], plain.base[i]);
}

TEST(ReadMesh, shows_materials_of_collada_that_would_be_invisible) {
  const auto alpha = [](const char* transparency) {
    TestCollada clear;
    clear.effect =
        "<diffuse><color>0.5 0 1 1</color></diffuse><transparent><color>1 1 1 1</color></transparent>"
        "<transparency><float>" +
        std::string(transparency) + "</float></transparency>";
    return material_of(read_collada(clear)).base[3];
  };
  EXPECT_EQ(alpha("0.0"), 1) << "as old exporters of Blender write opaque ones";
  EXPECT_NEAR(alpha("0.25"), 0.25, 1e-6);
}

const std::string kTexture = R"(,"images":[{"uri":"sub/t.png"}],"textures":[{"source":0}])";
const std::string kTextured = R"(,"baseColorTexture":{"index":0})";

/// Of a glTF file whose material is 30 % opaque and says this.
Material with_alpha(const std::string& says) {
  std::string gltf = test_gltf();
  gltf.replace(gltf.find("[0.5,0,0,1]"), 11, "[0.5,0,0,0.3]");
  gltf.insert(gltf.find(R"("doubleSided")"), says);
  return material_of(read("box.gltf", {{"box.gltf", gltf}, {"box.bin", test_gltf_buffer()}}));
}

TEST(ReadMesh, shows_both_sides_but_where_gltf_says_one) {
  std::string one_sided = test_gltf();
  one_sided.replace(one_sided.find(R"("doubleSided":true,)"), 19, "");
  EXPECT_FALSE(
      material_of(read("a.gltf", {{"a.gltf", one_sided}, {"box.bin", test_gltf_buffer()}})).is_two_sided);
  EXPECT_TRUE(material_of(read("box.obj", {{"box.obj", test_obj()}})).is_two_sided);
  EXPECT_TRUE(material_of(read_collada()).is_two_sided);
}

TEST(ReadMesh, takes_the_opacity_of_gltf_as_its_mode_says) {
  const Material solid = with_alpha(""), mask = with_alpha(R"("alphaMode":"MASK",)"),
                 thin = with_alpha(R"("alphaMode":"MASK","alphaCutoff":0.2,)"),
                 clear = with_alpha(R"("alphaMode":"BLEND",)");
  EXPECT_EQ(solid.opacity, Opacity::kSolid);
  EXPECT_EQ(solid.base[3], 1);
  EXPECT_TRUE(is_all_hole(mask));
  EXPECT_NEAR(thin.least_opacity, 0.2, 1e-6);
  EXPECT_FALSE(is_all_hole(thin));
  EXPECT_TRUE(is_see_through({}, clear));
  EXPECT_NEAR(clear.base[3], 0.3, 1e-6);
}

TEST(ReadMesh, reads_textures_of_the_folder) {
  const MeshFile file = read("d/box.gltf", {{"d/box.gltf", test_gltf("box.bin", "", kTexture, kTextured)},
                                            {"d/box.bin", test_gltf_buffer()},
                                            {"d/sub/t.png", test_png()}});
  EXPECT_THAT(file.warnings, testing::IsEmpty());
  ASSERT_EQ(file.mesh.images.size(), 1u);
  EXPECT_EQ(file.mesh.images[0].width, 2u);
  EXPECT_EQ(file.mesh.images[0].height, 1u);
  EXPECT_THAT(file.mesh.images[0].rgba, testing::ElementsAre(255, 0, 0, 255, 0, 255, 0, 128));
  EXPECT_EQ(file.mesh.materials.at(file.mesh.surfaces.at(0).material).texture, 0u);
}

TEST(ReadMesh, glows_by_the_mean_of_an_emissive_texture) {
  std::string gltf = test_gltf("box.bin", "", kTexture);
  gltf.insert(gltf.find(R"("doubleSided")"), R"("emissiveFactor":[1,0.5,1],"emissiveTexture":{"index":0},)");
  std::map<std::string, std::string> files{
      {"a.gltf", gltf}, {"box.bin", test_gltf_buffer()}, {"sub/t.png", test_png()}};
  const MeshFile file = read("a.gltf", files);
  EXPECT_THAT(file.warnings, testing::IsEmpty());
  EXPECT_THAT(material_of(file).emission, testing::ElementsAre(0.5f, 0.25f, 0.f));  // a red and a green pixel
  files.erase("sub/t.png");
  const MeshFile missing = read("a.gltf", files);
  EXPECT_THAT(missing.warnings, testing::ElementsAre(HasSubstr("surfaces do not glow")));
  EXPECT_THAT(material_of(missing).emission, testing::Each(0.f));
}

TEST(ReadMesh, reads_textures_of_a_model_of_gazebo) {
  for (const char* uri : {"../materials/textures/t.png", "t.png", "../../m/materials/textures/t.png"}) {
    const std::string texture =
        R"(,"images":[{"uri":")" + std::string(uri) + R"("}],"textures":[{"source":0}])";
    const MeshFile file =
        read("m/meshes/box.gltf", {{"m/meshes/box.gltf", test_gltf("box.bin", "", texture, kTextured)},
                                   {"m/meshes/box.bin", test_gltf_buffer()},
                                   {"m/meshes/../materials/textures/t.png", test_png()}});
    EXPECT_THAT(file.warnings, testing::IsEmpty());
    EXPECT_EQ(file.mesh.images.size(), 1u) << uri;
  }
}

TEST(ReadMesh, warns_of_a_texture_that_is_missing_or_none) {
  const std::map<std::string, std::string> files{{"box.gltf", test_gltf("box.bin", "", kTexture, kTextured)},
                                                 {"box.bin", test_gltf_buffer()}};
  const MeshFile missing = read("box.gltf", files);
  ASSERT_EQ(missing.warnings.size(), 1u);
  EXPECT_THAT(missing.warnings[0], HasSubstr(R"(texture "sub/t.png" cannot be opened)"));
  EXPECT_EQ(missing.mesh.materials.at(0).texture, Material::kNone);
  auto broken = files;
  broken["sub/t.png"] = "no picture";
  EXPECT_THAT(read("box.gltf", broken).warnings.at(0), HasSubstr("is neither a PNG nor a JPEG"));
}

TEST(ReadMesh, opens_no_file_outside_of_its_folder) {
  std::vector<std::string> asked;
  const auto files = [&](const std::string& path) -> Result<std::string> {
    asked.push_back(path);
    if (path == "d/box.gltf")
      return test_gltf("../../etc/box.bin", "",
                       R"(,"images":[{"uri":"/etc/passwd"}],"textures":[{"source":0}])", kTextured);
    if (path == "d/box.bin") return test_gltf_buffer();
    return Error{{}, "cannot be opened: no such file"};
  };
  const Result<MeshFile> file = read_mesh("d/box.gltf", files);
  ASSERT_TRUE(file) << file.error().line();
  for (const std::string& path : asked)
    EXPECT_TRUE(path == "d/box.gltf" || path == "d/box.bin" || path == "d/passwd" ||
                path == "d/../materials/textures/passwd")
        << path;
}

TEST(ReadMesh, tells_in_one_line_what_is_wrong) {
  EXPECT_THAT(error_of("a.ply", "ply"), HasSubstr("a.ply: is not a mesh: its name ends in none of"));
  EXPECT_THAT(error_of("a.dae", "no xml"), HasSubstr("a.dae: cannot be read: "));
  EXPECT_THAT(error_of("a.obj", "v 1 2 3\n"), HasSubstr("a.obj: "));
  EXPECT_THAT(error_of("a.glb", "glTF\2"), HasSubstr("a.glb: cannot be read: "));
  EXPECT_EQ(error_of("a.glb", std::string("glTF\1\0\0\0", 8)),
            "a.glb: cannot be read: it is glTF 1.0, and only 2.0 is read");
  EXPECT_THAT(error_of("a.gltf", test_gltf()), HasSubstr("a.gltf: cannot be read: "));  // without its buffer
  TestCollada broken;
  broken.triangles = "0 1 99";
  EXPECT_THAT(error_of("a.dae", test_collada(broken)), HasSubstr("a.dae: "));
  EXPECT_THAT(error_of("a.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), HasSubstr("a.obj: "));
  EXPECT_THAT(error_of("a.obj", "v 0 0 0\nv 1e30 0 0\nv 0 1 0\nf 1 2 3\n"),
              HasSubstr("a.obj: is broken: a corner is not a number, or farther than 100000 m"));
  for (const char* name : {"a.stl", "a.dae", "a.obj", "a.glb"})
    EXPECT_THAT(error_of(name, "x"), testing::Not(HasSubstr("\n")));
}

TEST(ReadMesh, reads_no_gltf_that_requires_an_extension_it_does_not_know) {
  const auto requires_list = [](const std::string& list) {
    return error_of(
        "a.gltf",
        test_gltf("box.bin", "", R"(,"extensionsUsed":["KHR_x","EXT_y"],"extensionsRequired":)" + list));
  };
  EXPECT_EQ(requires_list(R"([ "KHR_materials_unlit", "KHR_mesh_quantization" ])"),
            R"(a.gltf: needs the glTF extension "KHR_mesh_quantization", which is not read)");
  EXPECT_THAT(requires_list(R"(["EXT_f\noo"])"), HasSubstr(R"(needs the glTF extension "EXT_f)"));
  EXPECT_THAT(requires_list(R"(["KHR_lights_punctual"])"),
              HasSubstr("cannot be read"));  // without its buffer
  EXPECT_THAT(requires_list("[]"), HasSubstr("cannot be read"));
  const std::string deeper =
      R"({"extras":{"extensionsRequired":["EXT_a"]},"b":"\"extensionsRequired\":[","c":[1,"d"],)"
      R"("extensionsRequired":["EXT_e")";
  EXPECT_THAT(gltf_list(deeper, "extensionsRequired"), testing::ElementsAre("EXT_e"));
}

TEST(ReadMesh, says_of_collada_nodes_that_they_are_too_many_or_inside_themselves) {
  TestCollada endless;
  endless.node = "<instance_node url=\"#n\"/>";
  EXPECT_THAT(error_of("a.dae", test_collada(endless)),
              HasSubstr("has nodes more than 128 deep, or one that is inside"));
  TestCollada many;  // 16 of 16 of 16 of 16 of 16
  for (int level = 0; level < 5; ++level) {
    many.libraries += fmt::format("<library_nodes><node id=\"l{}\">", level);
    for (int i = 0; i < 16; ++i) many.libraries += fmt::format("<instance_node url=\"#l{}\"/>", level + 1);
    many.libraries += "</node></library_nodes>";
  }
  many.libraries += "<library_nodes><node id=\"l5\"><instance_geometry url=\"#box\"/></node></library_nodes>";
  many.node = "<instance_node url=\"#l0\"/>";
  EXPECT_THAT(error_of("a.dae", test_collada(many)),
              HasSubstr("has too many nodes: up to 65536 are possible"));
}

TEST(ReadMesh, counts_nodes_of_gltf_by_every_path_to_them) {
  const auto levels = [](int count, int copies) {  // each has the next so many times; the last has the mesh
    std::string nodes;
    for (int level = 1; level <= count; ++level) {
      nodes += R"({"name":"children","children":[)";
      for (int i = 0; i < copies; ++i) nodes += fmt::format("{}{}", i > 0 ? ", " : "", level);
      nodes += "]},";
    }
    std::string gltf = test_gltf();
    gltf.insert(gltf.find(R"({"mesh":0})"), nodes);
    return gltf;
  };
  EXPECT_FALSE(check_gltf_nodes(levels(40, 2)));
  EXPECT_FALSE(check_gltf_nodes(levels(2, 300)));  // 1 + 300 + 90,000
  EXPECT_TRUE(check_gltf_nodes(levels(2, 200)));
  EXPECT_TRUE(check_gltf_nodes(levels(100, 1)));
  EXPECT_EQ(error_of("a.gltf", levels(40, 2)), "a.gltf: has too many nodes: up to 65536 are possible");
  std::string endless = test_gltf();
  endless.insert(endless.find(R"("mesh":0)"), R"("children":[0],)");
  EXPECT_THAT(error_of("a.gltf", endless), HasSubstr("has too many nodes: up to 65536 are possible"));
}

/// 40 levels of nodes, each of which has the next twice by these children, written around "N,N"; before them
/// and after the nodes' own list something else may be.
std::string nodes_of_json(const std::string& before_children, const std::string& after_children,
                          const std::string& first = "", const std::string& more = "") {
  std::string nodes;
  const int shift = first.empty() ? 0 : 1;
  for (int level = 1; level <= 40; ++level)
    nodes += fmt::format("{{{}{},{}{}}},", before_children, level + shift, level + shift, after_children);
  std::string gltf = test_gltf();
  gltf.insert(gltf.find(R"(}],)", gltf.find(R"({"mesh":0)")) + 3, more);
  gltf.insert(gltf.find(R"({"mesh":0})"), first + nodes);
  if (shift > 0) gltf.replace(gltf.find(R"("nodes":[0])"), 11, R"("nodes":[1])");
  return gltf;
}

TEST(ReadMesh, counts_nodes_of_gltf_however_they_are_written) {
  EXPECT_FALSE(check_gltf_nodes(nodes_of_json(R"("children":[)", "]")));
  // Elements that are no numbers.
  EXPECT_FALSE(check_gltf_nodes(nodes_of_json(R"("children":["x",)", "]")));
  EXPECT_FALSE(check_gltf_nodes(nodes_of_json(R"("children":[{"a":[1]},)", R"(,"],[",[],null])")));
  EXPECT_FALSE(check_gltf_nodes(nodes_of_json(R"("children":[)", "]", "7,")));
  EXPECT_FALSE(check_gltf_nodes(nodes_of_json(R"("children":[)", "]", "[{},{}],")));
  // Twice: one of them counts.
  EXPECT_FALSE(check_gltf_nodes(nodes_of_json(R"("children":[)", R"(],"children":[])")));
  EXPECT_FALSE(check_gltf_nodes(nodes_of_json(R"("children":[],"children":[)", "]")));
  EXPECT_FALSE(check_gltf_nodes(nodes_of_json(R"("children":[)", "]", "", R"("nodes":[{},{}],)")));
  EXPECT_FALSE(
      check_gltf_nodes(nodes_of_json(R"("children":[)", "]", "", R"("scenes":[{"nodes":[]}],"scenes":[],)")));
  // Escaped.
  EXPECT_FALSE(check_gltf_nodes(nodes_of_json(R"("chil\u0064r\u0065n":[)", "]")));
  std::string gltf = nodes_of_json(R"("children":[)", "]");
  gltf.replace(gltf.find(R"("nodes":[{)"), 7, R"("n\u006Fdes")");
  EXPECT_FALSE(check_gltf_nodes(gltf));
  gltf.replace(gltf.find(R"("scenes")"), 8, R"("\u0073cenes")");
  EXPECT_FALSE(check_gltf_nodes(gltf));
  EXPECT_THAT(error_of("a.gltf", gltf), HasSubstr("has too many nodes: up to 65536 are possible"));
  // Names with escapes, and numbers elsewhere, are none of them.
  EXPECT_TRUE(check_gltf_nodes(nodes_of_json(R"("name":"\"\u0063","matrix":[)", "]")));
  EXPECT_TRUE(check_gltf_nodes(nodes_of_json(R"("extras":{"children":[)", "]}")));
}

TEST(ReadMesh, reads_no_gltf_of_version_1) {
  std::string as_second = test_gltf();
  as_second.replace(as_second.find(R"("2.0")"), 5, R"("1.0")");
  // As a reader of 1.0 would take it.
  const std::string first = R"({"asset":{"version":"1.0"},"scene":"s","scenes":{"s":{"nodes":["n"]}},)"
                            R"("nodes":{"n":{"meshes":["m"]}},"meshes":{"m":{"primitives":[{"attributes":)"
                            R"({"POSITION":"p"},"mode":4}]}},"accessors":{"p":{"bufferView":"v",)"
                            R"("byteOffset":0,"componentType":5126,"count":3,"type":"VEC3"}},)"
                            R"("bufferViews":{"v":{"buffer":"b","byteOffset":0,"byteLength":36}},)"
                            R"("buffers":{"b":{"uri":"box.bin","byteLength":168,"type":"arraybuffer"}}})";
  for (const std::string& gltf : {as_second, first}) {
    const Result<MeshFile> file =
        read_mesh("a.gltf", test_files({{"a.gltf", gltf}, {"box.bin", test_gltf_buffer()}}));
    ASSERT_FALSE(file);
    EXPECT_THAT(file.error().line(), HasSubstr("a.gltf: cannot be read: "));
  }
}

/// A PNG of one color, 1 bit for each of side x side pixels.
std::string flat_png(std::uint32_t side) {
  std::string file(1u << 20, '\0');
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = png.height = side;
  png.format = PNG_FORMAT_RGB_COLORMAP;
  png.colormap_entries = 1;
  const std::string pixels(std::size_t{side} * side, '\0'), map(3, '\0');
  png_alloc_size_t size = file.size();
  EXPECT_NE(png_image_write_to_memory(&png, file.data(), &size, 0, pixels.data(), 0, map.data()), 0);
  file.resize(size);
  return file;
}

TEST(ReadMesh, takes_textures_of_as_many_pixels_as_their_files_pay_for) {
  const auto warnings = [](const std::string& png) {
    return read("box.gltf", {{"box.gltf", test_gltf("box.bin", "", kTexture, kTextured)},
                             {"box.bin", test_gltf_buffer()},
                             {"sub/t.png", png}})
        .warnings;
  };
  EXPECT_THAT(warnings(flat_png(2048)), testing::IsEmpty());
  const std::string large = flat_png(4096);
  EXPECT_LT(large.size(), 20'000u);  // for 64 MiB of colors
  EXPECT_THAT(warnings(large), testing::ElementsAre(HasSubstr("4096 x 4096 pixels, which is too many")));
  EXPECT_THAT(warnings(large + std::string(50'000, '\0')),
              testing::IsEmpty());  // of a file that pays for them
}

TEST(ReadMesh, takes_textures_that_the_mesh_file_itself_pays_for) {
  const std::string large = flat_png(4096);
  const auto warnings = [&](std::size_t spaces) {
    return read("box.gltf",
                {{"box.gltf", test_gltf("box.bin", "", kTexture, kTextured) + std::string(spaces, ' ')},
                 {"box.bin", test_gltf_buffer()},
                 {"sub/t.png", large}})
        .warnings;
  };
  EXPECT_EQ(warnings(0).size(), 1u);
  EXPECT_THAT(warnings(60'000), testing::IsEmpty());
}

TEST(ReadMesh, refuses_a_small_file_that_unpacks_to_too_much) {
  if (!Allowance::bounds_memory()) GTEST_SKIP() << "sanitizers take address space of their own";
  std::string gltf = test_gltf();  // 2^26 corners, all of them 0 but one
  const std::string corners = R"({"bufferView":0,"componentType":5126,"count":8,"type":"VEC3")";
  const std::string sparse = R"({"componentType":5126,"count":67108864,"type":"VEC3","sparse":{"count":1,)"
                             R"("indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":0}})";
  gltf.replace(gltf.find(corners), corners.size(), sparse);
  const Result<MeshFile> file =
      read_mesh("a.gltf", test_files({{"a.gltf", gltf}, {"box.bin", test_gltf_buffer()}}));
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().line(), "a.gltf: cannot be read: it takes too much memory");
}

TEST(ReadMesh, gives_the_process_of_a_small_file_little_memory) {
  if (!Allowance::bounds_memory()) GTEST_SKIP() << "sanitizers take address space of their own";
  OwnProcess process([](Pipe& pipe, Allowance& allowance) {
    const auto can_take = [](std::size_t bytes) {
      void* memory = ::mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      if (memory == MAP_FAILED) return false;
      ::munmap(memory, bytes);
      return true;
    };
    constexpr std::size_t kSome = 16u << 20;  // in use, or just freed
    std::vector<std::byte> answers;
    const auto ask = [&](std::size_t bytes) { answers.push_back(std::byte{can_take(bytes)}); };
    ask(cost_of(0).memory - kSome), ask(cost_of(0).memory + kSome);
    allowance.grow(1u << 20);
    ask(cost_of(1u << 20).memory - kSome), ask(cost_of(1u << 20).memory + kSome);
    allowance.grow(64u << 20);
    ask(limits::kMeshMemoryBytes - kSome), ask(limits::kMeshMemoryBytes + kSome);
    pipe.send('a', answers);
  });
  ASSERT_NE(process.pipe(), nullptr);
  const auto answer = process.pipe()->receive(100);
  ASSERT_TRUE(answer);
  constexpr std::byte kYes{1}, kNo{0};
  EXPECT_THAT(answer->bytes, testing::ElementsAre(kYes, kNo, kYes, kNo, kYes, kNo));
}

TEST(ReadMesh, refuses_a_collada_unit_that_is_none) {
  for (const char* unit : {"-1", "0", "abc", "", "nan", "inf", "0,01", "1 m"}) {
    std::string file = test_collada();
    file.replace(file.find("meter=\"1\""), 9, std::string("meter=\"") + unit + "\"");
    EXPECT_THAT(error_of("a.dae", file),
                HasSubstr(std::string("a.dae: has an invalid unit of \"") + unit + "\" metres"))
        << unit;
  }
  std::string file = test_collada();
  file.replace(file.find(" meter=\"1\""), 10, "");
  EXPECT_EQ(error_of("a.dae", file), "read");
}

TEST(ReadMesh, refuses_triangles_with_corners_that_are_not_there) {
  const std::string text = "is broken: a triangle has a corner that is not there";
  TestCollada below;
  below.triangles.replace(0, 1, "-1");
  EXPECT_THAT(error_of("a.dae", test_collada(below)), HasSubstr(text));
  std::string buffer = test_gltf_buffer();
  buffer[96] = 99;  // the first row
  const Result<MeshFile> file =
      read_mesh("a.gltf", test_files({{"a.gltf", test_gltf()}, {"box.bin", buffer}}));
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().line(), HasSubstr(text));
}

TEST(ReadMesh, leaves_out_faces_of_obj_with_one_or_two_corners) {
  for (const char* face : {"f 1\n", "f 1 2\n", "f 1 2\nf 3\nf 1 1 1\n", "p 1\nl 1 2 3\n"})
    expect_box(read("box.obj", {{"box.obj", test_obj() + face}}).mesh);
  EXPECT_EQ(error_of("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"), "a.obj: has no triangles");
  TestCollada lamps;
  lamps.node = "<node id=\"a\"><matrix>1 0 0 5 0 1 0 0 0 0 1 3 0 0 0 1</matrix></node><node id=\"b\"/>";
  std::string bare = test_collada(lamps);
  const std::size_t begin = bare.find("<instance_geometry"), end = bare.find("<node id=\"a\"");
  bare.erase(begin, end - begin);
  bare.erase(bare.find("<library_geometries"),
             bare.find("</library_geometries>") + 21 - bare.find("<library_geometries"));
  EXPECT_EQ(error_of("a.dae", bare), "a.dae: has no triangles");
}

TEST(OwnProcess, tells_how_it_ended) {
  OwnProcess process([](Pipe&, Allowance&) { ::raise(SIGSEGV); });
  ASSERT_NE(process.pipe(), nullptr);
  EXPECT_FALSE(process.pipe()->receive(100));
  EXPECT_EQ(process.end(), "ended its process by signal 11");
}

/// With a point light of this color.
TestCollada lit_by(const std::string& color) {
  TestCollada lit;
  lit.libraries = "<library_lights><light id=\"lamp\"><technique_common><point><color>" + color +
                  "</color></point></technique_common></light></library_lights>";
  lit.node = "<node id=\"l\" name=\"l\"><translate>1 2 3</translate><instance_light url=\"#lamp\"/></node>";
  return lit;
}

TEST(ReadMesh, reads_lights) {
  const Mesh mesh = read_collada(lit_by("1 0.5 0")).mesh;
  ASSERT_EQ(mesh.lights.size(), 1u);
  EXPECT_EQ(mesh.lights[0].kind, LightKind::kPoint);
  EXPECT_NEAR(mesh.lights[0].p.x, 1, 1e-6);
  EXPECT_NEAR(mesh.lights[0].p.y, 2, 1e-6);
  EXPECT_NEAR(mesh.lights[0].p.z, 3, 1e-6);
  EXPECT_NEAR(mesh.lights[0].color[0], 683 / (4 * geom::kPi), 1e-3);
  EXPECT_NEAR(mesh.lights[0].color[1], 0.21404 * 683 / (4 * geom::kPi), 1e-2);
}

TEST(ReadMesh, gives_a_light_of_blender_the_candela_that_blender_gives_it_in_gltf) {
  const Mesh mesh = read_collada(lit_by("1000 1000 1000")).mesh;
  EXPECT_NEAR(mesh.lights.at(0).color[0], 54351.4, 1);  // 1000 W as KHR_lights_punctual has it
}

/// Physics of one body with these shapes, of the node of the box.
TestCollada with_physics(const std::string& shapes, const std::string& more = "<mass>3.5</mass>") {
  TestCollada of;
  of.libraries =
      "<library_physics_materials><physics_material id=\"pm\"><technique_common>"
      "<dynamic_friction>0.3</dynamic_friction><restitution>0.2</restitution><static_friction>0.5"
      "</static_friction></technique_common></physics_material></library_physics_materials>"
      "<library_physics_models><physics_model id=\"p\"><rigid_body sid=\"b\"><technique_common>"
      "<dynamic>true</dynamic>" +
      more + "<instance_physics_material url=\"#pm\"/>" + shapes +
      "</technique_common></rigid_body></physics_model></library_physics_models>"
      "<library_physics_scenes><physics_scene id=\"s\"><instance_physics_model url=\"#p\">"
      "<instance_rigid_body body=\"b\" target=\"#n\"/></instance_physics_model></physics_scene>"
      "</library_physics_scenes>";
  of.scene = "<instance_physics_scene url=\"#s\"/>";
  return of;
}

TEST(ColladaPhysics, has_shapes_where_their_bodies_are) {
  TestCollada of = with_physics(
      "<shape><box><half_extents>1 0.5 0.25</half_extents></box></shape>"
      "<shape><translate>0 0 1</translate><sphere><radius>0.5</radius></sphere></shape>"
      "<shape><cylinder><height>2</height><radius>0.3 0.3</radius></cylinder></shape>"
      "<shape><capsule><height>1</height><radius>0.2 0.2</radius></capsule></shape>");
  of.transform = "<translate>5 0 0</translate><rotate>0 0 1 90</rotate>";
  const Mesh mesh = read_collada(of).mesh;
  ASSERT_TRUE(mesh.physics);
  const PhysicalProperties& physics = *mesh.physics;
  EXPECT_EQ(physics.mass, 3.5);
  EXPECT_EQ(physics.friction, 0.3);
  EXPECT_EQ(physics.restitution, 0.2);
  EXPECT_FALSE(physics.is_fixed);
  ASSERT_EQ(physics.shapes.size(), 4u);
  EXPECT_EQ(physics.shapes[0].kind, ShapeKind::kBox);
  EXPECT_NEAR(physics.shapes[0].half.x, 1, 1e-9);
  const geom::Vec3 ahead = physics.shapes[0].q * geom::Vec3{1, 0, 0};
  EXPECT_NEAR(ahead.y, 1, 1e-9);
  EXPECT_EQ(physics.shapes[1].kind, ShapeKind::kSphere);
  EXPECT_NEAR(physics.shapes[1].p.x, 5, 1e-9);
  EXPECT_NEAR(physics.shapes[1].p.z, 1, 1e-9);
  EXPECT_EQ(physics.shapes[2].kind, ShapeKind::kCylinder);
  EXPECT_NEAR(physics.shapes[2].half.z, 1, 1e-9);
  const geom::Vec3 along = physics.shapes[2].q * geom::Vec3{0, 0, 1};  // y of the node, which is -x of F
  EXPECT_NEAR(along.x, -1, 1e-9);
  EXPECT_EQ(physics.shapes[3].kind, ShapeKind::kCapsule);
  EXPECT_NEAR(physics.shapes[3].half.x, 0.2, 1e-9);
}

TEST(ColladaPhysics, refuses_masses_and_shapes_that_no_world_has) {
  const auto error = [](const std::string& half, const std::string& mass) {
    return error_of("a.dae", test_collada(with_physics(
                                 "<shape><box><half_extents>" + half + "</half_extents></box></shape>",
                                 "<mass>" + mass + "</mass>")));
  };
  EXPECT_EQ(error("1 1 1", "1e9"), "read");
  for (const char* mass : {"1e30", "-1", "nan"})
    EXPECT_EQ(error("1 1 1", mass),
              "a.dae: is broken: its mass for physics is not a number from 0 to 1e+09 kg")
        << mass;
  EXPECT_EQ(error("1e6 1 1", "1"),
            "a.dae: is broken: a shape for physics is not a number, or larger or farther than 100000 m");
}

TEST(ColladaPhysics, turns_what_has_y_up) {
  TestCollada of =
      with_physics("<shape><cylinder><height>2</height><radius>0.3 0.3</radius></cylinder></shape>");
  of.up = "Y_UP";
  of.meter = 0.01;
  const Mesh mesh = read_collada(of).mesh;
  ASSERT_TRUE(mesh.physics);
  const CollisionShape& cylinder = mesh.physics->shapes.at(0);
  const geom::Vec3 along = cylinder.q * geom::Vec3{0, 0, 1};
  EXPECT_NEAR(along.z, 1, 1e-9);
  EXPECT_NEAR(cylinder.half.z, 0.01, 1e-9);
}

TEST(ColladaPhysics, takes_geometries_as_hulls_and_triangles) {
  TestCollada of = with_physics(
      "<shape><instance_geometry url=\"#box\"/></shape><shape><instance_geometry url=\"#hull\"/></shape>");
  of.libraries =
      "<library_geometries><geometry id=\"hull\"><convex_mesh "
      "convex_hull_of=\"#box\"/></geometry></library_geometries>" +
      of.libraries;
  const Result<MeshFile> file = read_mesh("a.dae", test_files({{"a.dae", test_collada(of)}}));
  ASSERT_TRUE(file) << file.error().line();
  const auto& shapes = file->mesh.physics->shapes;
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_EQ(shapes[0].kind, ShapeKind::kTriangles);
  EXPECT_EQ(shapes[0].points.size(), 8u);
  EXPECT_EQ(shapes[0].corners.size(), 12u);
  EXPECT_EQ(shapes[1].kind, ShapeKind::kHull);
  EXPECT_EQ(shapes[1].points.size(), 8u);
}

TEST(ColladaPhysics, tells_what_is_broken) {
  const auto error = [](const TestCollada& of) { return error_of("a.dae", test_collada(of)); };
  EXPECT_THAT(error(with_physics("<shape><box/></shape>")), HasSubstr("a box without half_extents"));
  EXPECT_THAT(error(with_physics("<shape><instance_geometry url=\"#none\"/></shape>")),
              HasSubstr("has no geometry \"#none\""));
  EXPECT_THAT(error(with_physics("<shape><sphere><radius>1</radius></sphere></shape>", "<mass>nan</mass>")),
              HasSubstr("its mass for physics is not a number from 0"));
  TestCollada elsewhere = with_physics("<shape><sphere><radius>1</radius></sphere></shape>");
  elsewhere.libraries.replace(elsewhere.libraries.find("target=\"#n\""), 11, "target=\"#x\"");
  EXPECT_THAT(error(elsewhere), HasSubstr("has no node \"#x\""));
}

TEST(ReadMesh, reads_stl_in_both_forms_as_z_up_and_metres) {
  for (const std::string& bytes :
       {test_stl(), test_binary_stl(), test_binary_stl("solid made by a program that says so in binary, too"),
        test_binary_stl("COLOR=\xff\x01\x01\xff", 0xFFFF), test_binary_stl() + "bytes that nobody asked for",
        "\xEF\xBB\xBF" + test_stl(), "  SOLID vertex \xc3\xa4\r\n" + test_stl().substr(12)}) {
    const Mesh mesh = read("d/box.STL", {{"d/box.STL", bytes}}).mesh;
    expect_box(mesh);
    ASSERT_EQ(mesh.materials.size(), 1u);
    EXPECT_EQ(mesh.materials[0].base, (std::array<float, 4>{0.6f, 0.6f, 0.6f, 1}));
    EXPECT_EQ(mesh.materials[0].opacity, Opacity::kHoles);
    ASSERT_EQ(mesh.surfaces.size(), 1u);
    EXPECT_EQ(mesh.surfaces[0].p.size(), 24u) << "corners of a face are shared, edges are sharp";
  }
}

TEST(ReadMesh, believes_no_number_of_an_stl) {
  std::string many = test_binary_stl();
  many.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(error_of("a.stl", many),
            "a.stl: is broken: it is not an ASCII STL, and a binary one of 4294967295 "
            "triangles has 214748364834 bytes, found 684");
  const std::string whole = test_binary_stl("solid");
  EXPECT_THAT(error_of("a.stl", whole.substr(0, 600)),
              HasSubstr("a binary one of 12 triangles has 684 bytes"));
  EXPECT_THAT(error_of("a.stl", "P5"),
              HasSubstr("is not a valid STL: it is not an ASCII one, and too short"));
  std::string none = test_binary_stl();
  none.replace(80, 4, std::string(4, '\0'));
  EXPECT_EQ(error_of("a.stl", none), "a.stl: has no triangles");
  EXPECT_EQ(error_of("a.stl", "solid\nendsolid"), "a.stl: has no triangles");
}

TEST(ReadMesh, tells_the_line_of_a_broken_stl) {
  const std::string whole = test_stl();
  const auto with = [&whole](const std::string& from, const std::string& to) {
    return error_of("a.stl", std::string(whole).replace(whole.find(from), from.size(), to));
  };
  EXPECT_EQ(with("vertex -1", "vertex one"), "a.stl: is broken in line 4: a vertex needs three numbers");
  EXPECT_EQ(with("endloop", "vertex 0 0 0 endloop"),
            "a.stl: is broken in line 7: a triangle needs three vertices");
  EXPECT_THAT(with("vertex -1", "vertex nan"), HasSubstr("a corner is not a number, or farther than"));
  EXPECT_THAT(with("vertex -1", "vertex 1e300"), HasSubstr("a corner is not a number, or farther than"));
  EXPECT_THAT(error_of("a.stl", whole.substr(0, whole.size() / 2)), HasSubstr("it ends before its endsolid"));
}

TEST(ReadMesh, reads_files_of_this_machine) {
  const TestFolder folder;
  std::ofstream(folder / "box.obj") << test_obj();
  const Result<Mesh> mesh = read_mesh(folder / "box.obj");
  ASSERT_TRUE(mesh) << mesh.error().line();
  expect_box(*mesh);
  EXPECT_THAT(read_mesh(folder / "none.obj").error().text, HasSubstr("cannot be opened"));
}

}  // namespace
}  // namespace playhouse::mesh
