// What the pixels of a camera show, against rays that are marched in small steps.

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/rays/lens.h"
#include "playhouse/scene/forms/camera.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::senses {
namespace {

using stage::testing::box;

const scene::Color kRed{1, 0, 0, 1}, kBlue{0, 0, 1, 1};

/// A camera of 41 x 31 pixels, its lens half a metre above the origin, that looks along +x.
scene::SceneDesc lookout(scene::ImageKind image = scene::ImageKind::kColor, double height = 0.5) {
  scene::SceneDesc scene;
  scene::ModelDesc& model = scene.models.emplace_back();
  model.name = model.alias = "camera";
  model.kind = scene::ModelKind::kCamera;
  model.X_PM = {0, 0, height, 0};
  model.alwayson = true;
  model.size = {};
  scene::CameraDesc& camera = model.camera.emplace();
  camera.width = 41;
  camera.height = 31;
  camera.fov_horizontal = geom::radians(80);
  camera.fov_vertical = geom::radians(60);
  camera.image = image;
  return scene;
}

void add(scene::SceneDesc& scene, const scene::Color& color, const geom::Pose& X_WM, const geom::Size& size) {
  scene.models.push_back(box("box" + std::to_string(scene.models.size()), X_WM, size));
  scene.models.back().color = color;
}

/// The image of the first model, after a tick.
class Picture {
 public:
  explicit Picture(const scene::SceneDesc& scene, unsigned workers = 1, std::uint64_t seed = 1,
                   bool is_pair = false)
      : width_(static_cast<std::size_t>(scene.models[0].camera->width)) {
    auto engine = stage::make_engine(scene, {.seed = seed, .workers = workers});
    EXPECT_TRUE(engine.ok());
    world::Cameras& cameras = (*engine)->world().cameras;
    cameras.stereo_open[{0}] = is_pair;
    (*engine)->step();
    EXPECT_EQ(cameras.measured_tick[{0}], 1u);
    pixels_ = cameras.pixels[{0}];
    right_ = cameras.right_pixels[{0}];
    depths_ = cameras.depths[{0}];
  }
  const std::vector<world::Pixel>& right() const { return right_; }
  const std::vector<float>& depths() const { return depths_; }
  std::uint32_t at(std::size_t column, std::size_t row) const {
    return pixels_[row * width_ + column].sample;
  }
  std::size_t count(std::uint32_t sample) const {
    return static_cast<std::size_t>(std::ranges::count(pixels_, sample, &world::Pixel::sample));
  }
  const std::vector<world::Pixel>& pixels() const { return pixels_; }

