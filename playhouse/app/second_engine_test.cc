// Another engine behind the same scenes, controllers, devices, clients and viewers: nothing but the engine
// knows which one runs.

#include <gtest/gtest.h>

#include <mutex>
#include <thread>

#include "playhouse/app/service.h"
#include "playhouse/behaviour/testing/spring_engine.h"
#include "playhouse/replicate/quantize.h"
#include "playhouse/replicate/viewer.h"
#include "playhouse/run/testing/still_engine.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/state.h"
#include "playhouse_client/laser.h"
#include "playhouse_client/position2d.h"
#include "playhouse_client/simulation.h"

namespace playhouse {
namespace {

using behaviour::testing::SpringEngine;

// A robot that clients drive, one that a controller drives, two loose things, of which one has a mark on
// top, and something that stands still.
constexpr const char* kWorld = R"(
interval_sim 100
define rover position( size [0.4 0.4 0.3] ranger( sensor( samples 9 fov 90 range [0 8] ) ) )
rover( name "guest" pose [0 0 0 0] )
rover( name "wanderer" pose [-5 3 0 0] ctrl "wander" )
model( name "puck" pose [3 0 0 0] size [0.2 0.2 0.2] gripper_return 1 )
model( name "ball" pose [6 0 0 0] size [0.2 0.2 0.2] gripper_return 1
  model( name "mark" pose [0.1 0 0 0] size [0.01 0.01 0.01] ) )
model( name "post" pose [-3 0 0 0] size [0.2 0.2 0.2] )
)";

Result<std::unique_ptr<world::Engine>> make_springs(const scene::SceneDesc& scene, std::uint64_t seed,
                                                    unsigned workers) {
  return std::unique_ptr<world::Engine>(std::make_unique<SpringEngine>(scene, seed, workers));
}

std::unique_ptr<world::Engine> springs_with_controllers(const scene::SceneDesc& scene, unsigned workers) {
  auto engine = app::make_engine(
      scene, {.workers = workers}, controllers::Libraries::LibraryUse::kLoad, [](const std::string&) {},
      make_springs);
  EXPECT_TRUE(engine);
  return std::move(*engine);
}

constexpr client::Pose3d kLeaning{-3, 0, 0.5, 0.3, -0.2, 1};

double x_of(const world::World& world, std::string_view name) {
  return world.models.X_WM[world.find(name)].x;
}

TEST(SecondEngine, moves_bodies_its_own_way_and_robots_by_the_shared_drive_models) {
  const scene::SceneDesc scene = run::testing::scene_of(kWorld);
  const auto engine = springs_with_controllers(scene, 1);
  world::World& world = engine->world();
  const world::ModelRow guest = world.find("guest");
  world::subscribe(world, guest);
  world::command_velocity(world, world.position(world.id(guest)), {0.5, 0, 0, 0});
  for (int tick = 0; tick < 5; ++tick) engine->step();
  EXPECT_NEAR(x_of(world, "guest"), 0.25, 1e-12);
  EXPECT_NEAR(x_of(world, "puck"), 3 + SpringEngine::kSwing, 1e-12) << "a quarter of its period";
  EXPECT_EQ(x_of(world, "post"), -3);
  EXPECT_NE(x_of(world, "wanderer"), -5);
  EXPECT_GT(engine->rays(), 0u);
}

TEST(SecondEngine, rolls_what_is_loose_with_all_its_parts) {
  const scene::SceneDesc scene = run::testing::scene_of(kWorld);
  const auto engine = springs_with_controllers(scene, 1);
  const world::World& world = engine->world();
  for (int tick = 0; tick < 5; ++tick) engine->step();
  const double angle = SpringEngine::kSwing / 0.1;
  const world::ModelRow ball = world.find("ball");
  const geom::SpatialPose X_WM = world::pose_in_world(world.models, ball);
  EXPECT_NEAR(X_WM.tilt.y, angle, 1e-12);
  EXPECT_NEAR(X_WM.X.a, 0, 1e-12);
  ASSERT_FALSE(world.children(ball).empty());
  const geom::Pose& mark = world.models.X_WM[*world.children(ball).begin()];
  EXPECT_NEAR(mark.x, 6 + SpringEngine::kSwing + 0.1 * std::cos(angle) + 0.2 * std::sin(angle), 1e-12);
  EXPECT_NEAR(mark.z, 0.2 * std::cos(angle) - 0.1 * std::sin(angle), 1e-12) << "it has gone under";
  EXPECT_EQ(world.models.tilt_WM[world.find("guest")], geom::Tilt{});
}

TEST(SecondEngine, hears_of_changes_saves_and_goes_on_to_the_same_hash_with_any_number_of_workers) {
  const scene::SceneDesc scene = run::testing::scene_of(kWorld);
  std::vector<std::uint64_t> hashes;
  std::vector<std::byte> saved;
  for (const unsigned workers : {1u, 3u}) {
    const auto engine = springs_with_controllers(scene, workers);
    world::World& world = engine->world();
    for (int tick = 0; tick < 40; ++tick) {
      if (tick == 10) ASSERT_TRUE(world::spawn(world, 0, {1, 1, 0, 0}));
      if (tick == 20)
        ASSERT_TRUE(world::attach(world, world.id(world.find("puck")), world.id(world.find("guest")), {}));
      if (tick == 30) ASSERT_TRUE(world::despawn(world, world.id(world.find("guest"))));
      if (tick == 25) {
        saved.clear();
        ASSERT_TRUE(world::save_state(world, saved));
      }
      engine->step();
    }
    EXPECT_EQ(static_cast<SpringEngine&>(*engine).ingested(), 4u) << "the puck is let go as its holder goes";
    hashes.push_back(world.hash());
  }
  const auto again = springs_with_controllers(scene, 2);
  ASSERT_TRUE(world::load_state(again->world(), saved));
  for (int tick = 25; tick < 40; ++tick) {
    if (tick == 30)
      ASSERT_TRUE(world::despawn(again->world(), again->world().id(again->world().find("guest"))));
    again->step();
  }
  hashes.push_back(again->world().hash());
  EXPECT_EQ(hashes, std::vector<std::uint64_t>(3, hashes[0]));
}

/// What somebody watches, brought up to date by packets alone.
class Watcher {
 public:
  void show(const world::World& world, const world::Pace& pace) {
    if (!prototypes_) {
      prototypes_.emplace(world.scene());
      layout_ = std::make_shared<replicate::Layout>(world, *prototypes_, nullptr);
      seen_.emplace(layout_);
      viewer_.emplace(layout_);
    }
    replicate::capture(world, pace, layout_, {}, snapshot_);
    const replicate::NextFrame next =
        viewer_->next_frame(snapshot_, replicate::Emit::kIfChanged, texts_, packet_);
    if (!next.packet) return;
    const Result<std::uint32_t> frame = replicate::apply_packet(packet_, *seen_);
    ASSERT_TRUE(frame);
    ASSERT_TRUE(viewer_->acknowledge(*frame));
  }
  /// Where it sees a model. [mm]
  std::int32_t x_of(world::ModelRow row) const { return seen_->models[row].x; }
  /// How far it sees it rolled. [1/65536 turn]
  std::uint16_t tilt_of(world::ModelRow row) const { return seen_->models[row].tilt_y; }

