#include "playhouse/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/bodies/polygon_hit.h"
#include "playhouse/simd/testing_instruction_sets.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::simd {
namespace {

TEST(InstructionSets, are_all_tested_here) {
  if (!is_available(InstructionSet::kAvx2))
    GTEST_SKIP()
        << "this processor has no AVX2: THE AVX2 VERSION OF EVERY VECTOR FUNCTION IS NOT TESTED HERE";
  const bool wide = is_available(InstructionSet::kAvx512);  // elsewhere it is tested emulated
  EXPECT_EQ(instruction_set(), wide ? InstructionSet::kAvx512 : InstructionSet::kAvx2)
      << "what is used where nothing else was chosen";
}

TEST(InstructionSets, are_chosen_by_name) {
  ASSERT_TRUE(parse_instruction_set("plain"));
  EXPECT_EQ(*parse_instruction_set("plain"), InstructionSet::kPlain);
  EXPECT_EQ(parse_instruction_set("avx").error().text,
            "there is no instruction set \"avx\" (did you mean \"avx2\"?)");
  EXPECT_EQ(parse_instruction_set("").error().text, "there is no instruction set \"\"");
  for (const std::string_view name : kInstructionSetNames) {
    const Result<InstructionSet> set = parse_instruction_set(name);
    if (!set) continue;
    const testing::WithInstructionSet chosen(*set);
    EXPECT_EQ(instruction_set(), *set) << name;
  }
}

/// The hash of a run and the bits of all that was measured in it.
std::vector<std::uint64_t> outcome(const scene::SceneDesc& scene, int ticks) {
  const auto engine = *stage::make_engine(scene, {.seed = 5, .workers = 2});
  std::vector<std::uint64_t> all;
  for (int tick = 0; tick < ticks; ++tick) engine->step();
  all.push_back(engine->world().hash());
  for (const float range : engine->world().sensors.ranges) all.push_back(std::bit_cast<std::uint32_t>(range));
  for (const float seen : engine->world().sensors.intensities)
    all.push_back(std::bit_cast<std::uint32_t>(seen));
  return all;
}

/// Robots in a room with more edges than a scanner looks at one by one, so that rays march too.
scene::SceneDesc among_posts(stage::testing::Sensing sensing) {
  scene::SceneDesc scene = stage::testing::crowd(40, sensing);
  Rng rng(3);
  for (int i = 0; i < 400; ++i)
    scene.models.push_back(stage::testing::box(
        "post" + std::to_string(i), {rng.uniform(-9, 9), rng.uniform(-9, 9), 0, rng.uniform(-3, 3)},
        {0.03, 0.03, 1}));
  return scene;
}

/// Robots whose bodies have any number of corners, from three on, every seventh the shape of a star; they
/// overlap, so that rays begin within others, and are lower or higher than some of the sonars.
scene::SceneDesc of_all_shapes() {
  scene::SceneDesc scene = stage::testing::crowd(80, stage::testing::Sensing::kSonar);
  Rng rng(4);
  for (std::size_t i = 0, body = 0; i < scene.models.size(); ++i) {
    scene::ModelDesc& model = scene.models[i];
    if (model.kind == scene::ModelKind::kRanger)
      for (std::size_t k = 0; k < model.sensors.size(); k += 3) model.sensors[k].X_BS.z = 0.1;
    if (model.kind != scene::ModelKind::kPosition) continue;
    const std::size_t corners = 3 + body % 12;
    std::vector<geom::Vec2> points;
    for (std::size_t k = 0; k < corners; ++k) {
      const double radius = body % 7 == 6 && k % 2 == 0 ? 0.3 : 0.6;
      const geom::SinCos at = geom::sincos((static_cast<double>(k) + rng.uniform(0, 0.5)) * geom::kTwoPi /
                                           static_cast<double>(corners));
      points.push_back({radius * at.cos, radius * at.sin});
    }
    model.blocks = {{points, rng.uniform(0, 0.2), rng.uniform(0.2, 0.4)}};
    ++body;
  }
  return scene;
}

TEST(InstructionSets, give_the_same_bits) {
  const std::vector<scene::SceneDesc> scenes = {
      of_all_shapes(), stage::testing::crowd(60, stage::testing::Sensing::kLaser),
      stage::testing::crowd(60, stage::testing::Sensing::kSonar),
      among_posts(stage::testing::Sensing::kLaser), among_posts(stage::testing::Sensing::kSonar)};
  for (const scene::SceneDesc& scene : scenes) {
    std::vector<std::vector<std::uint64_t>> outcomes;
    testing::with_every_instruction_set([&] { outcomes.push_back(outcome(scene, 30)); });
    for (const std::vector<std::uint64_t>& other : outcomes) EXPECT_TRUE(other == outcomes.front());
  }
}

TEST(InstructionSets, find_where_a_ray_meets_a_polygon_as_edge_by_edge) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Rng rng(i);
    const std::size_t corners = 3 + i % 9;
    std::vector<geom::Vec2> polygon;
    for (std::size_t k = 0; k < corners; ++k) polygon.push_back({rng.uniform(-2, 2), rng.uniform(-2, 2)});
    const geom::SinCos sc = geom::sincos(rng.uniform(-3, 3));
    const geom::Vec2 p{rng.uniform(-3, 3), rng.uniform(-3, 3)}, d{sc.cos, sc.sin};
    double nearest = bodies::kMiss;
    for (std::size_t k = 0; k < corners; ++k)
      nearest = std::min(nearest, bodies::edge_hit(polygon[k] - p, polygon[(k + 1) % corners] - p, d));
    polygon.push_back(polygon.front());
    polygon.resize(polygon.size() + bodies::Solids::kPad);
    testing::with_every_instruction_set([&] {
      const double hit = in_vectors<bodies::polygon_hit_here>(polygon.data(), corners, p, d);
      EXPECT_TRUE(hit == nearest || std::fabs(hit - nearest) < 1e-9) << hit << " not " << nearest;
    });
  }
}

}  // namespace
}  // namespace playhouse::simd
