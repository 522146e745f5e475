// All ways to find what a ray hits give the same solid and the same bits, also where things touch: single
// rays, bundles, scans; walls that are few, near, marched through and followed alone; bodies that are convex
// or not, looked at from outside and inside.

#include "playhouse/bodies/ray_edge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/base/rng.h"
#include "playhouse/bodies/polygon_hit.h"
#include "playhouse/bodies/space.h"
#include "playhouse/rays/ranger_kinds.h"
#include "playhouse/simd/testing_instruction_sets.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::bodies {
namespace {

using stage::testing::box;
using stage::testing::robot;
using stage::testing::sensor;

/// Where the ray enters a convex polygon, below 0 if it does not or sees the edge edge-on.
double entry_alone(std::span<const Vec2> polygon, const Ray& ray) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 w0 = polygon[i] - ray.p, w1 = polygon[(i + 1) % polygon.size()] - ray.p;
    const Crossing<double> ends({ray.d.x, ray.d.y, w0.x, w0.y}, {ray.d.x, ray.d.y, w1.x, w1.y});
    if (ends.enters) return ends.slope > -kEdgeOn ? -1 : geom::cross(w0, w1) / ends.slope;
  }
  return kMiss;
}

/// The rule, word by word: every solid, every edge, in order of rows.
Hit look(const Solids& solids, const Ray& ray) {
  Hit hit{ray.range, {}};
  for (const SolidRow row : solids.rows()) {
    if ((solids.seen_by[row] & ray.by) == 0 || solids.root[row] == ray.root ||
        !at_height(solids, row, ray.z_low, ray.z_high))
      continue;
    const std::span<const Vec2> polygon = solids.polygon(row);
    double t = -1;
    if (row >= solids.first_moving && solids.convex[row] != 0 && polygon.size() <= kConvexCorners)
      t = entry_alone(polygon, ray);
    if (t < 0) {
      t = kMiss;
      for (std::size_t i = 0; i < polygon.size(); ++i)
        t = std::min(t, edge_hit(polygon[i] - ray.p, polygon[(i + 1) % polygon.size()] - ray.p, ray.d));
    }
    if (t < hit.range) hit = {t, row};
  }
  return hit;
}

/// What became of the beams of all rangers of a scene.
struct Seen {
  std::size_t beams = 0, hits = 0, ties = 0;
};

class Paths {
 public:
  explicit Paths(const scene::SceneDesc& scene)
      : engine_(*stage::make_engine(scene, {.seed = 1, .workers = 1})),
        world_(engine_->world()),
        trees_(make_trees(world_)),
        solids_(stage::testing::make_solids(world_, trees_)),
        walls_(solids_),
        workers_(1) {
    index_.populate(solids_.moving(), 0.3);
    index_.rebuild(
        solids_.moving(), [&](std::size_t i) { return disc_of(solids_, solids_.moving_rows()[i]); },
        workers_);
    engine_->step();
  }

  /// Compares every beam with the rule, and a single ray like it.
  Seen compare() {
    double radius = 0;
    for (const SolidRow row : solids_.moving_rows()) radius = std::max(radius, solids_.radius[row]);
    rays::RangerKinds kinds;
    kinds.populate(world_, std::vector{radius});
    for (const world::RangerRow ranger : world_.rangers.rows()) {
      const world::ModelRow model = world_.rangers.model[ranger];
      const Pose& X_WM = world_.models.X_WM[model];
      const Rotation turn = Rotation::of(X_WM.a);
      const rays::RangerKind& kind = kinds.kinds[kinds.of_ranger[ranger]];
      const world::BeamRow first = world_.sensors.first_beam[world_.rangers.first_sensor[ranger]];
      const auto ray = [&](Vec2 p, Vec2 d, double z, double range) {
        return Ray{p, d, X_WM.z + z, X_WM.z + z, range, bit(SeenBy::kRanger), world_.models.root[model]};
      };
      for (const rays::Scan& scan : kind.scans) {
        const Pose X_WS = geom::compose(X_WM, scan.X_MS);
        const Rotation r = Rotation::of(X_WS.a);
        for (std::uint32_t k = 0; k < scan.count; ++k)
          compare(first + (scan.first_beam + k),
                  ray(X_WS.xy(), r * Vec2{scan.x[k], scan.y[k]}, scan.z, scan.range_max));
      }
      for (const rays::Bundle& bundle : kind.bundles)
        for (std::size_t k = 0; k < bundle.rays(); ++k)
          compare(first + bundle.beam[k],
                  ray(X_WM.xy() + turn * bundle.p[k], turn * bundle.d[k], bundle.z[k], bundle.range_max[k]));
    }
    return seen_;
  }

