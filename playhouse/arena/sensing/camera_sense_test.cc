// What cameras show in the arena: as in the stage engine where the world is flat, and in space.

#include "playhouse/arena/sensing/camera_sense.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/arena/sensing/looks.h"
#include "playhouse/arena/testing_runs.h"
#include "playhouse/rays/camera_image.h"

namespace playhouse::arena {
namespace {

using geom::Vec3;

struct Session : EngineRun {
  using EngineRun::EngineRun;
  /// Of a camera, in the order of the file.
  std::vector<std::uint32_t> image(std::uint32_t camera) {
    std::vector<std::uint32_t> samples;
    for (const world::Pixel& pixel : world().cameras.pixels[world::CameraRow{camera}])
      samples.push_back(pixel.sample);
    return samples;
  }
  std::uint32_t segment(const char* name) { return rays::segment_of(world().id(world().find(name))); }
};

int channel(std::uint32_t rgb, int shift) {
  return static_cast<int>(rgb >> shift & 0xff);
}

/// Red, green, blue, or none of them, by what is brightest.
char hue(std::uint32_t rgb) {
  const int r = channel(rgb, 16), g = channel(rgb, 8), b = channel(rgb, 0);
  if (3 * r > 4 * std::max(g, b)) return 'r';
  if (3 * g > 4 * std::max(r, b)) return 'g';
  if (3 * b > 4 * std::max(r, g)) return 'b';
  return '-';
}

// A robot with a camera of each kind, pan and tilt, among things of three colours.
const std::string kFlat = R"(
interval_sim 100
define eye camera( pose [0.1 0 0 0] resolution [64 48] fov [70 55] range [0.3 9] alwayson 1 size [0.05 0.05 0.05] )
define rover position( size [0.4 0.4 0.3] drive "omni" color "red" obstacle_return 0
  eye( name "color" image "color" pantilt [10 -8] )
  eye( name "depth" image "depth" pantilt [10 -8] )
  eye( name "models" image "segmentation" pantilt [10 -8] )
)
rover( name "a" pose [0 0 0 20] )
model( name "red" pose [3 1 0 10] size [0.6 0.9 0.5] color "red" )
model( name "green" pose [2.5 2 0 10] size [0.3 0.3 1.5] color "green" )
model( name "blue" pose [5 3 0 30] size [0.3 3 1] color "blue" )
model( name "lamp" pose [2 1 0.8 0] size [0.3 0.3 0.1] color "blue" )
model( name "ring" pose [0 0 0 0] size [14 14 2] boundary 1 noblocks 1 color "green" )
)";

TEST(CameraSense, shows_what_the_stage_engine_does_where_the_world_is_flat) {
  Session stage(kFlat, false), arena(kFlat, true);
  stage.step();
  arena.step();
  const auto flat = stage.image(0), lit = arena.image(0);
  const auto far = stage.image(1), far_lit = arena.image(1);
  const auto models = stage.image(2), models_lit = arena.image(2);
  ASSERT_EQ(lit.size(), 64u * 48u);
  int hues = 0, wrong_hues = 0, wrong_depths = 0, wrong_models = 0, shown = 0;
  for (std::size_t i = 0; i < lit.size(); ++i) {
    hues += hue(flat[i]) != '-';
    wrong_hues += hue(flat[i]) != '-' && hue(lit[i]) != hue(flat[i]);
    wrong_models += models[i] != models_lit[i];
    shown += far[i] > 0;
    // Pixels of a camera of the stage engine that is tilted show what is a quarter of a pixel aside.
    wrong_depths += std::fabs(double(far[i]) - double(far_lit[i])) > 0.02 * far[i] + 2;
  }
  EXPECT_GT(hues, 900);
  EXPECT_LT(wrong_hues, hues / 25);
  EXPECT_GT(shown, 2000);
  EXPECT_LT(wrong_depths, shown / 25);
  EXPECT_LT(wrong_models, 3072 / 25);
  for (const char* name : {"red", "green", "blue", "lamp", "ring"})
    EXPECT_GT(std::ranges::count(models_lit, arena.segment(name)), 20) << name;
  EXPECT_EQ(std::ranges::count(models_lit, arena.segment("a")), 0) << "its own robot";
}

TEST(CameraSense, depths_of_the_floor_are_exact_to_a_millimetre_and_follow_pan_tilt_and_zoom) {
  const std::string text = R"(
interval_sim 100
camera( name "eye" pose [1 2 0.5 40] size [0 0 0.1] image "depth" resolution [65 49] fov [60 45] range [0.1 20] alwayson 1 pantilt [30 -20] )
)";
  Session run(text, true);
  run.step();
  const auto depth = run.image(0);
  const double h = 0.55, tilt = -20 * geom::kPi / 180, half = std::tan(22.5 * geom::kPi / 180);
  for (int y = 0; y < 49; ++y) {
    const double up = half * (1 - (2 * y + 1) / 49.0);
    const double rise = std::sin(tilt) + std::cos(tilt) * up;
    const double expected = rise < 0 && h / -rise < 20 ? 1000 * h / -rise : 0;
    EXPECT_NEAR(depth[static_cast<std::size_t>(y) * 65 + 32], expected, 1) << y;
    EXPECT_NEAR(depth[static_cast<std::size_t>(y) * 65 + 3], expected, 1) << y;
  }
}

