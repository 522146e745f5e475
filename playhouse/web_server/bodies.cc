#include "playhouse/web_server/bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/world/population/population.h"

namespace playhouse::web_server {
namespace {

bool walks(const scene::ModelDesc& model) {
  return model.position && model.position->drive == scene::Drive::kWalk;
}

}  // namespace

Result<void> post_change(world::Control& control, std::function<void(world::Journal&)> change) {
  if (std::string why = control.why_fixed(); !why.empty()) return Error{"", std::move(why)};
  if (control.post(std::move(change))) return {};
  return Error{"", "the program is too busy to do that"};
}

Result<void> Bodies::join(const replicate::Join& join, std::uint32_t viewer, const std::string& name,
                          std::function<void(std::string)> tell) {
  const auto person = std::ranges::find_if(
      prototypes_.addable(), [this](const auto& each) { return walks(scene_.models[each.desc]); });
  if (person == prototypes_.addable().end())
    return Error{"",
                 "nobody can join this world: it has no position with drive \"walk\" (worlds/person.inc)"};
  const double now = network_.now();
  if (const auto own = bodies_.find(viewer); own != bodies_.end() && now - own->second->asked < join_period_)
    return Error{"", "you have joined just now; try again in a second"};
  leave(viewer);
  const auto body = bodies_[viewer] = std::make_shared<ViewerBody>();
  body->asked = now;
  body->desc = person->desc;
  return post_change(control_,
                     [join, viewer, name, body, desc = person->desc, tell = std::move(tell), place = place_,
                      weak = weak_from_this(), &network = network_](world::Journal& journal) {
                       const world::World& world = journal.world();
                       const geom::Pose wanted{join.x, join.y, world.scene().models[desc].X_PM.z, join.a};
                       const Result<geom::Pose> X_WM = place ? place(world, desc, wanted) : wanted;
                       if (!X_WM) return tell(X_WM.error().text);
                       const bool is_taken = static_cast<bool>(world.find(name));
                       const std::string own = is_taken ? world::fresh_name(world, name) : name;
                       const auto spawned = journal.spawn(desc, *X_WM, own);
                       if (!spawned) return tell(spawned.error().text);
                       if (is_taken)
                         tell(fmt::format("somebody is called {} already: you are {}", name, own));
                       network.post([weak, viewer, body, model = *spawned] {
                         if (const auto self = weak.lock()) self->came(viewer, *body, model);
                       });
                     });
}

void Bodies::came(std::uint32_t viewer, ViewerBody& body, world::ModelId model) {
  body.model = model;
  if (body.is_left) return remove(body);
  control_.reserve(model, true);
  came_(viewer, model, walk_text(*scene_.models[body.desc].position));
}

void Bodies::leave(std::uint32_t viewer) {
  const auto own = bodies_.find(viewer);
  if (own == bodies_.end()) return;
  own->second->is_left = true;
  remove(*own->second);
  bodies_.erase(own);
}

bool Bodies::is_of_another(world::ModelId model, std::uint32_t viewer) const {
  return std::ranges::any_of(
      bodies_, [=](const auto& each) { return each.first != viewer && each.second->model == model; });
}

void Bodies::remove(const ViewerBody& body) {
  if (!body.model) return;
  control_.reserve(*body.model, false);
  const auto change = [model = *body.model, desc = body.desc](world::Journal& journal) {
    const world::World& world = journal.world();
    const world::ModelRow row = world.row(model);
    if (!row || world.models.desc[row] != desc) return;  // removed already
    const Result<void> gone = journal.despawn(model);
    if (!gone) log::warn("web: the body of somebody who left stays: {}", gone.error().text);
  };
  const Result<void> posted = post_change(control_, change);
  if (!posted) log::warn("web: the body of somebody who left stays: {}", posted.error().text);
}

std::optional<world::ModelId> Bodies::of(std::uint32_t viewer) const {
  const auto own = bodies_.find(viewer);
  return own == bodies_.end() ? std::nullopt : own->second->model;
}

std::optional<world::ModelId> Bodies::of(std::uint32_t viewer, const replicate::Layout& now) const {
  const std::optional<world::ModelId> model = of(viewer);
  const world::ModelRow row = model ? now.row(*model) : world::ModelRow{};
  if (!row) return model;
  const std::uint32_t desc = bodies_.at(viewer)->desc;
  const bool is_same = now.root[row] == row && now.prototype[row] == prototypes_.of(desc);
  return is_same ? model : std::nullopt;
}

std::string Bodies::walk_text(const scene::PositionDesc& desc) const {
  const auto bounds = [&desc](int axis) {
    return fmt::format("[{},{}]", desc.velocity_bounds[axis].min, desc.velocity_bounds[axis].max);
  };
  return fmt::format(R"({{"engine":"{}","ahead":{},"aside":{},"turn":{}}})", engine_, bounds(0), bounds(1),
                     bounds(3));
}

}  // namespace playhouse::web_server
