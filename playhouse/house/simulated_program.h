#pragma once

/// SimulatedProgram: what one process of Playhouse is, on a simulated network and clock: a server, a simulated world, its
/// devices and drivers, a recording, pages and observers. Destroying it without end() kills it: what its recording
/// had not written is lost. Thread: one for the whole house.

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/bridge/simulated/auto_devices.h"
#include "playhouse/bridge/simulated/simulated_world.h"
#include "playhouse/device_server/server_host.h"
#include "playhouse/drivers/site.h"
#include "playhouse/house/failing_disk.h"
#include "playhouse/house/process.h"
#include "playhouse/house/recorder_link.h"
#include "playhouse/house/setting.h"
#include "playhouse/house/shown_worlds.h"
#include "playhouse/house/simulated_nodes.h"
#include "playhouse/observers/observer_server.h"
#include "playhouse/record/recorder.h"
#include "playhouse/run/simulation.h"
#include "playhouse/server/server.h"
#include "playhouse/web_server/web_server.h"
#include "playhouse/world/saving/saved_run.h"

namespace playhouse::house {

inline constexpr std::uint16_t kPlayerPort = 6665, kObserverPort = 7000, kWebPort = 8080;
inline constexpr const char* kObserverHost = "10.0.0.1";

/// A saved run, and the hash of its world.
struct Saved {
  std::vector<std::byte> file;
  std::uint64_t hash = 0;
};

class SimulatedProgram final : private device_server::ServerHost {
 public:
  struct ProgramOptions {
    Setting setting;
    std::uint64_t seed = 1;
    std::string recording;                        // file
    std::optional<std::size_t> room;              // bytes of the disk for it; none: enough
    bool loses_change = false;                    // one, on its way to the recording
    SimulatedNodes* nodes = nullptr;              // of its cluster; null: it computes alone
    const Saved* saved = nullptr;                 // where it goes on; null: at the beginning
    std::function<bool(double until)> wait = {};  // of the run
    std::function<void()> ticked = {};
    std::function<void(const world::World&)> reloaded = {};  // by a rewind
    std::function<void(std::string)> wrong = {};             // an invariant is broken
  };
  SimulatedProgram(net::Network& network, ProgramOptions options);
  ~SimulatedProgram() override;

  run::Simulation& simulation() { return *drivers::simulation_of(site_); }
  const world::World& world() { return simulation().world(); }
  /// What viewers were shown.
  const ShownWorlds& shown() const { return *shown_; }
  /// Of each turn: what is due of the recording is written.
  void write_recording();
  Saved save();
  /// Invariants of every turn.
  void look();
  /// After the run: nothing is kept of who has gone, and the recording is whole.
  void end();
  /// The recording does what the run did. After end(), or after kill().
  void kill();
  void run_again();
  std::size_t checks() const { return checks_; }
  bool disk_failed() const { return disk_failed_; }

 private:
  void begin_recording();
  void make_drivers();
  void open_feed();
  void open_observers();
  void open_page_server();
  void wrong(std::string what) { options_.wrong(std::move(what)); }

  // device_server::ServerHost
  server::Server& the_server() override { return server_; }
  net::Network& the_network() override { return network_; }
  bool has_threads() const override { return false; }
  Result<std::unique_ptr<drivers::SiteWorld>> open_world(const std::string& path,
                                                         drivers::Site& site) override;
  std::unique_ptr<run::Simulation> make_simulation();

  Process network_;
  const ProgramOptions options_;
  config::SourceFiles sources_;
  scene::SceneDesc scene_;
  drivers::Site site_;
  std::vector<std::unique_ptr<device::Driver>> drivers_;
  std::unique_ptr<drivers::AutoDevices> robots_;
  server::Server server_;  // stops devices in the end
  Disk disk_;
  std::unique_ptr<record::RecordThread> record_thread_;
  std::unique_ptr<record::Recorder> recorder_;
  std::shared_ptr<RecorderLink> recorder_link_;
  std::unique_ptr<replicate::SnapshotFeed> feed_;
  std::unique_ptr<observers::ObserverServer> observers_;
  std::optional<ShownWorlds> shown_;
  std::unique_ptr<web_server::WebServer> web_;
  bool killed_ = false, disk_failed_ = false;
  std::size_t checks_ = 0;
};

}  // namespace playhouse::house
