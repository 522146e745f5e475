#include "playhouse/app/command_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <utility>

#include "playhouse/app/commands.h"
#include "playhouse/app/sensor_shapes.h"
#include "playhouse/app/shared_options.h"
#include "playhouse/scenarios/scenario.h"

namespace playhouse::app {
namespace {

constexpr auto check_robots = check_count<std::uint32_t, 1, scenarios::kMostRobots>;
constexpr auto check_width = check_count<int, 16, 16384>;

/// Options of a rendered run, for PictureOptions and FilmOptions.
template <typename Options>
void add_drawn_run(CLI::App& app, Options& options) {
  app.add_option("--width", options.width, "pixels; the height follows from the world")
      ->check(check_width)
      ->capture_default_str();
  app.add_option("--show", options.show,
                 "also draw sensor data: " + SensorShapes::names() + ", comma-separated (none)")
      ->type_name("SENSOR,...")
      ->check(check_show);
  app.add_option("--renderer", options.renderer,
                 "chromium, the page in a headless browser, or playhouse, built in "
                 "(chromium, if one that renders is installed)")
      ->type_name("NAME")
      ->check(check_renderer);
  add_engine(app, options.running.engine);
  add_seed(app, options.running.seed);
  add_workers(app, options.running.workers, kWorkersOfARun);
  add_allowed_libraries(app, options.running);
}

void keep_saves(const std::vector<std::pair<double, std::string>>& saves, RunOptions& options) {
  for (const auto& [seconds, file] : saves) {
    if (!std::isfinite(seconds) || seconds < 0)
      throw CLI::ValidationError("--save-at wants a number of seconds that is not negative, and a file");
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
  if (scenario == "world" && options.world.empty()) return "bench world wants the name of a .world file";
  if (scenario == "world" && options.robots > 0) return "--robots: bench world has the robots of its file";
  if (scenario != "world" && !options.world.empty())
    return fmt::format("a file belongs to bench world, not to bench {}", scenario);
  if (options.engine != kStage && is_one_of({"load", "open", "server", "watched"}))
    return fmt::format("--engine: bench {} measures with stage", scenario);
  return {};
}

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
}

void add_export(CLI::App& app, ExportOptions& options) {
  app.add_option("FILE", options.file, "a recording of run --record")->required();
  app.add_flag("--csv", options.csv, "comma-separated values, one file per topic")->required();
  app.add_option("-o,--output", options.folder, "folder of the tables (FILE without .mcap)")
      ->type_name("DIR");
}

void add_serve(CLI::App& app, ServeOptions& options) {
  app.add_option("FILE", options.file, "a .cfg file")->required();
  add_serving(app, options.serving);
  add_running(app, options.running);
}

void add_node(CLI::App& app, NodeOptions& options) {
  app.add_option("HOST[:PORT]", options.head, "a run with --cluster")->required();
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
  add_bind(app, options.bind);
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

void add_devices(CLI::App& app, DevicesOptions& options) {
  app.add_option("HOST[:PORT]", options.server, "the server (127.0.0.1:6665)");
  app.add_flag("--json", options.json, "one JSON object per line and device");
}

void add_watch(CLI::App& app, WatchOptions& options) {
  app.add_option("HOST[:PORT]", options.server, "the server")->required();
  app.add_option("DEVICE", options.device, "INTERFACE:INDEX, e.g. laser:0, or a model's name")->required();
  app.add_option("--count", options.count, "end after so many messages")
      ->check(check_count<std::uint64_t, 1>);
}

void add_observe(CLI::App& app, ObserveOptions& options) {
  app.add_option("SERVER", options.server, "HOST or HOST:PORT (6670)")->required();
  app.add_option("--token", options.token, "token of a guest, for a run with --guests")->check(check_token);
  app.add_option("--name", options.names,
                 "print only the model of this name; may be repeated (all top-level models)")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_parsed(app, "--view", parse_view, options.view,
             "a square of the world: models inside have priority, others are sent once a second (everything)")
      ->type_name("X,Y,RADIUS");
  app.add_option("--rate", options.rate, "lines per second for each model (on change)")
      ->check(check_positive);
  app.add_option("--seconds", options.seconds, "seconds until the end (never)")->check(check_positive);
  app.add_option("--bytes-per-second", options.bytes_per_second,
                 "requested rate, at most the limit of the run (the limit)")
      ->type_name("N")
      ->check(check_observer_bytes);
  app.add_flag("--stats", options.stats, "print statistics in a last line: bytes, packets, losses");
}

void add_drive(CLI::App& app, DriveOptions& options) {
  app.add_option("HOST[:PORT]", options.server, "the server")->required();
  app.add_option("ROBOT", options.device, "a model's name, or a device, e.g. position2d:0")->required();
}

void add_check(CLI::App& app, CheckOptions& options) {
  app.add_option("FILE", options.files, "a .world, .inc or .cfg file")->required();
  app.add_flag("--strict", options.strict, "warnings, e.g. of unknown words, count as errors: exit code 2");
}

void add_convert(CLI::App& app, ConvertOptions& options) {
  app.add_option("FILE", options.input, "a .world file of any version, an image, or a ROS map.yaml")
      ->required();
  app.add_option("-o,--output", options.output,
                 "output file (standard output); .yaml: the walls of a world as a ROS map; "
                 ".glb: its bodies as glTF");
  app.add_option("--scale", options.scale, "metres per pixel of an image (of a map 0.05)")
      ->check(check_positive);
  app.add_option("--height", options.height,
                 "metres: height of generated walls (0.6), or height of the section through the world (0.2)")
      ->check(check_positive);
}

void add_picture(CLI::App& app, PictureOptions& options) {
  app.add_option("WORLD", options.world, "a .world file")->required();
  app.add_option("-o,--output", options.output, "output file")->type_name("FILE.png")->required();
  app.add_option("--at", options.at, "simulated seconds before the picture")
      ->check(check_not_negative)
      ->capture_default_str();
  add_drawn_run(app, options);
}

void add_film(CLI::App& app, FilmOptions& options) {
  app.add_option("WORLD", options.world, "a .world file")->required();
  app.add_option("-o,--output", options.output,
                 "output file: an animated .png, or a format that ffmpeg derives from the extension")
      ->type_name("FILE")
      ->required();
  app.add_option("--duration", options.duration, "simulated seconds")
      ->check(check_not_negative)
      ->capture_default_str();
  app.add_option("--rate", options.rate, "pictures per simulated second, one a tick at most")
      ->check(check_positive)
      ->capture_default_str();
  add_drawn_run(app, options);
}

void add_kinds(CLI::App& app, KindsOptions& options) {
  app.add_option("NAME", options.name, "a kind: print all its words");
  app.add_flag("--json", options.json, "one JSON object per line and kind");
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

/// A command with options of type `Options`.
template <typename Options>
Command command(const char* name, const char* summary, int (*execute)(const Options&),
                void (*add)(CLI::App&, Options&), const char* examples) {
  return {name, summary, examples, [execute, add](CLI::App& app) {
            const auto options = std::make_shared<Options>();
            add(app, *options);
            return [execute, options] { return CommandLine(*options, execute); };
          }};
}

}  // namespace

std::vector<Command> commands() {
  return {
      // tests/e2e/test_program.py runs every line that begins with "  playhouse".
      command("run", "simulate a world file and serve all its robots", run, add_run,
              R"(Examples:
  playhouse run worlds/cave.world
  playhouse run worlds/cave.world --port 7000 --web off
  playhouse run worlds/cave.world --fast --headless --duration 60 --json
  playhouse run worlds/cave.world --engine arena
  playhouse run worlds/cave.world --headless --lock-step
  playhouse run worlds/cave.world --headless --lock-step left,right --lock-step-timeout 10)"),
      command("replay", "replay a recorded run in the page, with its whole time on the slider", replay,
              add_replay,
              R"(Examples:
  playhouse replay my.mcap
  playhouse replay my.mcap --web 8081 --paused)"),
      command("export", "export a recording as tables", export_tables, add_export,
              R"(Examples:
  playhouse export my.mcap --csv
  playhouse export my.mcap --csv -o tables)"),
      command("serve", "serve the devices of a Player configuration file", serve, add_serve,
              R"(Examples:
  playhouse serve my.cfg
  playhouse serve my.cfg --bind 0.0.0.0 --paused)"),
      command("node", "compute a share of a run with --cluster (docs/cluster.md)", node, add_node,
              R"(Examples:
  playhouse node 127.0.0.1 --wait 1
  playhouse node 127.0.0.1:6675 --workers 2 --wait 1)"),
      command("robot", "spawn robots in the world of a server, and serve them on this machine", robot,
              add_robot,
              R"(Examples:
  playhouse robot examples/robot.toml --server 127.0.0.1:6665 --port 7000
  playhouse robot examples/robot.toml --server 127.0.0.1 --bind 0.0.0.0)"),
      command("gym", "let a learning program step all robots of a world (docs/gym.md)", gym, add_gym,
              R"(Started by the Python package playhouse_gym:
  env = playhouse_gym.VectorEnv("my.world"))"),
      command("verify", "run a world several times in parallel and compare the states", verify, add_verify,
              R"(Examples:
  playhouse verify worlds/cave.world --ticks 100
  playhouse verify worlds/cave.world --ticks 20 --workers 1,3)"),
      command("devices", "list the devices of a server", devices, add_devices,
              R"(Examples:
  playhouse devices
  playhouse devices 127.0.0.1:6665 --json)"),
      command("watch", "print a device's data as JSON lines", watch, add_watch,
              R"(Examples:
  playhouse watch 127.0.0.1 laser:0 --count 3
  playhouse watch 127.0.0.1 guest --count 3)"),
      command("observe", "print poses and speech of models, from a run with --observers", observe,
              add_observe,
              R"(Examples:
  playhouse observe 127.0.0.1 --seconds 1 --stats
  playhouse observe 127.0.0.1 --name guest --rate 2 --seconds 1
  playhouse observe 127.0.0.1 --view 0,0,5 --bytes-per-second 8000 --seconds 1)"),
      command("drive", "drive a robot by the keyboard", drive, add_drive,
              R"(Examples:
  playhouse drive 127.0.0.1 guest
  playhouse drive 127.0.0.1:6665 position2d:0)"),
      command("check", "report errors in .world, .inc and .cfg files", check, add_check,
              R"(Examples:
  playhouse check my.cfg
  playhouse check worlds/*.world worlds/*.inc)"),
      command("convert", "convert worlds to current words, floor plans and maps to worlds", convert,
              add_convert,
              R"(Examples:
  playhouse convert worlds/cave.world
  playhouse convert worlds/cave.world -o my.world
  playhouse convert worlds/bitmaps/cave.png --scale 0.032 -o my.world
  playhouse convert worlds/cave.world -o map.yaml
  playhouse convert map.yaml -o my.world
  playhouse convert my.world -o my.glb)"),
      command("picture", "render a world from above, off screen", picture, add_picture,
              R"(Examples:
  playhouse picture worlds/cave.world --at 10 -o cave.png
  playhouse picture worlds/cave.world --at 10 --show ranger -o scans.png
  playhouse picture worlds/swarm.world -o swarm.png --width 400 --renderer playhouse)"),
      command("film", "render a run from above, off screen", film, add_film,
              R"(Examples:
  playhouse film worlds/swarm.world --duration 2 -o swarm.png
  playhouse film worlds/cave.world --duration 2 --rate 5 --width 320 -o cave.png)"),
      command("kinds", "list the kinds of world files and their words", kinds, add_kinds,
              R"(Examples:
  playhouse kinds
  playhouse kinds position
  playhouse kinds sensor --json)"),
      command("bench", "measure scenes, loading and the server (docs/benchmarks.md)", bench, add_bench,
              R"(Examples:
  playhouse bench laser --robots 100 --duration 1
  playhouse bench world worlds/cave.world --duration 10
  playhouse bench sonar --robots 100 --duration 1 --workers 2
  playhouse bench vaughan2008 --robots 100 --duration 1)"),
  };
}

}  // namespace playhouse::app
