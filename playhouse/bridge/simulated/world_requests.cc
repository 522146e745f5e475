#include "playhouse/bridge/simulated/world_requests.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/bridge/simulated/joining.h"
#include "playhouse/wire/codec.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/speech.h"

namespace playhouse::drivers {
namespace {

namespace sim = wire::simulation;

static_assert(std::endian::native == std::endian::little, "property values travel in a PC's byte order");

/// A request with its replier, copyable into tasks.
struct Asked {
  sim::PropertyReq request;
  std::shared_ptr<device::Replier> replier;

  void ack(std::string value = {}) const {
    sim::PropertyReq body = request;
    body.value = std::move(value);
    replier->ack(wire::encode(body));
  }
  void nack(std::string_view why) const {
    sim::PropertyReq body = request;
    body.value = wire::c_string(why);
    replier->nack(wire::encode(body));
  }
  /// As the callback of a step.
  run::LockStep::Done when_done() const {
    return [asked = *this](std::optional<std::string> why_not) {
      if (why_not) return asked.nack(*why_not);
      asked.ack();
    };
  }
};

/// A number of 4 or 8 bytes; none for other sizes.
std::optional<std::uint64_t> number(std::string_view value) {
  if (value.size() == sizeof(std::uint32_t)) {
    std::uint32_t number = 0;
    std::memcpy(&number, value.data(), sizeof number);
    return number;
  }
  if (value.size() != sizeof(std::uint64_t)) return std::nullopt;
  std::uint64_t number = 0;
  std::memcpy(&number, value.data(), sizeof number);
  return number;
}

/// Removes a member when its client disconnects, whatever it waits for.
void watch(run::LockStep& lock_step, device::Caller& caller) {
  if (lock_step.has(&caller))
    caller.when_gone_once(&lock_step, [&lock_step, who = &caller] { lock_step.leave(who); });
}

void join(run::Simulation& simulation, const Asked& asked, device::Caller* caller) {
  run::LockStep* lock_step = simulation.lock_step();
  if (lock_step == nullptr)
    return asked.nack("this world goes on by itself: it was not started with --lock-step");
  if (caller == nullptr) return asked.nack("clients alone join");
  const std::string name(wire::text(asked.request.value));
  if (name.empty()) return asked.nack("a name is missing");
  const std::string why_not = lock_step->join(caller, name, caller->name());
  watch(*lock_step, *caller);
  if (!why_not.empty()) return asked.nack(why_not);
  asked.ack();
}

void step(run::Simulation& simulation, const Asked& asked, device::Caller* caller) {
  const std::optional<std::uint64_t> ticks =
      asked.request.value.empty() ? std::optional<std::uint64_t>(1) : number(asked.request.value);
  run::LockStep* lock_step = simulation.lock_step();
  const std::uint32_t most = lock_step == nullptr ? limits::kSingleSteps : limits::kStepTicks;
  if (!ticks || *ticks == 0 || *ticks > most)
    return asked.nack(fmt::format("invalid number of ticks: 1 to {} is valid, in 4 or 8 bytes", most));
  if (lock_step == nullptr) return simulation.requests().step(*ticks, asked.when_done());
  if (caller == nullptr) return asked.nack("clients alone step");
  lock_step->step(caller, caller->name(), *ticks, asked.when_done());
  watch(*lock_step, *caller);
}

void reset(run::Simulation& simulation, const Asked& asked) {
  const bool same_seed = asked.request.value.empty();
  const std::optional<std::uint64_t> seed = number(asked.request.value);
  if (!same_seed && !seed) return asked.nack("invalid seed: a whole number in 4 or 8 bytes is valid");
  const bool posted =
      simulation.requests().post_to_all([&simulation, asked, seed](const world::Journal& journal) {
        const Result<void> started = simulation.restart(seed.value_or(journal.world().seed()));
        if (!started) return asked.nack(started.error().line());
        asked.ack();
      });
  if (!posted) asked.nack(simulation.requests().why_not_posted());
}

/// Payload: x, y [m], heading [rad] as float64, then an optional name.
void spawn(run::Simulation& simulation, const Asked& asked, const device::Caller* caller,
           OverlapWarnings& overlaps) {
  double place[3];
  const std::string& value = asked.request.value;
  if (value.size() < sizeof place)
    return asked.nack("x, y and heading are needed, as three float64, and a name");
  std::memcpy(place, value.data(), sizeof place);
  const std::string name(wire::text(std::string_view(value).substr(sizeof place)));
  if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2]))
    return asked.nack("invalid pose: finite numbers are valid");
  if (!name.empty() && !world::can_be_said(name))
    return asked.nack(fmt::format("invalid name: a line of up to {} bytes is valid", limits::kSayBytes));
  const geom::Pose at{place[0], place[1], 0, place[2]};
  const std::string holder = caller == nullptr ? std::string() : caller->holder();
  const bool posted = simulation.requests().post(
      [asked, at, name, holder, shares = simulation.shares(), &overlaps](world::Journal& journal) {
        const world::World& world = journal.world();
        const std::string_view like = wire::text(asked.request.name);
        const world::ModelRow model = world.find(like);
        if (!model) return asked.nack("there is no model " + in_quotes(like));
        const std::uint32_t tree[] = {world.models.desc[model]};
        if (const Result<void> room = shares->check(world, holder, tree); !room)
          return asked.nack(room.error().text);
        if (const Result<void> near = check_near(world, at); !near) return asked.nack(near.error().text);
        const auto came = journal.spawn_copy(world.id(model), at, name);
        if (!came) return asked.nack(came.error().text);
        shares->add(world, holder, *came);
        overlaps.placed(world, world.row(*came), "spawned");
        asked.ack(wire::c_string(world.name(world.row(*came))));
      });
  if (!posted) asked.nack(simulation.requests().why_not_posted());
}

void remove(run::Simulation& simulation, const Asked& asked) {
  const bool posted = simulation.requests().post([asked](world::Journal& journal) {
    const world::World& world = journal.world();
    const std::string_view name = wire::text(asked.request.name);
    const world::ModelRow model = world.find(name);
    if (!model) return asked.nack("there is no model " + in_quotes(name));
    const Result<void> gone = journal.despawn(world.id(model));
    if (!gone) return asked.nack(gone.error().text);
    asked.ack();
  });
  if (!posted) asked.nack(simulation.requests().why_not_posted());
}

}  // namespace

bool ask_for_world(run::Simulation& simulation, const sim::PropertyReq& request, device::Caller* caller,
                   device::Replier& replier, OverlapWarnings& overlaps) {
  const std::string_view name = wire::text(request.name), property = wire::text(request.prop);
  const bool of_world = name.empty() || name == "world";
  const bool known = of_world ? property == "join" || property == "step" || property == "reset"
                              : property == "spawn" || property == "remove";
  if (!known) return false;
  const Asked asked{request, std::make_shared<device::Replier>(std::move(replier))};
  if (property == "join") {
    join(simulation, asked, caller);
  } else if (property == "step") {
    step(simulation, asked, caller);
  } else if (property == "reset") {
    reset(simulation, asked);
  } else if (property == "spawn") {
    spawn(simulation, asked, caller, overlaps);
  } else {
    remove(simulation, asked);
  }
  return true;
}

}  // namespace playhouse::drivers
