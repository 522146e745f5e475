#pragma once

/// DrawnBodies: the models of a world as a scene of the renderer (render/renderer.h): bodies in their full
/// orientation, looks, walking people, smoke and lamps. Shared by cameras of the arena and by pictures.
///
/// In: poses, bodies, colours and lamps of models.
/// Out: render::Scene.
/// Cost: find() after each change of the population; a shape is made once per description.
/// Thread: one at a time.

#include <cstdint>
#include <map>
#include <vector>

#include "playhouse/bodies/bodies.h"
#include "playhouse/render/renderer.h"

namespace playhouse::arena {

/// Pose of a model's frame in W.
struct PlacedModel {
  geom::Vec3 p;
  geom::Quaternion q;
};
PlacedModel model_in_world(const world::Models& models, world::ModelRow row);

class DrawnBodies {
 public:
  /// Lists what is to be drawn; after each change of the population. Adds shapes to the renderer, always
  /// the same one.
  void find(const world::World& world, const bodies::Solids& solids, render::Renderer& renderer);
  /// Places all of it for a time. [s]
  void place(const world::World& world, double time);
  /// Of the last place(), while this object lives.
  render::Scene scene() const { return {instances_, figures_, clouds_, lamps_}; }

 private:
  /// A body that cameras may see, by one of its shapes.
  struct DrawnModel {
    world::ModelRow model;
    std::uint32_t shape = 0;  // of the renderer
    bool is_tinted = false;   // by the colour of the model; a mesh has its own colours
  };
  struct DrawnShape {
    std::uint32_t shape = 0;
    bool is_tinted = false;
  };

  void add_shapes(const scene::ModelDesc& desc, const bodies::Solids& solids, bodies::SolidRows rows,
                  render::Renderer& renderer, std::vector<DrawnShape>& shapes) const;
  /// The model with its solids `rows`, in the shapes of its description.
  void add_body(const world::World& world, world::ModelRow model, const bodies::Solids& solids,
                bodies::SolidRows rows, render::Renderer& renderer);
  void place_bodies(const world::World& world);
  void place_people(const world::World& world, double time);
  void place_smoke(const world::World& world);
  void place_lamps(const world::World& world);

  std::map<std::uint32_t, std::vector<DrawnShape>> shapes_of_;  // by row of SceneDesc::models
  std::vector<DrawnModel> bodies_;
  std::vector<world::ModelRow> people_, smokes_, shining_;
  std::vector<render::Instance> instances_;
  std::vector<render::Figure> figures_;
  std::vector<render::Smoke> clouds_;
  std::vector<render::Lamp> lamps_;
};

}  // namespace playhouse::arena
