// Where points of the world are in a picture, against the formula of a pinhole.

#include "playhouse/render/view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/base/rng.h"

namespace playhouse::render {
namespace {

using geom::Vec3;

struct Clip {
  double x, y, z, w;
};
Clip clipped(const Matrix& m, const Vec3& p) {
  const auto row = [&](int r) { return m[r] * p.x + m[4 + r] * p.y + m[8 + r] * p.z + m[12 + r]; };
  return {row(0), row(1), row(2), row(3)};
}

View some_view(Rng& rng) {
  View view;
  view.q_WC = geom::orientation(rng.uniform(-3, 3), {rng.uniform(-1, 1), rng.uniform(-1, 1)});
  view.half_width = rng.uniform(0.2, 1.5);
  view.half_height = rng.uniform(0.2, 1.5);
  view.near = rng.uniform(0.05, 1);
  view.far = rng.uniform(5, 50);
  view.width = 64;
  view.height = 48;
  return view;
}

Vec3 some_point(Rng& rng) {
  return {rng.uniform(-20, 20), rng.uniform(-20, 20), rng.uniform(-20, 20)};
}

TEST(View, a_point_is_where_a_pinhole_has_it_and_its_depth_comes_back) {
  Rng rng(1);
  int shown = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const View view = some_view(rng);
    const Axes axes = axes_of(view.q_WC);
    const Vec3 p = some_point(rng);
    const double depth = dot(axes.ahead, p);
    if (depth < view.near || depth > view.far) continue;
    ++shown;
    const Clip clip = clipped(clip_from_eye(view, axes), p);
    EXPECT_NEAR(clip.x / clip.w, -dot(axes.left, p) / depth / view.half_width, 1e-4);
    EXPECT_NEAR(clip.y / clip.w, dot(axes.up, p) / depth / view.half_height, 1e-4);
    EXPECT_NEAR(depth_of(static_cast<float>(clip.z / clip.w), view), depth, 1e-4 * depth);
  }
  EXPECT_GT(shown, 500);
}

TEST(View, the_planes_hold_what_the_projection_shows) {
  Rng rng(2);
  int inside = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const View view = some_view(rng);
    const Axes axes = axes_of(view.q_WC);
    const Vec3 p = some_point(rng);
    const Clip clip = clipped(clip_from_eye(view, axes), p);
    const double most = 1.001 * clip.w;
    const bool shown =
        clip.w > view.near && clip.w < view.far && std::fabs(clip.x) < clip.w && std::fabs(clip.y) < clip.w;
    const bool is_far_out = clip.w < 0.999 * view.near || clip.w > 1.001 * view.far ||
                            std::fabs(clip.x) > most || std::fabs(clip.y) > most;
    if (shown) EXPECT_TRUE(planes_of(view, axes).may_show(p, 1e-3));
    if (is_far_out) EXPECT_FALSE(planes_of(view, axes).may_show(p, 0));
    inside += shown;
  }
  EXPECT_GT(inside, 200);
}

TEST(View, the_box_of_the_sun_holds_the_part_of_the_view_that_is_in_reach) {
  Rng rng(3);
  for (int trial = 0; trial < 500; ++trial) {
    const View view = some_view(rng);
    const Axes axes = axes_of(view.q_WC);
    const geom::SinCos up = geom::sincos(rng.uniform(0, geom::kPi / 2)),
                       turn = geom::sincos(rng.uniform(-3, 3));
    const SunBox box = sun_box(view, axes, {up.cos * turn.cos, up.cos * turn.sin, up.sin}, 8);
    const double depth = rng.uniform(view.near, std::min(8.0, view.far));
    const Vec3 p = depth * (axes.ahead + rng.uniform(-1, 1) * view.half_width * axes.left +
                            rng.uniform(-1, 1) * view.half_height * axes.up);
    const Clip clip = clipped(clip_from_eye(box), p);
    EXPECT_LE(std::fabs(clip.x), 1.0001);
    EXPECT_LE(std::fabs(clip.y), 1.0001);
    EXPECT_TRUE(clip.z > -1e-4 && clip.z < 1.0001) << clip.z;
    EXPECT_EQ(clip.w, 1);
    EXPECT_TRUE(box.may_shade(p, 0));
  }
}

TEST(View, pictures_are_packed_side_by_side_on_pages) {
  Rng rng(4);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<PictureSize> sizes;
    for (int k = 0; k < 60; ++k)
      sizes.push_back({1 + static_cast<std::uint32_t>(rng.uniform(0, 120)),
                       1 + static_cast<std::uint32_t>(rng.uniform(0, 90))});
    if (trial % 3 == 0) sizes[7] = {700, 500};  // alone on a page that is too small for it
    const std::vector<PageSlot> places = pack(sizes, {256, 200});
    ASSERT_EQ(places.size(), sizes.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const bool fits = sizes[i].width <= 256 && sizes[i].height <= 200;
      if (fits) EXPECT_TRUE(places[i].x + sizes[i].width <= 256 && places[i].y + sizes[i].height <= 200);
      for (std::size_t j = 0; j < i; ++j) {
        const bool apart = places[i].page != places[j].page || places[i].x >= places[j].x + sizes[j].width ||
                           places[j].x >= places[i].x + sizes[i].width ||
                           places[i].y >= places[j].y + sizes[j].height ||
                           places[j].y >= places[i].y + sizes[i].height;
        EXPECT_TRUE(apart) << i << " and " << j;
      }
    }
  }
}

}  // namespace
}  // namespace playhouse::render