 private:
  std::optional<replicate::Prototypes> prototypes_;
  std::shared_ptr<const replicate::Layout> layout_;
  std::optional<replicate::Replica> seen_;
  std::optional<replicate::Viewer> viewer_;
  replicate::ChangesTexts texts_;
  replicate::Snapshot snapshot_;
  std::vector<std::byte> packet_;
};

TEST(SecondEngine, serves_clients_and_viewers_as_the_first_does) {
  app::Service service({.port = 0, .web = std::nullopt}, {.speed = 0}, app::QuitTime::kIgnored);
  service.use_engine(make_springs);
  service.take_scene(run::testing::scene_of(kWorld));
  ASSERT_TRUE(service.open_ports());
  ASSERT_TRUE(service.make_devices());
  const std::uint16_t port = service.player_ports().front();
  Watcher watcher;
  bool has_rolled = false;  // it rolls to and fro: at the end it may be upright
  service.simulation().follow(run::on_show([&](const world::World& world, const world::Pace& pace) {
    watcher.show(world, pace);
    has_rolled = has_rolled || watcher.tilt_of(world.find("puck")) != 0;
  }));

  const auto drive_towards_the_puck = [&]() -> Result<double> {
    Result<client::Client> client = client::Client::connect("127.0.0.1", port);
    if (!client) return client.error();
    Result<client::Laser> laser = client::Laser::open(*client, 0);
    Result<client::Position2d> wheels = client::Position2d::open(*client, 0);
    if (!laser) return laser.error();
    if (!wheels) return wheels.error();
    if (const auto driven = wheels->go_to({2, 0, 0}); !driven) return driven.error();
    const auto read_until = [&](const auto& holds) -> Result<void> {
      while (!holds())
        if (const auto read = client->read(); !read) return read.error();
      return {};
    };
    if (const auto read = read_until([&] { return wheels->state() && wheels->state()->pose.x >= 1.9; });
        !read)
      return read.error();
    const double arrived = wheels->state()->time;  // scans of before are from farther away
    if (const auto read = read_until([&] { return laser->scan() && laser->scan()->time >= arrived; }); !read)
      return read.error();
    return laser->scan()->ranges[4];
  };
  const auto lean_the_post = [&]() -> Result<client::Pose3d> {
    Result<client::Client> client = client::Client::connect("127.0.0.1", port);
    if (!client) return client.error();
    Result<client::Simulation> simulation = client::Simulation::open(*client, 0);
    if (!simulation) return simulation.error();
    if (const auto set = simulation->set_pose3d("post", kLeaning); !set) return set.error();
    return simulation->pose3d("post");
  };
  Result<client::Pose3d> leaning = Error{{}, "nobody asked"};
  Result<double> ahead = Error{{}, "nobody drove"};
  std::thread program([&] {
    leaning = lean_the_post();
    ahead = drive_towards_the_puck();
    service.stop();
  });
  service.run();
  program.join();
  ASSERT_TRUE(leaning) << leaning.error().line();
  EXPECT_NEAR(leaning->z, kLeaning.z, 1e-12);
  EXPECT_NEAR(leaning->roll, kLeaning.roll, 1e-12);
  EXPECT_NEAR(leaning->pitch, kLeaning.pitch, 1e-12);
  EXPECT_NEAR(leaning->yaw, kLeaning.yaw, 1e-12);
  ASSERT_TRUE(ahead) << ahead.error().line();
  EXPECT_GT(*ahead, 0.3);
  EXPECT_LT(*ahead, 3.15 - 1.9)
      << "the puck swings between 2.65 and 3.15 m, and the robot is at 1.9 m at least";
  const world::World& world = service.simulation().world();
  for (const char* name : {"guest", "puck", "wanderer"}) {
    const world::ModelRow row = world.find(name);
    EXPECT_EQ(watcher.x_of(row), std::lround(1000 * world.models.X_WM[row].x)) << name;
    EXPECT_EQ(watcher.tilt_of(row), replicate::quantize_angle(world.models.tilt_WM[row].y)) << name;
  }
  EXPECT_TRUE(has_rolled);
}

}  // namespace
}  // namespace playhouse
