#include "playhouse/app/commands/command_options.h"

#include "playhouse/app/commands/device_name.h"
#include "playhouse/app/commands/shared_options.h"
#include "playhouse/app/pictures/sensor_shapes.h"

namespace playhouse::app {
namespace {

constexpr const char* kDrawable = "a .world file, or a recording (.mcap)";
constexpr auto check_width = check_count<int, 16, 16384>;

/// A word alone is a robot's name, unless it is plainly a server.
void check_alone(const std::string& server, const std::string& device, const std::string& name) {
  const bool is_server = server == "localhost" || server.find_first_of(".:") != std::string::npos ||
                         server.find_first_not_of("0123456789") == std::string::npos;
  if (device.empty() && is_server) throw CLI::RequiredError(name);
}

/// Options of a rendered run, for PictureOptions and FilmOptions.
template <typename Options>
void add_drawn_run(CLI::App& app, Options& options) {
  app.add_option("--width", options.width, "pixels; the height follows from the world")
      ->check(check_width)
      ->capture_default_str();
  CLI::Option* const from =
      add_parsed(app, "--from", parse_point, options.sight.from, "place of the camera in metres (above)")
          ->type_name("X,Y,Z");
  CLI::Option* const at = add_parsed(app, "--look-at", parse_point, options.sight.look_at,
                                     "point that the camera of --from looks at (the middle of the world)")
                              ->type_name("X,Y,Z")
                              ->needs(from);
  CLI::Option* const follow =
      app.add_option("--follow", options.sight.follow,
                     "name of a model to look at, from --from, or from behind and above it")
          ->type_name("NAME")
          ->excludes(at);
  app.add_option("--first-person", options.sight.first_person,
                 "name of the model that sees the picture: a robot, a person or a camera")
      ->type_name("NAME")
      ->excludes(from)
      ->excludes(follow);
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

}  // namespace

void add_export(CLI::App& app, ExportOptions& options) {
  app.add_option("FILE", options.file, "a recording of run --record")->required();
  CLI::Option* const csv = app.add_flag("--csv", options.csv, "comma-separated values, one file per topic");
  app.add_flag("--changes", options.changes, "print the changes of the run, a line each (docs/changes.md)")
      ->excludes(csv);
  app.add_option("-o,--output", options.folder, "folder of the tables (FILE without .mcap)")
      ->type_name("DIR")
      ->needs(csv);
}

void add_devices(CLI::App& app, DevicesOptions& options) {
  auto* const server = app.add_option("HOST[:PORT]", options.server, "the server (127.0.0.1:6665)");
  app.add_flag("--json", options.json, "one JSON object per line and device");
  app.add_flag("--network", options.network, "list the servers that are announced on the network instead")
      ->excludes(server);
  add_auth_key(app, options.token);
}

void add_watch(CLI::App& app, WatchOptions& options) {
  app.add_option("HOST[:PORT]", options.server, "the server, or a robot's name alone")->required();
  app.add_option("DEVICE", options.device, "INTERFACE:INDEX, e.g. laser:0, or a model's name");
  app.add_option("--count", options.count, "end after so many messages")
      ->check(check_count<std::uint64_t, 1>);
  add_auth_key(app, options.token);
  app.callback([&options] { check_alone(options.server, options.device, "DEVICE"); });
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
  app.add_option("HOST[:PORT]", options.server, "the server, or a robot's name alone")->required();
  app.add_option("ROBOT", options.device, "a model's name, or a device, e.g. position2d:0");
  add_auth_key(app, options.token);
  app.callback([&options] { check_alone(options.server, options.device, "ROBOT"); });
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
  app.add_option("WORLD", options.world, kDrawable)->required();
  app.add_option("-o,--output", options.output, "output file")->type_name("FILE.png")->required();
  app.add_option("--at", options.at, "simulated seconds before the picture")
      ->check(check_not_negative)
      ->capture_default_str();
  add_drawn_run(app, options);
}

void add_film(CLI::App& app, FilmOptions& options) {
  app.add_option("WORLD", options.world, kDrawable)->required();
  app.add_option("-o,--output", options.output,
                 "output file: an animated .png, or a format that ffmpeg derives from the extension")
      ->type_name("FILE")
      ->required();
  app.add_option("--duration", options.duration, "simulated seconds (10; of a recording all)")
      ->check(check_not_negative);
  app.add_option("--rate", options.rate, "pictures per simulated second, one a tick at most")
      ->check(check_positive)
      ->capture_default_str();
  add_drawn_run(app, options);
}

void add_kinds(CLI::App& app, KindsOptions& options) {
  app.add_option("NAME", options.name, "a kind: print all its words");
  app.add_flag("--json", options.json, "one JSON object per line and kind");
}

void add_emulate(CLI::App& app, EmulateOptions& options) {
  app.add_option("HARDWARE", options.hardware, "what it is for other programs: p2os")->required();
  app.add_option("--robot", options.robot, "name of the robot (the first one)")->type_name("NAME");
  app.add_option("--device", options.devices,
                 "a device to use, in place of those of the robot, once for each")
      ->type_name("INTERFACE:INDEX")
      ->allow_extra_args(false)
      ->check([](const std::string& text) {
        const Result<DeviceName> device = parse_device_name(text);
        return device ? std::string() : device.error().line();
      });
  app.add_option("--server", options.server, "the robot's server (127.0.0.1:6665)")->type_name("HOST[:PORT]");
  CLI::Option* const port =
      app.add_option("--port", options.port,
                     "make a pseudo-terminal of this name, to be opened as a serial port")
          ->type_name("FILE");
  app.add_option("--tcp-port", options.tcp_port, "listen at this TCP port of the machine instead")
      ->type_name("PORT")
      ->excludes(port);
  app.add_option("--option", options.options,
                 "an option of the emulator, which playhouse drivers HARDWARE_emulator lists")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  add_auth_key(app, options.token);
  app.callback([&options] {
    if (options.port.empty() && options.tcp_port == 0) throw CLI::RequiredError("--port or --tcp-port");
  });
}

void add_drivers(CLI::App& app, DriversOptions& options) {
  app.add_option("NAME", options.name, "a driver: print its devices and options");
  app.add_flag("--json", options.json, "one JSON object per line and driver");
}

}  // namespace playhouse::app
