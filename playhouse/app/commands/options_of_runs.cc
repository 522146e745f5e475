#include "playhouse/app/commands/command_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/app/commands/shared_options.h"
#include "playhouse/scenarios/scenario.h"

namespace playhouse::app {
namespace {

constexpr auto check_robots = check_count<std::uint32_t, 1, scenarios::kMostRobots>;

void keep_saves(const std::vector<std::pair<double, std::string>>& saves, RunOptions& options) {
  for (const auto& [seconds, file] : saves) {
    if (!std::isfinite(seconds) || seconds < 0)
      throw CLI::ValidationError("--save-at needs a number of seconds that is not negative, and a file");
    options.saves.push_back({seconds, file});
  }
}

/// Why these options are invalid; empty if they are valid.
std::string why_no_bench(const BenchOptions& options) {
  const std::string& scenario = options.scenario;
  const auto is_one_of = [&scenario](std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, scenario) != names.end();
  };
  if (options.duration > 0 && scenario == "server")
    return "--duration: bench server measures for a time of its own";
  if (options.duration > 0 && scenario == "load") return "--duration: bench load ends before the first tick";
  if (scenario == "world" && options.world.empty()) return "bench world needs the name of a .world file";
  if (scenario == "world" && options.robots > 0) return "--robots: bench world has the robots of its file";
  if (scenario != "world" && !options.world.empty())
    return fmt::format("a file belongs to bench world, not to bench {}", scenario);
  if (options.engine != kStage && is_one_of({"load", "open", "server", "watched"}))
    return fmt::format("--engine: bench {} measures with stage", scenario);
  return {};
}

}  // namespace

