#include "playhouse/app/command_line.h"

#include <arpa/inet.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/app/sensor_shapes.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/record/selection.h"
#include "playhouse/scenarios/scenario.h"

namespace playhouse::app {
namespace {

constexpr const char* kExamples = R"(Examples:
  playhouse run worlds/cave.world                    robots, Player clients on 6665, a page on 8080
  playhouse run my.world --port 7000 --web off       Player clients alone
  playhouse run my.world --fast --headless --duration 60 --json
                                                     a minute of simulated time, as fast as it goes
  playhouse run my.world --engine arena              the same world with rigid bodies that push and fall
  playhouse run my.world --save-at 60 minute.run     the state after a minute, into a file
  playhouse run --from minute.run                    on from there
  playhouse run my.world --save-at 60 later.world    where everybody is after a minute, as a world file
  playhouse run my.world --record my.mcap            a recording, for Foxglove, ROS and what follows
  playhouse run --again my.mcap                      the same run once more, to the bit
  playhouse replay my.mcap                           the same run in the page, with its time on a slider
  playhouse export my.mcap --csv                     what it has, as tables
  playhouse verify my.world --ticks 100              whether it is the same run on any number of workers
  playhouse serve simple.cfg                         devices as a Player configuration file names them
  playhouse robot my.toml --server lab               a robot of this machine in the world of another one
  playhouse devices 127.0.0.1:6665                   what a server offers
  playhouse watch 127.0.0.1 laser:0                  a device's data as JSON lines
  playhouse observe 127.0.0.1                        who is where, as JSON lines, by UDP (run --observers)
  playhouse drive 127.0.0.1 guest                    a robot by the keyboard
  playhouse check my.world                           what is wrong with a file
  playhouse convert old.world -o new.world           a world for older versions of Stage in today's words
  playhouse convert plan.png --scale 0.05 -o w.world a floor plan as a world; also a map.yaml of ROS, and back
  playhouse picture my.world --at 10 -o a.png        how it looks from above after ten seconds
  playhouse kinds ranger                             what a world file can say of a ranger
  playhouse bench laser --robots 1000                one line of figures
`playhouse COMMAND --help` tells more. Documentation: docs/cli.md)";

// Every line that begins with "  playhouse" is run by tests/e2e/test_program.py.
constexpr const char* kRunExamples = R"(Examples:
  playhouse run worlds/cave.world
  playhouse run worlds/cave.world --port 7000 --web off
  playhouse run worlds/cave.world --fast --headless --duration 60 --json
  playhouse run worlds/cave.world --engine arena
  playhouse run worlds/cave.world --headless --lock-step
  playhouse run worlds/cave.world --headless --lock-step left,right --lock-step-timeout 10)";
constexpr const char* kReplayExamples = R"(Examples:
  playhouse replay my.mcap
  playhouse replay my.mcap --web 8081 --paused)";
constexpr const char* kExportExamples = R"(Examples:
  playhouse export my.mcap --csv
  playhouse export my.mcap --csv -o tables)";
constexpr const char* kGymExamples = R"(Started by the Python package playhouse_gym:
  env = playhouse_gym.VectorEnv("my.world"))";
constexpr const char* kVerifyExamples = R"(Examples:
  playhouse verify worlds/cave.world --ticks 100
  playhouse verify worlds/cave.world --ticks 20 --workers 1,3)";
constexpr const char* kServeExamples = R"(Examples:
  playhouse serve my.cfg
  playhouse serve my.cfg --bind 0.0.0.0 --paused)";
constexpr const char* kRobotExamples = R"(Examples:
  playhouse robot examples/robot.toml --server 127.0.0.1:6665 --port 7000
  playhouse robot examples/robot.toml --server 127.0.0.1 --bind 0.0.0.0)";
constexpr const char* kDevicesExamples = R"(Examples:
  playhouse devices
  playhouse devices 127.0.0.1:6665 --json)";
constexpr const char* kWatchExamples = R"(Examples:
  playhouse watch 127.0.0.1 laser:0 --count 3
  playhouse watch 127.0.0.1 guest --count 3)";
constexpr const char* kObserveExamples = R"(Examples:
  playhouse observe 127.0.0.1 --seconds 1 --stats
  playhouse observe 127.0.0.1 --name guest --rate 2 --seconds 1
  playhouse observe 127.0.0.1 --view 0,0,5 --bytes-per-second 8000 --seconds 1)";
constexpr const char* kDriveExamples = R"(Examples:
  playhouse drive 127.0.0.1 guest
  playhouse drive 127.0.0.1:6665 position2d:0)";
