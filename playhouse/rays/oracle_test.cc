// Ranges in every example world against an oracle that knows no index, no vectors and no rule but one: a beam
// ends at the nearest edge of anything that it may see. PLAYHOUSE_ORACLE_RAYS=1000000 has it look at so many
// in each world.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/base/testing/reference.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::rays {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kBeams = 360, kSingles = 16;
constexpr double kLaserRange = 8, kSonarRange = 5;  // m

std::size_t rays_of_a_world() {
  const char* const wanted = std::getenv("PLAYHOUSE_ORACLE_RAYS");
  return wanted ? std::strtoull(wanted, nullptr, 10) : 4 * (kBeams + kSingles);
}

/// Adds a scanner and a ring of single beams, which nobody can see, at the top of the scene.
void add_probe(scene::SceneDesc& scene) {
  const auto top = static_cast<std::uint32_t>(scene.models.size());
  scene::ModelDesc carrier;
  carrier.name = carrier.alias = "the probe";
  carrier.type = "position";
  carrier.kind = scene::ModelKind::kPosition;
  carrier.position.emplace();
  scene.models.push_back(carrier);
  scene::ModelDesc scanner =
      stage::testing::ranger("the probe.scanner", static_cast<int>(top), {0.05, -0.02, 0, 0.3});
  scanner.sensors = {stage::testing::sensor({0.01, 0.02, 0, -0.4}, kLaserRange, geom::radians(360), kBeams)};
  scene.models.push_back(scanner);
  scene::ModelDesc ring = stage::testing::ranger("the probe.ring", static_cast<int>(top), {});
  for (std::uint32_t k = 0; k < kSingles; ++k)
    ring.sensors.push_back(stage::testing::sensor(
        {0.02 * k, 0.01, 0, geom::normalize(0.1 + k * geom::kTwoPi / kSingles)}, kSonarRange, 0, 1));
  scene.models.push_back(ring);
  for (const std::uint32_t row : {top + 1, top + 2}) {
    scene.models[row].update_interval = scene.interval;
    for (scene::RangerSensorDesc& sensor : scene.models[row].sensors) sensor.size = {};
  }
  scene::TreeDesc tree;
  tree.top = top;
  tree.name = tree.alias = "the probe";
  scene.trees.push_back(tree);
}

struct Edge {
  double ax, ay, bx, by, z_min, z_max;  // m, in W
};

/// Every edge that a ranger of the probe may see.
std::vector<Edge> edges_of(const world::World& world, world::ModelRow probe) {
  std::vector<Edge> edges;
  for (const world::ModelRow row : world.models.rows()) {
    const scene::ModelDesc& desc = world.desc(row);
    if (desc.ranger_return < 0 || world.models.root[row] == probe) continue;
    const geom::Pose& X_WM = world.models.X_WM[row];
    const auto add = [&](const std::vector<geom::Vec2>& points, double low, double high) {
      const auto in_world = [&](geom::Vec2 p) {
        const double x = desc.X_MB.x + std::cos(desc.X_MB.a) * p.x - std::sin(desc.X_MB.a) * p.y;
        const double y = desc.X_MB.y + std::sin(desc.X_MB.a) * p.x + std::cos(desc.X_MB.a) * p.y;
        return geom::Vec2{X_WM.x + std::cos(X_WM.a) * x - std::sin(X_WM.a) * y,
                          X_WM.y + std::sin(X_WM.a) * x + std::cos(X_WM.a) * y};
      };
      for (std::size_t i = 0; i < points.size(); ++i) {
        const geom::Vec2 a = in_world(points[i]), b = in_world(points[(i + 1) % points.size()]);
        const double z = X_WM.z + desc.X_MB.z;
        edges.push_back({a.x, a.y, b.x, b.y, z + low, z + high});
      }
    };
    for (const scene::Block& block : desc.blocks) add(block.points, block.z_min, block.z_max);
    for (const scene::Contours& bitmap : desc.bitmaps)
      for (const auto& loop : bitmap.loops) add(loop, bitmap.z_min, bitmap.z_max);
  }
  return edges;
}

/// The distance to the nearest edge, or the range.
double oracle(const std::vector<Edge>& edges, const geom::Pose& X_WS, double bearing, double range) {
  const double dx = std::cos(X_WS.a + bearing), dy = std::sin(X_WS.a + bearing);
  for (const Edge& edge : edges) {
    if (X_WS.z < edge.z_min || X_WS.z > edge.z_max) continue;
    const double ex = edge.bx - edge.ax, ey = edge.by - edge.ay;
    const double wx = edge.ax - X_WS.x, wy = edge.ay - X_WS.y;
    const double across = dx * ey - dy * ex;
    if (across == 0) continue;
    const double t = (wx * ey - wy * ex) / across, along = (wx * dy - wy * dx) / across;
    if (t >= 0 && t < range && along >= 0 && along <= 1) range = t;
  }
  return range;
}

