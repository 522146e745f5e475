// What watching costs the tick thread (a capture; a frame of pages and observers together) and the thread that
// serves viewers (a packet each), while every robot moves.

#include <benchmark/benchmark.h>

#include "playhouse/base/limits.h"
#include "playhouse/replicate/small_world.h"
#include "playhouse/replicate/snapshot_feed.h"
#include "playhouse/replicate/viewer.h"

namespace playhouse::replicate {
namespace {

struct Show {
  explicit Show(int robots) : small(robots), layout(small.layout()) {
    for (const world::ModelRow row : small.world.models.rows()) world::subscribe(small.world, row);
    interest.view = {-10000, -10000, 10000, 10000};
  }
  SmallWorld small;
  const std::shared_ptr<const Layout> layout;
  Interest interest;
  Snapshot snapshot;
};

void BM_capture(benchmark::State& state) {
  Show show(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    state.PauseTiming();
    show.small.tick();
    state.ResumeTiming();
    capture(show.small.world, {}, show.layout, show.interest, show.snapshot);
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_capture)->Arg(100)->Arg(10000)->Unit(benchmark::kMicrosecond);

/// With and without the sensors of all robots.
void BM_show(benchmark::State& state) {
  Show show(static_cast<int>(state.range(0)));
  SnapshotFeed feed(show.small.world, {}, [] { return 0.0; });
  const auto post = [](const std::function<void()>&) {};
  SnapshotReader pages(feed, post, [] {}), observers(feed, post, [] {});
  if (state.range(1) != 0) pages.set_interest(show.interest);
  for (auto _ : state) {
    state.PauseTiming();
    show.small.tick();
    pages.take();
    observers.take();
    state.ResumeTiming();
    feed.show(show.small.world, {});
  }
}
BENCHMARK(BM_show)->Args({10000, 0})->Args({10000, 1})->Unit(benchmark::kMicrosecond);

void BM_packet(benchmark::State& state) {
  Show show(static_cast<int>(state.range(0)));
  DeltaWriter writer;
  Replica replica(show.layout);
  std::vector<std::byte> packet;
  const Wish wish{show.interest.view, true, std::nullopt};
  std::uint32_t frame = 0;
  std::size_t bytes = 0;
  for (auto _ : state) {
    state.PauseTiming();
    show.small.tick();
    capture(show.small.world, {}, show.layout, show.interest, show.snapshot);
    state.ResumeTiming();
    writer.write(show.snapshot, wish, ++frame, limits::kViewerFrameBytes, replica, packet);
    bytes += packet.size();
  }
  state.counters["bytes"] = static_cast<double>(bytes) / static_cast<double>(state.iterations());
}
BENCHMARK(BM_packet)->Arg(100)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace playhouse::replicate
