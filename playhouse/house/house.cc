#include "playhouse/house/house.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "playhouse/app/world_opener.h"
#include "playhouse/base/limits.h"
#include "playhouse/drivers/registry.h"
#include "playhouse/drivers/simulated/auto_devices.h"
#include "playhouse/drivers/simulated/joining.h"
#include "playhouse/drivers/site.h"
#include "playhouse/house/client.h"
#include "playhouse/house/failing_disk.h"
#include "playhouse/house/recorder_link.h"
#include "playhouse/house/shown_worlds.h"
#include "playhouse/house/simulated_viewer.h"
#include "playhouse/observers/observer_client.h"
#include "playhouse/observers/observer_server.h"
#include "playhouse/record/mcap/mcap_writer.h"
#include "playhouse/record/recorder.h"
#include "playhouse/record/rerun.h"
#include "playhouse/scene/cfg.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/server/server.h"
#include "playhouse/web_server/web_server.h"
#include "playhouse/world/population/population.h"

namespace playhouse::house {
namespace {

constexpr std::uint16_t kPort = 6665, kObserverPort = 7000, kWebPort = 8080;
constexpr const char* kObserverHost = "10.0.0.1";
constexpr std::size_t kClients = 6, kPages = 3, kSpawned = 6;
constexpr double kTurn = 0.1;          // s between two turns of people and clients
constexpr double kSlice = 0.02;        // s of the network, while the tick sleeps
constexpr double kTickSeconds = 1e-3;  // that a tick takes
constexpr double kPatience = 5;        // s until a client has all its answers
constexpr double kSettling = 3;        // s until nothing is on its way that was before
/// A page assumes that the program hangs if it hears nothing for longer. [s]
constexpr double kSignOfLife = 1.5;
constexpr std::uint64_t kRewindTicks = 200;

constexpr const char* kWorld = R"(
interval_sim 100
model( name "walls" size [12 12 1] boundary 1 noblocks 1 )
define robot position( size [0.4 0.4 0.3] ctrl "wander"
  ranger( sensor( range [0 6] fov 180 samples 9 noise [0.01 0.01 0] ) )
  ranger( sensor( pose [0.1 0 0 0] range [0 3] samples 1 ) sensor( pose [0 0.1 0 90] range [0 3] samples 1 ) )
  fiducial( ) )
robot( name "r0" pose [-3 -3 0 10] ) robot( name "r1" pose [3 3 0 200] )
position( name "ada" pose [2 -3 0 0] size [0.3 0.5 1.75] drive "walk" velocity_bounds [-0.8 2 -0.8 0.8 0 0 -180 180] )
position( name "r2" pose [0 0 0 0] size [0.4 0.4 0.3] ranger( sensor( range [0 6] fov 90 samples 5 ) ) )
)";

/// The robot r0 knows where it is, and finds its way past what is not on the map. Far from the indices of robots
/// that come.
constexpr const char* kDrivers = R"(
driver ( name "stage" provides ["map:40000"] model "walls" )
driver ( name "amcl" provides ["localize:0" "position2d:40000"]
  requires ["odometry:::position2d:0" "laser:0" "laser:::map:40000"] pf_min_samples 20 pf_max_samples 100 )
driver ( name "vfh" provides ["position2d:40001"] requires ["position2d:0" "laser:0"] )
driver ( name "wavefront" provides ["planner:0"]
  requires ["output:::position2d:40001" "input:::position2d:40000" "map:40000"] )
)";

/// Lets time pass in each tick, so that it does even in a run that waits for nobody.
class TickTime final : public run::Follower {
 public:
  explicit TickTime(std::function<void()> pass) : pass_(std::move(pass)) {}
  void ticked(const world::World&) override { pass_(); }

 private:
  const std::function<void()> pass_;
};

class House final : private drivers::Host {
 public:
  House(const Options& options, const std::string& folder);
  ~House() override {
    clients_.clear();
    pages_.clear();
    site_.simulation()->discard();
  }
  Report run();

 private:
  std::uint32_t draw(std::uint32_t below) { return static_cast<std::uint32_t>(random_() % below); }
  run::Simulation& simulation() { return *site_.simulation(); }
  const world::World& world() { return simulation().world(); }