 private:
  void compare(world::BeamRow beam, const Ray& ray) {
    const Hit expected = look(solids_, ray), hit = cast({solids_, index_, walls_}, ray);
    const bool is_hit = expected.solid.valid();
    EXPECT_EQ(hit.range, expected.range) << at(ray);
    EXPECT_EQ(hit.solid.index, expected.solid.index) << at(ray);
    EXPECT_EQ(world_.sensors.ranges[beam], static_cast<float>(expected.range)) << at(ray);
    // Each model returns its own row.
    EXPECT_EQ(world_.sensors.intensities[beam],
              is_hit ? static_cast<float>(solids_.model[expected.solid].index) : 0.0f)
        << at(ray);
    ++seen_.beams;
    seen_.hits += is_hit;
    if (!is_hit) return;
    // Another solid at the same distance?
    const std::uint8_t by = std::exchange(solids_.seen_by[expected.solid], 0);
    seen_.ties += look(solids_, ray).range == expected.range;
    solids_.seen_by[expected.solid] = by;
  }

  static std::string at(const Ray& ray) {
    return ::testing::PrintToString(ray.p.x) + " " + ::testing::PrintToString(ray.p.y) + " along " +
           ::testing::PrintToString(ray.d.x) + " " + ::testing::PrintToString(ray.d.y);
  }

  std::unique_ptr<world::Engine> engine_;
  const world::World& world_;
  Trees trees_;
  Solids solids_;
  Walls walls_;
  world::Workers workers_;
  DiscIndex index_;
  Seen seen_;
};

/// A regular polygon of 1 m.
std::vector<Vec2> round(std::size_t corners) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < corners; ++i) {
    const geom::SinCos at =
        geom::sincos(geom::kTwoPi * static_cast<double>(i) / static_cast<double>(corners));
    points.push_back({0.5 * at.cos, 0.5 * at.sin});
  }
  return points;
}

/// Things on a grid of quarters of a metre, so that they share corners, sides and places; half of them drive.
void add_things(scene::SceneDesc& scene, Rng& rng, std::size_t count) {
  const auto quarter = [&](double low, double high) {
    return 0.25 * std::floor(rng.uniform(4 * low, 4 * high));
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Pose X_WM{quarter(-3, 3), quarter(-3, 3), 0, 0.25 * geom::kPi * std::floor(rng.uniform(-3, 4))};
    const geom::Size size{quarter(0.5, 1.5), quarter(0.5, 1.5), 1};
    const std::string name = "thing" + std::to_string(i);
    scene.models.push_back(rng.uniform() < 0.5 ? robot(name, X_WM, size) : box(name, X_WM, size));
    if (rng.uniform() < 0.2)  // an L, which is not convex
      scene.models.back().blocks[0].points = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0},
                                              {0, 0},       {0, 0.5},    {-0.5, 0.5}};
    else if (rng.uniform() < 0.3)
      scene.models.back().blocks[0].points = round(3 + static_cast<std::size_t>(rng.uniform(0, 40)));
    if (i > 0 && rng.uniform() < 0.3) scene.models.back().X_PM = scene.models[scene.models.size() - 2].X_PM;
  }
}

/// Rangers in the same places: scanners, single rays at one height and at two, some on what stands still.
/// Beams go along the grid, along its diagonals and to its corners.
void add_lookouts(scene::SceneDesc& scene, Rng& rng) {
  for (int i = 0; i < 4; ++i) {
    const Pose X_WM{0.25 * std::floor(rng.uniform(-14, 14)), 0.25 * std::floor(rng.uniform(-14, 14)), 0,
                    0.25 * geom::kPi * std::floor(rng.uniform(-3, 4))};
    const std::string name = "lookout" + std::to_string(i);
    const int parent = static_cast<int>(scene.models.size());
    const geom::Size size{0.25, 0.25, 1};
    scene.models.push_back(i % 3 == 0 ? box(name, X_WM, size) : robot(name, X_WM, size));
    scene.models.push_back(stage::testing::ranger(name + ".ranger:0", parent, {0, 0, 0.5, 0}));
    std::vector<scene::RangerSensorDesc>& sensors = scene.models.back().sensors;
    sensors.push_back(sensor({}, 5, geom::kPi, 181));
    sensors.push_back(sensor({0.125, 0, 0, 0}, 5, geom::kTwoPi, 73));
    scene.models.push_back(stage::testing::ranger(name + ".ranger:1", parent, {0, 0, 0.5, 0}));
    std::vector<scene::RangerSensorDesc>& rays = scene.models.back().sensors;
    for (int k = 0; k < 40; ++k) {
      const double x = 0.25 * std::floor(rng.uniform(-12, 12)), y = 0.25 * std::floor(rng.uniform(-12, 12));
      rays.push_back(sensor({0, 0, i % 2 == 0 && k % 2 == 0 ? 0.25 : 0, geom::atan2(y, x)}, 5, 0, 1));
    }
  }
}