 private:
  std::size_t width_;
  std::vector<world::Pixel> pixels_, right_;
  std::vector<float> depths_;
};

TEST(CameraSense, shows_bodies_before_the_sky_and_the_floor_where_a_pinhole_would) {
  scene::SceneDesc scene = lookout();
  add(scene, kRed, {2.5, 0, 0, 0}, {1, 1, 1});
  const Picture picture(scene);
  // The face is 2 m ahead and spans 14 degrees to each side of 80 over 41 columns of a plane: 6.1 columns.
  EXPECT_EQ(picture.at(20, 15), 0xff0000u);
  EXPECT_EQ(picture.at(20 - 6, 15), 0xff0000u);
  EXPECT_NE(picture.at(20 - 7, 15), 0xff0000u);
  EXPECT_EQ(picture.at(20 + 6, 15), 0xff0000u);
  EXPECT_NE(picture.at(20 + 7, 15), 0xff0000u);
  // And half a metre up and down from the lens: 0.25 of tan(30 degrees) over 15.5 rows.
  EXPECT_EQ(picture.at(20, 15 - 6), 0xff0000u);
  EXPECT_NE(picture.at(20, 15 - 7), 0xff0000u);
  EXPECT_EQ(picture.at(20, 0), picture.at(0, 0)) << "the sky";
  EXPECT_EQ(picture.at(20, 30), picture.at(0, 30)) << "the floor";
  EXPECT_NE(picture.at(0, 0), picture.at(0, 30));
  EXPECT_EQ(picture.count(0xff0000), 13u * 13u);
}

TEST(CameraSense, shows_what_is_nearer_and_what_is_seen_above_and_below_it) {
  scene::SceneDesc scene = lookout();
  add(scene, kBlue, {4, 0, 0, 0}, {0.5, 4, 2});
  add(scene, kRed, {1.5, 0, 0, 0}, {0.2, 0.4, 0.3});
  scene.models.push_back(box("lamp", {1.5, 0, 0, 0}, {0.2, 0.2, 0.1}));
  scene.models.back().X_PM.z = 0.8;
  scene.models.back().color = {0, 1, 0, 1};
  const Picture picture(scene);
  EXPECT_EQ(picture.at(20, 15), 0x0000ffu) << "between the two";
  EXPECT_EQ(picture.at(20, 20), 0xff0000u);
  EXPECT_EQ(picture.at(20, 9), 0x00ff00u);
}

TEST(CameraSense, tells_distances_along_the_way_it_looks_in_millimetres) {
  scene::SceneDesc scene = lookout(scene::ImageKind::kDepth);
  add(scene, kRed, {3, 0, 0, 0}, {1, 8, 3});
  const Picture picture(scene);
  for (const std::size_t column : {0u, 20u, 40u}) EXPECT_EQ(picture.at(column, 10), 2500u) << column;
  EXPECT_NEAR(picture.at(20, 30), 500 / (std::tan(geom::radians(30)) * 30 / 31), 1) << "the floor";
}

TEST(CameraSense, has_no_depth_beyond_what_a_pixel_holds) {
  for (const auto& [x, depth] : {std::pair{65.5, 65000u}, std::pair{66.6, 0u}}) {
    scene::SceneDesc scene = lookout(scene::ImageKind::kDepth);
    scene.models[0].camera->range_max = 100;
    add(scene, kRed, {x, 0, 0, 0}, {1, 80, 30});
    EXPECT_EQ(Picture(scene).at(20, 10), depth) << x;
  }
}

TEST(CameraSense, shows_nothing_beyond_its_range_or_nearer_than_it) {
  scene::SceneDesc scene = lookout(scene::ImageKind::kDepth, 3);
  add(scene, kRed, {3, 0, 0, 0}, {1, 4, 6});
  EXPECT_GT(Picture(scene).count(2500), 0u);
  scene.models[0].camera->range_max = 2.4;
  EXPECT_EQ(Picture(scene).count(0), Picture(scene).pixels().size());
  scene.models[0].camera->range_max = 8;
  scene.models[0].camera->range_min = 2.6;
  EXPECT_EQ(Picture(scene).count(2500), 0u);
}

TEST(CameraSense, sees_the_tops_of_what_is_below_it_and_what_it_stands_above) {
  scene::SceneDesc scene = lookout();
  scene.models[0].camera->tilt = geom::radians(-60);
  scene.models[0].camera->range_min = 0.01;
  scene.models[0].camera->range_max = 2;
  add(scene, kRed, {0, 0, 0, 0}, {400, 400, 0.05});
  EXPECT_EQ(Picture(scene).count(0xff0000), Picture(scene).pixels().size()) << "its edge is beyond the range";
  scene.models.back().blocks[0].z_max = 0.4;
  EXPECT_EQ(Picture(scene).count(0xff0000), Picture(scene).pixels().size());
}

TEST(CameraSense, sees_the_floor_in_the_rooms_of_a_bitmap) {
  scene::SceneDesc scene = lookout(scene::ImageKind::kColor, 1.5);
  scene.models[0].camera->tilt = geom::radians(-45);
  scene::ModelDesc& walls = scene.models.emplace_back(box("walls", {}, {20, 20, 1}));
  walls.color = kBlue;
  walls.blocks.clear();
  // A square with a room from -1 to 1, low enough to be looked over.
  walls.bitmaps = {{{{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}}, 0, 0.2}};
  const Picture picture(scene);
  EXPECT_NE(picture.at(20, 30), 0x0000ffu) << "the floor of the room";
  EXPECT_EQ(picture.at(20, 12), 0x0000ffu) << "the top of the walls";
}

/// What the straight line through the middle of a pixel meets, found by small steps: the distance along the
/// way that the camera looks, 0 for nothing. [m]
class StepByStep {
 public:
  StepByStep(const scene::SceneDesc& scene, std::uint32_t column, std::uint32_t row) : scene_(scene) {
    const scene::CameraDesc& camera = *scene.models[0].camera;
    const scene::HalfImage half = scene::half_image(camera, camera.fov_horizontal);
    const double left = half.width * (1 - (2 * column + 1) / camera.width);
    const double up = half.height * (1 - (2 * row + 1) / camera.height);
    const double ahead = std::cos(camera.tilt) - std::sin(camera.tilt) * up;
    const double a = scene.models[0].X_PM.a + camera.pan;
    x_ = ahead * std::cos(a) - left * std::sin(a);
    y_ = ahead * std::sin(a) + left * std::cos(a);
    z_ = std::sin(camera.tilt) + std::cos(camera.tilt) * up;
  }

