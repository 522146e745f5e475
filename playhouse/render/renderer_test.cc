// Pictures, against where a pinhole would have things and what rays meet.

#include "playhouse/render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <tuple>

#include "playhouse/base/rng.h"
#include "playhouse/render/testing_meshes.h"

namespace playhouse::render {
namespace {

using geom::Vec3;

/// One for all tests, never deleted: making one takes long.
Renderer& renderer() {
  static Renderer* const one = [] {
    Result<std::unique_ptr<Renderer>> made = Renderer::make();
    EXPECT_TRUE(made) << made.error().line();
    return made ? std::move(*made).release() : nullptr;
  }();
  return *one;
}

std::uint32_t unit_box() {
  static const std::uint32_t shape = renderer().add_shape(testing::box({0.5, 0.5, 0.5}));
  return shape;
}

/// From above the origin along +x; 80 x 60 pixels.
View lookout(Shows shows, double height = 1, double down = 0) {
  View view;
  view.shows = shows;
  view.eye = {0, 0, height};
  view.q_WC = geom::orientation(0, {0, down});
  view.half_width = 0.8;
  view.half_height = 0.6;
  view.near = 0.05;
  view.far = 30;
  view.width = 80;
  view.height = 60;
  return view;
}

Instance box_at(const Vec3& p, std::array<float, 4> tint = {1, 0, 0, 1}, std::uint32_t segment = 7) {
  Instance instance;
  instance.shape = unit_box();
  instance.p = p;
  instance.tint = tint;
  instance.segment = segment;
  return instance;
}

/// The sun is straight above.
Environment noon() {
  return {};
}

struct Shot {
  View view;
  Picture picture;
  std::uint32_t sample(std::uint32_t x, std::uint32_t y) const { return picture.sample[y * view.width + x]; }
  double depth(std::uint32_t x, std::uint32_t y) const { return picture.depth[y * view.width + x]; }
  int red(std::uint32_t x, std::uint32_t y) const { return static_cast<int>(sample(x, y) >> 16); }
  int green(std::uint32_t x, std::uint32_t y) const { return static_cast<int>(sample(x, y) >> 8 & 0xff); }
  int blue(std::uint32_t x, std::uint32_t y) const { return static_cast<int>(sample(x, y) & 0xff); }
};

Shot shot(const View& view, const Scene& scene, const Environment& around = noon()) {
  std::vector<Picture> pictures;
  renderer().draw(around, scene, {&view, 1}, pictures);
  return {view, std::move(pictures[0])};
}

/// The direction of a pixel's middle, 1 along the way it looks.
Vec3 ray(const View& view, double x, double y) {
  const Axes axes = axes_of(view.q_WC);
  return axes.ahead + view.half_width * (1 - (2 * x + 1) / view.width) * axes.left +
         view.half_height * (1 - (2 * y + 1) / view.height) * axes.up;
}

TEST(Renderer, a_box_is_where_a_pinhole_has_it_in_colour_depth_and_segments) {
  // Its near face is 2 m ahead, 1 m wide and high, its middle half a metre to the left and at the height of
  // the eye.
  const std::vector<Instance> boxes{box_at({2.5, 0.5, 1})};
  const Scene scene{.instances = boxes};
  const Shot color = shot(lookout(Shows::kColor), scene), depth = shot(lookout(Shows::kDepth), scene),
             segments = shot(lookout(Shows::kSegments), scene);
  // 0 .. 1 m left at 2 m: 0 .. 0.5 of 0.8, so columns 40 - 25 .. 39; up and down 0.25 of 0.6: rows 17.5
  // .. 42.5.
  for (const auto& [x, y, seen] : {std::tuple(39u, 30u, true),
                                   {16u, 30u, true},
                                   {13u, 30u, false},
                                   {41u, 30u, false},
                                   {27u, 18u, true},
                                   {27u, 16u, false},
                                   {27u, 41u, true},
                                   {27u, 44u, false}}) {
    EXPECT_EQ(segments.sample(x, y), seen ? 7u : 0u) << x << " " << y;
    EXPECT_EQ(color.red(x, y) > 2 * color.green(x, y), seen) << x << " " << y;
    if (seen) EXPECT_NEAR(depth.depth(x, y), 2, 1e-4) << x << " " << y;
  }
  EXPECT_EQ(depth.depth(70, 5), 0) << "the sky";
  EXPECT_GT(color.blue(70, 5), color.red(70, 5));
}

TEST(Renderer, the_floor_is_as_far_as_it_is) {
  View view = lookout(Shows::kDepth, 0.7, 0.15);
  view.far = 20;
  const Shot depth = shot(view, {});
  int floor = 0;
  for (std::uint32_t y = 0; y < 60; ++y)
    for (std::uint32_t x = 0; x < 80; ++x) {
      const Vec3 d = ray(view, x, y);
      const double t = d.z < 0 ? 0.7 / -d.z : 1e9;
      if (std::fabs(t - view.far) < 0.01) continue;
      EXPECT_NEAR(depth.depth(x, y), t < view.far ? t : 0, 5e-4) << x << " " << y;
      floor += t < view.far;
    }
  EXPECT_GT(floor, 2000);
}

TEST(Renderer, a_face_that_lies_on_the_floor_hides_it) {
  const std::uint32_t slab = renderer().add_shape(testing::box({4, 4, 0.5}));
  for (const double height : {0.1, 0.7, 2.0, 15.0})
    for (const double heading : {0.0, 0.3, 1.0}) {
      View view = lookout(Shows::kSegments, height, 0.2);
      view.eye = {101.3, -57.1, height};
      view.q_WC = geom::orientation(heading, {0, std::atan2(height, 5)});  // at what is 5 m away
      std::vector<Instance> slabs{
          box_at({101.3 + 5 * std::cos(heading), -57.1 + 5 * std::sin(heading), -0.5})};
      slabs[0].shape = slab;
      slabs[0].q = geom::orientation(heading, {});
      const Shot segments = shot(view, {.instances = slabs});
      view.shows = Shows::kColor;
      const Shot color = shot(view, {.instances = slabs});
      int seen = 0, hidden = 0;
      for (std::uint32_t y = 0; y < 60; ++y)
        for (std::uint32_t x = 0; x < 80; ++x) {
          const Vec3 d = ray(view, x, y);
          const Vec3 p = height / -d.z * d;
          const double along = std::cos(heading) * p.x + std::sin(heading) * p.y - 5,
                       across = std::cos(heading) * p.y - std::sin(heading) * p.x;
          if (d.z >= 0 || std::fabs(along) > 3.9 || std::fabs(across) > 3.9) continue;
          ++seen;
          hidden += segments.sample(x, y) != 7 || color.red(x, y) < 2 * color.green(x, y);
        }
      EXPECT_GT(seen, 100);
      EXPECT_EQ(hidden, 0) << "from " << height << " m, " << heading << " rad";
    }
}

/// Along the ray from the origin: how far to the outside of a unit box at p, turned by q; 0: never, or nearer
/// than `near`.
double to_box(const Vec3& d, const Vec3& p, const geom::Quaternion& q, double near) {
  const geom::Quaternion back{q.w, -q.x, -q.y, -q.z};
  const Vec3 from = back * (-1 * p), along = back * d;
  const double o[3] = {from.x, from.y, from.z}, v[3] = {along.x, along.y, along.z};
  double first = -1e300, last = 1e300;
  for (int k = 0; k < 3; ++k) {
    const double a = (-0.5 - o[k]) / v[k], b = (0.5 - o[k]) / v[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first < last && first >= near ? first : 0;
}

/// Graphics cards snap corners to 1/256 of a pixel, and a pixel of a slanted face spans decimetres: how far
/// aside of its middle a pixel may show a face. [pixels]
double snap() {
  return renderer().name().starts_with("llvmpipe") ? 0 : 1.0 / 128;
}

/// Depth of the first box on the ray of a pixel; 0: none.
double nearest(const std::vector<Instance>& boxes, const View& view, double x, double y) {
  double nearest = 0;
  for (const Instance& box : boxes) {
    const double t = to_box(ray(view, x, y), box.p - view.eye, box.q, view.near);
    if (t > 0 && (nearest == 0 || t < nearest)) nearest = t;
  }
  return nearest;
}

TEST(Renderer, boxes_that_lie_in_any_way_are_where_rays_meet_them) {
  constexpr double kEdge = 0.05;  // m; what is further apart is of different faces
  const double aside = snap();
  Rng rng(5);
  for (int trial = 0; trial < 6; ++trial) {
    View view = lookout(Shows::kDepth, 1e-9);  // far from W's origin, and no floor
    view.eye = {3e5 * trial, -2e5, -5};
    view.near = 1.2;
    view.q_WC = geom::orientation(rng.uniform(-3, 3), {rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)});
    const Axes axes = axes_of(view.q_WC);
    std::vector<Instance> boxes;
    for (int k = 0; k < 25; ++k) {
      const Vec3 p = view.eye + rng.uniform(0.5, 9) * (axes.ahead + rng.uniform(-0.8, 0.8) * axes.left +
                                                       rng.uniform(-0.6, 0.6) * axes.up);
      boxes.push_back(box_at(p));
      boxes.back().q = geom::orientation(rng.uniform(-3, 3), {rng.uniform(-2, 2), rng.uniform(-2, 2)});
    }
    const Shot depth = shot(view, {boxes, {}, {}});
    int wrong = 0, met = 0;
    for (std::uint32_t y = 0; y < 60; ++y)
      for (std::uint32_t x = 0; x < 80; ++x) {
        const double expected = nearest(boxes, view, x, y);
        double slack = 1e-3;
        for (const auto& [right, down] :
             {std::pair(aside, 0.0), {-aside, 0.0}, {0.0, aside}, {0.0, -aside}}) {
          const double difference = std::fabs(nearest(boxes, view, x + right, y + down) - expected);
          if (difference < kEdge) slack = std::max(slack, 1e-3 + difference);
        }
        met += expected > 0;
        wrong += std::fabs(depth.depth(x, y) - expected) > slack;
      }
    EXPECT_GT(met, 500);
    EXPECT_LT(wrong, 12) << "of 4800: what is on an edge may be on either side";
  }
}

TEST(Renderer, things_throw_shadows_also_those_that_the_view_does_not_show) {
  std::vector<Instance> boxes{box_at({4, 0, 2.5}, {1, 1, 1, 1})};
  View view = lookout(Shows::kColor, 1.5, 0.35);
  const Vec3 below{4, 0, 0}, beside{4, 1.6, 0};
  const auto pixel_of = [&](const Vec3& p) {
    const Axes axes = axes_of(view.q_WC);
    const Vec3 q = p - view.eye;
    const double depth = dot(axes.ahead, q);
    return std::pair(static_cast<std::uint32_t>(40 * (1 - dot(axes.left, q) / depth / view.half_width)),
                     static_cast<std::uint32_t>(30 * (1 - dot(axes.up, q) / depth / view.half_height)));
  };
  const auto bright = [&](const Shot& of, const Vec3& p) {
    const auto [x, y] = pixel_of(p);
    return of.green(x, y);
  };
  const Shot with = shot(view, {boxes, {}, {}}), without = shot(view, {});
  EXPECT_LT(bright(with, below), bright(with, beside) - 30);
  EXPECT_NEAR(bright(with, beside), bright(without, beside), 2);
  view.hides = boxes[0].group = 3;
  EXPECT_LT(bright(shot(view, {boxes, {}, {}}), below), bright(with, beside) - 30)
      << "hidden, and in the light all the same";
  Environment night = noon();
  night.to_sun = {1, 0, -0.1};
  EXPECT_NEAR(bright(shot(view, {boxes, {}, {}}, night), below), bright(shot(view, {}, night), below), 2)
      << "the sun has set";
}

TEST(Renderer, one_sees_through_glass_and_smoke_in_colours_alone) {
  std::vector<Instance> boxes{box_at({6.5, 0, 1}, {0, 0, 1, 1}, 1), box_at({3.5, 0, 1}, {1, 0, 0, 0.4f}, 2)};
  boxes[0].shape = renderer().add_shape(testing::box({0.5, 5, 5}));
  const Scene glass{boxes, {}, {}};
  const Shot through = shot(lookout(Shows::kColor), glass);
  EXPECT_GT(through.red(40, 30), 80);
  EXPECT_GT(through.blue(40, 30), 80);
  EXPECT_LT(through.red(75, 30), 40) << "beside the glass";
  EXPECT_NEAR(shot(lookout(Shows::kDepth), glass).depth(40, 30), 3, 1e-3);
  EXPECT_EQ(shot(lookout(Shows::kSegments), glass).sample(40, 30), 2u);

  Smoke smoke;
  smoke.p = {3.5, 0, 1};
  smoke.half = {1, 1, 1};
  smoke.tint = {1, 1, 1, 1};
  const Scene fire{{boxes.data(), 1}, {}, {&smoke, 1}}, clear{{boxes.data(), 1}, {}, {}};
  const Shot before = shot(lookout(Shows::kColor), clear), in_smoke = shot(lookout(Shows::kColor), fire);
  EXPECT_GT(in_smoke.red(40, 30), before.red(40, 30) + 60);
  EXPECT_EQ(in_smoke.sample(2, 30), before.sample(2, 30));
  EXPECT_EQ(shot(lookout(Shows::kDepth), fire).picture.depth,
            shot(lookout(Shows::kDepth), clear).picture.depth);
  smoke.p.x = 9;  // behind the wall
  EXPECT_EQ(shot(lookout(Shows::kColor), fire).picture.sample, before.picture.sample);
}

TEST(Renderer, fog_takes_contrast_with_distance) {
  Environment around = noon();
  around.fog = {0.5f, 0.5f, 0.5f};
  const auto red_at = [&](double x) {
    const std::vector<Instance> boxes{box_at({x + 0.5, 0, 1}, {0, 0, 0, 1})};
    return linear(static_cast<float>(shot(lookout(Shows::kColor), {boxes, {}, {}}, around).red(40, 30)) /
                  255);
  };
  const double clear = red_at(8);
  around.visibility = 10;
  for (const double x : {2.0, 5.0, 10.0})  // 5 % are left at 10 m
    EXPECT_NEAR(red_at(x), 0.5 + (clear - 0.5) * std::exp(-3 * x / 10), 0.02) << x;
}

TEST(Renderer, textures_stand_upright_and_holes_are_holes) {
  mesh::Mesh poster = testing::box({0.01, 1, 1});
  poster.materials[0].texture = 0;
  // Red and green above, blue and nothing below.
  mesh::Image& image = poster.images.emplace_back();
  image.width = image.height = 16;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const std::array<std::uint8_t, 4> quarters[4] = {
          {255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {}};
      const auto& quarter = quarters[y / 8 * 2 + x / 8];
      image.rgba.insert(image.rgba.end(), quarter.begin(), quarter.end());
    }
  mesh::Surface face;
  face.p = {{0, 1, 1},
            {0, -1, 1},
            {0, -1, -1},
            {0, 1, -1}};  // from the left above, as seen from the eye, clockwise
  face.normal.assign(4, {-1, 0, 0});
  face.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  face.corners = {{0, 3, 2}, {0, 2, 1}};
  poster.surfaces = {face};
  Instance instance;
  instance.shape = renderer().add_shape(poster);
  instance.p = {2, 0, 1};
  const std::vector<Instance> all{instance};
  const Shot color = shot(lookout(Shows::kColor), {all, {}, {}});
  const auto is = [&](std::uint32_t x, std::uint32_t y, bool r, bool g, bool b) {
    return (color.red(x, y) > 70) == r && (color.green(x, y) > 70) == g && (color.blue(x, y) > 70) == b;
  };
  EXPECT_TRUE(is(20, 10, true, false, false)) << std::hex << color.sample(20, 10);
  EXPECT_TRUE(is(60, 10, false, true, false)) << std::hex << color.sample(60, 10);
  EXPECT_TRUE(is(20, 50, false, false, true)) << std::hex << color.sample(20, 50);
  EXPECT_TRUE(is(60, 50, true, true, true)) << "the floor: " << std::hex << color.sample(60, 50);
}

TEST(Renderer, people_are_where_they_stand_and_their_levels_look_alike) {
  Figure person;
  person.p = {4, 0, 0};
  person.segment = 9;
  const std::vector<Figure> people{person};
  View view = lookout(Shows::kSegments);
  const auto count_at = [&](std::uint32_t scale) {
    view.width = 80 * scale;
    view.height = 60 * scale;
    const Shot of = shot(view, {{}, people, {}});
    return static_cast<double>(std::ranges::count(of.picture.sample, 9u)) / (scale * scale);
  };
  const double coarse = count_at(1), middle = count_at(2), fine = count_at(6);
  EXPECT_GT(fine, 80);
  EXPECT_NEAR(coarse, fine, 0.15 * fine);
  EXPECT_NEAR(middle, fine, 0.10 * fine);
  view = lookout(Shows::kDepth);
  EXPECT_NEAR(shot(view, {{}, people, {}}).depth(40, 28), 4 - 0.1, 0.1) << "its chest";
}

TEST(Renderer, another_thread_and_another_renderer_draw_the_same_pictures_of_a_tick) {
  std::vector<Instance> boxes;
  for (int k = 0; k < 30; ++k)
    boxes.push_back(box_at({3 + 0.4 * k, 0.7 * (k % 7) - 2, 0.5},
                           {0.1f * static_cast<float>(k % 10), 0.5f, 0.2f, 1}, 1 + k));
  std::vector<View> views;
  for (int k = 0; k < 12; ++k) {
    views.push_back(lookout(static_cast<Shows>(k % 3), 1 + 0.1 * k, 0.1));
    views.back().width = static_cast<std::uint32_t>(40 + 8 * k);
  }
  const Scene scene{.instances = boxes};
  std::vector<Picture> here, there, alone;
  renderer().draw(noon(), scene, views, here);
  std::thread other([&] { renderer().draw(noon(), scene, views, there); });
  other.join();
  Result<std::unique_ptr<Renderer>> second = Renderer::make();
  ASSERT_TRUE(second);
  for (Instance& box : boxes) box.shape = 0;
  (*second)->add_shape(testing::box({0.5, 0.5, 0.5}));
  (*second)->draw(noon(), scene, views, alone);
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(here[i].sample, there[i].sample) << i;
    EXPECT_EQ(here[i].depth, there[i].depth) << i;
    EXPECT_EQ(here[i].sample, alone[i].sample) << i;
    EXPECT_EQ(here[i].depth, alone[i].depth) << i;
    EXPECT_EQ(here[i].sample.size() + here[i].depth.size(), std::size_t{views[i].width} * views[i].height);
  }
}

/// Everything is dark but for lamps.
Environment dark() {
  Environment around;
  around.sun = around.ambient = 0;
  around.floor = {0.5f, 0.5f, 0.5f};
  return around;
}

/// How blue a black box of this opacity is before the sky; with a texture of one pixel where that is not
/// clear.
int blue_of(mesh::Opacity opacity, float alpha, std::array<std::uint8_t, 4> pixel = {}) {
  mesh::Mesh box = testing::box({0.5, 0.5, 0.5});
  box.materials[0].base = {0, 0, 0, alpha};
  box.materials[0].opacity = opacity;
  if (pixel[3] != 0) {
    box.materials[0].texture = 0;
    box.images.push_back({1, 1, {pixel.begin(), pixel.end()}});
  }
  std::vector<Instance> boxes{box_at({3, 0, 5})};
  boxes[0].shape = renderer().add_shape(box);
  boxes[0].tint = {1, 1, 1, 1};
  return shot(lookout(Shows::kColor, 5), {.instances = boxes}).blue(40, 30);
}

TEST(Renderer, opacity_is_nothing_holes_or_glass_as_a_material_says) {
  using mesh::Opacity;
  const std::array<std::uint8_t, 4> faint{255, 255, 255, 100};
  const int sky = blue_of(Opacity::kHoles, 0.4f), box = blue_of(Opacity::kSolid, 1);
  EXPECT_GT(sky, 200);
  EXPECT_LT(box, 100);
  EXPECT_EQ(blue_of(Opacity::kHoles, 0.6f), box);
  EXPECT_EQ(blue_of(Opacity::kHoles, 1, faint), sky);
  EXPECT_EQ(blue_of(Opacity::kSolid, 1, faint), box);
  for (const int clear : {blue_of(Opacity::kClear, 0.4f), blue_of(Opacity::kClear, 1, faint)}) {
    EXPECT_GT(clear, box + 30);
    EXPECT_LT(clear, sky - 10);
  }
}

/// The light of a pixel: its red, from 0 to 1.
double light_at(const Shot& shot, std::uint32_t x, std::uint32_t y) {
  return linear(static_cast<float>(shot.red(x, y)) / 255);
}

TEST(Renderer, the_floor_under_a_lamp_is_as_bright_as_the_inverse_square_says) {
  // From 4 m above, straight down, on 4 m x 3 m; the lamp is 1.5 m above the middle.
  View view = lookout(Shows::kColor, 4, 0.5 * geom::kPi);
  view.half_width = 0.5;
  view.half_height = 0.375;
  Lamp lamp;
  lamp.p = {0, 0, 1.5};
  lamp.light = {40, 40, 40};
  const Shot color = shot(view, {.lamps = {&lamp, 1}}, dark());
  int compared = 0;
  for (std::uint32_t y = 3; y < 60; y += 6)
    for (std::uint32_t x = 3; x < 80; x += 6) {
      const Vec3 p = 4 * ray(view, x, y);  // across, from the eye
      const double square = p.x * p.x + p.y * p.y + 1.5 * 1.5;
      const double lux = 40 * 1.5 / (square * std::sqrt(square));
      const double expected = 0.5 * lux / dark().white_lux;
      if (std::fabs(p.x - std::round(p.x)) < 0.06 || std::fabs(p.y - std::round(p.y)) < 0.06)
        continue;                                                               // a joint
      EXPECT_NEAR(light_at(color, x, y) / expected, 1, 0.08) << x << " " << y;  // slabs differ by 2.5 %
      ++compared;
    }
  EXPECT_GT(compared, 50);
}

TEST(Renderer, a_spot_shines_within_its_cone_alone) {
  View view = lookout(Shows::kColor, 4, 0.5 * geom::kPi);
  Lamp lamp;
  lamp.p = {0, 0, 1};
  lamp.light = {40, 40, 40};
  lamp.inner = std::cos(0.4f);
  lamp.outer = std::cos(0.5f);
  const Shot color = shot(view, {.lamps = {&lamp, 1}}, dark());
  for (std::uint32_t x = 0; x < 80; ++x) {
    const Vec3 p = 4 * ray(view, x, 30);
    const double away = std::atan(std::sqrt(p.x * p.x + p.y * p.y));
    if (away < 0.38) EXPECT_GT(light_at(color, x, 30), 0.3) << x;
    if (away > 0.52) EXPECT_EQ(color.red(x, 30), 0) << x;
  }
}

TEST(Renderer, a_lamp_lights_the_faces_that_look_at_it_in_its_color) {
  const std::vector<Instance> boxes{box_at({3, 0, 1}, {1, 1, 1, 1})};
  Lamp before, behind;
  before.p = {1, 0, 1};
  before.light = {0, 60, 0};
  behind.p = {6, 0, 1};
  behind.light = {600, 0, 0};
  const std::vector<Lamp> lamps{before, behind};
  const Shot color = shot(lookout(Shows::kColor), {.instances = boxes, .lamps = lamps}, dark());
  EXPECT_GT(color.green(40, 30), 200);
  EXPECT_EQ(color.red(40, 30), 0);
}

TEST(Renderer, what_glows_shows_its_color_in_the_dark) {
  std::vector<Instance> boxes{box_at({3, 1, 1}, {0, 1, 0, 1}), box_at({3, -1, 1}, {0, 1, 0, 1})};
  boxes[1].glow = 1;
  const Shot color = shot(lookout(Shows::kColor), {.instances = boxes}, dark());
  EXPECT_EQ(color.green(23, 30), 0);
  EXPECT_EQ(color.sample(56, 30), 0x00ff00u);
}

TEST(Renderer, of_many_lamps_those_shine_that_are_brightest_at_the_eye) {
  View view = lookout(Shows::kColor, 4, 0.5 * geom::kPi);
  std::vector<Lamp> lamps(kMostLamps + 1);
  for (Lamp& lamp : lamps) {
    lamp.p = {0, 0, 1};
    lamp.light = {0, 2, 0};
  }
  lamps[3].light = {1, 0, 0};
  const Shot without = shot(view, {.lamps = lamps}, dark());
  EXPECT_EQ(without.red(40, 30), 0);
  lamps[3].light = {3, 0, 0};
  const Shot with = shot(view, {.lamps = lamps}, dark());
  EXPECT_GT(with.red(40, 30), 0);
}

}  // namespace
}  // namespace playhouse::render