TEST(CameraSense, sees_bodies_as_they_lie_and_looks_where_it_is_tilted_to) {
  const std::string text = R"(
interval_sim 100
model( name "plank" pose [2 0 0 0] size [0.1 0.1 2] gripper_return 1 color "blue" )
model( name "post" pose [0 0 0 0] size [0.2 0.2 0.5] gripper_return 1
  camera( pose [0 0 0.5 0] size [0 0 0] alwayson 1 resolution [33 33] fov [60 60] range [0.2 8] image "segmentation" )
  camera( pose [0 0 0.5 0] size [0 0 0] alwayson 1 resolution [33 33] fov [60 60] range [0.2 8] image "depth" ) )
)";
  Session run(text, true);
  run.step();
  EXPECT_EQ(run.image(0)[16 * 33 + 16], run.segment("plank"));
  EXPECT_NEAR(run.image(1)[16 * 33 + 16], 1950, 1);
  world::Models& models = run.world().models;
  const world::ModelRow plank = run.world().find("plank"), post = run.world().find("post");
  models.tilt_PM.set(plank, {1.4, 0});
  models.still.set(plank, 100);  // rests as it stands
  world::place_tree(run.world(), plank);
  run.step();
  EXPECT_EQ(run.image(0)[16 * 33 + 16], 0u) << "it leans to the side";
  EXPECT_GT(std::ranges::count(run.image(0), run.segment("plank")), 5);
  models.tilt_PM.set(post, {0, 0.5});
  models.still.set(post, 100);
  world::place_tree(run.world(), post);
  run.step();
  const double eye = models.X_WM[post].z + std::cos(0.5);  // the camera stands on the post, 1 m from its foot
  EXPECT_NEAR(run.image(1)[16 * 33 + 4], 1000 * eye / std::sin(0.5), 5) << "it looks down";
}

TEST(CameraSense, images_are_the_same_for_any_number_of_workers_and_follow_a_population_that_changes) {
  const auto changed = [](unsigned workers) {
    Session run(kFlat, true, workers);
    run.step(2);
    EXPECT_TRUE(world::despawn(run.world(), run.world().id(run.world().find("green"))));
    run.step(2);
    const auto seen = run.image(2);
    EXPECT_TRUE(world::set_pose(run.world(), run.world().find("red"), {2, 0.4, 0, 0}));
    run.step(2);
    EXPECT_NE(run.image(2), seen);
    return std::pair(run.world().sensed_hash(), run.image(2));
  };
  const auto one = changed(1), three = changed(3);
  EXPECT_EQ(one, three);
  Session stage(kFlat, false);
  stage.step(2);
  ASSERT_TRUE(world::despawn(stage.world(), stage.world().id(stage.world().find("green"))));
  ASSERT_TRUE(world::set_pose(stage.world(), stage.world().find("red"), {2, 0.4, 0, 0}));
  stage.step(2);
  const auto flat = stage.image(2);
  int wrong = 0;
  for (std::size_t i = 0; i < flat.size(); ++i) wrong += flat[i] != one.second[i];
  EXPECT_LT(wrong, 3072 / 25);
}