  double depth() const {
    constexpr double kStep = 2e-3;
    const scene::CameraDesc& camera = *scene_.models[0].camera;
    const geom::Pose& X_WM = scene_.models[0].X_PM;
    for (double t = camera.range_min; t <= camera.range_max; t += kStep)
      if (is_solid({X_WM.x + t * x_, X_WM.y + t * y_}, X_WM.z + t * z_)) return t;
    return 0;
  }

 private:
  bool is_solid(geom::Vec2 p, double z) const {
    if (z <= 0) return true;
    for (std::size_t i = 1; i < scene_.models.size(); ++i) {
      const scene::ModelDesc& model = scene_.models[i];
      const geom::Vec2 q = geom::Rotation::of(model.X_PM.a).inverse(p - model.X_PM.xy());
      if (std::fabs(q.x) <= model.size.x / 2 && std::fabs(q.y) <= model.size.y / 2 && z >= model.X_PM.z &&
          z <= model.X_PM.z + model.size.z)
        return true;
    }
    return false;
  }

  const scene::SceneDesc& scene_;
  double x_, y_, z_;
};

TEST(CameraSense, sees_what_a_line_through_each_pixel_meets_step_by_step) {
  Rng rng(1, 0, {Purpose::kTestScene, 3});
  for (int trial = 0; trial < 8; ++trial) {
    scene::SceneDesc scene = lookout(scene::ImageKind::kDepth, rng.uniform(0.3, 1.5));
    scene.models[0].X_PM.a = rng.uniform(-3, 3);
    const double tilt = trial % 2 == 1 ? rng.uniform(-1.2, 0.8) : 0;
    scene.models[0].camera->pan = rng.uniform(-1, 1);
    scene.models[0].camera->tilt = tilt;
    for (int k = 0; k < 40; ++k) {
      const double bearing = rng.uniform(-3.1, 3.1), distance = rng.uniform(1.2, 7);
      add(scene, kRed,
          {distance * std::cos(bearing), distance * std::sin(bearing), rng.uniform(0, 0.6), bearing},
          {rng.uniform(0.1, 0.6), rng.uniform(0.1, 0.6), rng.uniform(0.1, 1)});
    }
    const Picture picture(scene);
    int wrong = 0, pixels = 0;
    for (std::uint32_t row = 0; row < 31; row += 3)
      for (std::uint32_t column = 0; column < 41; column += 4, ++pixels) {
        const double stepped = 1000 * StepByStep(scene, column, row).depth();
        // Steps pass corners by, and pixels of a tilted camera show what is a quarter of a pixel aside.
        const double off = std::fabs(stepped - picture.at(column, row));
        wrong += off > (tilt == 0 ? 4 : 40);
      }
    EXPECT_LT(wrong, tilt == 0 ? 2 : pixels / 12) << trial << " of " << pixels;
  }
}

TEST(CameraSense, sees_the_same_with_any_number_of_workers_and_its_noise_for_a_seed) {
  scene::SceneDesc scene = lookout();
  for (int k = -5; k <= 5; ++k) add(scene, k % 2 ? kRed : kBlue, {4, k * 0.6, 0, 0.1 * k}, {0.5, 0.5, 0.7});
  for (int k = 0; k < 5; ++k) {
    scene.models.push_back(scene.models[0]);
    scene.models.back().name = scene.models.back().alias = "camera" + std::to_string(k);
  }
  EXPECT_EQ(Picture(scene, 1).pixels(), Picture(scene, 3).pixels());
  const Picture clear(scene);
  scene.models[0].camera->noise_value = 0.05;
  EXPECT_EQ(Picture(scene, 1, 7).pixels(), Picture(scene, 2, 7).pixels());
  EXPECT_NE(Picture(scene, 1, 7).pixels(), Picture(scene, 1, 8).pixels());
  const Picture noisy(scene, 1, 7);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < clear.pixels().size(); ++i) {
    const auto green = [&](const Picture& picture) {
      return static_cast<double>(picture.pixels()[i].sample >> 8 & 0xff);
    };
    if (green(clear) < 50 || green(clear) > 220) continue;  // where nothing is cut off
    sum += 1;
    squares += (green(noisy) - green(clear)) * (green(noisy) - green(clear));
  }
  ASSERT_GT(sum, 300);
  EXPECT_NEAR(std::sqrt(squares / sum), 0.05 * 255, 1.5);
}

TEST(CameraSense, tells_which_model_is_where_by_its_id_plus_one) {
  scene::SceneDesc scene = lookout(scene::ImageKind::kSegmentation);
  scene.models[0].camera->noise_value = 0.2;  // which is of colours
  add(scene, kRed, {2.5, 0, 0, 0}, {1, 1, 1});
  add(scene, kRed, {2.5, 1.5, 0, 0}, {1, 1, 1});
  const Picture picture(scene);
  EXPECT_EQ(picture.at(20, 15), 2u) << "the first box has the id 1";
  EXPECT_EQ(picture.count(2), 13u * 13u);
  EXPECT_GT(picture.count(3), 50u);
  EXPECT_EQ(picture.count(0) + picture.count(2) + picture.count(3), picture.pixels().size());
  EXPECT_EQ(picture.at(20, 0), 0u) << "the sky";
  EXPECT_EQ(picture.at(20, 30), 0u) << "the floor";
}