  void begin_recording(const std::string& folder);
  void make_drivers();
  void open_feed();
  void open_observers();
  void open_page_server();
  void follow_rewinds();
  void change_world();
  void rewind();
  void change_clients();
  void change_pages();
  void end_page(SimulatedViewer& page);
  void change_network();
  void excuse_until(double time);
  bool sleep(double until);
  void pass(double seconds);
  void turn();
  void begin_to_end();
  void look();
  void end_clients();
  void expect_all_answered(const std::vector<std::unique_ptr<SimulatedClient>>& clients);
  void run_again();
  void wrong(std::string what);

  // drivers::Host
  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver) override {
    return server_.add_device(address, driver);
  }
  void retire_device(device::DeviceId device) override { server_.retire_device(device); }
  Result<void> hold(device::DeviceId device, device::Driver* holder) override {
    return server_.hold(device, holder);
  }
  void release(device::DeviceId device, device::Driver* holder) override { server_.release(device, holder); }
  void post(std::function<void()> task) override { network_.post(std::move(task)); }
  bool has_threads() const override { return false; }
  net::Network& network() override { return network_; }
  Result<std::unique_ptr<run::Simulation>> open_world(const std::string&) override;

  const Options options_;
  std::mt19937_64 random_;
  Report report_;
  scene::SourceFiles sources_;
  scene::SceneDesc scene_;
  net::SimulatedNetwork network_;
  drivers::Site site_;
  std::vector<std::unique_ptr<device::Driver>> drivers_;
  std::unique_ptr<drivers::AutoDevices> robots_;
  server::Server server_;  // stops devices in the end
  std::string file_;
  std::unique_ptr<record::RecordThread> record_thread_;
  std::unique_ptr<record::Recorder> recorder_;
  std::unique_ptr<replicate::SnapshotFeed> feed_;
  std::unique_ptr<observers::ObserverServer> observers_;
  std::unique_ptr<observers::ObserverClient> observer_;
  std::optional<ShownWorlds> shown_;
  std::unique_ptr<web_server::WebServer> web_;
  std::vector<std::unique_ptr<SimulatedViewer>> pages_;
  std::vector<std::unique_ptr<SimulatedClient>> clients_, leaving_;
  std::uint64_t turns_ = 0;
  double next_turn_ = kTurn, leaving_until_ = 0, whole_at_ = 0;  // s; the network carries all
  std::optional<double> ends_;                                   // s; all clients leave
  std::vector<world::ModelId> spawned_;
  std::optional<std::uint64_t> rewound_to_;
  bool paused_ = false;
  Hash digest_;
};

scene::SourceFiles sources_of_world() {
  scene::SourceFiles sources;
  sources.path = "house.world";
  sources.files["house.world"] = kWorld;
  return sources;
}

app::Running running(std::uint64_t seed) {
  return {.engine = seed % 4 == 0 ? "arena" : "stage", .seed = seed};
}

std::unique_ptr<world::Engine> engine_of(const scene::SceneDesc& scene, std::uint64_t seed) {
  return *app::make_engine(scene, running(seed), controllers::Libraries::Use::kLoad,
                           [](const std::string&) {});
}

House::House(const Options& options, const std::string& folder)
    : options_(options),
      random_(options.seed),
      sources_(sources_of_world()),
      scene_(*app::scene_of(sources_, std::nullopt, nullptr)),
      network_(options.seed),
      site_(*this, kPort),
      server_(network_) {
  PLAYHOUSE_ASSERT(server_.listen(kPort).ok());
  PLAYHOUSE_ASSERT(site_.open_world("house.world").ok());
  site_.data_flow().pass_to(server_);
  robots_ = std::make_unique<drivers::AutoDevices>(site_, kPort);
  PLAYHOUSE_ASSERT(robots_->add_all().ok());
  make_drivers();
  begin_recording(folder);
  open_feed();
  open_observers();
  open_page_server();
  follow_rewinds();
  simulation().follow(std::make_shared<TickTime>([this] { pass(kTickSeconds); }));
  simulation().requests().record(true);
}

void House::make_drivers() {
  scene::DiskFiles files;
  auto made = drivers::make_drivers(*scene::load_cfg_text(kDrivers, "house.cfg", files), site_);
  PLAYHOUSE_ASSERT(made.ok());
  drivers_ = std::move(*made);
}

