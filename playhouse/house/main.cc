/// playhouse_sim: runs of the whole program on a simulated clock and network (house.h), one seed after the
/// other. The first broken invariant ends it with the seed that repeats it. The wall clock decides only when
/// to stop.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "playhouse/base/log.h"
#include "playhouse/house/house.h"

namespace {

using playhouse::house::HouseOptions;
using playhouse::house::Report;

/// A folder of its own, removed in the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "playhouse_sim_XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

struct Totals {
  std::uint64_t houses = 0;
  double simulated = 0;  // s
  std::size_t answers = 0, clients = 0, spawned = 0, rewinds = 0, checks = 0, failed_disks = 0, frames = 0,
              cuts = 0, nodes = 0, machines = 0, crashes = 0;
  void add(const Report& report) {
    ++houses;
    simulated += report.simulated;
    answers += report.answers;
    clients += report.clients;
    spawned += report.spawned;
    rewinds += report.rewinds;
    checks += report.checks;
    frames += report.frames;
    cuts += report.cuts;
    nodes += report.nodes;
    machines += report.machines;
    crashes += report.crashes;
    failed_disks += report.disk_failed ? 1 : 0;
  }
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Runs the whole program on a simulated clock and network, seed after seed."};
  HouseOptions options;
  double seconds = 60;
  bool verbose = false;
  std::optional<std::uint64_t> seed;
  app.add_option("--seed", seed, "repeat the run of this seed alone");
  app.add_option("--seconds", seconds, "wall time, without --seed")->check(CLI::NonNegativeNumber);
  app.add_option("--length", options.seconds, "simulated seconds of each run")->check(CLI::PositiveNumber);
  app.add_flag("--verbose", verbose, "with the log of the program");
  CLI11_PARSE(app, argc, argv);
  if (!verbose) playhouse::log::silence();
  const Folder folder;
  if (folder.path().empty()) {
    fmt::print(stderr, "playhouse_sim: there is no folder for temporary files\n");
    return 1;
  }
  const auto start = std::chrono::steady_clock::now();
  const auto passed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  Totals totals;
  for (options.seed = seed.value_or(1);; ++options.seed) {
    const Report report = run_house(options, folder.path());
    if (report.fault) {
      fmt::print(stderr, "playhouse_sim: --seed {} --length {}: {}\n", options.seed, options.seconds,
                 *report.fault);
      return 1;
    }
    totals.add(report);
    if (seed) fmt::print("seed {}: digest {:016x}\n", options.seed, report.digest);
    if (seed || passed() >= seconds) break;
  }
  fmt::print(
      "{} runs, {:.1f} simulated hours in {:.0f} s: {} clients, {} answers, {} frames of pages, {} robots, "
      "{} more of other machines, {} cuts, {} crashes, {} nodes of clusters, {} rewinds, {} full disks, "
      "{} checks of recordings: all invariants hold\n",
      totals.houses, totals.simulated / 3600, passed(), totals.clients, totals.answers, totals.frames,
      totals.spawned, totals.machines, totals.cuts, totals.crashes, totals.nodes, totals.rewinds,
      totals.failed_disks, totals.checks);
  return 0;
}
