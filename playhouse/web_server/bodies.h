#pragma once

/// Bodies: the avatars of viewers, at most one each. They are spawned and removed
/// between ticks, so a viewer may leave before its body exists. Thread: web.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "playhouse/net/network.h"
#include "playhouse/replicate/command.h"
#include "playhouse/replicate/layout.h"
#include "playhouse/replicate/prototypes.h"
#include "playhouse/world/control.h"

namespace playhouse::web_server {

/// Queues a change of the world. Fails if changes are not allowed or the queue is full.
Result<void> post_change(world::Control& control, std::function<void(world::Journal&)> change);

/// The place for a tree of the prototype at this row of SceneDesc::models for somebody who asks for
/// X_WM, or why there is none, as one line.
using PlaceOfBody = std::function<Result<geom::Pose>(const world::World& world, std::uint32_t prototype,
                                                     const geom::Pose& X_WM)>;

class Bodies : public std::enable_shared_from_this<Bodies> {
 public:
  /// Called when a body has been spawned; `walk`: JSON parameters of its gait, for client-side prediction.
  using Came = std::function<void(std::uint32_t viewer, world::ModelId body, const std::string& walk)>;

  /// References must outlive this; `engine` is its name; `join_period`: the least time between two
  /// joins of one viewer; `place`, if not empty, is called on the tick thread. Must be owned by a shared_ptr:
  /// queued changes hold a weak one.
  Bodies(net::Network& network, world::Control& control, const scene::SceneDesc& scene,
         const replicate::Prototypes& prototypes, std::string engine, double join_period, PlaceOfBody place,
         Came came)
      : network_(network),
        control_(control),
        scene_(scene),
        prototypes_(prototypes),
        engine_(std::move(engine)),
        join_period_(join_period),
        place_(std::move(place)),
        came_(std::move(came)) {}

  /// Spawns a person for the viewer, under this name or one derived from it; replaces
  /// its previous body. Fails within the join period after the last time: a body that comes changes the
  /// population, of which every viewer is told. Later errors are passed to `tell`, on the tick thread.
  Result<void> join(const replicate::Join& join, std::uint32_t viewer, const std::string& name,
                    std::function<void(std::string)> tell);
  void leave(std::uint32_t viewer);

  /// None if it has not joined or its body is not spawned yet.
  std::optional<world::ModelId> of(std::uint32_t viewer) const;
  /// True for the body of another viewer.
  bool is_of_another(world::ModelId model, std::uint32_t viewer) const;
  /// As of(), but none if the id names another model in `now`: after a
  /// restart of the run, a model spawned by a controller may have it.
  std::optional<world::ModelId> of(std::uint32_t viewer, const replicate::Layout& now) const;

 private:
  struct ViewerBody {
    double asked = 0;                     // for it [s]
    std::optional<world::ModelId> model;  // none: not spawned yet
    std::uint32_t desc = 0;               // its prototype
    bool is_left = false;                 // the viewer has left or has a newer body
  };

  void came(std::uint32_t viewer, ViewerBody& body, world::ModelId model);
  void remove(const ViewerBody& body);
  std::string walk_text(const scene::PositionDesc& desc) const;

  net::Network& network_;
  world::Control& control_;
  const scene::SceneDesc& scene_;
  const replicate::Prototypes& prototypes_;
  const std::string engine_;
  const double join_period_;
  const PlaceOfBody place_;
  const Came came_;
  std::map<std::uint32_t, std::shared_ptr<ViewerBody>> bodies_;  // by viewer number
};

}  // namespace playhouse::web_server