TEST(CameraSense, a_run_that_goes_on_from_a_saved_state_takes_the_same_images) {
  const std::string text = R"(
interval_sim 100
define person position( drive "walk" size [0.3 0.5 1.75] color "blue" obstacle_return 0 localization "gps" alwayson 1 velocity [0.8 0 0 20] )
person( name "walker" pose [3 0 0 90] )
camera( name "eye" pose [0 0 1 0] alwayson 1 resolution [40 30] range [0.1 12] noise [0.02 0] )
)";
  Session first(text, true), second(text, true);
  std::vector<std::byte> saved;
  first.step(7);
  const auto middle = first.image(0);
  ASSERT_TRUE(world::save_state(first.world(), saved));
  first.step(5);
  EXPECT_NE(first.image(0), middle) << "somebody walks there";
  second.step(3);
  ASSERT_TRUE(world::load_state(second.world(), saved));
  second.step(5);
  EXPECT_EQ(second.image(0), first.image(0));
}

/// A camera 1 m above the origin, a thing behind it in each of two colours, and before it a wall whose face
/// is at 4 m.
std::string before_a_wall(const std::string& words) {
  return R"(
interval_sim 100
camera( name "eye" pose [0 0 1 0] alwayson 1 resolution [161 121] fov [90 73.74] range [0.1 20] size [0 0 0] )
camera( name "far" pose [0 0 1 0] alwayson 1 resolution [161 121] fov [90 73.74] range [0.1 20] size [0 0 0] image "depth" )
model( name "red" pose [-1 0.9 0.7 0] size [0.6 0.6 0.6] color "red" )
model( name "blue" pose [-1 -1.2 0.4 0] size [0.6 0.6 0.6] color "blue" )
model( name "behind" pose [6 0 0.5 0] size [1 1 1] color "green" )
model( name "wall" pose [4.1 0 0 0] size [0.2 5 2.4] color "white" )" +
         words + " )\n";
}

/// The hue of the pixel where the mirror image of p in the wall is.
char hue_of_image(Session& run, const Vec3& p) {
  const world::Models& models = run.world().models;
  const PlacedModel wall = model_in_world(models, run.world().find("wall"));
  const Vec3 n = wall.q * Vec3{-1, 0, 0}, on = wall.p + wall.q * Vec3{-0.1, 0, 0};
  const Vec3 d = p - 2 * dot(n, p - on) * n - Vec3{0, 0, 1};
  const double x = 80.5 * (1 - d.y / d.x), y = 60.5 * (1 - d.z / d.x / 0.75);
  EXPECT_TRUE(x >= 0 && x < 161 && y >= 0 && y < 121) << x << " " << y;
  return hue(run.image(0).at(static_cast<std::size_t>(y) * 161 + static_cast<std::size_t>(x)));
}

TEST(CameraSense, a_mirror_shows_what_is_before_it_also_when_it_is_tilted) {
  const Vec3 red{-1, 0.9, 1}, blue{-1, -1.2, 0.7};
  Session mirror(before_a_wall("material \"mirror\""), true), wall(before_a_wall(""), true);
  mirror.step();
  wall.step();
  EXPECT_EQ(hue_of_image(mirror, red), 'r');
  EXPECT_EQ(hue_of_image(mirror, blue), 'b');
  EXPECT_EQ(hue_of_image(wall, red), '-');
  const auto has_green = [](Session& run) {
    return std::ranges::any_of(run.image(0), [](std::uint32_t rgb) { return hue(rgb) == 'g'; });
  };
  EXPECT_FALSE(has_green(mirror)) << "behind it";
  EXPECT_EQ(mirror.image(1), wall.image(1)) << "depths are those of the mirror itself";
  const auto before = mirror.image(0);
  for (const geom::Tilt tilt : {geom::Tilt{0, 0.06}, {0.3, -0.05}}) {
    world::Models& models = mirror.world().models;
    const world::ModelRow row = mirror.world().find("wall");
    models.tilt_PM.set(row, tilt);
    world::place_tree(mirror.world(), row);
    mirror.step();
    EXPECT_NE(mirror.image(0), before);
    EXPECT_EQ(hue_of_image(mirror, red), 'r') << tilt.x << " " << tilt.y;
    EXPECT_EQ(hue_of_image(mirror, blue), 'b') << tilt.x << " " << tilt.y;
  }
}

