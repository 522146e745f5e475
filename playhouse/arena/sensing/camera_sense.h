#pragma once

/// CameraSense: cameras rendered in 3D (render/renderer.h): bodies in their full
/// orientation, walking people, lights, shadows, fog and smoke. Image type, range and
/// noise are those of the stage engine, whose images are also the fallback without OpenGL.
///
/// In: poses, bodies, colours and lamps of models; the pose of each camera; sun, sky and fog.
/// Out: the pixels of cameras; of stereo cameras that are read as such also those of the right lens, and the depths.
/// Cost: OpenGL is initialised by the first image of a run; then one Renderer::draw() per tick for all its
/// images. Thread: the tick thread; conversion to pixels on the workers.

#include <memory>
#include <vector>

#include "playhouse/arena/sensing/drawn_bodies.h"
#include "playhouse/render/renderer.h"
#include "playhouse/senses/sense_phase.h"

namespace playhouse::arena {

class CameraSense final : public senses::SensePhase {
 public:
  using MakeRenderer = Result<std::unique_ptr<render::Renderer>> (*)();

  explicit CameraSense(unsigned workers, MakeRenderer make = render::Renderer::make)
      : workers_(workers), make_(make) {}

  senses::SensorTable table(world::World& world) const override;
  void populate(const world::World& world, const bodies::Space& space) override;
  /// The last bits of a picture depend on its place in a page of pictures, and on the renderer.
  behaviour::Sharing sharing() const override { return behaviour::Sharing::kHead; }
  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t tick, world::Workers& workers) override;

 private:
  /// The pictures of a camera, by their numbers.
  struct PicturesOfCamera {
    world::CameraRow camera;
    std::size_t picture = 0;
    bool is_pair = false;
    std::size_t right = 0, depths = 0;
  };

  void begin();
  PicturesOfCamera take(const world::World& world, world::CameraRow camera);
  std::size_t add(const render::View& view);
  void expose(world::World& world, const PicturesOfCamera& taken, std::uint64_t tick) const;
  render::View view_of(const world::World& world, world::CameraRow camera) const;

  unsigned workers_;
  MakeRenderer make_;
  std::unique_ptr<render::Renderer> renderer_;   // null before the first image
  std::unique_ptr<senses::SensePhase> instead_;  // fallback without OpenGL
  bool is_stale_ = true;                         // the list of bodies is out of date with the population
  DrawnBodies bodies_;
  std::vector<PicturesOfCamera> taken_;
  std::vector<render::View> views_;
  std::vector<render::Picture> pictures_;
};

std::unique_ptr<senses::SensePhase> make_camera_sense(unsigned workers);

}  // namespace playhouse::arena