void House::open_observers() {
  network_.datagrams = {
      .loss = draw(50) / 100.0, .duplication = 0.1, .delay = 0.01, .jitter = draw(20) / 100.0};
  observers::ObserverOptions served;
  served.bind = kObserverHost;
  served.port = kObserverPort;
  observers_ = std::make_unique<observers::ObserverServer>(network_, std::move(served), *feed_);
  PLAYHOUSE_ASSERT(observers_->listen().ok());
}

void House::open_page_server() {
  network_.connections = {.delay = draw(20) / 1000.0, .jitter = draw(50) / 1000.0};
  web_server::WebOptions options{.port = kWebPort,
                                 .host_name = "house",
                                 .physics_shapes = [this] { return simulation().engine().physics_shapes(); },
                                 .place_of_body = drivers::free_place,
                                 .shares = simulation().shares()};
  web_ = std::make_unique<web_server::WebServer>(network_, std::move(options), simulation().requests(),
                                                 world(), *feed_);
  PLAYHOUSE_ASSERT(web_->listen().ok());
}

void House::open_feed() {
  feed_ = std::make_unique<replicate::SnapshotFeed>(world(), replicate::DeviceNames(),
                                                    [this] { return network_.now(); });
  shown_.emplace(world());
  simulation().follow(run::on_show([this](const world::World& world, const world::Pace& pace) {
    if (!feed_->wants_show()) return;
    feed_->show(world, pace);
    shown_->show(world, pace);
  }));
}

/// A rewind arrives at the tick that was asked for.
void House::follow_rewinds() {
  simulation().follow(run::on_event([this](const world::World& world, const world::Event& event) {
    if (event.kind != world::Event::Kind::kReload) return;
    excuse_until(network_.now() + kSettling);
    if (!rewound_to_) return;
    if (world.tick() != *rewound_to_)
      wrong(fmt::format("the run went to tick {} instead of {}", world.tick(), *rewound_to_));
    rewound_to_.reset();
    std::erase_if(spawned_, [&](world::ModelId model) { return !world.row(model); });
  }));
}

Result<std::unique_ptr<run::Simulation>> House::open_world(const std::string&) {
  return std::make_unique<run::Simulation>(
      engine_of(scene_, options_.seed),
      run::Simulation::Options{.clock = [this] { return network_.now(); },
                               .wait = [this](double until) { return sleep(until); }});
}

void House::begin_recording(const std::string& folder) {
  file_ = fmt::format("{}/house-{}.mcap", folder, options_.seed);
  std::unique_ptr<record::RecordSink> sink = *record::McapWriter::create(file_, "ros2");
  report_.disk_failed = options_.seed % 3 == 0;
  if (report_.disk_failed) sink = std::make_unique<FailingDisk>(std::move(sink), 100000 + draw(1 << 20));
  record_thread_ = std::make_unique<record::RecordThread>(std::move(sink));
  recorder_ =
      std::make_unique<record::Recorder>(*record_thread_, record::Selection(), simulation().requests());
  simulation().follow(
      std::make_shared<RecorderLink>(*recorder_, options_.sabotage == Sabotage::kLosesChange));
  PLAYHOUSE_ASSERT(recorder_->begin(world(), sources_).ok());
}

void House::wrong(std::string what) {
  if (!report_.fault)
    report_.fault = fmt::format("at {:.1f} s, tick {}: {}", network_.now(), world().tick(), what);
}

/// What people do: robots come, go and are carried; the run is paused, and taken back.
void House::change_world() {
  run::Requests& requests = simulation().requests();
  const geom::Pose place{draw(100) / 10.0 - 5, draw(100) / 10.0 - 5, 0, draw(60) / 10.0};
  const std::uint32_t what = draw(100);
  if (what < 3 && spawned_.size() < kSpawned) {
    requests.post([this, place](world::Journal& journal) {
      const Result<world::ModelId> copy =
          journal.spawn_copy(journal.world().id(journal.world().find("r1")), place);
      if (!copy) return;
      spawned_.push_back(*copy);
      ++report_.spawned;
    });
  } else if (what < 5 && !spawned_.empty()) {
    const world::ModelId model = spawned_[draw(static_cast<std::uint32_t>(spawned_.size()))];
    std::erase(spawned_, model);
    requests.post([model](world::Journal& journal) { static_cast<void>(journal.despawn(model)); });
  } else if (what < 7) {
    requests.post([place](world::Journal& journal) {
      journal.apply(world::changes::Place{journal.world().id(journal.world().find("r0")), place});
    });
  } else if (what < 9) {
    paused_ = !paused_;
    paused_ ? requests.pause() : requests.resume();
  } else if (what == 9) {
    rewind();
  }
}