TEST(CameraSense, smooth_metal_of_any_material_is_a_mirror_and_what_is_rough_is_none) {
  const auto shows = [](const std::string& words) {
    Session run(before_a_wall(words), true);
    run.step();
    return hue_of_image(run, {-1, 0.9, 1}) == 'r';
  };
  EXPECT_TRUE(shows("material \"steel\" roughness 0"));
  EXPECT_FALSE(shows("material \"steel\""));
  EXPECT_FALSE(shows("material \"mirror\" roughness 0.4"));
  EXPECT_FALSE(shows("material \"wood\" roughness 0")) << "no metal";
}

TEST(CameraSense, people_are_people) {
  const std::string text = R"(
interval_sim 100
position( name "person" drive "walk" size [0.3 0.5 1.75] color "red" pose [3 0 0 180] )
camera( name "eye" pose [0 0 0.85 0] alwayson 1 resolution [60 80] fov [50 60] range [0.1 12] size [0 0 0] )
camera( name "seg" pose [0 0 0.85 0] alwayson 1 resolution [60 80] fov [50 60] range [0.1 12] size [0 0 0] image "segmentation" )
)";
  Session run(text, true);
  run.step();
  const auto models = run.image(1), color = run.image(0);
  const auto wide_at = [&](std::size_t row) {
    return std::ranges::count(models.begin() + 60 * row, models.begin() + 60 * (row + 1),
                              run.segment("person"));
  };
  // 1.75 m at 3 m in a view of 2 * 3 m * tan(30 degrees): from row 40 - 20.8 to 40 + 19.6.
  EXPECT_EQ(wide_at(17), 0);
  EXPECT_GT(wide_at(21), 0);
  EXPECT_EQ(wide_at(62), 0);
  EXPECT_LT(wide_at(22), wide_at(28)) << "a head is not so wide as shoulders";
  EXPECT_EQ(hue(color[28 * 60 + 30]), 'r') << "its shirt";
}

TEST(CameraSense, a_person_that_waves_raises_a_hand_beside_its_head) {
  const auto beside_the_head = [](const std::string& says) {
    Session run(R"(
interval_sim 100
position( name "person" drive "walk" size [0.3 0.5 1.75] color "red" pose [3 0 0 180] say ")" +
                    says + R"(" )
camera( pose [0 0 0.85 0] alwayson 1 resolution [60 80] fov [50 60] range [0.1 12] size [0 0 0] image "segmentation" )
)",
                true);
    run.step();
    const auto models = run.image(0);
    std::ptrdiff_t found = 0;
    // It faces the camera: its right hand is on the left, above the shoulders, which begin in row 26.
    for (std::size_t row = 10; row < 25; ++row)
      found += std::ranges::count(models.begin() + 60 * row, models.begin() + 60 * row + 26,
                                  run.segment("person"));
    return found;
  };
  EXPECT_EQ(beside_the_head("hello"), 0);
  EXPECT_GT(beside_the_head("*waves*"), 4);
}

/// The brightest red of an image at night of a white wall 3 m ahead, with a lamp beside the camera.
int brightest(const std::string& lamp) {
  Session run(R"(
interval_sim 100
sun [0 -10 0] sky [0 0 0]
model( pose [3 0 0 0] size [0.1 4 2] color "white" )
camera( pose [0 0 0.5 0] size [0 0 0] alwayson 1 resolution [40 30] range [0.1 12] )
)" + lamp,
              true);
  run.step();
  int most = 0;
  for (const std::uint32_t sample : run.image(0)) most = std::max(most, channel(sample, 16));
  return most;
}

