#pragma once

/// Service: one simulated world, its devices on Player's ports and its web
/// page. Builds the object tree from a world file or a .cfg file, runs it
/// to its end, and reports the outcome. Threads: run() is the tick thread;
/// the io thread, the web thread and the signal thread live inside run().

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/app/again.h"
#include "playhouse/app/commands/options.h"
#include "playhouse/app/playback.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/app/world_saver.h"
#include "playhouse/bridge/simulated/auto_devices.h"
#include "playhouse/bridge/simulated/lock_step_turns.h"
#include "playhouse/bridge/simulated/simulated_world.h"
#include "playhouse/cluster/head.h"
#include "playhouse/config/cfg.h"
#include "playhouse/config/text/source_text.h"
#include "playhouse/device_server/server_host.h"
#include "playhouse/drivers/registry.h"
#include "playhouse/drivers/site.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/observers/observer_server.h"
#include "playhouse/record/recorder.h"
#include "playhouse/replicate/snapshot_feed.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/server/server.h"
#include "playhouse/web_server/web_server.h"
#include "playhouse/world/saving/saved_run.h"

namespace playhouse::app {

/// Result of a run.
struct Outcome {
  double sim_time = 0;   // s
  double wall_time = 0;  // s
  double real_time_factor = 0;
  std::uint64_t ticks = 0;
  std::size_t robots = 0;  // root position models
  std::uint64_t rays = 0;
  std::uint64_t hash = 0;         // World::hash()
  std::uint64_t sensed_hash = 0;  // World::sensed_hash()
  int signal = 0;                 // that ended the run; 0: none

  /// As a JSON object, for --json.
  std::string json() const;
};

/// The outcome of an engine after this wall time. [s]
Outcome outcome_of(world::Engine& engine, double wall_time);

class Service final : private device_server::ServerHost {
 public:
  Service(Serving serving, Running running, QuitTime quit_time);
  ~Service() override;

  /// Handler of warnings; default: the log. Before the first step.
  void on_warning(Warn warn) { warn_ = std::move(warn); }
  /// Overrides the engine named in the options. Before the first step.
  void use_engine(EngineMaker make) { engine_maker_ = std::move(make); }
  /// Overrides the number of indices of an interface on a port, for tests. Before the first step.
  void use_indices(std::size_t indices) { indices_ = indices; }
  /// Locates controller libraries without loading them: the world cannot run then. Before the first step.
  void load_no_code() { libraries_ = controllers::Libraries::LibraryUse::kFind; }

  // Steps, in this order; errors are one-line messages.

  /// Reads a world file: every robot of it becomes a set of
  /// devices. Or a configuration file, which lists the devices.
  Result<void> read_world(const std::string& path, config::NamedBy by = config::NamedBy::kPerson);
  Result<void> read_cfg(const std::string& path);
  /// The configuration file, if it has no world: then it is for serve_devices().
  const config::CfgFile* file_without_world() const;
  /// Reads a saved run: it continues where it was saved, with its seed.
  Result<void> read_saved(const std::string& path);
  /// All files read so far, which must not be overwritten.
  std::vector<std::string> files_read() const;
  /// Allows clients to save the world into a file; before run(). Fails if it is not writable.
  Result<void> let_clients_save(const std::string& file);
  /// Serves a recording instead of a live run: without devices, and
  /// with a read-only page. The recording must outlive the service.
  void play(OpenedRecording& recording) { recording_ = &recording; }
  /// Schedules a save of the state, or of the world, depending on the file's extension;
  /// before run(). Fails if a controller, made by make_devices(), cannot be saved.
  Result<void> save_at(const SaveAt& save);
  /// Records the run into a file; before run(), after everything else that changes the
  /// world. `only` is a record::Selection, or empty. Fails if the file is not writable.
  Result<void> record(const std::string& file, const std::string& only);
  /// After run(). False: something was not saved or recorded, or a node of the cluster was wrong; see the
  /// log.
  bool succeeded() const { return saves_.empty() && saving_works_ && run_works_; }
  /// Uses a scene made in code instead of a file.
  void take_scene(scene::SceneDesc scene) { scene_ = std::move(scene); }
  /// Reads the certificate and the key of --tls-cert, if there is one: ports speak TLS.
  Result<void> read_tls();
  /// Opens the Player ports; clients are served once run() is called.
  Result<void> open_ports();
  /// Makes the engine and the devices.
  Result<void> make_devices();
  /// Opens the ports behind the first one that the devices of many robots need.
  Result<void> open_following_ports();
  /// Further errors in the file of a failed step.
  const std::vector<Error>& other_errors() const { return other_errors_; }
  /// Reads the guest file. Fails if it is invalid or admits nobody.
  Result<void> read_guests();
  void close_clients_sent_out();
  /// Starts the web page, if enabled.
  Result<void> open_page();
  std::optional<web_server::WebOptions::PlayerClients> clients_of_pages();
  /// Opens the observer port, if enabled.
  Result<void> open_observers();

