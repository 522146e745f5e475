#include "playhouse/arena/sensing/ray_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/base/rng.h"
#include "playhouse/simd/testing_instruction_sets.h"

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
    std::vector<RayScene::OwnedShape> instances;
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

/// A batch from p with directions within an angle of d, in order around it. [rad]
RayBatch batch_of(Rng& rng, const Vec3& p, const Vec3& d, double spread, std::size_t count) {
  RayBatch rays;
  rays.count = count;
  rays.p = p;
  const Vec3 left = unit(cross({0.1, 0.2, 1}, d));
  for (std::size_t k = 0; k < count; ++k) {
    const geom::SinCos off =
        geom::sincos(spread * (static_cast<double>(k) / static_cast<double>(count) - 0.5));
    const Vec3 at = unit(off.cos * d + off.sin * left + 0.01 * somewhere(rng, 1));
    rays.set_ray(k, at, static_cast<float>(rng.uniform(0.5, 12)));
  }
  return rays;
}

Vec3 direction(const RayBatch& rays, std::size_t k) {
  return {rays.dx[k], rays.dy[k], rays.dz[k]};
}

TEST(RayScene, hits_what_a_test_of_every_triangle_hits) {
  const World world(1);
  Rng rng(2);
  int hits = 0, wrong = 0;
  for (int i = 0; i < 800; ++i) {
    const Vec3 p = somewhere(rng, 6);
    RayBatch rays = batch_of(rng, p, unit(somewhere(rng, 1)), rng.uniform(0, 7),
                             1 + rng.bits() % (i % 2 == 0 ? 20 : RayBatch::kMost));
    rays.group = static_cast<std::uint32_t>(rng.bits() % 15);
    const RayBatch asked = rays;
    world.scene.cast(rays);
    for (std::size_t k = 0; k < rays.count; ++k) {
      const Vec3 from = rays.p;
      const Hit expected = world.slow(from, direction(asked, k), asked.range[k], rays.group);
      hits += expected.owner != RayBatch::kNobody;
      wrong += std::fabs(rays.range[k] - expected.range) > 1e-4 || rays.met[k] != expected.owner;
    }
  }
  EXPECT_GT(hits, 3000);
  EXPECT_LE(wrong, 2) << "of " << hits << ": rays along an edge, which float hits or misses";
}

// The directions of some of them add up to exactly nothing: 32 to the bit.
TEST(RayScene, rays_all_around_hit_in_every_number) {
  RayScene scene;
  Triangles room = box(5);
  scene.set_fixed(std::span(&room, 1), std::vector<Owner>{{7, 8}});
  scene.commit();
  for (std::size_t count = 1; count <= RayBatch::kMost; ++count) {
    for (const double first : {0.0, 0.1, 1.2345}) {
      RayBatch rays;
      rays.count = count;
      for (std::size_t k = 0; k < count; ++k) {
        const geom::SinCos at =
            geom::sincos(first + geom::kTwoPi * static_cast<double>(k) / static_cast<double>(count));
        rays.set_ray(k, {at.cos, at.sin, 0}, 30);
      }
      scene.cast(rays);
      for (std::size_t k = 0; k < count; ++k)
        EXPECT_NEAR(rays.range[k], 5 / std::max(std::fabs(rays.dx[k]), std::fabs(rays.dy[k])), 1e-5)
            << k << " of " << count;
    }
  }
}

// Rays nearly in the plane of a face of 100 m: its edge functions are near 0 all over it and beyond.
TEST(RayScene, hits_nothing_beyond_the_ends_of_long_faces_and_no_end_is_missed) {
  constexpr double kHalf[] = {50, 0.05, 1};
  const std::vector<geom::Vec2> outline{{-50, -0.05}, {50, -0.05}, {50, 0.05}, {-50, 0.05}};
  RayScene scene;
  Triangles fence;
  add_extrusion(fence, std::vector<geom::Outline>{outline}, -1, 1);
  scene.set_fixed(std::span(&fence, 1), std::vector<Owner>{{1, 1}});
  scene.commit();
  // Where a ray enters the fence if that is larger by so much, infinite if it does not.
  const auto enters = [&](const Vec3& p, const Vec3& d, double larger) {
    double first = 0, last = 1e300;
    for (std::size_t k = 0; k < 3; ++k) {
      const double from = (&p.x)[k], way = (&d.x)[k], half = kHalf[k] + larger;
      const double a = (-half - from) / way, b = (half - from) / way;
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b));
    }
    return first < last ? first : 1e300;
  };
  Rng rng(5);
  std::size_t hits = 0, misses = 0;
  for (int i = 0; i < 500; ++i) {
    RayBatch rays;
    rays.count = 100;
    rays.p = {rng.uniform(-70, -51), 0.05 + rng.uniform(-0.05, 0.05), rng.uniform(-1, 2)};
    std::vector<Vec3> directions;
    for (std::size_t k = 0; k < rays.count; ++k) {
      const Vec3 to{rng.uniform(-50, 80), rng.uniform(-0.1, 0.1), rng.uniform(-2, 2)};
      rays.set_ray(k, unit(to - rays.p), 1000);
      directions.push_back({rays.dx[k], rays.dy[k], rays.dz[k]});
    }
    scene.cast(rays);
    for (std::size_t k = 0; k < rays.count; ++k) {
      const bool is_hit = rays.met[k] != RayBatch::kNobody;
      const double least = enters(rays.p, directions[k], 1e-4), most = enters(rays.p, directions[k], -1e-4);
      if (is_hit) EXPECT_GE(rays.range[k], least * (1 - 1e-6));
      if (most < 1e300) EXPECT_LE(rays.range[k], most * (1 + 1e-6));
      hits += is_hit;
      misses += !is_hit;
    }
  }
  EXPECT_GT(hits, 5000u);
  EXPECT_GT(misses, 5000u);
}