TEST(CameraSense, lamps_shine_at_night_in_their_color_while_they_are_lit) {
  const int night = brightest("");
  EXPECT_LT(night, 70);
  EXPECT_GT(brightest("model( pose [0 1 0.9 0] size [0.1 0.1 0.1] color \"white\" lamp 65 )"), night + 80);
  EXPECT_EQ(brightest("model( pose [0 1 0.9 0] size [0.1 0.1 0.1] color \"blue\" lamp 65 )"), night);
  const std::string switched = "blinkenlight( pose [0 1 0.9 0] color \"white\" lamp 65 enabled ";
  EXPECT_GT(brightest(switched + "1 )"), night + 80);
  EXPECT_EQ(brightest(switched + "0 )"), night);
}

TEST(CameraSense, a_lamp_that_is_lit_glows) {
  const auto shown = [](const char* enabled) {
    Session run(std::string(R"(
interval_sim 100
sun [0 -10 0] sky [0 0 0]
camera( pose [0 0 0.5 0] size [0 0 0] alwayson 1 resolution [40 30] range [0.1 12] )
blinkenlight( pose [1 0 0.25 0] size [0.5 0.5 0.5] color "green" enabled )") +
                    enabled + " )",
                true);
    run.step();
    return channel(run.image(0)[15 * 40 + 20], 8);
  };
  EXPECT_GE(shown("1"), 255);
  EXPECT_LT(shown("0"), 70);
}

/// A square in the plane x = -0.5 that faces back, from y = low to y = high and 1 m high.
mesh::Surface square(std::uint32_t material, float low, float high) {
  mesh::Surface surface;
  surface.material = material;
  surface.p = {{-0.5f, low, 0}, {-0.5f, low, 1}, {-0.5f, high, 1}, {-0.5f, high, 0}};
  surface.normal.assign(4, {-1, 0, 0});
  surface.uv.assign(4, {0, 0});
  surface.corners = {{0, 1, 2}, {0, 2, 3}};
  return surface;
}

// The truth is the geometry: the left half of the look is white, its right half green, its model red.
TEST(Looks, are_seen_in_place_of_the_body_and_white_ones_in_the_color_of_the_model) {
  const std::string text = R"(
interval_sim 100
position( name "eye" obstacle_return 0 size [0.1 0.1 0.1] ranger( pose [0 0 0 0] size [0 0 0] sensor( range [0 9] fov 30 samples 31 ) )
  camera( pose [0 0 0.4 0] resolution [40 30] fov [40 30] range [0.1 9] alwayson 1 size [0 0 0] ) )
model( name "box" pose [3 0 0 0] size [1 1 1] color "red" ))";
  config::MemoryFiles files({});
  Result<scene::SceneDesc> scene = scene::load_world_text(text, "w.world", files);
  ASSERT_TRUE(scene);
  const auto bare = make_engine(*scene, {.seed = 1, .workers = 1});
  auto look = std::make_shared<mesh::Mesh>();
  look->materials.resize(2);
  look->materials[1].base = {0, 0.5f, 0, 1};
  look->surfaces = {square(0, 0, 0.5f), square(1, -0.5f, 0)};
  scene::SceneDesc dressed = *scene;
  for (scene::ModelDesc& model : dressed.models)
    if (model.name == "box") model.look = look;
  const auto seen = make_engine(dressed, {.seed = 1, .workers = 1});
  for (const auto* engine : {&bare, &seen}) {
    world::World& world = (**engine)->world();
    world::subscribe(world, world.find("eye.ranger:0"));
    (**engine)->step();
  }
  const world::World& world = (*seen)->world();
  const auto& pixels = world.cameras.pixels[{0}];
  EXPECT_EQ(hue(pixels[15 * 40 + 17].sample), 'r');
  EXPECT_EQ(hue(pixels[15 * 40 + 22].sample), 'g');
  EXPECT_EQ(hue((*bare)->world().cameras.pixels[{0}][15 * 40 + 22].sample), 'r');
  EXPECT_EQ(world.sensors.ranges, (*bare)->world().sensors.ranges);
  EXPECT_NEAR(world.sensors.ranges[{15}], 2.5, 1e-6);
}

