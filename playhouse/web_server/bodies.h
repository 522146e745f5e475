#pragma once

/// Bodies: the models that viewers have joined the world as, one each. They come and go with ticks, so that
/// who leaves may do so before the body has come. Thread: web.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "playhouse/net/io_loop.h"
#include "playhouse/replicate/command.h"
#include "playhouse/replicate/prototypes.h"
#include "playhouse/replicate/layout.h"
#include "playhouse/world/control.h"

namespace playhouse::web_server {

/// Posts a change of the world. Fails where nobody may change it, and where the tick's queue is full.
Result<void> post_change(world::Control& control, std::function<void(world::World&)> change);

class Bodies : public std::enable_shared_from_this<Bodies> {
 public:
  /// Hears of a body that has come, and how it walks: JSON text for the page's prediction.
  using Came = std::function<void(std::uint32_t viewer, world::ModelId body, const std::string& walk)>;

  /// What is referred to outlives this; `engine` is its name. Held by a shared_ptr: changes that were posted
  /// find out whether it is gone.
  Bodies(net::IoLoop& loop, world::Control& control, const scene::SceneDesc& scene,
         const replicate::Prototypes& prototypes, std::string engine, Came came)
      : loop_(loop),
        control_(control),
        scene_(scene),
        prototypes_(prototypes),
        engine_(std::move(engine)),
        came_(std::move(came)) {}

  /// A person comes for the viewer, under this name or one like it; the body that it had before goes. What
  /// becomes known later goes to `tell`, on the tick thread.
  Result<void> join(const replicate::Join& join, std::uint32_t viewer, const std::string& name,
                    std::function<void(std::string)> tell);
  void leave(std::uint32_t viewer);

  /// None: it has not joined, or its body has not come yet.
  std::optional<world::ModelId> of(std::uint32_t viewer) const;
  /// The same, unless the id names somebody else as far as viewers know: what a controller makes within a
  /// tick may have it once the run began again.
  std::optional<world::ModelId> of(std::uint32_t viewer, const replicate::Layout& now) const;

 private:
  struct Body {
    std::optional<world::ModelId> model;  // none: it has not come yet
    std::uint32_t desc = 0;               // what it was made from
    bool is_left = false;                 // the viewer has gone, or has another one
  };

  void came(std::uint32_t viewer, Body& body, world::ModelId model);
  void remove(const Body& body);
  std::string walk_text(const scene::PositionDesc& desc) const;

  net::IoLoop& loop_;
  world::Control& control_;
  const scene::SceneDesc& scene_;
  const replicate::Prototypes& prototypes_;
  const std::string engine_;
  const Came came_;
  std::map<std::uint32_t, std::shared_ptr<Body>> bodies_;  // by the viewer's number
};

}  // namespace playhouse::web_server
