#pragma once

/// Renderer: what draws pictures of a world as it stands. There are two: ours (picture_of_world.h), and the
/// page in Chromium (chromium_renderer.h).

#include "playhouse/app/picture_of_world.h"
#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::app {

inline constexpr double kSeePeriod = 0.2;  // s

class Renderer {
 public:
  virtual ~Renderer() = default;

  /// For how long before a picture it wants to see() the world every kSeePeriod, since what was remains
  /// visible. 0: it draws what is. [s]
  virtual double memory() const { return 0; }
  virtual Result<void> see(const world::World&) { return {}; }

  /// Fails where it cannot, with a text that goes on from its name.
  virtual Result<Picture> draw(const world::World& world, const View& view) = 0;
};

}  // namespace playhouse::app