TEST(CameraSense, shows_the_sky_that_the_file_says) {
  scene::SceneDesc scene = lookout();
  scene.sky_red = 1;
  scene.sky_green = 0.5;
  scene.sky_blue = 0;
  EXPECT_EQ(Picture(scene).at(20, 0), 0xff8000u);
}

TEST(Lens, has_each_pixel_once) {
  const scene::CameraDesc camera = *lookout().models[0].camera;
  for (const double tilt : {0.0, 0.4, -1.2, -geom::kPi / 2}) {
    const rays::Lens lens = rays::make_lens(camera, tilt, camera.fov_horizontal);
    std::vector<std::uint32_t> place = lens.place;
    std::ranges::sort(place);
    for (std::uint32_t i = 0; i < 41 * 31; ++i) ASSERT_EQ(place[i], i) << tilt;
    EXPECT_EQ(lens.first.back(), 41u * 31u);
    if (tilt == 0) EXPECT_EQ(lens.ahead.size(), 41u);
  }
}

/// Two walls of one depth, side by side before a third one, and a baseline of so many pixels of disparity.
scene::SceneDesc before_walls(double pixels, scene::ImageKind image = scene::ImageKind::kColor) {
  scene::SceneDesc scene = lookout(image);
  add(scene, kRed, {2.5, 0.3, 0, 0}, {1, 0.6, 4});
  add(scene, kBlue, {2.5, -0.2, 0, 0}, {1, 0.4, 4});
  add(scene, {0, 1, 0, 1}, {7, 0, 0, 0}, {1, 40, 4});
  scene.models[0].camera->baseline =
      pixels * 2 / scene::focal_length(*scene.models[0].camera, geom::radians(80));
  return scene;
}

TEST(CameraSense, the_right_image_of_a_wall_is_the_left_one_shifted_by_its_disparity) {
  const Picture picture(before_walls(3), 1, 1, true);
  ASSERT_EQ(picture.right().size(), 41u * 31u);
  int shifted = 0;
  for (std::size_t i = 3; i < 41; ++i) {
    const std::uint32_t left = picture.at(i, 15), right = picture.right()[15 * 41 + i - 3].sample;
    const bool is_near = left == 0xff0000 || left == 0x0000ff;
    if (is_near) EXPECT_EQ(right, left) << i;
    shifted += is_near;
  }
  EXPECT_EQ(shifted, 12) << "a metre at 2 m";
  EXPECT_NE(picture.pixels(), picture.right());
}

TEST(CameraSense, depths_of_a_pair_are_those_along_the_axis) {
  const Picture picture(before_walls(3), 1, 1, true);
  ASSERT_EQ(picture.depths().size(), 41u * 31u);
  EXPECT_FLOAT_EQ(picture.depths()[15 * 41 + 20], 2);
  EXPECT_FLOAT_EQ(picture.depths()[15 * 41 + 1], 6.5f);
  EXPECT_EQ(picture.depths()[0], 0) << "the sky";
}

TEST(CameraSense, has_one_image_while_nobody_reads_pairs) {
  const Picture alone(before_walls(3)), pair(before_walls(3), 1, 1, true), one(before_walls(0), 1, 1, true);
  EXPECT_TRUE(alone.right().empty() && alone.depths().empty());
  EXPECT_TRUE(one.right().empty() && one.depths().empty());
  EXPECT_EQ(alone.pixels(), pair.pixels());
}

TEST(CameraSense, the_images_of_a_pair_have_noise_of_their_own_and_depths_that_of_the_depth_image) {
  scene::SceneDesc scene = before_walls(0.0001);
  scene.models[0].camera->noise_value = 0.1;
  const Picture noisy(scene, 1, 1, true);
  EXPECT_NE(noisy.pixels(), noisy.right());
  scene = before_walls(0.0001, scene::ImageKind::kDepth);
  scene.models[0].camera->noise_depth = 0.05;
  const Picture far(scene, 1, 1, true);
  EXPECT_NE(far.pixels(), far.right());
  for (std::size_t i = 0; i < far.depths().size(); ++i)
    EXPECT_NEAR(1000 * far.depths()[i], far.pixels()[i].sample, 0.51) << i;
}

}  // namespace
}  // namespace playhouse::senses
