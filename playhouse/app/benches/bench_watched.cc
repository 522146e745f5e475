#include "playhouse/app/benches/bench_watched.h"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <new>
#include <thread>
#include <utility>
#include <vector>

#include "playhouse/app/benches/bench_apart.h"
#include "playhouse/app/benches/bench_clients.h"
#include "playhouse/app/benches/bench_figures.h"
#include "playhouse/base/fail.h"
#include "playhouse/run/follower.h"
#include "playhouse/scenarios/scenario.h"

namespace playhouse::app {
namespace {

constexpr std::uint32_t kRobots = 1000;  // default
constexpr std::size_t kClients = 200;
constexpr double kSeconds = 12;        // per phase, default
constexpr double kRoundSeconds = 1.5;  // maximum per phase and round

enum Phase : int { kAlone, kPage, kLasers, kPhases, kBetween };

/// Memory shared by the two processes.
struct Board {
  std::atomic<int> phase = kBetween;
  std::atomic<double> packets_per_s = 0, messages_per_s = 0;
  std::atomic<std::uint64_t> lost = 0;
};
static_assert(std::atomic<double>::is_always_lock_free, "processes can share it");

Board* share_board() {
  void* const memory =
      mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? nullptr : new (memory) Board;
}

/// Alternating, so that other load affects all.
Result<void> watch_in_turn(const Ports& ports, std::size_t robots, double seconds, Board& board) {
  const int rounds = static_cast<int>(std::ceil(seconds / kRoundSeconds));
  const double of_round = seconds / rounds;
  const auto in_phase = [&](Phase phase) {
    return [&board, phase](bool begins) { board.phase = begins ? phase : kBetween; };
  };
  for (int round = 0; round < rounds; ++round) {
    board.phase = kAlone;
    std::this_thread::sleep_for(std::chrono::duration<double>(of_round));
    board.phase = kBetween;
    const Result<double> packets = watch_as_page(ports.web, of_round, in_phase(kPage));
    if (!packets) return packets.error();
    const Result<FanOut> lasers =
        read_lasers({.port = ports.player, .clients = kClients, .robots = robots, .seconds = of_round},
                    in_phase(kLasers));
    if (!lasers) return lasers.error();
    board.packets_per_s = *packets;
    board.messages_per_s = lasers->messages_per_s;
    board.lost += lasers->lost;
    std::this_thread::sleep_for(std::chrono::duration<double>(0.3));  // until all are disconnected
  }
  return {};
}

/// CPU times of whole ticks, by phase. [s]
class TickTimes final : public run::Follower {
 public:
  explicit TickTimes(const Board& board) : board_(board) {}

  void ticked(const world::World&) override {
    const double now = cpu_time(CLOCK_THREAD_CPUTIME_ID);
    const int phase = board_.phase;
    if (phase == phase_ && phase < kPhases) times_[static_cast<std::size_t>(phase)].push_back(now - last_);
    phase_ = phase;
    last_ = now;
  }
  /// False if a phase had no whole tick.
  bool in_all_phases() const {
    return std::ranges::none_of(times_, [](const std::vector<double>& times) { return times.empty(); });
  }
  double median_ms(Phase phase) const { return 1e3 * median(times_[phase]); }

 private:
  const Board& board_;
  std::array<std::vector<double>, kPhases> times_;
  int phase_ = kBetween;
  double last_ = 0;
};

void print_result(const BenchOptions& options, std::size_t robots, const Board& board,
                  const TickTimes& times) {
  const double alone = times.median_ms(kAlone), page = times.median_ms(kPage),
               lasers = times.median_ms(kLasers);
  fmt::print(
      R"({{"scenario":"watched","robots":{},"workers":{},"tick_ms":{:.3f},"tick_ms_with_page":{:.3f},"tick_ms_with_lasers":{:.3f},"page_ratio":{:.3f},"lasers_ratio":{:.3f},)"
      R"("packets_per_s":{:.1f},"clients":{},"messages_per_s":{:.0f},"lost":{}}})"
      "\n",
      robots, options.workers, alone, page, lasers, page / alone, lasers / alone, board.packets_per_s.load(),
      kClients, board.messages_per_s.load(), board.lost.load());
}

}  // namespace

int bench_watched(const BenchOptions& options) {
  const std::uint32_t robots = options.robots > 0 ? options.robots : kRobots;
  Result<scene::SceneDesc> scene = scenarios::make("laser", robots);
  if (!scene) return fail(scene.error(), kUsage);
  Board* const board = share_board();
  if (board == nullptr) return kFailed;
  TickTimes times(*board);
  const int code = serve_apart(
      options, std::move(*scene),
      [&](const Ports& ports, pid_t) {
        const Result<void> done =
            watch_in_turn(ports, robots, options.duration > 0 ? options.duration : kSeconds, *board);
        return done ? kDone : fail(done.error());
      },
      [&](Service& service) { service.simulation().follow(times); });
  if (code != kDone) return code;
  if (!times.in_all_phases())
    return fail({"--duration", "too short: not one whole tick of each of the three"});
  print_result(options, robots, *board, times);
  return kDone;
}

}  // namespace playhouse::app
