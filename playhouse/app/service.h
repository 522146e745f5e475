#pragma once

/// Service: one simulated world with its devices on Player's ports and a page on the web. Builds the object
/// tree from a world file or a .cfg file, runs it until it ends, and says how it went. Threads: the caller of
/// run() is the tick thread; the io thread, the web thread and the one that waits for signals live inside
/// run().

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/app/again.h"
#include "playhouse/app/options.h"
#include "playhouse/app/playback.h"
#include "playhouse/app/server_surroundings.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/app/world_saver.h"
#include "playhouse/drivers/registry.h"
#include "playhouse/drivers/simulated/auto_devices.h"
#include "playhouse/drivers/site.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/observers/observer_server.h"
#include "playhouse/record/recorder.h"
#include "playhouse/scene/cfg.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/scene/source_text.h"
#include "playhouse/server/server.h"
#include "playhouse/web_server/web_server.h"
#include "playhouse/world/saved_run.h"

namespace playhouse::app {

/// How a run went.
struct Outcome {
  double sim_time = 0;   // s
  double wall_time = 0;  // s
  double real_time_factor = 0;
  std::uint64_t ticks = 0;
  std::size_t robots = 0;  // top-level position models
  std::uint64_t rays = 0;
  std::uint64_t hash = 0;         // of what robots did
  std::uint64_t sensed_hash = 0;  // of what sensors measured, for whomever
  int signal = 0;                 // that ended the run; 0: none

  /// One JSON object, for --json.
  std::string json() const;
};

/// Of what an engine has run, in so much time. [s]
Outcome outcome_of(world::Engine& engine, double wall_time);

class Service final : private ServerSurroundings {
 public:
  Service(Serving serving, Running running, QuitTime quit_time);
  ~Service() override;

  /// Where lines about odd things in the files go; by default, to the log. Before the first step.
  void on_warning(Warn warn) { warn_ = std::move(warn); }
  /// The engine that runs the world; by default, the one that the options name. Before the first step.
  void use_engine(EngineMaker make) { engine_maker_ = std::move(make); }
  /// Finds libraries of controllers without loading them: nothing can run then. Before the first step.
  void load_no_code() { libraries_ = controllers::Libraries::Use::kFind; }

  // Steps, in this order; each fails with one line for a person.

  /// A world file: every robot of it becomes a set of devices. Or a configuration file, which names the
  /// devices.
  Result<void> read_world(const std::string& path, scene::NamedBy by = scene::NamedBy::kPerson);
  Result<void> read_cfg(const std::string& path);
  /// The configuration file that was read, if it has no world to serve: then it is for serve_devices().
  const scene::CfgFile* file_without_world() const;
  /// A saved run: its world goes on where it was saved, with its seed.
  Result<void> read_saved(const std::string& path);
  /// All files that were read so far, which none may write over.
  std::vector<std::string> files_read() const;
  /// Lets clients save the world into a file; before run(). Fails where nobody can write it.
  Result<void> let_clients_save(const std::string& file);
  /// A recorded run is shown in place of one that is made: no devices, and a page that changes nothing. The
  /// recording outlives the service.
  void play(OpenedRecording& recording) { recording_ = &recording; }
  /// Saves the state once the run has come to a time, or the world where the file's name says so; before
  /// run(). Fails where a controller, which make_devices() must have made, has a state that cannot be saved.
  Result<void> save_at(const SaveAt& save);
  /// Records the run into a file; before run(), after all else that changes the world. `only` is what of it
  /// (record::Selection), or empty. Fails where nobody can write the file.
  Result<void> record(const std::string& file, const std::string& only);
  /// After run(). False: something was not saved or recorded; the log says what.
  bool all_saved() const { return saves_.empty() && saving_works_; }
  /// A scene made in memory, in place of a file.
  void take_scene(scene::SceneDesc scene) { scene_ = std::move(scene); }
  /// Opens the ports for Player clients; they are served once run() is called.
  Result<void> open_ports();
  /// Makes the engine and the devices.
  Result<void> make_devices();
  /// What else is wrong with the file that a step failed for.
  const std::vector<Error>& other_errors() const { return other_errors_; }
  /// The file that says who may open the page. Fails where it is wrong, or nobody could use it.
  Result<void> read_guests();
  /// Opens the web page, if one is wanted.
  Result<void> open_page();
  /// Opens the port for observers, if one is wanted.
  Result<void> open_observers();

  const Serving& serving() const { return serving_; }
  /// Ports for Player clients, the default one first.
  const std::vector<std::uint16_t>& player_ports() const { return player_ports_; }
  /// Of the web page; 0 where there is none.
  std::uint16_t web_port() const { return web_port_; }
  /// "Player clients: ...", "web page: ..." and "observers: ...", one line each.
  std::vector<std::string> places() const;

  /// Until the duration is over, the file says so, or a signal comes. `ended` is called with that signal, or
  /// 0, before the clients are disconnected.
  Outcome run(const std::function<void(int signal)>& ended = {});
  /// Ends run(). Any thread.
  void stop() { simulation().stop(); }

  drivers::Simulation& simulation() { return *site_->simulation(); }
  const server::Server& server() const { return *server_; }

 private:
  server::Server& the_server() override { return *server_; }
  net::IoLoop& the_loop() override { return loop_; }
  Result<std::unique_ptr<drivers::Simulation>> open_world(const std::string& path) override;

  Result<void> open_playback();
  Result<void> add_robots();
  Result<void> make_drivers();
  void catch_signals();
  void show_progress();
  void save_due(const world::World& world);
  Result<void> save(const world::World& world, const std::string& file) const;

  Serving serving_;
  Running running_;
  QuitTime quit_time_;
  Warn warn_;
  EngineMaker engine_maker_;
  std::vector<Error> other_errors_;
  controllers::Libraries::Use libraries_ = controllers::Libraries::Use::kLoad;

  // In order of construction; what is below uses what is above.
  std::optional<scene::CfgFile> cfg_;
  scene::SourceFiles sources_;           // of scene_
  std::vector<std::string> files_read_;  // besides those
  std::optional<world::SavedRun> saved_;
  OpenedRecording* recording_ = nullptr;
  std::vector<SaveAt> saves_;  // not done yet
  bool saving_works_ = true;
  WorldSaver world_saver_;
  std::unique_ptr<record::RecordThread> record_file_;
  std::unique_ptr<record::Recorder> recorder_;
  scene::SceneDesc scene_;
  net::IoLoop loop_;
  net::IoLoop
      web_loop_;  // of its own, so that drawing a large world for many viewers delays no Player client
  net::IoLoop signal_loop_;                               // of its own: a signal waits for no client
  std::unique_ptr<drivers::Site> site_;                   // with the simulation
  std::unique_ptr<Playback> playback_;                    // of the recording
  std::vector<std::unique_ptr<device::Driver>> drivers_;  // of the configuration file
  std::unique_ptr<drivers::AutoDevices> robots_;          // without one
  std::unique_ptr<server::Server> server_;
  web_server::GuestBook guests_;
  std::unique_ptr<web_server::WebServer> web_;
  std::unique_ptr<observers::ObserverServer> observers_;
  std::unique_ptr<net::Timer> progress_;

  std::vector<std::uint16_t> player_ports_;
  std::uint16_t web_port_ = 0, observer_port_ = 0;
  std::atomic<int> signal_ = 0;
};

}  // namespace playhouse::app
