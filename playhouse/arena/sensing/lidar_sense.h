#pragma once

/// LidarSense: rangers in 3D. Rays follow the tilt of the ranger, in any number of
/// rings, and hit bodies in their full orientation and the ground. A single-beam
/// transducer sees a cone: the nearest of the hit on its axis and the off-axis hits
/// that face it. Noise is that of the stage engine, plus a lidar's (lidar_echo.h).
///
/// In: poses and tilts of models; the population's surfaces and optics.
/// Out: ranges and intensities of the rangers that are due.
/// Cost: in each tick with a due ranger an index of the movable bodies (RayScene::commit()), and
///   RayScene::cast() for each ray.

#include <map>
#include <vector>

#include "playhouse/arena/sensing/lidar_beams.h"
#include "playhouse/arena/sensing/lidar_echo.h"
#include "playhouse/arena/sensing/ray_scene.h"
#include "playhouse/senses/sense_phase.h"

namespace playhouse::arena {

class LidarSense final : public senses::SensePhase {
 public:
  explicit LidarSense(unsigned workers) : scratch_(workers) {}

  senses::SensorTable table(world::World& world) const override;
  void populate(const world::World& world, const bodies::Space& space) override;
  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t tick, world::Workers& workers) override;

 private:
  struct LidarScratch {
    RayBatch rays;
    std::size_t ray[RayBatch::kMost] = {};  // rows of LidarBeams::rays
    std::vector<double> range;              // m (beams)
    std::vector<float> intensity;           // (beams)
  };

  void populate_fixed(const world::World& world, const bodies::Solids& solids);
  void populate_moving(const world::World& world, const bodies::Solids& solids);
  void populate_rangers(const world::World& world);
  void place(const world::Models& models);
  const LidarBeams& beams(const world::World& world, world::RangerRow ranger) const;
  void measure(world::World& world, world::RangerRow ranger, std::uint64_t tick, LidarScratch& scratch) const;
  /// One measurement.
  struct Measurement {
    const world::World& world;
    world::ModelRow model;
    std::uint64_t tick;
    const LidarBeams& beams;
  };
  void cast(const Measurement& look, LidarScratch& scratch) const;
  void keep_nearest(const LidarBeams& beams, std::size_t k, LidarScratch& scratch) const;
  void keep_echo(const Measurement& look, std::size_t k, LidarScratch& scratch) const;
  static void store(world::World& world, const LidarBeams& beams, world::RangerRow ranger,
                    LidarScratch& scratch);

  RayScene scene_;
  std::vector<bodies::StaticModel> fixed_;           // that scene_ has
  std::map<std::uint32_t, std::uint32_t> shape_of_;  // by row of SceneDesc::models, of movable models
  std::vector<world::ModelRow> instances_;
  std::map<std::uint32_t, LidarBeams> beams_;  // by row of SceneDesc::models
  std::vector<float> returns_;                 // return value of a beam that hits a model (models)
  std::vector<Optics> optics_;                 // (models)
  std::vector<LidarScratch> scratch_;          // one per worker
};

std::unique_ptr<senses::SensePhase> make_lidar_sense(unsigned workers);

}  // namespace playhouse::arena