TEST(Looks, lights_of_a_mesh_are_where_its_model_is) {
  mesh::Mesh mesh;
  mesh::Light point, spot, sun;
  point.p = {1, 0, 2};
  point.color = {5, 6, 7};
  spot.kind = mesh::LightKind::kSpot;
  spot.d = {1, 0, 0};
  spot.inner = 0.2f;
  spot.outer = 0.5f;
  sun.kind = mesh::LightKind::kDirection;
  mesh.lights = {point, spot, sun};
  std::vector<render::Lamp> lamps;
  add_lamps(mesh, {0.5, 0, 0, geom::kPi / 2}, {10, 0, 0}, geom::orientation(geom::kPi / 2, {}), lamps);
  ASSERT_EQ(lamps.size(), 2u) << "the sun is the world's";
  // The body is half a metre along the model's x, which is the world's y, and turned about: its x is -x.
  EXPECT_NEAR(lamps[0].p.x, 9, 1e-12);
  EXPECT_NEAR(lamps[0].p.y, 0.5, 1e-12);
  EXPECT_NEAR(lamps[0].p.z, 2, 1e-12);
  EXPECT_EQ(lamps[0].light, (render::Rgb{5, 6, 7}));
  EXPECT_EQ(lamps[0].outer, -1) << "every way";
  EXPECT_NEAR(lamps[1].way.x, -1, 1e-12);
  EXPECT_NEAR(lamps[1].inner, std::cos(0.2), 1e-6);
  EXPECT_NEAR(lamps[1].outer, std::cos(0.5), 1e-6);
}

TEST(CameraSense, without_opengl_images_are_those_of_the_stage_engine) {
  CameraSense sense(1, [] {
    return Result<std::unique_ptr<render::Renderer>>(Error{{}, "there is no OpenGL 4.5"});
  });
  Session stage(kFlat, false), other(kFlat, false);
  stage.step();
  other.step();
  // The images of `other` are taken again, from the same state.
  for (auto& pixels : other.world().cameras.pixels) pixels.clear();
  bodies::Shapes shapes(*other.scene);
  bodies::Trees trees = bodies::make_trees(other.world());
  bodies::Solids solids = bodies::make_fixed_solids(other.world(), shapes);
  bodies::replace_moving_solids(solids, other.world(), shapes, trees);
  const bodies::Walls walls(solids);
  bodies::DiscIndex index;
  world::Workers workers(1);
  index.populate(solids.moving(), 0.3, {});
  index.rebuild(
      solids.moving(), [&](std::size_t i) { return bodies::disc_of(solids, solids.moving_rows()[i]); },
      workers);
  const world::KindRow due[] = {{0}, {1}, {2}};
  const bodies::Space space{solids, index, walls};
  sense.populate(other.world(), space);
  EXPECT_EQ(sense.sense(other.world(), space, due, 1, workers), 3u * 64 * 48);
  for (const world::KindRow camera : due)
    EXPECT_EQ(other.image(camera.index), stage.image(camera.index)) << camera.index;
}

TEST(Looks, a_person_walks_as_fast_as_it_moves_and_stands_when_it_does_not) {
  const auto gait = [](const geom::SpatialVelocity& V, double time = 3, std::string_view says = {}) {
    return gait_of({V, 0, 1.75, 1, says}, time);
  };
  EXPECT_EQ(gait({{0.001, 0, 0}, {}}).stride, 0);
  const render::Gait slow = gait({{0.5, 0, 0}, {}}), fast = gait({{1.0, 0, 0}, {}});
  EXPECT_NEAR(fast.stride, 2 * slow.stride, 1e-9);
  EXPECT_EQ(fast.phase, slow.phase) << "its feet go on from where they are";
  EXPECT_LT(gait({{-1, 0, 0}, {}}).stride, 0) << "backwards";
  // So far the feet reach in a second as the person goes.
  const double steps =
      (gait({{1, 0, 0}, {}}, 0.1).phase - gait({{1, 0, 0}, {}}, 0).phase) / (2 * geom::kPi) / 0.1;
  EXPECT_NEAR(fast.stride * 1.75 * (steps < 0 ? steps + 10 : steps), 1, 1e-9);
  EXPECT_TRUE(gait({{}, {0, 0, 1}}).turns);
  EXPECT_FALSE(gait({{1, 0, 0}, {0, 0, 1}}).turns) << "it walks";
  EXPECT_TRUE(gait({}, 3, "*waves*").waves);
  EXPECT_FALSE(gait({}, 3, "hello").waves);
}

