#pragma once

/// Sight: from where pictures of a run are seen: from above, or by a camera in the world.

#include "playhouse/app/commands/options.h"
#include "playhouse/app/pictures/picture_of_world.h"
#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::app {

class Sight {
 public:
  /// Fails on a name that no model of the world has.
  static Result<Sight> of(const SightOptions& options, const world::World& world);

  /// The view of this width at a moment; from above that of view_of(). A model that is gone is seen, or
  /// sees, from where it last was. Fails like view_of().
  Result<Viewport> at(const world::World& world, int width);
  /// True if the view of a run stays as it is at first.
  bool is_fixed() const { return !model_; }

 private:
  enum class From : std::uint8_t { kAbove, kPlace, kBehind, kModel };

  Eye eye_of(const world::World& world) const;

  From from_ = From::kAbove;
  geom::Vec3 place_;                     // of the camera, of kPlace
  std::optional<geom::Vec3> target_;     // what it looks at; none: the middle, or the model
  std::optional<world::ModelId> model_;  // what it follows, or who sees
  std::optional<Eye> last_;              // while the model is there
};

}  // namespace playhouse::app