  const Serving& serving() const { return serving_; }
  /// Player ports at the start of the run, the default one first.
  const std::vector<std::uint16_t>& player_ports() const { return player_ports_; }
  /// Of the world, before run(). None of a recording, which has no devices.
  std::vector<std::string> robot_names();
  /// Web port; 0: no page.
  std::uint16_t web_port() const { return web_port_; }
  /// Addresses: "Player clients: ...", "web page: ...", "observers: ..." and "cluster nodes: ...", one line
  /// each.
  std::vector<std::string> places() const;

  /// Runs until the duration is over, the file's end, or a signal. `ended`
  /// is called with that signal, or 0, before clients are disconnected.
  Outcome run(const std::function<void(int signal)>& ended = {});
  /// Ends run(). Any thread.
  void stop();

  run::Simulation& simulation() { return *drivers::simulation_of(*site_); }
  const server::Server& server() const { return *server_; }

 private:
  server::Server& the_server() override { return *server_; }
  net::Network& the_network() override { return loop_; }
  Result<std::unique_ptr<drivers::SiteWorld>> open_world(const std::string& path,
                                                         drivers::Site& site) override;
  Result<std::unique_ptr<run::Simulation>> open_simulation(const std::string& path);
  Result<void> open_port(std::uint32_t port) override;
  libraries::Libraries libraries() const override;

  std::uint16_t first_of_free_ports();
  Result<std::uint16_t> listen(std::uint16_t port);
  Result<void> open_playback();
  Result<void> add_robots();
  Result<void> make_drivers();
  replicate::SnapshotFeed& feed();
  void fail_run(const Error& why);
  void catch_signals();
  void show_progress();
  void save_due(const world::World& world);
  Result<void> save(const world::World& world, const std::string& file) const;

  Serving serving_;
  Running running_;
  QuitTime quit_time_;
  Warn warn_;
  EngineMaker engine_maker_;
  std::size_t indices_ = drivers::AutoMap::kIndices;
  std::vector<Error> other_errors_;
  controllers::Libraries::LibraryUse libraries_ = controllers::Libraries::LibraryUse::kLoad;

  // In order of construction; later members use earlier ones.
  std::optional<config::CfgFile> cfg_;
  config::SourceFiles sources_;          // of scene_
  std::vector<std::string> files_read_;  // besides those
  std::optional<world::SavedRun> saved_;
  OpenedRecording* recording_ = nullptr;
  std::vector<SaveAt> saves_;  // pending
  bool saving_works_ = true, run_works_ = true;
  WorldSaver world_saver_;
  std::unique_ptr<record::RecordThread> record_file_;
  std::unique_ptr<record::Recorder> recorder_;
  scene::SceneDesc scene_;
  net::IoLoop loop_;
  net::IoLoop
      web_loop_;  // separate, so that encoding a large world for many viewers does not delay Player clients
  net::IoLoop signal_loop_;              // separate: signals are handled at once
  std::unique_ptr<drivers::Site> site_;  // owns the simulation
  std::optional<drivers::LockStepTurns> turns_;
  cluster::Head* head_ = nullptr;                         // of a cluster; owned by the simulation
  std::unique_ptr<Playback> playback_;                    // of a recording
  std::vector<std::unique_ptr<device::Driver>> drivers_;  // of the configuration file, or the program's own
  std::unique_ptr<drivers::AutoDevices> robots_;          // without a configuration file
  std::unique_ptr<server::Server> server_;
  server::GuestBook guests_;
  std::unique_ptr<replicate::SnapshotFeed> feed_;  // of the page and of observers
  std::unique_ptr<web_server::WebServer> web_;
  std::unique_ptr<observers::ObserverServer> observers_;
  std::unique_ptr<net::Timer> progress_;

  std::shared_ptr<net::TlsIdentity> tls_;  // null: in the clear
  std::vector<std::uint16_t> player_ports_;
  std::vector<std::unique_ptr<net::Listener>> held_ports_;  // until each is opened
  bool io_runs_ = false;                                    // tick thread
  std::uint16_t web_port_ = 0, observer_port_ = 0, cluster_port_ = 0;
  std::atomic<int> signal_ = 0;
};

}  // namespace playhouse::app