void add_run(CLI::App& app, RunOptions& options) {
  auto* world = app.add_option("WORLD", options.world, "a .world file, unless --from or --again is given");
  add_serving(app, options.serving);
  add_running(app, options.running);
  app.add_option("--from", options.from,
                 "resume a saved run instead; --duration counts from the start of its world")
      ->type_name("FILE")
      ->excludes(world)
      ->excludes(app.get_option("--engine"))
      ->excludes(app.get_option("--seed"));
  auto* again =
      app.add_option(
             "--again", options.again,
             "run a recording again, as fast as possible, and compare: exit code 1 if the runs differ")
          ->type_name("FILE.mcap")
          ->excludes(world);
  for (const char* const other : {"--from", "--engine", "--seed", "--duration", "--record", "--lock-step",
                                  "--paused", "--save-world", "--speed", "--cluster"})
    again->excludes(app.get_option(other));
  app.add_option_function<std::vector<std::pair<double, std::string>>>(
         "--save-at", [&options](const auto& saves) { keep_saves(saves, options); },
         "save the state at a simulated time, or the current world if FILE ends in .world, and continue; "
         "may be repeated")
      ->type_name("SECONDS FILE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->excludes(again);
  app.callback([&options] {
    if (options.world.empty() && options.from.empty() && options.again.empty())
      throw CLI::RequiredError("WORLD");
    check_access(options.serving);
  });
}

void add_replay(CLI::App& app, ReplayOptions& options) {
  app.add_option("FILE", options.file, "a recording of run --record")->required();
  app.add_option("--web", options.serving.web, "port of the web page; 0: any free one, printed")
      ->check(check_port)
      ->default_str(std::to_string(kWebPort));
  add_hosts(app, options.serving);
  app.add_option("--speed", options.running.speed, "times real time; 0: as fast as possible (1)")
      ->check(check_not_negative);
  add_workers(app, options.running.workers);
  add_allowed_libraries(app, options.running);
  app.add_flag("--paused", options.running.paused, "start paused, until a viewer resumes the replay");
  app.callback([&options] { check_access(options.serving); });
}

void add_serve(CLI::App& app, ServeOptions& options) {
  app.add_option("FILE", options.file, "a .cfg file")->required();
  add_serving(app, options.serving);
  add_running(app, options.running);
  app.callback([&app, &options] {
    check_access(options.serving);
    options.serving.web_was_asked_for = app.count("--web") > 0;
    for (const char* const name :
         {"--engine", "--fast", "--speed", "--duration", "--seed", "--workers", "--save-world",
          "--record-only", "--lock-step", "--lock-step-timeout", "--cluster", "--nodes", "--cluster-token",
          "--paused", "--json", "--viewers", "--page-bytes", "--observers", "--observer-bytes"})
      if (app.count(name) > 0) options.running.for_a_world.push_back(name);
  });
}

void add_node(CLI::App& app, NodeOptions& options) {
  app.add_option("HOST[:PORT]", options.head, "a run with --cluster")->required();
  app.add_option("--token", options.token, "token of the run, if it has one")->check(check_token);
  app.add_option("--wait", options.wait, "seconds for the run to begin")
      ->check(check_not_negative)
      ->capture_default_str();
  add_workers(app, options.running.workers, kWorkersOfARun);
  add_allowed_libraries(app, options.running);
}

void add_robot(CLI::App& app, RobotOptions& options) {
  app.add_option("FILE", options.files, "a .toml file of one or several robots (docs/robot-client.md)")
      ->required();
  app.add_option("--server", options.server, "server of the world")->type_name("HOST[:PORT]")->required();
  app.add_option("--port", options.port,
                 "port of the first robot without one in its file, counting up for further ones; "
                 "0: any free ones, printed")
      ->check(check_port)
      ->capture_default_str();
  add_auth_key(app, options.token);
  app.add_option("--tls-ca", options.tls_ca, "certificates to trust, PEM, for a server with --tls-cert")
      ->type_name("FILE");
  app.add_option("--wait", options.wait, "seconds for the server to answer")
      ->check(check_positive)
      ->capture_default_str();
  add_bind(app, options.bind);
  add_insecure(app, options.insecure);
  app.callback([&options] { check_bind_insecure(options.bind, options.insecure); });
}

void add_gym(CLI::App& app, GymOptions& options) {
  app.add_option("WORLD", options.world, "a .world file")->required();
  app.add_option("--socket", options.socket, "file descriptor of the socket to the parent program")
      ->check(check_count<std::uint16_t, 3>)
      ->required();
  options.serving.port = 0;
  options.serving.web.reset();
  options.running.lock_step = LockStepping{};
  add_parsed(app, "--web", parse_web, options.serving.web,
             "port of a web page; 0: any free one, printed (none)");
  add_engine(app, options.running.engine);
  add_seed(app, options.running.seed, "seed until the first reset");
  add_workers(app, options.running.workers);
  add_recording(app, options.running);
  add_allowed_libraries(app, options.running);
}

void add_verify(CLI::App& app, VerifyOptions& options) {
  app.add_option("WORLD", options.world, "a .world file")->required();
  app.add_option("--ticks", options.ticks, "number of ticks")
      ->check(check_count<std::uint64_t, 1>)
      ->required();
  app.add_option("--workers", options.workers, "threads of each run (1,2,4)")
      ->check(check_workers)
      ->delimiter(',')
      ->type_name("N,N,...");
  add_engine(app, options.running.engine);
  add_seed(app, options.running.seed);
  add_allowed_libraries(app, options.running);
}

void add_bench(CLI::App& app, BenchOptions& options) {
  app.add_option(
         "SCENARIO", options.scenario,
         "sonar, laser, cave, hospital, swarm, vaughan2008, diffusion, world, load, open, server or watched")
      ->required();
  app.add_option("WORLD", options.world, "a .world file, for bench world");
  app.add_option(
         "--robots", options.robots,
         "number of robots (the scenario's own; vaughan2008 and diffusion: a series of 1, 10, ... 100000)")
      ->check(check_robots);
  app.add_option("--duration", options.duration,
                 "simulated seconds (the scenario's own); not for load, server")
      ->check(check_positive);
  add_engine(app, options.engine);
  add_seed(app, options.seed);
  add_workers(app, options.workers);
  app.callback([&options] {
    if (const std::string why = why_no_bench(options); !why.empty()) throw CLI::ValidationError(why);
  });
}

}  // namespace playhouse::app
