#include "playhouse/app/commands/command_table.h"

#include <memory>

#include "playhouse/app/commands/command_options.h"
#include "playhouse/app/commands/commands.h"

namespace playhouse::app {
namespace {

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
      command("export", "export a recording as tables, or list its changes", export_tables, add_export,
              R"(Examples:
  playhouse export my.mcap --csv
  playhouse export my.mcap --csv -o tables
  playhouse export my.mcap --changes)"),
      command("serve", "serve the devices of a Player configuration file", serve, add_serve,
              R"(Examples:
  playhouse serve my.cfg
  playhouse serve my.cfg --bind 0.0.0.0 --insecure --paused)"),
      command("node", "compute a share of a run with --cluster (docs/cluster.md)", node, add_node,
              R"(Examples:
  playhouse node 127.0.0.1 --wait 1
  playhouse node 127.0.0.1:6675 --workers 2 --wait 1)"),
      command("robot", "spawn robots in the world of a server, and serve them on this machine", robot,
              add_robot,
              R"(Examples:
  playhouse robot examples/robot.toml --server 127.0.0.1:6665 --port 7000
  playhouse robot examples/robot.toml --server 127.0.0.1 --bind 0.0.0.0 --insecure)"),
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
  playhouse devices --network
  playhouse devices 127.0.0.1:6665 --json)"),
      command("watch", "print a device's data as JSON lines", watch, add_watch,
              R"(Examples:
  playhouse watch 127.0.0.1 laser:0 --count 3
  playhouse watch 127.0.0.1 guest --count 3
  playhouse watch guest)"),
      command("observe", "print poses and speech of models, from a run with --observers", observe,
              add_observe,
              R"(Examples:
  playhouse observe 127.0.0.1 --seconds 1 --stats
  playhouse observe 127.0.0.1 --name guest --rate 2 --seconds 1
  playhouse observe 127.0.0.1 --view 0,0,5 --bytes-per-second 8000 --seconds 1)"),
      command("drive", "drive a robot by the keyboard", drive, add_drive,
              R"(Examples:
  playhouse drive guest
  playhouse drive 127.0.0.1 guest
  playhouse drive 127.0.0.1:6665 position2d:0)"),
      command("emulate", "let a robot of a server behave as hardware on a serial line (docs/hardware.md)",
              emulate, add_emulate,
              R"(Examples:
  playhouse emulate p2os --robot guest --port /tmp/pioneer
  playhouse emulate p2os --tcp-port 8101 --option robot=p3at-sh --option watchdog=5)"),
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
      command("picture", "render a world or a recording, off screen", picture, add_picture,
              R"(Examples:
  playhouse picture worlds/cave.world --at 10 -o cave.png
  playhouse picture worlds/cave.world --at 10 --show ranger -o scans.png
  playhouse picture worlds/cave.world --from 0,-9,6 --look-at 0,0,0 -o aside.png
  playhouse picture worlds/cave.world --first-person guest -o eyes.png
  playhouse picture my.mcap --at 1 -o moment.png
  playhouse picture worlds/swarm.world -o swarm.png --width 400 --renderer playhouse)"),
      command("film", "render a run or a recording, off screen", film, add_film,
              R"(Examples:
  playhouse film worlds/swarm.world --duration 2 -o swarm.png
  playhouse film worlds/cave.world --duration 2 --rate 5 --width 320 -o cave.png
  playhouse film worlds/cave.world --duration 2 --rate 5 --width 320 --follow guest -o behind.png
  playhouse film my.mcap --width 320 -o run.png)"),
      command("kinds", "list the kinds of world files and their words", kinds, add_kinds,
              R"(Examples:
  playhouse kinds
  playhouse kinds position
  playhouse kinds sensor --json)"),
      command("drivers", "list the drivers of configuration files and their options", drivers, add_drivers,
              R"(Examples:
  playhouse drivers
  playhouse drivers vfh
  playhouse drivers vfh --json)"),
      command("bench", "measure scenes, loading and the server (docs/benchmarks.md)", bench, add_bench,
              R"(Examples:
  playhouse bench laser --robots 100 --duration 1
  playhouse bench world worlds/cave.world --duration 10
  playhouse bench sonar --robots 100 --duration 1 --workers 2
  playhouse bench vaughan2008 --robots 100 --duration 1)"),
  };
}

}  // namespace playhouse::app