constexpr const char* kCheckExamples = R"(Examples:
  playhouse check my.cfg
  playhouse check worlds/*.world worlds/*.inc)";
constexpr const char* kConvertExamples = R"(Examples:
  playhouse convert worlds/cave.world
  playhouse convert worlds/cave.world -o my.world
  playhouse convert worlds/bitmaps/cave.png --scale 0.032 -o my.world
  playhouse convert worlds/cave.world -o map.yaml
  playhouse convert map.yaml -o my.world
  playhouse convert my.world -o my.glb)";
constexpr const char* kPictureExamples = R"(Examples:
  playhouse picture worlds/cave.world --at 10 -o cave.png
  playhouse picture worlds/cave.world --at 10 --show ranger -o scans.png
  playhouse picture worlds/swarm.world -o swarm.png --width 400 --renderer playhouse)";
constexpr const char* kFilmExamples = R"(Examples:
  playhouse film worlds/swarm.world --duration 2 -o swarm.png
  playhouse film worlds/cave.world --duration 2 --rate 5 --width 320 -o cave.png)";
constexpr const char* kKindsExamples = R"(Examples:
  playhouse kinds
  playhouse kinds position
  playhouse kinds sensor --json)";
constexpr const char* kBenchExamples = R"(Examples:
  playhouse bench laser --robots 100 --duration 1
  playhouse bench world worlds/cave.world --duration 10
  playhouse bench sonar --robots 100 --duration 1 --workers 2
  playhouse bench vaughan2008 --robots 100 --duration 1)";

// Set where this file is compiled (CMakeLists.txt); sources without their history have none.
#ifndef PLAYHOUSE_COMMIT
#define PLAYHOUSE_COMMIT "unknown"
#endif
constexpr const char* kVersion =
    "playhouse " PLAYHOUSE_VERSION " (commit " PLAYHOUSE_COMMIT ", Player protocol 3.1)";

/// What CLI11 fills; the parts that need a second look become options afterwards.
struct Raw {
  RunOptions run;
  ReplayOptions replay;
  ExportOptions export_tables;
  ServeOptions serve;
  RobotOptions robot;
  GymOptions gym;
  VerifyOptions verify;
  DevicesOptions devices;
  WatchOptions watch;
  ObserveOptions observe;
  DriveOptions drive;
  CheckOptions check;
  ConvertOptions convert;
  PictureOptions picture;
  FilmOptions film;
  KindsOptions kinds;
  BenchOptions bench;
  std::string web, gym_web = "off", replay_web = std::to_string(kWebPort);
  std::vector<std::pair<double, std::string>> saves;
  std::string lock_step, view;
  bool headless = false, fast = false;
};

/// Whether `text` is a whole number that fits: CLI11 takes -1 for the largest number, and cuts off larger
/// ones.
template <typename Number>
bool is_whole(const std::string& text, Number least = 0, Number most = std::numeric_limits<Number>::max()) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value >= least && value <= most;
}

std::string check_port(const std::string& text) {
  return is_whole<std::uint16_t>(text) ? "" : "a port from 0 to 65535 is wanted, not " + in_quotes(text);
}

std::string check_web(const std::string& text) {
  if (text == "off" || is_whole<std::uint16_t>(text)) return {};
  return "a port or \"off\" is wanted, not " + in_quotes(text);
}

template <typename Number, Number least = 0, Number most = std::numeric_limits<Number>::max()>
std::string check_count(const std::string& text) {
  if (is_whole<Number>(text, least, most)) return {};
  return fmt::format("a whole number from {} to {} is wanted, not {}", least, most, in_quotes(text));
}

constexpr auto check_robots = check_count<std::uint32_t, 1, scenarios::kMostRobots>;

/// As net's listen() takes it: an address, which may name its interface (fe80::1%eth0).
std::string check_bind(const std::string& text) {
  in6_addr address;
  const bool good = text == "localhost" || inet_pton(AF_INET, text.c_str(), &address) == 1 ||
                    inet_pton(AF_INET6, text.substr(0, text.find('%')).c_str(), &address) == 1;
  return good ? "" : "an IPv4 or IPv6 address is wanted, without a port, not " + in_quotes(text);
}

/// As a browser writes it: no address, which needs no telling, no port, no scheme.
std::string check_web_host(const std::string& text) {
  const bool good = !text.empty() && std::ranges::all_of(text, [](unsigned char letter) {
    return std::isalnum(letter) || letter == '-' || letter == '.' || letter == '_';
  });
  return good ? "" : "the name of a host is wanted, without http:// and port, not " + in_quotes(text);
}

std::string check_workers(const std::string& text) {
  return is_whole<unsigned>(text, 1, 1024) ? "" : "a number from 1 to 1024 is wanted, not " + in_quotes(text);
}

constexpr auto check_width = check_count<int, 16, 16384>;

std::string check_not_negative(const std::string& text) {
  double value = 0;
  if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0) return {};
  return "a number that is not negative is wanted, not " + in_quotes(text);
}

std::string check_positive(const std::string& text) {
  double value = 0;
  if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0) return {};
  return "a number above 0 is wanted, not " + in_quotes(text);
}

/// "X,Y,RADIUS".
std::optional<ViewSquare> view_in(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : CLI::detail::split(text, ',')) {
    double value = 0;
    if (!CLI::detail::lexical_cast(word, value) || !(std::abs(value) <= 1e6)) return std::nullopt;
    numbers.push_back(value);
  }
  if (numbers.size() != 3 || numbers[2] <= 0) return std::nullopt;
  return ViewSquare{numbers[0], numbers[1], numbers[2]};
}

std::string check_view(const std::string& text) {
  if (view_in(text)) return {};
  return "X,Y,RADIUS in metres is wanted, the radius above 0, not " + in_quotes(text);
}

constexpr auto check_observer_bytes =
    check_count<std::uint32_t, limits::kObserverBytesLeast, limits::kObserverBytesMost>;

std::string check_token(const std::string& text) {
  const bool good = !text.empty() && text.size() <= limits::kTokenBytes;
  return good ? "" : fmt::format("a token of 1 to {} letters is wanted", limits::kTokenBytes);
}

std::string check_selection(const std::string& text) {
  const Result<record::Selection> selection = record::Selection::parse(text);
  return selection ? "" : selection.error().text;
}

std::string check_show(const std::string& text) {
  const Result<SensorShapes> shown = SensorShapes::parse(text);
  return shown ? "" : shown.error().text;
}

std::string check_renderer(const std::string& text) {
  constexpr std::string_view kNames[] = {kChromium, kPlayhouse};
  if (std::ranges::find(kNames, text) != std::end(kNames)) return "";
  return fmt::format("{} or {} is wanted, not {}{}", kChromium, kPlayhouse, in_quotes(text),
                     did_you_mean(text, kNames));
}

std::string check_engine(const std::string& text) {
  if (std::ranges::find(kEngines, text) != std::end(kEngines)) return "";
  return fmt::format("{} is wanted, not {}{}", fmt::join(kEngines, " or "), in_quotes(text),
                     did_you_mean(text, kEngines));
}

void add_engine(CLI::App& app, std::string& engine) {
  app.add_option("--engine", engine,
                 "what moves the robots: stage, in the plane, or arena, bodies with mass (docs/arena.md)")
      ->type_name("NAME")
      ->check(check_engine)
      ->capture_default_str();
}

void add_hosts(CLI::App& app, Serving& serving) {
  app.add_option("--bind", serving.bind, "address to listen on; 0.0.0.0: everybody's")
      ->check(check_bind)
      ->capture_default_str();
  app.add_option("--web-host", serving.web_hosts,
                 "a further name of this host that the page may be opened under (once for each)")
      ->check(check_web_host)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--guests", serving.guests,
                 "who may open the page, as observer, driver, human or admin (docs/guests.md)")
      ->type_name("FILE");
  app.add_option("--viewers", serving.viewers, "pages at once, and observers")
      ->check(check_count<std::size_t, 1, limits::kViewers>)
      ->capture_default_str();
  auto* observers =
      app.add_option("--observers", serving.observers,
                     "UDP port of playhouse observe; 0: any free one, printed (none; docs/observers.md)")
          ->type_name("PORT")
          ->check(check_port);
  app.add_option("--observer-bytes", serving.observer_bytes, "a second, to each observer at most")
      ->type_name("N")
      ->check(check_observer_bytes)
      ->capture_default_str()
      ->needs(observers);
}

void add_serving(CLI::App& app, Raw& raw, Serving& serving) {
  app.add_option("--port", serving.port, "port for Player clients; 0: any free one, printed")
      ->check(check_port)
      ->capture_default_str();
  app.add_option("--web", raw.web, "port of the web page, or off; 0: any free one, printed (8080)")
      ->check(check_web);
  add_hosts(app, serving);
  app.add_flag("--headless", raw.headless, "no web page, as --web off");
}

void add_allowed_libraries(CLI::App& app, Running& running) {
  app.add_option("--allow-library", running.allowed_libraries,
                 "a library that a world may load from elsewhere; may be given again")
      ->type_name("FILE.so")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

/// The names between commas; nothing where one is none.
std::optional<std::set<std::string>> names_in(const std::string& text) {
  std::set<std::string> names;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    const bool good = !name.empty() && name[0] != '-' && std::ranges::all_of(name, [](unsigned char letter) {
      return std::isalnum(letter) || letter == '-' || letter == '_';
    });
    if (!good || !names.insert(name).second) return std::nullopt;
    begin = end + 1;
  }
  return names;
}

constexpr auto is_client_count = is_whole<std::uint32_t>;

std::string check_lock_step(const std::string& text) {
  if (text.empty() || is_client_count(text, 1, limits::kSessions) ||
      (!std::isdigit(text[0]) && names_in(text)))
    return {};
  return fmt::format(
      "a number of clients from 1 to {}, or names of letters and digits between commas, is wanted, not {}",
      limits::kSessions, in_quotes(text));
}

LockStepping lock_stepping(const std::string& text) {
  if (text.empty()) return {};
  if (std::isdigit(static_cast<unsigned char>(text[0]))) return {.clients = std::stoul(text), .names = {}};
  std::set<std::string> names = names_in(text).value_or(std::set<std::string>());
  return {.clients = names.size(), .names = std::move(names)};
}

/// How a run is drawn, and what it depends on: for PictureOptions and FilmOptions.
template <typename Options>
void add_drawn_run(CLI::App& app, Options& options) {
  app.add_option("--width", options.width, "pixels; the height follows from the world")
      ->check(check_width)
      ->capture_default_str();
  app.add_option("--show", options.show,
                 "what sensors see as well: " + SensorShapes::names() + ", between commas (nothing)")
      ->type_name("SENSOR,...")
      ->check(check_show);
  app.add_option(
         "--renderer", options.renderer,
         "what draws: chromium, the page in a browser without a window, or playhouse, which needs none "
         "(chromium, where there is one that draws)")
      ->type_name("NAME")
      ->check(check_renderer);
  add_engine(app, options.running.engine);
  app.add_option("--seed", options.running.seed, "seed of all random numbers")
      ->check(check_count<std::uint64_t>)
      ->capture_default_str();
  app.add_option("--workers", options.running.workers,
                 "threads that compute; the result does not depend on it")
      ->check(check_workers)
      ->capture_default_str();
  add_allowed_libraries(app, options.running);
}

void add_lock_step(CLI::App& app, Raw& raw, Running& running) {
  auto* lock_step = app.add_option("--lock-step", raw.lock_step,
                                   "go on only when a client asks for a step; with a number or names: each "
                                   "of so many, or of these, "
                                   "clients (docs/lock-step.md)")
                        ->check(check_lock_step)
                        ->type_name("[N | NAME,NAME,...]")
                        ->expected(0, 1);
  app.add_option("--lock-step-timeout", running.lock_step_timeout,
                 "seconds that a client may be silent before the others go on without it (for ever)")
      ->check(check_positive)
      ->needs(lock_step);
}

void add_recording(CLI::App& app, Running& running) {
  auto* record =
      app.add_option("--record", running.record, "record the run into an MCAP file (docs/recording.md)")
          ->type_name("FILE.mcap");
  app.add_option(
         "--record-only", running.record_only,
         "what is recorded besides poses: kinds, @NAMES, or KIND@NAME, between commas; poses: nothing "
         "(everything)")
      ->type_name("WHAT,...")
      ->check(check_selection)
      ->needs(record);
}

void add_running(CLI::App& app, Raw& raw, Running& running) {
  add_engine(app, running.engine);
  auto* fast = app.add_flag("--fast", raw.fast, "as fast as possible instead of real time");
  app.add_option("--speed", running.speed, "times real time; 0: as fast as possible (the file's speedup)")
      ->check(check_not_negative)
      ->excludes(fast);
  app.add_option("--duration", running.duration, "simulated seconds, then end (run: the file's quit_time)")
      ->check(check_not_negative);
  app.add_option("--seed", running.seed, "seed of all random numbers")
      ->check(check_count<std::uint64_t>)
      ->capture_default_str();
  app.add_option("--workers", running.workers, "threads that compute; the result does not depend on it")
      ->check(check_workers)
      ->capture_default_str();
  add_allowed_libraries(app, running);
  app.add_option("--save-world", running.save_world,
                 "the file into which clients may save the world as it stands (SAVE of simulation)")
      ->type_name("FILE.world");
  add_recording(app, running);
  add_lock_step(app, raw, running);
  app.add_flag("--paused", running.paused, "wait to be resumed by a viewer or a client");
  app.add_flag("--json", running.json, "print the result as the last line of standard output");
}

void add_commands(CLI::App& app, Raw& raw) {
  CLI::App* run = app.add_subcommand("run", "simulate a world file and serve every robot of it");
  run->footer(kRunExamples);
  auto* world = run->add_option("WORLD", raw.run.world, "a .world file")->required();
  add_serving(*run, raw, raw.run.serving);
  add_running(*run, raw, raw.run.running);
  run->add_option("--from", raw.run.from,
                  "go on with a saved run instead; --duration counts from the start of its world")
      ->type_name("FILE")
      ->excludes(world)
      ->excludes(run->get_option("--engine"))
      ->excludes(run->get_option("--seed"));
  auto* again =
      run->add_option("--again", raw.run.again,
                      "run a recording again, as fast as it goes, and compare: exit code 1 where it differs")
          ->type_name("FILE.mcap")
          ->excludes(world);
  for (const char* const other : {"--from", "--engine", "--seed", "--duration", "--record", "--lock-step",
                                  "--paused", "--save-world", "--speed"})
    again->excludes(run->get_option(other));
  run->add_option(
         "--save-at", raw.saves,
         "save the state at a simulated time, or the world as it stands into FILE.world, and go on; may be "
         "given again")
      ->type_name("SECONDS FILE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->excludes(again);

  CLI::App* replay =
      app.add_subcommand("replay", "show a recorded run in the page, with its whole time on the slider");
  replay->footer(kReplayExamples);
  replay->add_option("FILE", raw.replay.file, "a recording of run --record")->required();
  replay->add_option("--web", raw.replay_web, "port of the web page; 0: any free one, printed")
      ->check(check_port)
      ->capture_default_str();
  add_hosts(*replay, raw.replay.serving);
  replay->add_option("--speed", raw.replay.running.speed, "times real time; 0: as fast as possible (1)")
      ->check(check_not_negative);
  replay->add_option("--workers", raw.replay.running.workers, "threads that compute")
      ->check(check_workers)
      ->capture_default_str();
  add_allowed_libraries(*replay, raw.replay.running);
  replay->add_flag("--paused", raw.replay.running.paused, "wait for a viewer to let it go on");

  CLI::App* tables = app.add_subcommand("export", "write what a recording has as tables");
  tables->footer(kExportExamples);
  tables->add_option("FILE", raw.export_tables.file, "a recording of run --record")->required();
  tables->add_flag("--csv", raw.export_tables.csv, "comma-separated values, one file for each channel")
      ->required();
  tables->add_option("-o,--output", raw.export_tables.folder, "the folder of the tables (FILE without .mcap)")
      ->type_name("DIR");

  CLI::App* serve = app.add_subcommand("serve", "serve the devices of a Player configuration file");
  serve->footer(kServeExamples);
  serve->add_option("FILE", raw.serve.file, "a .cfg file")->required();
  add_serving(*serve, raw, raw.serve.serving);
  add_running(*serve, raw, raw.serve.running);

  CLI::App* robot =
      app.add_subcommand("robot", "bring robots into the world of a server, and serve them on this machine");
  robot->footer(kRobotExamples);
  robot->add_option("FILE", raw.robot.files, "a .toml file of one robot or several (docs/robot-client.md)")
      ->required();
  robot->add_option("--server", raw.robot.server, "the server of the world")
      ->type_name("HOST[:PORT]")
      ->required();
  robot
      ->add_option("--port", raw.robot.port,
                   "port of the first robot whose file names none, and so on; 0: any free ones, printed")
      ->check(check_port)
      ->capture_default_str();
  robot->add_option("--bind", raw.robot.bind, "address to listen on; 0.0.0.0: everybody's")
      ->check(check_bind)
      ->capture_default_str();

  CLI::App* gym =
      app.add_subcommand("gym", "let a learning program step all robots of a world (docs/gym.md)");
  gym->footer(kGymExamples);
  gym->add_option("WORLD", raw.gym.world, "a .world file")->required();
  gym->add_option("--socket", raw.gym.socket, "descriptor of the socket to the program that started this one")
      ->check(check_count<std::uint16_t, 3>)
      ->required();
  gym->add_option("--web", raw.gym_web, "port of a web page; 0: any free one, printed (none)")
      ->check(check_web);
  add_engine(*gym, raw.gym.running.engine);
  gym->add_option("--seed", raw.gym.running.seed, "seed until the first reset")
      ->check(check_count<std::uint64_t>)
      ->capture_default_str();
  gym->add_option("--workers", raw.gym.running.workers, "threads that compute")
      ->check(check_workers)
      ->capture_default_str();
  add_recording(*gym, raw.gym.running);
  add_allowed_libraries(*gym, raw.gym.running);

  CLI::App* verify =
      app.add_subcommand("verify", "run a world several times side by side and compare the states");
  verify->footer(kVerifyExamples);
  verify->add_option("WORLD", raw.verify.world, "a .world file")->required();
  verify->add_option("--ticks", raw.verify.ticks, "how many ticks")
      ->check(check_count<std::uint64_t, 1>)
      ->required();
  verify->add_option("--workers", raw.verify.workers, "threads of each run (1,2,4)")
      ->check(check_workers)
      ->delimiter(',')
      ->type_name("N,N,...");
  add_engine(*verify, raw.verify.running.engine);
  verify->add_option("--seed", raw.verify.running.seed, "seed of all random numbers")
      ->check(check_count<std::uint64_t>)
      ->capture_default_str();
  add_allowed_libraries(*verify, raw.verify.running);

  CLI::App* devices = app.add_subcommand("devices", "list the devices of a server");
  devices->footer(kDevicesExamples);
  devices->add_option("HOST[:PORT]", raw.devices.server, "the server (127.0.0.1:6665)");
  devices->add_flag("--json", raw.devices.json, "a JSON object per device, one a line");

  CLI::App* watch = app.add_subcommand("watch", "print a device's data as JSON lines");
  watch->add_option("HOST[:PORT]", raw.watch.server, "the server")->required();
  watch->footer(kWatchExamples);
  watch->add_option("DEVICE", raw.watch.device, "INTERFACE:INDEX, e.g. laser:0, or a model's name")
      ->required();
  watch->add_option("--count", raw.watch.count, "end after so many messages")
      ->check(check_count<std::uint64_t, 1>);

  CLI::App* observe =
      app.add_subcommand("observe", "print who is where and what they say, of a run with --observers");
  observe->footer(kObserveExamples);
  observe->add_option("SERVER", raw.observe.server, "HOST or HOST:PORT (6670)")->required();
  observe->add_option("--token", raw.observe.token, "of a guest, where the run has --guests")
      ->check(check_token);
  observe
      ->add_option("--name", raw.observe.names,
                   "of a model to print, and no others; may be given again (those that stand for themselves)")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  observe
      ->add_option("--view", raw.view,
                   "a square of the world: what is in it comes first, the rest once a second (everything)")
      ->type_name("X,Y,RADIUS")
      ->check(check_view);
  observe->add_option("--rate", raw.observe.rate, "lines a second of each model (when it changes)")
      ->check(check_positive);
  observe->add_option("--seconds", raw.observe.seconds, "until the end (never)")->check(check_positive);
  observe
      ->add_option("--bytes-per-second", raw.observe.bytes_per_second,
                   "to ask for, at most what the run gives (that)")
      ->type_name("N")
      ->check(check_observer_bytes);
  observe->add_flag("--stats", raw.observe.stats, "a last line of figures: bytes, packets, losses");

  CLI::App* drive = app.add_subcommand("drive", "drive a robot by the keyboard");
  drive->add_option("HOST[:PORT]", raw.drive.server, "the server")->required();
  drive->footer(kDriveExamples);
  drive->add_option("ROBOT", raw.drive.device, "its name, or its device, e.g. position2d:0")->required();

  CLI::App* check = app.add_subcommand("check", "say what is wrong with .world, .inc and .cfg files");
  check->footer(kCheckExamples);
  check->add_option("FILE", raw.check.files, "a .world, .inc or .cfg file")->required();

  CLI::App* convert =
      app.add_subcommand("convert", "write a world in today's words, and floor plans and maps as worlds");
  convert->footer(kConvertExamples);
  convert
      ->add_option("FILE", raw.convert.input, "a .world file of any version, an image, or a map.yaml of ROS")
      ->required();
  convert->add_option("-o,--output", raw.convert.output,
                      "where to write (standard output); a .yaml: the walls of a world as a map of ROS; a "
                      ".glb: its bodies as glTF");
  convert
      ->add_option("--scale", raw.convert.scale, "metres that a pixel of an image measures (of a map 0.05)")
      ->check(check_positive);
  convert
      ->add_option("--height", raw.convert.height,
                   "metres: of the walls that are made (0.6), or at which they are looked for (0.2)")
      ->check(check_positive);

  CLI::App* picture = app.add_subcommand("picture", "draw a world from above, without a screen");
  picture->footer(kPictureExamples);
  picture->add_option("WORLD", raw.picture.world, "a .world file")->required();
  picture->add_option("-o,--output", raw.picture.output, "the picture")->type_name("FILE.png")->required();
  picture->add_option("--at", raw.picture.at, "after so many simulated seconds")
      ->check(check_not_negative)
      ->capture_default_str();
  add_drawn_run(*picture, raw.picture);

  CLI::App* film = app.add_subcommand("film", "draw a run from above, without a screen");
  film->footer(kFilmExamples);
  film->add_option("WORLD", raw.film.world, "a .world file")->required();
  film->add_option("-o,--output", raw.film.output,
                   "the film: an animated .png, or what ffmpeg makes of its ending")
      ->type_name("FILE")
      ->required();
  film->add_option("--duration", raw.film.duration, "simulated seconds")
      ->check(check_not_negative)
      ->capture_default_str();
  film->add_option("--rate", raw.film.rate, "pictures per simulated second, one a tick at most")
      ->check(check_positive)
      ->capture_default_str();
  add_drawn_run(*film, raw.film);

  CLI::App* kinds = app.add_subcommand("kinds", "list what world files can hold, and its words");
  kinds->footer(kKindsExamples);
  kinds->add_option("NAME", raw.kinds.name, "one of them, with its words");
  kinds->add_flag("--json", raw.kinds.json, "a JSON object per kind, one a line");

  CLI::App* bench =
      app.add_subcommand("bench", "measure scenes, loading and the server (docs/benchmarks.md)");
  bench->footer(kBenchExamples);
  bench
      ->add_option(
          "SCENARIO", raw.bench.scenario,
          "sonar, laser, cave, hospital, swarm, vaughan2008, diffusion, world, load, open, server or watched")
      ->required();
  bench->add_option("WORLD", raw.bench.world, "a .world file, of bench world");
  bench
      ->add_option(
          "--robots", raw.bench.robots,
          "how many (the scenario's own number; of vaughan2008 and diffusion 1, 10, ... 100000 in turn)")
      ->check(check_robots);
  bench
      ->add_option("--duration", raw.bench.duration,
                   "simulated seconds (the scenario's own); not of load, server")
      ->check(check_positive);
  add_engine(*bench, raw.bench.engine);
  bench->add_option("--seed", raw.bench.seed, "seed of all random numbers")
      ->check(check_count<std::uint64_t>)
      ->capture_default_str();
  bench->add_option("--workers", raw.bench.workers, "threads that compute")
      ->check(check_workers)
      ->capture_default_str();
}

std::vector<std::string_view> command_names(const CLI::App& app) {
  std::vector<std::string_view> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> flag_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

bool looks_like_flag(std::string_view word) {
  return word.size() > 1 && word[0] == '-' && !(word[1] >= '0' && word[1] <= '9') && word[1] != '.';
}

/// CLI11 says that a word is unknown, but not what was meant; so words are looked at before it sees them.
Result<void> check_words(const CLI::App& app, std::span<const char* const> words) {
  const CLI::App* scope = &app;
  std::size_t next = 0;
  if (!words.empty() && !looks_like_flag(words[0])) {
    const std::vector<std::string_view> commands = command_names(app);
    const std::string_view command = words[0];
    if (std::ranges::find(commands, command) == commands.end()) {
      return Error{"", fmt::format("{} is no command{}; see playhouse --help", in_quotes(command),
                                   did_you_mean(command, commands))};
    }
    scope = app.get_subcommand(words[0]);
    next = 1;
  }
  const std::vector<std::string> names = flag_names(*scope);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  for (const std::string_view word : words.subspan(next)) {
    if (word == "--") break;  // what follows is no option
    if (!looks_like_flag(word)) continue;
    const std::string_view flag = word.substr(0, word.find('='));
    if (std::ranges::find(candidates, flag) != candidates.end()) continue;
    const bool is_letter = flag.size() == 2;  // -p: every other letter would be near
    return Error{"", fmt::format("unknown option {}{}", flag,
                                 is_letter ? "; playhouse COMMAND --help lists them"
                                           : did_you_mean(flag, candidates))};
  }
  return {};
}

void finish(const Raw& raw, Serving& serving, Running& running) {
  if (raw.headless || raw.web == "off") {
    serving.web.reset();
  } else if (!raw.web.empty()) {
    serving.web = static_cast<std::uint16_t>(std::stoi(raw.web));
  }
  if (raw.fast) running.speed = 0;
}

CommandLine chosen(const CLI::App& app, Raw& raw) {
  const std::string name = app.get_subcommands().front()->get_name();
  finish(raw, raw.run.serving, raw.run.running);
  finish(raw, raw.serve.serving, raw.serve.running);
  for (const auto& [command, running] : {std::pair("run", &raw.run.running), {"serve", &raw.serve.running}})
    if (app.get_subcommand(command)->count("--lock-step") > 0)
      running->lock_step = lock_stepping(raw.lock_step);
  if (name == "run") return raw.run;
  if (name == "replay") {
    raw.replay.serving.web = static_cast<std::uint16_t>(std::stoi(raw.replay_web));
    return raw.replay;
  }
  if (name == "export") return raw.export_tables;
  if (name == "serve") return raw.serve;
  if (name == "gym") {
    raw.gym.serving.port = 0;
    raw.gym.serving.web.reset();
    if (raw.gym_web != "off") raw.gym.serving.web = static_cast<std::uint16_t>(std::stoi(raw.gym_web));
    raw.gym.running.lock_step = LockStepping{};
    return raw.gym;
  }
  if (name == "verify") return raw.verify;
  if (name == "devices") return raw.devices;
  if (name == "watch") return raw.watch;
  if (name == "observe") {
    if (!raw.view.empty()) raw.observe.view = view_in(raw.view);
    return raw.observe;
  }
  if (name == "robot") return raw.robot;
  if (name == "drive") return raw.drive;
  if (name == "check") return raw.check;
  if (name == "convert") return raw.convert;
  if (name == "picture") return raw.picture;
  if (name == "film") return raw.film;
  if (name == "kinds") return raw.kinds;
  return raw.bench;
}

}  // namespace

Result<CommandLine> parse_command_line(std::span<const char* const> words) {
  CLI::App app("A robot device server and simulator: Player clients and Stage worlds.", "playhouse");
  Raw raw;
  app.set_version_flag("-V,--version", kVersion);
  app.footer(kExamples);
  app.require_subcommand(1);
  add_commands(app, raw);

  if (words.empty()) return CommandLine(Answer{app.help()});
  if (const Result<void> known = check_words(app, words); !known) return known.error();
  // CLI11 gives every further word to an option that may be given again, unless something still wants it.
  const bool goes_on = std::ranges::any_of(words, [](std::string_view word) {
    const std::string_view option = word.substr(0, word.find('='));
    return option == "--from" || option == "--again";
  });
  if (goes_on) app.get_subcommand("run")->get_option("WORLD")->required(false);
  try {
    // CLI11 takes the words last first.
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    app.parse(reversed);
  } catch (const CLI::CallForHelp&) {
    const std::vector<CLI::App*> commands = app.get_subcommands();
    return CommandLine(Answer{commands.empty() ? app.help() : commands.front()->help(app.get_name())});
  } catch (const CLI::CallForVersion& version) {
    return CommandLine(Answer{std::string(version.what()) + "\n"});
  } catch (const CLI::ArgumentMismatch& error) {
    // "--port: 1 required UINT missing", "--port: At Most 1 required but received 2"
    const std::string_view text = error.what();
    const bool twice = text.find("At Most") != std::string_view::npos;
    return Error{"", fmt::format("{} {}", text.substr(0, text.find(':')),
                                 twice ? "is given more than once" : "wants a value")};
  } catch (const CLI::ParseError& error) {
    return Error{"", error.what()};
  }
  for (const auto& [seconds, file] : raw.saves) {
    if (!std::isfinite(seconds) || seconds < 0)
      return Error{"", "--save-at wants a number of seconds that is not negative, and a file"};
    raw.run.saves.push_back({seconds, file});
  }
  if (raw.bench.scenario == "server" && raw.bench.duration > 0)
    return Error{"", "--duration: bench server measures for a time of its own"};
  if (raw.bench.scenario == "load" && raw.bench.duration > 0)
    return Error{"", "--duration: bench load ends before the first tick"};
  if (raw.bench.scenario == "world" && raw.bench.world.empty())
    return Error{"", "bench world wants the name of a .world file"};
  if (raw.bench.scenario == "world" && raw.bench.robots > 0)
    return Error{"", "--robots: bench world has the robots of its file"};
  if (raw.bench.engine != kStage && (raw.bench.scenario == "load" || raw.bench.scenario == "open" ||
                                     raw.bench.scenario == "server" || raw.bench.scenario == "watched"))
    return Error{"", fmt::format("--engine: bench {} measures with stage", raw.bench.scenario)};
  if (raw.bench.scenario != "world" && !raw.bench.world.empty())
    return Error{"", fmt::format("a file belongs to bench world, not to bench {}", raw.bench.scenario)};
  return chosen(app, raw);
}

}  // namespace playhouse::app