/// Where the frame of a sensor is, and its beams.
geom::Pose sensor_pose(const world::World& world, const world::ModelRow ranger,
                       const scene::RangerSensorDesc& sensor) {
  const geom::Pose X_WM = world.models.X_WM[ranger];
  const double c = std::cos(X_WM.a), s = std::sin(X_WM.a);
  return {X_WM.x + c * sensor.X_BS.x - s * sensor.X_BS.y, X_WM.y + s * sensor.X_BS.x + c * sensor.X_BS.y,
          X_WM.z + sensor.X_BS.z, X_WM.a + sensor.X_BS.a};
}

/// Compares what the probe's sensors measured; returns how many beams.
std::size_t compare(const world::World& world, const std::vector<Edge>& edges, const std::string& name) {
  std::size_t rays = 0;
  for (const char* part : {"the probe.scanner", "the probe.ring"}) {
    const world::ModelRow ranger = world.find(part);
    const auto& sensors = world.desc(ranger).sensors;
    const world::SensorRow first = world.rangers.first_sensor[world.models.part[ranger]];
    for (std::uint32_t k = 0; k < sensors.size(); ++k) {
      const geom::Pose X_WS = sensor_pose(world, ranger, sensors[k]);
      const std::uint32_t count = sensors[k].samples;
      for (std::uint32_t beam = 0; beam < count; ++beam, ++rays) {
        const double bearing = count > 1 ? sensors[k].fov * (beam / (count - 1.0) - 0.5) : 0;
        const double right = oracle(edges, X_WS, bearing, sensors[k].range_max);
        const double range = world.sensors.ranges[world.sensors.first_beam[first + k] + beam];
        EXPECT_NEAR(range, right, 1e-3 + 1e-6 * right)
            << name << ": " << part << " at " << X_WS.x << ' ' << X_WS.y << ' ' << X_WS.z << ", bearing "
            << X_WS.a + bearing;
      }
    }
  }
  return rays;
}

void look_around(const fs::path& file) {
  auto scene = scene::load_world(file.string());
  ASSERT_TRUE(scene.ok()) << scene.error().line();
  add_probe(*scene);
  auto engine = stage::make_engine(*scene, {});
  ASSERT_TRUE(engine.ok()) << engine.error().line();
  world::World& world = (*engine)->world();
  const world::ModelRow probe = world.find("the probe");
  ASSERT_TRUE(probe);
  const std::vector<Edge> edges = edges_of(world, probe);
  geom::Box box;
  double highest = 0;
  for (const Edge& edge : edges) {
    box.add({edge.ax, edge.ay});
    highest = std::max(highest, edge.z_max);
  }
  Rng rng(2026, 0, {Purpose::kTestScene, 17});
  for (std::size_t rays = 0; rays < rays_of_a_world() && !::testing::Test::HasFailure();) {
    const geom::Pose X{rng.uniform(box.x_min - 1, box.x_max + 1), rng.uniform(box.y_min - 1, box.y_max + 1),
                       rng.uniform(0.001, std::min(highest, 0.6)), rng.uniform(-3.14, 3.14)};
    ASSERT_TRUE(world::set_pose(world, probe, X));
    (*engine)->step();
    rays += compare(world, edges, file.filename().string());
  }
}

TEST(Oracle, agrees_in_every_world_that_comes_with_the_program) {
  int worlds = 0;
  for (const auto& entry : fs::directory_iterator(PLAYHOUSE_SOURCE_DIR "/worlds"))
    if (entry.path().extension() == ".world") ++worlds, look_around(entry.path());
  EXPECT_GE(worlds, 8);
}

TEST(Oracle, agrees_in_stages_example_worlds) {
  SKIP_WITHOUT_STAGE();
  const fs::path folder = stage_source() / "worlds";
  for (const char* name :
       {"SFU", "benchmark/cave", "benchmark/hospital", "camera", "circuit", "everything", "fasr", "fasr2",
        "fasr_plan", "large", "pioneer_follow", "pioneer_walle", "sensor_noise_demo", "simple"})
    look_around(folder / (std::string(name) + ".world"));
}

}  // namespace
}  // namespace playhouse::rays