TEST(RayScene, is_as_exact_far_from_the_origin) {
  for (const double far : {0.0, 1e4, 5.4e6}) {
    RayScene scene;
    const Vec3 there{far, -far, 0};
    Triangles wall = box(0.5);
    for (Vec3& p : wall.p) p = there + p;
    scene.set_fixed(std::span(&wall, 1), std::vector<Owner>{{1, 1}});
    scene.set_instances(std::vector<RayScene::OwnedShape>{{scene.add_shape(box(0.25)), {2, 2}}});
    scene.place(0, there + Vec3{0, 2, 0}, geom::orientation(0, {}));
    scene.commit();
    RayBatch rays;
    rays.count = 2;
    rays.p = there + Vec3{-2.6, 0.4, 0};
    rays.set_ray(0, {1, 0, 0}, 10);
    const Vec3 to_instance = unit({2.6, 1.6, 0});
    rays.set_ray(1, to_instance, 10);
    scene.cast(rays);
    EXPECT_NEAR(rays.range[0], 2.1, 1e-5) << far;
    EXPECT_EQ(rays.met[0], 1u);
    EXPECT_NEAR(rays.range[1], 2.35 / to_instance.x, 1e-5) << far;
    EXPECT_EQ(rays.met[1], 2u);
  }
}

TEST(RayScene, all_instruction_sets_compute_the_same_bits) {
  const World world(3);
  std::vector<std::vector<float>> outcomes;
  simd::testing::with_every_instruction_set([&] {
    Rng rng(4);
    std::vector<float>& outcome = outcomes.emplace_back();
    for (std::size_t i = 0; i < 200; ++i) {
      RayBatch rays = batch_of(rng, somewhere(rng, 6), unit(somewhere(rng, 1)), rng.uniform(0, 3),
                               1 + i % RayBatch::kMost);
      rays.wants_normals = true;
      world.scene.cast(rays);
      for (std::size_t k = 0; k < rays.count; ++k) {
        const bool is_hit = rays.met[k] != RayBatch::kNobody;
        outcome.insert(outcome.end(), {rays.range[k], rays.facing[k], static_cast<float>(rays.met[k])});
        if (is_hit) outcome.insert(outcome.end(), {rays.nx[k], rays.ny[k], rays.nz[k]});
      }
    }
  });
  for (const std::vector<float>& other : outcomes) EXPECT_EQ(other, outcomes.front());
}

// Distances are checked by the slow test; here that what is close to a box far from the origin, and turned,
// adds up.
TEST(RayScene, tells_the_normal_and_the_angle) {
  RayScene scene;
  const std::uint32_t shape = scene.add_shape(box(0.5));
  scene.set_instances(std::vector<RayScene::OwnedShape>{{shape, {3, 4}}});
  scene.place(0, {1000, -2000, 5}, geom::orientation(0.3, {0, 0.2}));
  scene.commit();
  const geom::Quaternion q = geom::orientation(0.3, {0, 0.2});
  const Vec3 normal = q * Vec3{-1, 0, 0}, p = Vec3{1000, -2000, 5} + 4.5 * normal;
  RayBatch rays;
  rays.count = 1;
  rays.wants_normals = true;
  const Vec3 d = unit(-1 * normal + 0.05 * (q * Vec3{0, 1, 0}));
  rays.p = p;
  rays.set_ray(0, d, 10);
  scene.cast(rays);
  EXPECT_EQ(rays.met[0], 3u);
  EXPECT_NEAR(rays.range[0], 4 * std::sqrt(1 + 0.05 * 0.05), 1e-3) << "0.2 mm between floats at 2 km";
  EXPECT_NEAR(rays.facing[0], 1 / std::sqrt(1 + 0.05 * 0.05), 1e-5);
  EXPECT_NEAR(std::fabs(dot(normal, {rays.nx[0], rays.ny[0], rays.nz[0]})), 1, 1e-5);
}