TEST(Looks, days_get_dark_when_the_sun_sets) {
  scene::WorldDesc world;
  const render::Environment day = surroundings_of(world, 0);
  EXPECT_GT(day.to_sun.z, 0.7);
  world.sun_elevation = -0.1;
  const render::Environment night = surroundings_of(world, 0);
  EXPECT_LT(night.ambient, 0.2 * day.ambient);
  EXPECT_LT(night.sky[2], 0.2 * day.sky[2]);
}

TEST(Looks, lamps_fade_as_the_sun_rises) {
  const auto white_lux = [](double elevation) {
    scene::WorldDesc world;
    world.sun_elevation = elevation;
    return surroundings_of(world, 0).white_lux;
  };
  EXPECT_NEAR(white_lux(-0.1), 20, 1e-3);
  EXPECT_NEAR(white_lux(1), 2000, 0.1);
  EXPECT_NEAR(white_lux(std::asin(0.175)), 200, 10);  // half way through dawn
}

// The focal length is 32 px; the wall is 2 m before the lens, and its depth is seen 4 px apart.
TEST(CameraSense, a_pair_shows_a_wall_apart_by_its_disparity_whatever_its_direction) {
  const std::string text = R"(
interval_sim 100
define eyes camera( size [0 0 0.1] pose [0 0 0.45 90] resolution [64 48] fov [90 73.7397952917] range [0.1 4] alwayson 1
  baseline 0.25 pantilt [-90 0] )
eyes( image "segmentation" ) eyes( image "color" ) eyes( image "depth" )
model( name "wall" pose [2.5 0 0 0] size [1 0.9 3] color "red" )
model( name "back" pose [4 0 0 0] size [1 20 3] color "blue" )
)";
  for (const bool arena : {false, true}) {
    Session run(text, arena);
    world::Cameras& cameras = run.world().cameras;
    for (const world::CameraRow camera : cameras.rows()) cameras.stereo_open[camera] = 1;
    run.step();
    for (const world::CameraRow camera : cameras.rows()) {
      ASSERT_EQ(cameras.depths[camera].size(), 64u * 48u) << arena;
      EXPECT_NEAR(cameras.depths[camera][24 * 64 + 32], 2, 1e-3) << arena;
      EXPECT_NEAR(cameras.depths[camera][24 * 64 + 2], 3.5, 1e-3) << arena;
    }
    const auto left = run.image(0);
    const std::vector<world::Pixel>& right = cameras.right_pixels[{0}];
    int on_the_wall = 0;
    for (std::size_t i = 24 * 64 + 4; i < 25 * 64; ++i) {
      on_the_wall += left[i] == run.segment("wall");
      EXPECT_EQ(right[i - 4].sample == run.segment("wall"), left[i] == run.segment("wall")) << arena << i;
    }
    EXPECT_EQ(on_the_wall, 14) << "0.9 m of 16 px each";
    EXPECT_EQ(hue(cameras.right_pixels[{1}][24 * 64 + 28].sample), 'r') << arena;
    EXPECT_NEAR(cameras.right_pixels[{2}][24 * 64 + 28].sample, 2000, 1) << arena;
    for (const world::CameraRow camera : cameras.rows()) cameras.stereo_open[camera] = 0;
    run.step();
    EXPECT_TRUE(cameras.right_pixels[{1}].empty() && cameras.depths[{1}].empty()) << arena;
  }
}

}  // namespace
}  // namespace playhouse::arena
