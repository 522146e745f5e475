#include "playhouse/bridge/simulated/joined_robots.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers {
namespace {

constexpr std::size_t kRobotsOfClient = 1024;  // total per client, including robots that have left

std::vector<std::byte> answer(wire::simulation::PropertyReq body, std::string_view value) {
  body.value = wire::c_string(value);
  return wire::encode(body);
}

}  // namespace

JoinedRobots::JoinedRobots(run::Simulation& simulation) : simulation_(simulation) {
  // May outlive the device.
  simulation.follow(
      run::on_event([&simulation, brought = brought_](const world::World&, const world::Event& event) {
        follow(simulation, *brought, event);
      }));
}

/// Removes the sensors of a robot that has been removed, before the next tick.
void JoinedRobots::follow(run::Simulation& simulation, Brought& brought, const world::Event& event) {
  if (event.kind != world::Event::EventKind::kDespawn) return;
  const auto found = brought.find(event.model);
  if (found == brought.end()) return;
  std::vector<Joined>& robots = found->second->robots;
  const auto gone = std::ranges::find(robots, event.model, &Joined::robot);
  if (gone != robots.end()) {
    simulation.requests().post_always(
        [joined = *gone](world::Journal& journal) { leave(journal, std::span(&joined, 1)); }, {});
    robots.erase(gone);
  }
  brought.erase(found);
}

std::shared_ptr<JoinedRobots::Owned> JoinedRobots::owned_by(device::Caller& caller) {
  std::shared_ptr<Owned>& owned = (*owners_)[&caller];
  if (owned) return owned;
  owned = std::make_shared<Owned>();
  caller.expect_alive();
  caller.when_gone(
      [&simulation = simulation_, owners = owners_, who = &caller, owned = owned, name = caller.name()] {
        owners->erase(who);
        // After the changes that spawned them.
        simulation.requests().post_always(
            [owned, name](world::Journal& journal) {
              leave(journal, owned->robots);
              if (!owned->robots.empty())
                log::info("{}: gone, and its {} robots with it", name, owned->robots.size());
              owned->robots.clear();
            },
            {});
      });
  return owned;
}

void JoinedRobots::join(const wire::simulation::PropertyReq& request, device::Caller* caller,
                        device::Replier replier) {
  if (caller == nullptr) return replier.nack(answer(request, "clients alone bring robots"));
  Result<RobotRequest> wanted = parse_join_request(wire::text(request.name), request.value);
  if (!wanted) return replier.nack(answer(request, wanted.error().text));
  const std::shared_ptr<Owned> owned = owned_by(*caller);
  if (owned->asked_for >= kRobotsOfClient)
    return replier.nack(answer(request, fmt::format("a client brings {} robots at most", kRobotsOfClient)));
  ++owned->asked_for;
  auto shared = std::make_shared<device::Replier>(std::move(replier));  // std::function must be copyable
  const bool posted = simulation_.requests().post([owned, brought = brought_, shared, request,
                                                   wanted = std::move(*wanted), holder = caller->holder(),
                                                   shares = simulation_.shares()](world::Journal& journal) {
    const world::World& world = journal.world();
    const Result<std::vector<std::uint32_t>> types = types_of(world, wanted);
    if (!types) return shared->nack(answer(request, types.error().text));
    if (const Result<void> room = shares->check(world, holder, *types); !room)
      return shared->nack(answer(request, room.error().text));
    Result<Joined> joined = drivers::join(journal, wanted);
    if (!joined) return shared->nack(answer(request, joined.error().text));
    shares->add(world, holder, joined->robot);
    for (const world::ModelId sensor : joined->sensors) shares->add(world, holder, sensor);
    shared->ack(answer(request, joined->name));
    (*brought)[joined->robot] = owned;
    owned->robots.push_back(std::move(*joined));
  });
  if (!posted) shared->nack(answer(request, simulation_.requests().why_not_posted()));
}

}  // namespace playhouse::drivers
