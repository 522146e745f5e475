#include "playhouse/arena/ray_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/base/rng.h"

namespace playhouse::arena {
namespace {

using geom::Vec3;

Vec3 somewhere(Rng& rng, double half) {
  return {rng.uniform(-half, half), rng.uniform(-half, half), rng.uniform(-half, half)};
}
Vec3 unit(const Vec3& v) {
  return (1 / std::sqrt(dot(v, v))) * v;
}

Triangles box(double half) {
  const std::vector<geom::Vec2> outline{{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  const std::vector<geom::Outline> outlines{outline};
  Triangles triangles;
  add_extrusion(triangles, outlines, -half, half);
  return triangles;
}

struct Hit {
  double range;
  std::uint32_t owner;
};

/// Every triangle in double precision (Cramer's rule).
Hit meet(const Vec3& p, const Vec3& d, double range, const Triangles& triangles, const Owner& owner,
         Hit best) {
  for (const auto& corner : triangles.corner) {
    const Vec3 a = triangles.p[corner[0]], e = triangles.p[corner[1]] - a, f = triangles.p[corner[2]] - a;
    const Vec3 n = cross(d, f), s = p - a;
    const double det = dot(e, n);
    if (det == 0) continue;
    const double u = dot(s, n) / det, v = dot(d, cross(s, e)) / det, t = dot(f, cross(s, e)) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < std::min(range, best.range)) best = {t, owner.id};
  }
  return best;
}

struct World {
  std::vector<Triangles> fixed, placed;
  std::vector<Owner> fixed_owners, owners;
  RayScene scene;

  explicit World(std::uint64_t seed) {
    Rng rng(seed);
    for (std::uint32_t i = 0; i < 5; ++i) {
      Triangles& soup = fixed.emplace_back();
      for (std::uint32_t k = 0; k < 20; ++k) {
        const Vec3 middle = somewhere(rng, 5);
        for (int c = 0; c < 3; ++c) soup.p.push_back(middle + somewhere(rng, 1));
        soup.corner.push_back({3 * k, 3 * k + 1, 3 * k + 2});
      }
      fixed_owners.push_back({100 + i, 1000 + i});
    }
    scene.set_fixed(fixed, fixed_owners);
    const std::uint32_t shape = scene.add_shape(box(0.4));
    std::vector<RayScene::Instance> instances;
    for (std::uint32_t i = 0; i < 30; ++i) {
      owners.push_back({i, i / 2});
      instances.push_back({shape, owners.back()});
    }
    scene.set_instances(instances);
    for (std::uint32_t i = 0; i < 30; ++i) {
      const Vec3 p = somewhere(rng, 5);
      const geom::Quaternion q =
          geom::orientation(rng.uniform(-3, 3), {rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)});
      scene.place(i, p, q);
      Triangles& at = placed.emplace_back(box(0.4));
      for (Vec3& v : at.p) v = p + q * v;
    }
    scene.commit();
  }
  Hit slow(const Vec3& p, const Vec3& d, double range, std::uint32_t group) const {
    Hit best{range, RayBatch::kNobody};
    for (std::size_t i = 0; i < fixed.size(); ++i)
      if (fixed_owners[i].group != group) best = meet(p, d, range, fixed[i], fixed_owners[i], best);
    for (std::size_t i = 0; i < placed.size(); ++i)
      if (owners[i].group != group) best = meet(p, d, range, placed[i], owners[i], best);
    return best;
  }
};

TEST(RayScene, meets_what_a_test_of_every_triangle_meets) {
  const World world(1);
  Rng rng(2);
  int met = 0, wrong = 0;
  for (int batch = 0; batch < 1000; ++batch) {
    RayBatch rays;
    rays.count = 1 + rng.bits() % RayBatch::kMost;
    rays.is_narrow = batch % 2 == 0;
    rays.group = static_cast<std::uint32_t>(rng.bits() % 15);
    std::vector<Vec3> p, d;
    std::vector<double> range;
    for (std::size_t k = 0; k < rays.count; ++k) {
      p.push_back(somewhere(rng, 6));
      d.push_back(unit(somewhere(rng, 1)));
      range.push_back(rng.uniform(0.5, 12));
      rays.px[k] = static_cast<float>(p[k].x);
      rays.py[k] = static_cast<float>(p[k].y);
      rays.pz[k] = static_cast<float>(p[k].z);
      rays.dx[k] = static_cast<float>(d[k].x);
      rays.dy[k] = static_cast<float>(d[k].y);
      rays.dz[k] = static_cast<float>(d[k].z);
      rays.range[k] = static_cast<float>(range[k]);
    }
    world.scene.cast(rays);
    for (std::size_t k = 0; k < rays.count; ++k) {
      const Hit expected = world.slow(p[k], d[k], range[k], rays.group);
      met += expected.owner != RayBatch::kNobody;
      wrong += std::fabs(rays.range[k] - expected.range) > 1e-4 || rays.met[k] != expected.owner;
    }
  }
  EXPECT_GT(met, 1000);
  EXPECT_LE(wrong, 2) << "of about 8,500: rays along an edge, which float meets or misses";
}

// A ray that may begin where it leaves its own solids meets a thing that reaches into them.
TEST(RayScene, a_hint_does_not_change_what_is_met) {
  RayScene scene;
  const std::uint32_t shape = scene.add_shape(box(0.5));
  scene.set_instances(std::vector<RayScene::Instance>{{shape, {7, 1}}, {shape, {8, 2}}, {shape, {9, 1}}});
  scene.place(1, {0.9, 0, 0}, {});  // begins 0.1 m within the own one
  scene.place(2, {-3, 0, 0}, {});   // of the own group as well
  scene.commit();
  for (const float inside : {0.0f, 0.5f}) {
    RayBatch rays;
    rays.count = 2;
    rays.group = 1;
    rays.dx[0] = 1;
    rays.dx[1] = -1;
    rays.range[0] = rays.range[1] = 8;
    rays.inside[0] = rays.inside[1] = inside;
    scene.cast(rays);
    EXPECT_NEAR(rays.range[0], 0.4, 1e-5);
    EXPECT_EQ(rays.met[0], 8u);
    EXPECT_NEAR(rays.facing[0], 1, 1e-5);
    EXPECT_EQ(rays.range[1], 8);
    EXPECT_EQ(rays.met[1], RayBatch::kNobody);
  }
}

TEST(RayScene, an_empty_one_meets_nothing) {
  RayScene scene;
  scene.commit();
  RayBatch rays;
  rays.count = 1;
  rays.dx[0] = 1;
  rays.range[0] = 3;
  scene.cast(rays);
  EXPECT_EQ(rays.met[0], RayBatch::kNobody);
  EXPECT_EQ(rays.range[0], 3);
}

}  // namespace
}  // namespace playhouse::arena