/// A surface of many small triangles around the origin, without a gap.
Triangles ball(std::uint32_t rings, std::uint32_t around) {
  Triangles triangles;
  for (std::uint32_t i = 0; i <= rings; ++i)
    for (std::uint32_t j = 0; j < around; ++j) {
      const geom::SinCos e = geom::sincos(geom::kPi * (i + 0.5) / (rings + 1) - geom::kPi / 2),
                         a = geom::sincos(geom::kTwoPi * j / around);
      triangles.p.push_back({3 * e.cos * a.cos, 3 * e.cos * a.sin, 3 * e.sin});
    }
  for (std::uint32_t i = 0; i < rings; ++i)
    for (std::uint32_t j = 0; j < around; ++j) {
      const std::uint32_t a = i * around + j, b = i * around + (j + 1) % around;
      triangles.corner.push_back({a, b, b + around});
      triangles.corner.push_back({a, b + around, a + around});
    }
  return triangles;
}

// Rays at corners and at middles of edges: each is hit by one of the triangles there.
TEST(RayScene, no_ray_passes_between_triangles) {
  const Triangles surface = ball(40, 60);
  RayScene scene;
  scene.set_fixed(std::vector{surface}, std::vector<Owner>{{1, 1}});
  scene.commit();
  const Vec3 p{0.1, -0.2, 0.3};
  std::vector<Vec3> targets;
  for (const auto& corner : surface.corner) {
    bool is_at_rim = false;
    for (const std::uint32_t row : corner) is_at_rim = is_at_rim || row < 60 || row >= 40 * 60;
    if (is_at_rim) continue;
    const Vec3 &a = surface.p[corner[0]], &b = surface.p[corner[1]], &c = surface.p[corner[2]];
    targets.insert(targets.end(), {a, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)});
  }
  std::size_t missed = 0;
  for (std::size_t first = 0; first < targets.size(); first += RayBatch::kMost) {
    RayBatch rays;
    rays.count = std::min(RayBatch::kMost, targets.size() - first);
    rays.p = p;
    for (std::size_t k = 0; k < rays.count; ++k) {
      const Vec3 d = unit(targets[first + k] - p);
      rays.set_ray(k, d, 10);
    }
    scene.cast(rays);
    for (std::size_t k = 0; k < rays.count; ++k) missed += rays.met[k] == RayBatch::kNobody;
  }
  EXPECT_GT(targets.size(), 10000u);
  EXPECT_EQ(missed, 0u);
}

// A thing that reaches into the solids of a ray's own group is hit where it is, inside them.
TEST(RayScene, rays_ignore_their_own_group_alone) {
  RayScene scene;
  const std::uint32_t shape = scene.add_shape(box(0.5));
  scene.set_fixed(std::vector{box(0.6)}, std::vector<Owner>{{6, 1}});
  scene.set_instances(std::vector<RayScene::OwnedShape>{{shape, {7, 1}}, {shape, {8, 2}}, {shape, {9, 1}}});
  scene.place(1, {0.9, 0, 0}, {});  // begins 0.1 m within the own one
  scene.place(2, {-3, 0, 0}, {});   // of the own group as well
  scene.commit();
  RayBatch rays;
  rays.count = 2;
  rays.group = 1;
  rays.dx[0] = 1;
  rays.dx[1] = -1;
  rays.range[0] = rays.range[1] = 8;
  scene.cast(rays);
  EXPECT_NEAR(rays.range[0], 0.4, 1e-5);
  EXPECT_EQ(rays.met[0], 8u);
  EXPECT_NEAR(rays.facing[0], 1, 1e-5);
  EXPECT_EQ(rays.range[1], 8);
  EXPECT_EQ(rays.met[1], RayBatch::kNobody);
  EXPECT_EQ(rays.facing[1], 0);
}

TEST(RayScene, an_empty_one_hits_nothing) {
  RayScene scene;
  scene.commit();
  RayBatch rays;
  rays.count = 1;
  rays.dx[0] = 1;
  rays.range[0] = 3;
  scene.cast(rays);
  EXPECT_EQ(rays.met[0], RayBatch::kNobody);
  EXPECT_EQ(rays.range[0], 3);
  rays.count = 0;
  scene.cast(rays);
}

}  // namespace
}  // namespace playhouse::arena