void House::rewind() {
  const std::vector<std::uint64_t> kept = simulation().requests().timeline()->ticks;
  if (kept.empty() || rewound_to_) return;  // or one is under way
  const std::uint64_t now = world().tick();
  const std::uint64_t to = std::max(kept.front(), now - std::min<std::uint64_t>(now, draw(kRewindTicks)));
  rewound_to_ = to;
  simulation().requests().rewind(to);
  ++report_.rewinds;
}

void House::change_clients() {
  if (clients_.size() < kClients && draw(5) == 0) {
    const auto manner = static_cast<Manner>(draw(kManners));
    clients_.push_back(std::make_unique<SimulatedClient>(network_, kPort, manner, random_()));
    clients_.back()->excuse_until(whole_at_ + kSettling);
    ++report_.clients;
    if (options_.sabotage == Sabotage::kLosesAnswer && report_.clients >= kClients)
      for (const auto& client : clients_) client->lose_an_answer();
    if (options_.sabotage == Sabotage::kLosesTick && report_.clients >= kClients)
      for (const auto& client : clients_) client->lose_a_tick();
  }
  if (leaving_.empty() && draw(100) == 0) {
    leaving_ = std::exchange(clients_, {});
    for (const auto& client : leaving_) client->finish();
    leaving_until_ = std::max(network_.now(), whole_at_) + kPatience;
  }
  if (!leaving_.empty() && network_.now() >= leaving_until_) end_clients();
  std::erase_if(clients_, [](const auto& client) { return client->is_over(); });
  if (draw(200) == 0) observer_.reset();
  if (observer_ == nullptr && draw(50) == 0)
    observer_ = *observers::ObserverClient::open(
        network_, *net::parse_endpoint(kObserverHost, kObserverPort), {0, 30}, "", [] {}, "10.0.0.2");
}

void House::change_pages() {
  if (pages_.size() < kPages && draw(20) == 0) {
    const std::string address = fmt::format("10.1.{}.{}", report_.pages / 200, 1 + report_.pages % 200);
    const auto manner = static_cast<PageManner>(draw(kPageManners));
    pages_.push_back(
        std::make_unique<SimulatedViewer>(network_, kWebPort, address, *shown_, manner, random_()));
    pages_.back()->excuse_until(whole_at_);
    if (options_.sabotage == Sabotage::kLosesFrame && report_.pages >= kPages) pages_.back()->lose_changes();
    ++report_.pages;
  }
  if (!pages_.empty() && draw(300) == 0) pages_[draw(static_cast<std::uint32_t>(pages_.size()))]->leave();
  std::erase_if(pages_, [this](const auto& page) {
    if (!page->is_over()) return false;
    end_page(*page);
    return true;
  });
}

void House::end_page(SimulatedViewer& page) {
  report_.frames += page.whole_frames();
  digest_.add(page.digest());
  page.leave();
}

/// Now and then nothing arrives for some seconds.
void House::change_network() {
  if (draw(600) != 0 || network_.is_cut()) return;
  const double seconds = draw(50) / 10.0;
  network_.cut(seconds);
  ++report_.cuts;
  whole_at_ = network_.now() + seconds;
  leaving_until_ += seconds;
  excuse_until(whole_at_ + kSettling);
}

/// Of data that are missing, and of silence.
void House::excuse_until(double time) {
  for (auto* clients : {&clients_, &leaving_})
    for (const auto& client : *clients) client->excuse_until(time);
  for (const auto& page : pages_) page->excuse_until(time);
}

/// Those that have had the time for all answers.
void House::end_clients() {
  expect_all_answered(leaving_);
  for (const auto& client : leaving_) {
    report_.answers += client->answered();
    digest_.add(client->digest());
    client->leave();
  }
  leaving_.clear();
}

