#pragma once

/// Options of each command of the program: plain values, filled by command_line.cc. Where code
/// lists some members of a struct by name, the others have an initializer here: g++ warns of those without.

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/fail.h"
#include "playhouse/base/limits.h"
#include "playhouse/geom/orientation.h"
#include "playhouse/net/endpoint.h"
#include "playhouse/net/forwarded.h"

namespace playhouse::app {

inline constexpr std::uint16_t kPlayerPort = 6665;
inline constexpr std::uint16_t kWebPort = 8080;
inline constexpr std::uint16_t kObserverPort = 6670;  // UDP
inline constexpr std::uint16_t kClusterPort = 6675;
inline constexpr std::uint16_t kGroupPort = 6680;  // UDP

/// Ports and access of a served world.
struct Serving {
  bool is_encrypted() const { return !tls_cert.empty(); }
  bool is_controlled() const { return !guests.empty() || !key.empty(); }

  std::uint16_t port = kPlayerPort;             // 0: any free one
  std::optional<std::uint16_t> web = kWebPort;  // none: no page; 0: any free port
  bool web_was_asked_for =
      true;  // false: a server without a world goes on without a page if the port is in use
  std::string bind = "127.0.0.1";
  bool insecure = false;                    // may be bound wider than this machine without guests
  std::string port_option = "--port";       // name of the option of `port`, for errors
  std::vector<std::string> web_hosts = {};  // host names of the page besides the machine's
  net::TrustedProxies proxies = {};         // in front of the page
  std::string tls_cert = {}, tls_key = {};  // PEM files; empty: ports are in the clear
  std::string guests = {};                  // access control file of the page; empty: full access
  std::string key = {};                     // that everybody has to know who comes; empty: none
  std::string unix_folder = {};             // with a Unix socket for each port of Player clients; empty: none
  bool udp = false;                         // ports of Player clients are of UDP as well
  std::optional<net::Endpoint> multicast = {};  // group that data go to as well; none: nothing does
  std::size_t client_mib = limits::kClientMiB;  // memory for what Player clients send and do not read
  std::size_t viewers = limits::kViewers;       // limit on simultaneous pages, and on observers
  std::uint32_t page_bytes = limits::kPageBytesPerSecond;  // limit per second for each page
  std::optional<std::uint16_t> observers = {};  // UDP port for observers; none: no observers; 0: any free one
  std::uint32_t observer_bytes = limits::kObserverBytesPerSecond;  // limit per second for each observer
};

/// The engines: 2D, and 3D with rigid bodies.
inline constexpr const char *kStage = "stage", *kArena = "arena";
inline constexpr std::string_view kEngines[] = {kStage, kArena};

/// The members of lock-step.
struct LockStepping {
  std::size_t clients = 1;
  std::set<std::string> names;  // names of the members; empty: any clients
};

/// Options of a run. Defaults come from the world file.
struct Running {
  std::string engine = kStage;          // a name of kEngines
  std::optional<double> speed = {};     // times real time; 0: as fast as possible
  std::optional<double> duration = {};  // simulated seconds
  std::uint64_t seed = 1;
  unsigned workers = 1;
  /// Libraries of controllers and custom models outside the library folders.
  std::vector<std::string> allowed_libraries = {};
  std::string save_world = {};                 // file for SAVE of clients; empty: none
  std::optional<LockStepping> lock_step = {};  // none: no lock-step
  double lock_step_timeout = 0;                // s of silence after which a member is dropped; 0: never
  std::string record = {};                     // recording file; empty: none
  std::string record_only = {};                // recorded part, record::Selection; empty: everything
  std::optional<std::uint16_t> cluster =
      {};                          // port for nodes of a cluster; none: no cluster; 0: any free one
  std::size_t nodes = 0;           // of the cluster, to wait for
  std::string cluster_token = {};  // that its nodes have to have; empty: a random one beyond this machine
  std::vector<std::string> for_a_world = {};  // names of given options that a server without a world lacks
  bool paused = false;
  bool json = false;  // the result as the last line of standard output
};

/// A state, or the current world as a world file, to be saved during a run.
struct SaveAt {
  double seconds = 0;  // simulated; at the first tick at or after it
  std::string file;    // .world: a world file
};

struct RunOptions {
  std::string world;
  std::string from;   // a saved run, in place of a world
  std::string again;  // a recording that is run again, in place of a world
  std::vector<SaveAt> saves;
  Serving serving;
  Running running;
};

struct ReplayOptions {
  std::string file;  // a recording
  Serving serving;
  Running running;
};

struct ExportOptions {
  std::string file;    // a recording
  std::string folder;  // of the tables; empty: the file's name without its extension
  bool csv = false;
  bool changes = false;
};

struct ServeOptions {
  std::string file;  // .cfg
  Serving serving;
  Running running;
};

struct NodeOptions {
  std::string head;   // "host" or "host:port" of the run
  double wait = 10;   // seconds for the run to begin
  std::string token;  // of the run; empty: none
  Running running;    // workers and libraries
};

struct RobotOptions {
  double wait = 30;                // seconds for the server to answer
  std::vector<std::string> files;  // .toml
  std::string server;              // "host" or "host:port" of the world
  std::string token;               // of a guest; empty: none
  std::string tls_ca;              // PEM file; empty: in the clear
  std::uint16_t port = kPlayerPort;
  std::string bind = "127.0.0.1";
  bool insecure = false;  // may be bound wider than this machine
};

struct GymOptions {
  std::string world;
  int socket = -1;  // connected to the learning program
  Serving serving;
  Running running;
};

struct VerifyOptions {
  std::string world;
  std::uint64_t ticks = 0;
  std::vector<unsigned> workers;  // of the parallel runs
  Running running;
};

struct DevicesOptions {
  std::string server;    // "host", "host:port" or ""
  std::string token;     // of a guest; empty: none
  bool json = false;     // an object per device
  bool network = false;  // lists servers instead
};

struct WatchOptions {
  std::string server;       // or a robot's name, without a device
  std::string token;        // of a guest; empty: none
  std::string device;       // "laser:0", or the name of a model
  std::uint64_t count = 0;  // messages until the end; 0: for ever
};

/// A square of the world. [m, W]
struct ViewSquare {
  double x = 0, y = 0, radius = 0;
};

struct ObserveOptions {
  std::string server;
  std::string token;                   // of a guest; empty: none
  std::vector<std::string> names;      // of models; empty: all top-level models
  std::optional<ViewSquare> view;      // region with priority
  double rate = 0;                     // lines per second for each model; 0: on change
  double seconds = 0;                  // after reception of the world; 0: for ever
  std::uint32_t bytes_per_second = 0;  // requested; 0: the limit of the run
  bool stats = false;
};

struct DriveOptions {
  std::string server;  // or a robot's name, without a device
  std::string token;   // of a guest; empty: none
  std::string device;
};

struct EmulateOptions {
  std::string hardware;                   // "p2os"
  std::string server = {};                // of the robot; empty: this machine's
  std::string token = {};                 // of a guest; empty: none
  std::string robot = {};                 // its name; empty: the first one
  std::vector<std::string> devices = {};  // "INTERFACE:INDEX", in place of those of the robot
  std::string port = {};                  // name of a pseudo-terminal to make
  std::uint16_t tcp_port = 0;             // in its place
  std::vector<std::string> options;       // of the emulator's section: "KEY=VALUE"
};

struct CheckOptions {
  std::vector<std::string> files;
  bool strict = false;  // warnings count as errors
};

struct ConvertOptions {
  std::string input;             // a world, an image or a ROS map
  std::string output;            // "": standard output
  std::optional<double> scale;   // of an image or map [m per pixel]
  std::optional<double> height;  // of generated walls, or of the section through the world [m]
};

/// Renderers of pictures.
inline constexpr const char *kChromium = "chromium", *kPlayhouse = "playhouse";

/// Where pictures are seen from, by default from above. At most one of look_at, follow and first_person.
struct SightOptions {
  std::optional<geom::Vec3> from, look_at;  // of the camera; what it looks at  [m, W]
  std::string follow;                       // name of a model to look at; without `from`: from behind it
  std::string first_person;                 // name of the model that sees it
};

struct PictureOptions {
  std::string world, output;  // .world or .mcap, .png
  double at = 0;              // simulated seconds
  SightOptions sight;
  int width = 1280;      // pixels
  std::string show;      // drawn sensor data, SensorShapes; empty: none
  std::string renderer;  // kChromium or kPlayhouse; empty: Chromium, if one that renders is installed
  Running running;
};

inline constexpr double kFilmSeconds = 10;

struct FilmOptions {
  std::string world, output;            // .world or .mcap; .png, or a format of ffmpeg
  std::optional<double> duration = {};  // simulated seconds; none: kFilmSeconds, or all of a recording
  SightOptions sight;
  double rate = 10;      // pictures per simulated second, at most one a tick
  int width = 640;       // pixels
  std::string show;      // as of a picture
  std::string renderer;  // the same
  Running running;
};

struct KindsOptions {
  std::string name;   // "": all
  bool json = false;  // an object per kind
};

struct DriversOptions {
  std::string name;   // "": all
  bool json = false;  // an object per driver
};

struct BenchOptions {
  std::string scenario;
  std::string engine = kStage;  // a name of kEngines
  std::string world;            // a .world file, of scenario "world" alone
  std::uint32_t robots = 0;     // 0: the scenario's own number
  double duration = 0;          // simulated seconds; 0: the scenario's own
  std::uint64_t seed = 1;
  unsigned workers = 1;
};

}  // namespace playhouse::app
