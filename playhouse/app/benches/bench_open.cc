#include "playhouse/app/benches/bench_open.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>
#include <vector>

#include "playhouse/app/benches/bench_figures.h"
#include "playhouse/app/commands/commands.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/base/assert.h"
#include "playhouse/base/fail.h"
#include "playhouse/bridge/simulated/auto_map.h"
#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/scenarios/scenario.h"

namespace playhouse::app {
namespace {

constexpr std::uint32_t kRobots = 2000;  // default
constexpr double kSeconds = 10;
constexpr std::size_t kOpensAtOnce = 1000;  // capacity of the inbox

/// An engine whose workers run only inside its phases.
class KeepsItsWorkers final : public world::Engine {
 public:
  explicit KeepsItsWorkers(std::unique_ptr<world::Engine> engine) : engine_(std::move(engine)) {}
  void step() override { engine_->step(); }
  world::World& world() override { return engine_->world(); }
  world::Workers& workers() override { return caller_; }
  std::uint64_t rays() const override { return engine_->rays(); }

 private:
  std::unique_ptr<world::Engine> engine_;
  world::Workers caller_{1};
};

/// Keeps the latest batch, for comparison.
class Sink final : public device::Publisher {
 public:
  void publish(std::vector<device::Publication> batch) override { newest = std::move(batch); }
  std::vector<device::Publication> newest;
};

/// A run with all devices open.
class OpenRun {
 public:
  explicit OpenRun(std::unique_ptr<world::Engine> engine)
      : simulation_(std::move(engine), {.speed = 0, .duration = 0}),
        devices_(simulation_, sink_),
        driver_(devices_, "stage") {
    std::uint32_t row = 0;
    for (const drivers::MappedDevice& mapped : drivers::AutoMap().of_world(simulation_.world())) {
      const device::DeviceId id{row++};
      driver_.add(id, drivers::make_device(devices_, mapped.interf, mapped.model));
      const bool opened = driver_.start(id).ok();
      PLAYHOUSE_ASSERT(opened);
      if (row % kOpensAtOnce == 0) simulation_.run();
    }
    simulation_.run();
  }
  std::size_t devices() const { return devices_.sources().size(); }
  const world::World& world() const { return simulation_.world(); }

  /// Wall time of a tick. [s]
  double tick() {
    sink_.newest.clear();
    simulation_.extend(1);
    const auto start = std::chrono::steady_clock::now();
    simulation_.run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  const std::vector<device::Publication>& published() const { return sink_.newest; }

 private:
  Sink sink_;
  run::Simulation simulation_;
  drivers::ModelDevices devices_;
  drivers::SimulatedDriver driver_;
};

bool same(const std::vector<device::Publication>& one, const std::vector<device::Publication>& other) {
  return std::ranges::equal(one, other, [](const auto& a, const auto& b) {
    return a.device == b.device && a.subtype == b.subtype && a.timestamp == b.timestamp && a.body == b.body;
  });
}

/// Alternating, so that other load affects both.
int compare(OpenRun& alone, OpenRun& shared, const BenchOptions& options) {
  const double interval = alone.world().scene().interval;
  const auto ticks =
      static_cast<std::size_t>((options.duration > 0 ? options.duration : kSeconds) / interval);
  std::vector<double> of_alone, of_shared, ratios;
  std::uint64_t messages = 0;
  for (std::size_t k = 0; k < ticks; ++k) {
    of_alone.push_back(alone.tick());
    of_shared.push_back(shared.tick());
    ratios.push_back(of_shared.back() / of_alone.back());
    messages += shared.published().size();
    if (!same(alone.published(), shared.published()))
      return fail({"", fmt::format("tick {}: the workers encoded other messages", k + 1)});
  }
  fmt::print(
      R"({{"scenario":"open","robots":{},"devices":{},"workers":{},"ticks":{},"messages":{},"tick_ms":{:.3f},"tick_ms_encoded_by_one":{:.3f},"ratio":{:.3f},"hash":"{:016x}"}})"
      "\n",
      count_robots(shared.world()), shared.devices(), options.workers, ticks, messages,
      1e3 * median(of_shared), 1e3 * median(of_alone), median(ratios), shared.world().hash());
  return kDone;
}

}  // namespace

int bench_open(const BenchOptions& options) {
  const Result<scene::SceneDesc> scene =
      scenarios::make("laser", options.robots > 0 ? options.robots : kRobots);
  if (!scene) return fail(scene.error(), kUsage);
  Running running;
  running.seed = options.seed;
  running.workers = options.workers;
  const auto make = [&] {
    return make_engine(*scene, running, controllers::Libraries::LibraryUse::kLoad, &warn);
  };
  Result<std::unique_ptr<world::Engine>> one = make(), other = make();
  if (!one) return fail(one.error());
  if (!other) return fail(other.error());
  OpenRun alone(std::make_unique<KeepsItsWorkers>(std::move(*one))), shared(std::move(*other));
  return compare(alone, shared, options);
}

}  // namespace playhouse::app