void House::expect_all_answered(const std::vector<std::unique_ptr<SimulatedClient>>& clients) {
  for (const auto& client : clients) {
    const bool pulls = client->manner() == Manner::kPulls;  // the last request for data may be on its way
    if (!client->is_over() && client->waits_for() > (pulls ? 1u : 0u))
      wrong(fmt::format("{} requests of a client are not answered", client->waits_for()));
  }
}

/// What the tick thread does while it waits: the network goes on, and with it all others.
bool House::sleep(double until) {
  while (network_.now() < until) {
    pass(std::min(until - network_.now(), kSlice));
    if (simulation().requests().is_woken()) return true;
  }
  return false;
}

void House::pass(double seconds) {
  network_.run_for(seconds);
  for (; next_turn_ <= network_.now(); next_turn_ += kTurn) turn();
}

/// Everybody does something.
void House::turn() {
  ++turns_;
  for (auto* clients : {&clients_, &leaving_})
    for (const auto& client : *clients) client->hear(network_.now());
  for (const auto& page : pages_)
    page->hear(kSignOfLife + 4 * (network_.connections.delay + network_.connections.jitter));
  look();
  if (report_.fault || (ends_ && network_.now() >= *ends_ + kPatience)) return simulation().requests().stop();
  if (network_.now() >= options_.seconds) return begin_to_end();
  change_world();
  change_clients();
  change_pages();
  change_network();
  for (const auto& page : pages_) page->act();
  for (auto* clients : {&clients_, &leaving_})
    for (const auto& client : *clients) client->act();
}

/// All clients get their last answers, and leave.
void House::begin_to_end() {
  if (!ends_) {
    simulation().requests().resume();
    for (auto& client : clients_) leaving_.push_back(std::move(client));
    clients_.clear();
    for (const auto& client : leaving_) client->finish();
    for (const auto& page : pages_) end_page(*page);
    pages_.clear();
    ends_ = std::max(network_.now(), whole_at_) + kPatience;
  }
  if (network_.now() >= *ends_) end_clients();
  for (const auto& client : leaving_) client->act();
}

/// Invariants of every tick.
void House::look() {
  const server::ServerStatus status = server_.status();
  if (status.output_bytes > limits::kOutputBytes) wrong("the server keeps more than its limit for clients");
  if (status.devices != site_.device_count())
    wrong(fmt::format("the server has {} devices and the site {}", status.devices, site_.device_count()));
  for (auto* clients : {&clients_, &leaving_})
    for (const auto& client : *clients)
      if (client->fault()) wrong(*client->fault());
  for (const auto& page : pages_)
    if (page->fault()) wrong(*page->fault());
  if (turns_ % 10 == 0) digest_.add(world().hash());
}

/// The recording does what the run did, up to the disk's end.
void House::run_again() {
  recorder_->end(world());
  const bool written = record_thread_->finish();
  if (!written && !report_.disk_failed) return wrong("the recording was not written");
  const Result<std::unique_ptr<record::ByteSource>> source = record::open_source(file_);
  if (!source) return wrong(source.error().line());
  const Result<record::Recording> recording = record::read_recording(**source);
  report_.disk_failed = !written;
  if (!recording) return written ? wrong("the recording " + recording.error().text) : void();
  record::Rerun rerun(*recording, engine_of(scene_, options_.seed));
  if (const Result<void> begun = rerun.begin(); !begun) return wrong(begun.error().line());
  while (!rerun.at_end() && !rerun.differs()) rerun.step();
  report_.checks = rerun.checks();
  if (rerun.differs()) return wrong("run again, " + *rerun.differs());
  if (written && rerun.world().hash() != world().hash()) wrong("run again, the world is another one");
}

Report House::run() {
  simulation().run();
  network_.run_for(kPatience);
  if (server_.status().output_bytes > 0) wrong("the server keeps bytes of clients that have gone");
  if (!report_.fault) run_again();
  report_.simulated = network_.now();
  digest_.add(world().hash());
  report_.digest = digest_.value();
  return report_;
}

}  // namespace

Report run_house(const Options& options, const std::string& folder) {
  return House(options, folder).run();
}

}  // namespace playhouse::house
