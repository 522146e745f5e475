#pragma once

/// WorldRenderer: draws pictures of a world's present state. Implementations: our
/// own (picture_of_world.h), and the page in Chromium (chromium_renderer.h).

#include "playhouse/app/pictures/picture_of_world.h"
#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::app {

inline constexpr double kSeePeriod = 0.2;  // s

class WorldRenderer {
 public:
  virtual ~WorldRenderer() = default;

  /// Time before a picture during which see() has to be called
  /// every kSeePeriod, to accumulate trails. 0: not needed. [s]
  virtual double memory() const { return 0; }
  virtual Result<void> see(const world::World&) { return {}; }

  /// Fails with a predicate for its name.
  virtual Result<scene::RgbImage> draw(const world::World& world, const Viewport& view) = 0;
};

}  // namespace playhouse::app
