// Mirrors in pictures: a reflected body is where its mirror image would be, projected; the oracle of whole
// pictures is a camera at the mirror image of the eye, in a scene without the mirror, turned left to right.

#include "playhouse/render/mirrors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "playhouse/render/renderer.h"
#include "playhouse/render/testing_meshes.h"

namespace playhouse::render {
namespace {

using geom::Vec3;

constexpr std::uint32_t kWide = 160, kHigh = 120;

/// A renderer of its own, with shapes of every finish.
struct Studio {
  Studio() {
    Result<std::unique_ptr<Renderer>> made = Renderer::make();
    EXPECT_TRUE(made) << made.error().line();
    renderer = std::move(*made);
    crate = renderer->add_shape(testing::box({0.2, 0.2, 0.2}));
    pane = add_pane(1, 0);
  }
  /// 0.2 m thick, 3 m wide, 2.4 m high.
  std::uint32_t add_pane(float metallic, float roughness) {
    mesh::Mesh mesh = testing::box({0.1, 1.5, 1.2});
    mesh.materials[0].metallic = metallic;
    mesh.materials[0].roughness = roughness;
    return renderer->add_shape(mesh);
  }
  Instance crate_at(const Vec3& p, std::array<float, 4> tint) const {
    Instance instance;
    instance.shape = crate;
    instance.p = p;
    instance.tint = tint;
    instance.segment = 3;
    return instance;
  }
  /// A mirror whose face towards -x of its own frame has its middle at p.
  Instance mirror_at(const Vec3& p, double heading = 0, geom::Tilt tilt = {}) const {
    Instance instance;
    instance.shape = pane;
    instance.q = geom::orientation(heading, tilt);
    instance.p = p + instance.q * Vec3{0.1, 0, 0};
    instance.segment = 9;
    return instance;
  }
  Picture draw(const View& view, const Scene& scene, const Environment& around = {}) {
    std::vector<Picture> pictures;
    renderer->draw(around, scene, {&view, 1}, pictures);
    return std::move(pictures[0]);
  }
  std::unique_ptr<Renderer> renderer;
  std::uint32_t crate = 0, pane = 0;
};

Studio& studio() {
  static Studio* const one = new Studio;
  return *one;
}

constexpr std::array<float, 4> kRed{0.8f, 0.02f, 0.02f, 1}, kGreen{0.02f, 0.7f, 0.02f, 1},
    kBlue{0.02f, 0.02f, 0.8f, 1};

View ahead(Shows shows = Shows::kColor, double heading = 0, double down = 0) {
  View view;
  view.shows = shows;
  view.eye = {0, 0, 1};
  view.q_WC = geom::orientation(heading, {0, down});
  view.half_width = 0.8;
  view.half_height = 0.6;
  view.near = 0.05;
  view.far = 40;
  view.width = kWide;
  view.height = kHigh;
  return view;
}

struct Spot {
  double x = -1, y = -1;  // px
  bool is_in(const View& view) const { return x >= 0 && y >= 0 && x < view.width && y < view.height; }
};

Spot spot_of(const View& view, const Vec3& p) {
  const Axes axes = axes_of(view.q_WC);
  const Vec3 d = p - view.eye;
  const double depth = dot(axes.ahead, d);
  return {0.5 * view.width * (1 - dot(axes.left, d) / depth / view.half_width),
          0.5 * view.height * (1 - dot(axes.up, d) / depth / view.half_height)};
}

Vec3 mirror_image(const Instance& mirror, const Vec3& p) {
  const Vec3 n = mirror.q * Vec3{-1, 0, 0}, at = mirror.p + mirror.q * Vec3{-0.1, 0, 0};
  return p - 2 * dot(n, p - at) * n;
}

std::array<int, 3> rgb_at(const Picture& picture, const View& view, const Spot& spot) {
  EXPECT_TRUE(spot.is_in(view)) << spot.x << " " << spot.y;
  if (!spot.is_in(view)) return {};
  const std::uint32_t rgb =
      picture.sample[static_cast<std::size_t>(spot.y) * view.width + static_cast<std::size_t>(spot.x)];
  return {static_cast<int>(rgb >> 16), static_cast<int>(rgb >> 8 & 0xff), static_cast<int>(rgb & 0xff)};
}

/// 'r', 'g', 'b': twice as bright as the others; else '-'.
char hue_at(const Picture& picture, const View& view, const Spot& spot) {
  const std::array<int, 3> c = rgb_at(picture, view, spot);
  for (std::size_t k = 0; k < 3; ++k)
    if (c[k] > 2 * std::max(c[(k + 1) % 3], c[(k + 2) % 3])) return "rgb"[k];
  return '-';
}

TEST(Mirrors, a_shape_has_the_flat_faces_of_smooth_metal) {
  mesh::Mesh box = testing::box({0.1, 1.5, 1.2});
  EXPECT_TRUE(mirror_faces(box).empty()) << "of another finish";
  box.materials[0].metallic = 0.9f;
  box.materials[0].roughness = 0.05f;
  const std::vector<FlatFace> faces = mirror_faces(box);
  ASSERT_EQ(faces.size(), 6u);
  EXPECT_NEAR(faces[0].area, 3 * 2.4, 1e-6);
  EXPECT_NEAR(std::fabs(faces[0].n.x), 1, 1e-9);
  EXPECT_NEAR(dot(faces[0].n, faces[0].corner[0]), 0.1, 1e-6) << "outwards";
  EXPECT_EQ(faces[0].corner.size(), 4u);
  box.materials[0].roughness = 0.2f;
  EXPECT_TRUE(mirror_faces(box).empty());
  box.materials[0].roughness = 0;
  box.materials[0].metallic = 0;
  EXPECT_TRUE(mirror_faces(box).empty()) << "glass";
  box.materials[0].metallic = 1;
  for (auto& normal : box.surfaces[0].normal) normal = {0.6f, 0.8f, 0};
  EXPECT_TRUE(mirror_faces(box).empty()) << "shaded as if it were curved";
}

TEST(Mirrors, a_thing_of_many_facets_is_no_mirror) {
  mesh::Mesh cone;
  cone.materials.emplace_back();
  cone.materials[0].metallic = 1;
  cone.materials[0].roughness = 0;
  mesh::Surface& surface = cone.surfaces.emplace_back();
  constexpr int kSides = 200;
  for (int k = 0; k < kSides; ++k) {
    const double a = 2 * geom::kPi * k / kSides, b = 2 * geom::kPi * (k + 1) / kSides;
    const Vec3 p[3] = {{std::cos(a), std::sin(a), 0}, {std::cos(b), std::sin(b), 0}, {0, 0, 1}};
    const Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
    const double length = std::sqrt(dot(n, n));
    const auto first = static_cast<std::uint32_t>(surface.p.size());
    for (const Vec3& corner : p) {
      surface.p.push_back(
          {static_cast<float>(corner.x), static_cast<float>(corner.y), static_cast<float>(corner.z)});
      surface.normal.push_back({static_cast<float>(n.x / length), static_cast<float>(n.y / length),
                                static_cast<float>(n.z / length)});
    }
    surface.corners.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(mirror_faces(cone).empty());
}

TEST(Mirrors, a_shape_of_very_many_flat_triangles_has_none) {
  mesh::Mesh box = testing::box({0.1, 1.5, 1.2});
  box.materials[0] = {.metallic = 1, .roughness = 0};
  mesh::Surface& surface = box.surfaces[0];
  const auto first = surface.corners[0];
  surface.corners.resize(65'536, first);
  EXPECT_FALSE(mirror_faces(box).empty());
  surface.corners.push_back(first);
  EXPECT_TRUE(mirror_faces(box).empty());
  for (std::size_t k = 12; k < surface.corners.size(); ++k)
    surface.corners[k] = {first[0], first[0], first[0]};  // no triangles
  EXPECT_EQ(mirror_faces(box).size(), 6u);
}

/// Flat strips around the origin, 3 m from it, two degrees apart, towards it.
mesh::Mesh strips(int count) {
  constexpr double kRadius = 3, kHeight = 2, kStep = geom::kPi / 90;
  mesh::Mesh mesh;
  mesh.materials.push_back({.metallic = 1, .roughness = 0});
  mesh::Surface& surface = mesh.surfaces.emplace_back();
  for (int k = 0; k < count; ++k) {
    const double middle = (k - 0.5 * (count - 1)) * kStep;
    const auto first = static_cast<std::uint32_t>(surface.p.size());
    for (const auto& [side, z] : {std::pair(-0.5, 0.0), {-0.5, kHeight}, {0.5, kHeight}, {0.5, 0.0}}) {
      const double angle = middle + side * kStep;
      surface.p.push_back({static_cast<float>(kRadius * std::cos(angle)),
                           static_cast<float>(kRadius * std::sin(angle)), static_cast<float>(z)});
      surface.normal.push_back(
          {static_cast<float>(-std::cos(middle)), static_cast<float>(-std::sin(middle)), 0});
      surface.uv.push_back({0, 0});
    }
    surface.corners.push_back({first, first + 1, first + 2});
    surface.corners.push_back({first, first + 2, first + 3});
  }
  return mesh;
}

TEST(Mirrors, beside_those_that_are_shown_have_nothing_of_earlier_pictures) {
  const mesh::Mesh mesh = strips(12);
  EXPECT_EQ(mirror_faces(mesh).size(), 12u);
  Studio fresh, used;
  std::vector<Instance> instances{fresh.crate_at({-1, -0.4, 1}, kRed), fresh.crate_at({-1, 0.4, 1.2}, kBlue)};
  Instance& strip = instances.emplace_back();
  strip.shape = fresh.renderer->add_shape(mesh);
  ASSERT_EQ(used.renderer->add_shape(mesh), strip.shape);
  for (const double heading : {-0.2, 0.1, 0.25, 0.02})
    used.draw(ahead(Shows::kColor, heading), {.instances = instances});
  const View view = ahead(Shows::kColor, 0.05);
  const Picture picture = fresh.draw(view, {.instances = instances});
  EXPECT_EQ(used.draw(view, {.instances = instances}).sample, picture.sample);
  mesh::Mesh matt = mesh;
  matt.materials[0] = {.metallic = 0, .roughness = 1};
  strip.shape = fresh.renderer->add_shape(matt);
  EXPECT_NE(fresh.draw(view, {.instances = instances}).sample, picture.sample);
}

TEST(Mirrors, show_what_is_before_them_where_its_mirror_image_is) {
  Studio& in = studio();
  // Beside and behind the eye, none of them in the direct picture.
  const std::vector<std::pair<Vec3, std::array<float, 4>>> things{
      {{-0.5, 0.8, 1.3}, kRed}, {{-0.5, -0.8, 0.7}, kGreen}, {{-1, -0.2, 1.9}, kBlue}};
  struct Pose {
    Vec3 p;
    double heading;
    geom::Tilt tilt;
  };
  for (const Pose& pose : {Pose{{4, 0, 1.2}, 0, {}},
                           {{4, 0.3, 1.2}, 0.06, {}},
                           {{4, 0, 1.2}, -0.05, {0, 0.07}},
                           {{3.5, 0, 1.3}, 0.02, {0.4, -0.05}}}) {
    std::vector<Instance> instances{in.mirror_at(pose.p, pose.heading, pose.tilt)};
    for (const auto& [p, tint] : things) instances.push_back(in.crate_at(p, tint));
    const View view = ahead();
    const Picture picture = in.draw(view, {.instances = instances});
    for (std::size_t k = 0; k < things.size(); ++k) {
      const Spot spot = spot_of(view, mirror_image(instances[0], things[k].first));
      EXPECT_EQ(hue_at(picture, view, spot), "rgb"[k])
          << k << " at " << spot.x << " " << spot.y << ", heading " << pose.heading;
    }
  }
}

TEST(Mirrors, show_the_picture_of_an_eye_behind_them_turned_left_to_right) {
  Studio& in = studio();
  constexpr double kAt = 4, kHeading = 0.1, kDown = 0.05;
  std::vector<Instance> before{in.crate_at({1.5, 0.9, 0.2}, kRed), in.crate_at({-1, -1.2, 0.6}, kGreen),
                               in.crate_at({2.5, -0.7, 1.5}, kBlue), in.crate_at({-3, 0.4, 1}, kRed)};
  Figure person;
  person.p = {-2, 1.2, 0};
  const Lamp lamp{.p = {1, -1, 2}, .light = {8, 8, 8}};
  std::vector<Instance> with = before;
  with.push_back(in.mirror_at({kAt, 0, 1.2}));
  with.push_back(in.crate_at({6, 0, 1}, kBlue));  // behind it
  const View view = ahead(Shows::kColor, kHeading, kDown),
             of_models = ahead(Shows::kSegments, kHeading, kDown);
  View other = ahead(Shows::kColor, geom::kPi - kHeading, kDown);
  other.eye = {2 * kAt, 0, 1};
  Environment foggy;
  foggy.to_sun = {-0.48, 0.36, 0.8};
  for (const double visibility : {0.0, 15.0}) {
    foggy.visibility = visibility;
    const Picture seen = in.draw(view, {with, {&person, 1}, {}, {&lamp, 1}}, foggy);
    const Picture oracle = in.draw(other, {before, {&person, 1}, {}, {&lamp, 1}}, foggy);
    const Picture models = in.draw(of_models, {with, {&person, 1}, {}, {}});
    int count = 0, differ = 0;
    for (std::uint32_t y = 1; y + 1 < kHigh; ++y)
      for (std::uint32_t x = 1; x + 1 < kWide; ++x) {
        bool is_inside = true;
        for (const std::uint32_t at :
             {y * kWide + x - 1, y * kWide + x + 1, (y - 1) * kWide + x, (y + 1) * kWide + x})
          is_inside = is_inside && models.sample[at] == 9;
        if (!is_inside || models.sample[y * kWide + x] != 9) continue;
        ++count;
        const std::array<int, 3> a = rgb_at(seen, view, {x + 0.5, y + 0.5}),
                                 b = rgb_at(oracle, other, {kWide - x - 0.5, y + 0.5});
        for (std::size_t k = 0; k < 3; ++k)
          if (std::abs(a[k] - b[k]) > 3) {
            ++differ;
            break;
          }
      }
    EXPECT_GT(count, 3500);
    // Edges of bodies and of shadows fall on pixels by their last bits.
    EXPECT_LT(differ, count / 50) << "visibility " << visibility;
  }
}

TEST(Mirrors, hide_what_is_behind_them_and_what_they_show_is_not_before_them) {
  Studio& in = studio();
  std::vector<Instance> instances{in.mirror_at({4, 0, 1.2}), in.crate_at({-0.5, 0.8, 1.3}, kRed)};
  const View view = ahead();
  Environment overcast;
  overcast.sun = 0;
  const Picture alone = in.draw(view, {.instances = instances}, overcast);
  // One anywhere behind, also where the eye's mirror image is.
  for (const Vec3& p : {Vec3{6, 0, 1}, Vec3{4.5, -0.5, 1.4}, Vec3{7.8, 0, 1}}) {
    instances.push_back(in.crate_at(p, kGreen));
    EXPECT_EQ(in.draw(view, {.instances = instances}, overcast).sample, alone.sample) << p.x;
    instances.pop_back();
  }
  Smoke smoke;
  smoke.p = {6, 0, 1};
  smoke.half = {0.8, 0.8, 0.8};
  EXPECT_EQ(in.draw(view, {.instances = instances, .smokes = {&smoke, 1}}, overcast).sample, alone.sample);
  smoke.p = {-2, 0, 1};
  const Picture smoky = in.draw(view, {.instances = instances, .smokes = {&smoke, 1}}, overcast);
  const Spot spot = spot_of(view, mirror_image(instances[0], smoke.p));
  EXPECT_NE(rgb_at(smoky, view, spot), rgb_at(alone, view, spot)) << "smoke behind the eye is seen";
}

TEST(Mirrors, on_the_floor_show_sky_and_what_is_above_them_upside_down) {
  Studio& in = studio();
  std::vector<Instance> instances{in.mirror_at({2.5, 0, 0.05}, 0, {0, geom::kPi / 2}),
                                  in.crate_at({4, 0.8, 1.1}, kRed), in.crate_at({4, 0.8, 1.5}, kBlue),
                                  in.crate_at({2.5, 0, -0.5}, kGreen)};
  Smoke smoke;
  smoke.p = {4.5, -0.4, 1.5};
  smoke.half = {0.6, 0.6, 0.6};
  smoke.tint = {1, 0.4f, 0.4f, 1};
  const View view = ahead();
  const Picture picture = in.draw(view, {.instances = instances, .smokes = {&smoke, 1}});
  const Spot red = spot_of(view, mirror_image(instances[0], instances[1].p)),
             blue = spot_of(view, mirror_image(instances[0], instances[2].p));
  EXPECT_LT(red.y, blue.y);
  EXPECT_EQ(hue_at(picture, view, red), 'r');
  EXPECT_EQ(hue_at(picture, view, blue), 'b');
  const std::array<int, 3> sky = rgb_at(picture, view, spot_of(view, {2, 0.8, 0.05}));
  EXPECT_GT(sky[2], sky[0] + 30);
  const std::array<int, 3> direct = rgb_at(picture, view, spot_of(view, smoke.p)),
                           mirrored =
                               rgb_at(picture, view, spot_of(view, mirror_image(instances[0], smoke.p)));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(mirrored[k], direct[k], 15) << "smoke is as bright " << k;
}

TEST(Mirrors, show_the_body_that_carries_the_camera_though_the_camera_does_not) {
  Studio& in = studio();
  std::vector<Instance> instances{in.mirror_at({4, 0, 1.2}), in.crate_at({0, 0, 1}, kRed)};
  instances[1].group = 5;
  View view = ahead();
  view.hides = 5;
  EXPECT_EQ(hue_at(in.draw(view, {.instances = instances}), view, {0.5 * kWide, 0.5 * kHigh}), 'r');
}

TEST(Mirrors, two_in_one_picture_each_show_their_own) {
  Studio& in = studio();
  std::vector<Instance> instances{in.mirror_at({4, 1.7, 1.2}, 0.35), in.mirror_at({4, -1.7, 1.2}, -0.35),
                                  in.crate_at({1.2, 2.6, 1.2}, kRed), in.crate_at({1.2, -2.6, 0.8}, kBlue)};
  const View view = ahead();
  const Picture picture = in.draw(view, {.instances = instances});
  const Spot left = spot_of(view, mirror_image(instances[0], instances[2].p)),
             right = spot_of(view, mirror_image(instances[1], instances[3].p));
  EXPECT_LT(left.x, 0.5 * kWide);
  EXPECT_GT(right.x, 0.5 * kWide);
  EXPECT_EQ(hue_at(picture, view, left), 'r');
  EXPECT_EQ(hue_at(picture, view, right), 'b');
}

TEST(Mirrors, of_six_planes_the_four_largest_in_the_picture_reflect) {
  Studio& in = studio();
  // A pane each, turned a little so that none is in the plane of another; the last ones are farther away.
  std::vector<Instance> panes;
  for (int k = 0; k < 6; ++k)
    panes.push_back(in.mirror_at(
        {k < 4 ? 10.0 : 18.0, (k < 4 ? 3.4 : 3.6) * (k < 4 ? k - 1.5 : 5.0 * (k - 4.5)), k < 4 ? 1.2 : 5.0},
        0.01 * k));
  MirrorList list;
  View view = ahead();
  list.begin(view, axes_of(view.q_WC));
  mesh::Mesh mesh = testing::box({0.1, 1.5, 1.2});
  mesh.materials[0] = {.metallic = 1, .roughness = 0};
  const std::vector<FlatFace> faces = mirror_faces(mesh);
  for (std::size_t k = panes.size(); k-- > 0;) list.add(panes[k].p - view.eye, panes[k].q, faces);
  list.finish();
  ASSERT_EQ(list.mirrors().size(), kMostMirrors);
  for (const Mirror& mirror : list.mirrors()) {
    EXPECT_LT(mirror.depth, 11);
    EXPECT_GT(mirror.pixels, 300);
  }
  // Two panes in one plane are one mirror.
  list.begin(view, axes_of(view.q_WC));
  for (const double y : {-1.6, 1.6}) list.add(Vec3{10, y, 0.5}, {}, faces);
  list.finish();
  std::size_t same = 0;
  for (const Mirror& mirror : list.mirrors()) same += mirror.n.x < -0.99;
  EXPECT_EQ(same, 1u);
}

TEST(Mirrors, a_window_holds_all_pixels_of_its_mirror) {
  Studio& in = studio();
  for (const double heading : {0.0, 0.7, -1.1}) {
    const Instance pane = in.mirror_at({2.5, 0.8, 1.5}, heading, {0.2, 0.3});
    const std::vector<Instance> all{pane};
    const View view = ahead(Shows::kSegments);
    MirrorList list;
    list.begin(view, axes_of(view.q_WC));
    mesh::Mesh mesh = testing::box({0.1, 1.5, 1.2});
    mesh.materials[0] = {.metallic = 1, .roughness = 0};
    const std::vector<FlatFace> faces = mirror_faces(mesh);
    list.add(pane.p - view.eye, pane.q, faces);
    list.finish();
    double pixels = 0;
    for (const Mirror& mirror : list.mirrors()) pixels += mirror.pixels;
    const Picture picture = in.draw(view, {.instances = all});
    int shown = 0, outside = 0;
    for (std::uint32_t y = 0; y < kHigh; ++y)
      for (std::uint32_t x = 0; x < kWide; ++x) {
        if (picture.sample[y * kWide + x] != 9) continue;
        ++shown;
        bool is_held = false;
        for (const Mirror& mirror : list.mirrors())
          is_held = is_held || (x >= mirror.window.left && x < mirror.window.right &&
                                y >= mirror.window.high && y < mirror.window.low);
        outside += !is_held;
      }
    EXPECT_EQ(outside, 0) << heading;
    EXPECT_NEAR(shown, pixels, 0.03 * pixels + 20) << heading;
  }
}

TEST(Mirrors, a_mirror_within_a_mirror_is_plain_metal) {
  Studio& in = studio();
  // Two facing ones, the eye between them; a crate between them is seen once in the first.
  std::vector<Instance> instances{in.mirror_at({3, 0, 1.2}), in.mirror_at({-3, 0, 1.2}, geom::kPi),
                                  in.crate_at({-1, 1.1, 1}, kRed)};
  const View view = ahead();
  const Picture picture = in.draw(view, {.instances = instances});
  EXPECT_EQ(hue_at(picture, view, spot_of(view, mirror_image(instances[0], instances[2].p))), 'r');
  const Vec3 twice = mirror_image(instances[0], mirror_image(instances[1], instances[2].p));
  EXPECT_EQ(hue_at(picture, view, spot_of(view, twice)), '-');
}

TEST(Mirrors, tint_and_roughness_of_a_material_count) {
  Studio& in = studio();
  std::vector<Instance> instances{in.mirror_at({4, 0, 1.2}),
                                  in.crate_at({-0.5, 0.8, 1.3}, {0.8f, 0.8f, 0.8f, 1})};
  const View view = ahead();
  const Spot spot = spot_of(view, mirror_image(instances[0], instances[1].p));
  instances[0].tint = {0.02f, 0.02f, 0.8f, 1};
  EXPECT_EQ(hue_at(in.draw(view, {.instances = instances}), view, spot), 'b')
      << "a blue mirror, a white crate";
  instances[0].tint = {1, 1, 1, 1};
  instances[1].tint = kRed;
  instances[0].shape = in.add_pane(0.85f, 0);
  EXPECT_EQ(hue_at(in.draw(view, {.instances = instances}), view, spot), 'r') << "polished steel";
  for (const auto& [metallic, roughness] : {std::pair(0.85f, 0.35f), {0.0f, 0.0f}}) {
    instances[0].shape = in.add_pane(metallic, roughness);
    EXPECT_EQ(hue_at(in.draw(view, {.instances = instances}), view, spot), '-') << metallic;
  }
}

TEST(Mirrors, of_very_large_pictures_are_coarser_and_in_the_same_place) {
  Studio& in = studio();
  const std::vector<Instance> instances{in.mirror_at({4, 0.3, 1.2}, 0.06),
                                        in.crate_at({-0.5, 0.8, 1.3}, kRed)};
  View view = ahead();
  view.width = 3401;  // odd, and with more than 2^23 pixels
  view.height = 2551;
  const Picture picture = in.draw(view, {.instances = instances});
  const Vec3 crate = instances[1].p;
  for (const double aside : {-0.18, 0.18})  // half its width is 0.2 m
    EXPECT_EQ(hue_at(picture, view, spot_of(view, mirror_image(instances[0], crate + Vec3{0.2, aside, 0}))),
              'r');
  for (const double aside : {-0.22, 0.22})
    EXPECT_EQ(hue_at(picture, view, spot_of(view, mirror_image(instances[0], crate + Vec3{0.2, aside, 0}))),
              '-');
}

TEST(Mirrors, change_neither_depths_nor_segments) {
  Studio& in = studio();
  std::vector<Instance> instances{in.mirror_at({4, 0, 1.2}), in.crate_at({-0.5, 0.8, 1.3}, kRed)};
  const std::uint32_t matt = in.add_pane(0, 1);
  for (const Shows shows : {Shows::kDepth, Shows::kSegments}) {
    const View view = ahead(shows);
    instances[0].shape = in.pane;
    const Picture mirror = in.draw(view, {.instances = instances});
    instances[0].shape = matt;
    const Picture wall = in.draw(view, {.instances = instances});
    EXPECT_EQ(mirror.depth, wall.depth);
    EXPECT_EQ(mirror.sample, wall.sample);
  }
}

TEST(Mirrors, are_the_same_to_the_bit_and_leave_no_trace_in_other_pictures) {
  Studio& in = studio();
  const std::vector<Instance> with{in.mirror_at({4, 0, 1.2}, 0.04, {0, 0.03}),
                                   in.crate_at({-0.5, 0.8, 1.3}, kRed), in.crate_at({3, -0.4, 0.2}, kGreen)};
  const std::span<const Instance> without(with.data() + 1, 2);
  Figure person;
  person.p = {2, 1, 0};
  Smoke smoke;
  smoke.p = {1.5, -1, 0.8};
  smoke.half = {0.5, 0.5, 0.5};
  const View view = ahead();
  const auto scene = [&](std::span<const Instance> instances) {
    return Scene{instances, {&person, 1}, {&smoke, 1}, {}};
  };
  Studio fresh;  // the same shapes by the same numbers
  const Picture before = fresh.draw(view, scene(without)), mirror = fresh.draw(view, scene(with));
  EXPECT_NE(before.sample, mirror.sample);
  EXPECT_EQ(fresh.draw(view, scene(without)).sample, before.sample) << "after a picture with a mirror";
  EXPECT_EQ(fresh.draw(view, scene(with)).sample, mirror.sample);
  EXPECT_EQ(in.draw(view, scene(with)).sample, mirror.sample) << "by another renderer";
  // Of a page of pictures of several sizes.
  View large = view;
  large.width = 2 * kWide;
  const std::vector<View> views{large, view, ahead(Shows::kDepth), view};
  std::vector<Picture> pictures;
  fresh.renderer->draw({}, scene(with), views, pictures);
  int differ = 0;
  for (const std::size_t k : {std::size_t{1}, std::size_t{3}})
    for (std::size_t i = 0; i < mirror.sample.size(); ++i)
      differ += pictures[k].sample[i] != mirror.sample[i];
  EXPECT_LT(differ, kWide * kHigh / 50) << "the last bits depend on the place in the page";
  EXPECT_EQ(hue_at(pictures[3], view, spot_of(view, mirror_image(with[0], with[1].p))), 'r');
}

}  // namespace
}  // namespace playhouse::render
