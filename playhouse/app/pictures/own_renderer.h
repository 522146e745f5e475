#pragma once

/// OwnRenderer: pictures without a browser: from above by a painter in software (picture_of_world.h), by a
/// camera in the world as cameras of the arena see it (render/renderer.h).

#include <memory>
#include <optional>
#include <vector>

#include "playhouse/app/pictures/renderer.h"
#include "playhouse/app/pictures/sensor_shapes.h"
#include "playhouse/arena/sensing/drawn_bodies.h"
#include "playhouse/render/renderer.h"

namespace playhouse::app {

class OwnRenderer final : public WorldRenderer {
 public:
  /// `seen` must outlive it.
  explicit OwnRenderer(const SensorShapes& seen) : seen_(seen) {}

  /// Fails for a camera in the world, if there is no OpenGL.
  Result<scene::RgbImage> draw(const world::World& world, const Viewport& view) override;

 private:
  Result<scene::RgbImage> draw_by_camera(const world::World& world, const Viewport& view);
  Result<void> begin();
  void find_bodies(const world::World& world);

  const SensorShapes& seen_;
  std::unique_ptr<render::Renderer> renderer_;  // null before the first picture by a camera
  arena::DrawnBodies bodies_;
  std::optional<std::uint64_t> population_;  // of bodies_
  std::vector<render::Picture> pictures_;
};

}  // namespace playhouse::app