void return_rows(scene::SceneDesc& scene) {
  for (std::size_t row = 0; row < scene.models.size(); ++row)
    scene.models[row].ranger_return = static_cast<double>(row);
}

TEST(Rays, meet_the_same_whichever_way_they_are_followed_also_where_things_touch) {
  Seen all;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Rng rng(seed);
    scene::SceneDesc scene;
    add_things(scene, rng, seed % 3 == 0 ? 12 : 60);
    if (seed % 3 == 2)  // so many edges that scans march too
      for (int i = 0; i < 500; ++i)
        scene.models.push_back(
            box("post" + std::to_string(i),
                {0.125 * std::floor(rng.uniform(-32, 32)), 0.125 * std::floor(rng.uniform(-32, 32)), 0, 0},
                {0.0625, 0.0625, 1}));
    add_lookouts(scene, rng);
    return_rows(scene);
    simd::testing::with_every_instruction_set([&] {
      const Seen seen = Paths(scene).compare();
      all.beams += seen.beams;
      all.hits += seen.hits;
      all.ties += seen.ties;
    });
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(all.hits, all.beams / 2);
  EXPECT_GT(all.ties, all.beams / 50);
}

TEST(Rays, meet_the_same_whichever_way_they_are_followed_anywhere) {
  std::uint64_t seed = 0;
  for (const double far : {0.0, 0.0, 0.0, -70000.0, 3e6}) {
    Rng rng(seed++);
    scene::SceneDesc scene;
    add_things(scene, rng, 40);
    add_lookouts(scene, rng);
    for (scene::ModelDesc& model : scene.models) {
      if (model.parent >= 0) continue;
      model.X_PM.x += far + rng.uniform(-0.3, 0.3);
      model.X_PM.a += rng.uniform(-0.3, 0.3);
    }
    return_rows(scene);
    simd::testing::with_every_instruction_set([&] { Paths(scene).compare(); });
    if (HasFailure()) FAIL() << "seed " << seed;
  }
}

TEST(EdgeHit, counts_a_corner_on_the_ray_as_being_on_its_right) {
  const Vec2 ahead{1, 0};
  EXPECT_EQ(edge_hit({2, 0}, {2, 1}, ahead), 2);       // the rest of the edge is on the left
  EXPECT_EQ(edge_hit({2, 0}, {2, -1}, ahead), kMiss);  // on the right
  EXPECT_EQ(edge_hit({2, 0}, {3, 0}, ahead), kMiss);   // along the ray
}

TEST(EdgeHit, is_zero_where_the_ray_begins_on_the_edge) {
  EXPECT_EQ(edge_hit({0, -1}, {0, 1}, {1, 0}), 0);
  EXPECT_EQ(edge_hit({0, -1}, {0, 1}, {-1, 0}), 0);
  EXPECT_EQ(edge_hit({-1, -1}, {1, 1}, {1, 0}), 0);
}

TEST(EdgeHit, is_at_the_nearer_end_of_an_edge_that_is_seen_edge_on) {
  const double off = 1e-10;
  EXPECT_EQ(edge_hit({3, off}, {1, -off}, {1, 0}), 1);
  EXPECT_EQ(edge_hit({-1, off}, {1, -off}, {1, 0}), 0);  // it begins between the ends
  EXPECT_EQ(edge_hit({-3, off}, {-1, -off}, {1, 0}), kMiss);
}

TEST(EdgeHit, of_equal_distances_that_of_the_lower_row_stays) {
  double range = 5, solid = kNoSolid;
  keep_first(5.0, number_of({3}), range, solid);
  EXPECT_EQ(solid, kNoSolid) << "the end of the range is out of reach";
  for (const std::uint32_t row : {7u, 3u, 4u}) keep_first(2.0, number_of({row}), range, solid);
  EXPECT_EQ(row_of(solid).index, 3u);
  keep_first(1.0, number_of({9}), range, solid);
  EXPECT_EQ(row_of(solid).index, 9u);
  EXPECT_EQ(range, 1);
}

}  // namespace
}  // namespace playhouse::bodies
