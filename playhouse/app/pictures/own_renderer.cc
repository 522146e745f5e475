#include "playhouse/app/pictures/own_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "playhouse/arena/sensing/looks.h"
#include "playhouse/base/log.h"
#include "playhouse/bodies/bodies.h"

namespace playhouse::app {
namespace {

constexpr double kEyeNear = 0.02, kEyeFar = 1000;  // m
constexpr int kSubpixels = 2;                      // of a pixel's side, against jagged edges
constexpr int kMostSide = 16384;                   // px of a picture of the renderer

/// The camera of a view, with `times` as many pixels to a side.
render::View camera_of(const world::World& world, const Viewport& view, int times) {
  const Eye& eye = *view.eye;
  render::View camera;
  camera.eye = eye.p;
  camera.q_WC = geom::orientation(geom::normalize(eye.yaw), {0, -eye.pitch});
  camera.half_height = std::tan(0.5 * eye.fov);
  camera.half_width = camera.half_height * view.width / view.height;
  camera.near = kEyeNear;
  camera.far = kEyeFar;
  camera.width = static_cast<std::uint32_t>(times * view.width);
  camera.height = static_cast<std::uint32_t>(times * view.height);
  if (const world::ModelRow row = eye.of ? world.row(*eye.of) : world::ModelRow{})
    camera.hides = world.models.root[row].index;
  return camera;
}

/// The mean of `times` x `times` samples, 0xRRGGBB, for each pixel.
images::RgbImage mean_of(const std::vector<std::uint32_t>& samples, const Viewport& view, int times) {
  images::RgbImage picture{view.width, view.height, {}};
  picture.rgb.reserve(3 * static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  const auto across = static_cast<std::size_t>(times) * static_cast<std::size_t>(view.width);
  const auto side = static_cast<std::size_t>(times);
  for (std::size_t y = 0; y < static_cast<std::size_t>(view.height); ++y)
    for (std::size_t x = 0; x < static_cast<std::size_t>(view.width); ++x) {
      std::array<std::uint32_t, 3> sum{};
      for (std::size_t k = 0; k < side * side; ++k) {
        const std::uint32_t sample = samples[(y * side + k / side) * across + x * side + k % side];
        for (std::size_t channel = 0; channel < 3; ++channel)
          sum[channel] += sample >> (16 - 8 * channel) & 0xff;
      }
      for (const std::uint32_t channel : sum)
        picture.rgb.push_back(static_cast<std::uint8_t>(channel / (side * side)));
    }
  return picture;
}

}  // namespace

Result<images::RgbImage> OwnRenderer::draw(const world::World& world, const Viewport& view) {
  return view.eye ? draw_by_camera(world, view) : Result<images::RgbImage>(picture_of(world, view, seen_));
}

Result<void> OwnRenderer::begin() {
  if (renderer_) return {};
  Result<std::unique_ptr<render::Renderer>> made = render::Renderer::make();
  if (!made) return Error{"", "draws from above only: " + made.error().line()};
  renderer_ = std::move(*made);
  if (!seen_.empty()) log::warn("--show has an effect from above only, without Chromium");
  return {};
}

void OwnRenderer::find_bodies(const world::World& world) {
  if (population_ == world.population()) return;
  population_ = world.population();
  bodies::Shapes shapes(world.scene());
  bodies::Trees trees = bodies::make_trees(world);
  bodies::Solids solids = bodies::make_fixed_solids(world, shapes);
  bodies::replace_moving_solids(solids, world, shapes, trees);
  bodies_.find(world, solids, *renderer_);
}

Result<images::RgbImage> OwnRenderer::draw_by_camera(const world::World& world, const Viewport& view) {
  if (const Result<void> begun = begin(); !begun) return begun.error();
  find_bodies(world);
  const double time = static_cast<double>(world.tick()) * world.scene().interval;
  bodies_.place(world, time);
  const int times = kSubpixels * std::max(view.width, view.height) <= kMostSide ? kSubpixels : 1;
  const render::View camera = camera_of(world, view, times);
  renderer_->draw(arena::surroundings_of(world.scene(), time), bodies_.scene(), {&camera, 1}, pictures_);
  return mean_of(pictures_.front().sample, view, times);
}

}  // namespace playhouse::app
