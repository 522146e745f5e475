#include "playhouse/house/simulated_nodes.h"

#include <utility>

#include "playhouse/app/world_opener.h"
#include "playhouse/base/assert.h"
#include "playhouse/cluster/node.h"

namespace playhouse::house {
namespace {

constexpr std::uint16_t kHeadPort = 6700;
constexpr std::size_t kMachinesAtOnce = 4;  // machines at once
constexpr cluster::Seconds kConnectPatience{1};

/// The program of a node: it takes part until the run ends, or it is lost.
void take_part(net::PolledNetwork& network) {
  Result<cluster::MessageStream> stream =
      cluster::MessageStream::connect(network, "head", kHeadPort, kConnectPatience);
  if (!stream) return;
  scene::SceneDesc scene;
  std::unique_ptr<world::Engine> engine;
  cluster::Node node(std::move(*stream));
  static_cast<void>(node.run([&](world::SavedRun run) -> Result<world::Engine*> {
    scene = *app::scene_of(run.sources, std::nullopt, nullptr);
    engine = *app::make_engine(scene, {.engine = run.engine, .seed = run.seed},
                               controllers::Libraries::LibraryUse::kLoad, [](const std::string&) {});
    return engine.get();
  }));
}

}  // namespace

std::unique_ptr<cluster::Head> SimulatedNodes::head(std::unique_ptr<world::Engine> engine,
                                                    config::SourceFiles sources,
                                                    std::function<void(const std::string&)> fail) {
  cluster::Head::HeadOptions options;
  options.port = kHeadPort;
  const auto failed = [fail = std::move(fail)](const Error& error) { fail(error.line()); };
  auto head =
      std::make_unique<cluster::Head>(machines_, std::move(engine), std::move(sources), options, failed);
  PLAYHOUSE_ASSERT(head->listen().ok());
  return head;
}

void SimulatedNodes::act() {
  std::vector<std::size_t> running;
  for (std::size_t machine = 0; machine < machines_begun_; ++machine)
    if (!machines_.has_ended(machine)) running.push_back(machine);
  if (running.size() < kMachinesAtOnce && draw(30) == 0) {
    machines_.begin([this] { take_part(machines_); });
    ++machines_begun_;
  }
  if (!running.empty() && draw(300) == 0)
    machines_.crash(running[draw(static_cast<std::uint32_t>(running.size()))]);
  if (draw(600) == 0) machines_.cut(draw(100) / 50.0);
}

}  // namespace playhouse::house
