#include "playhouse/house/simulated_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "playhouse/app/world_opener.h"
#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"
#include "playhouse/bridge/all_drivers.h"
#include "playhouse/bridge/simulated/joining.h"
#include "playhouse/config/cfg.h"
#include "playhouse/record/mcap/mcap_writer.h"
#include "playhouse/record/rerun.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::house {
namespace {

constexpr double kRecordedAfter = 1;  // s; what a killed program has not recorded is not older
constexpr const char* kFile = "house.world";

constexpr const char* kWorld = R"(
interval_sim {}
model( name "walls" size [12 12 1] boundary 1 noblocks 1 )
define robot position( size [0.4 0.4 0.3] ctrl "wander"
  ranger( sensor( range [0 6] fov 180 samples 9 noise [0.01 0.01 0] ) )
  ranger( sensor( pose [0.1 0 0 0] range [0 3] samples 1 ) sensor( pose [0 0.1 0 90] range [0 3] samples 1 ) )
  fiducial( ) )
robot_types [ "robot" ]
robot( name "r0" pose [-3 -3 0 10] ) robot( name "r1" pose [3 3 0 200] )
position( name "r2" pose [0 0 0 0] size [0.4 0.4 0.3] ranger( sensor( range [0 6] fov 90 samples 5 ) ) )
)";

constexpr const char* kPerson = R"(
position( name "ada" pose [2 -3 0 0] size [0.3 0.5 1.75] drive "walk" velocity_bounds [-0.8 2 -0.8 0.8 0 0 -180 180] )
)";

/// The robot r0 knows where it is, and finds its way past what is not on the map. Far from the indices of robots
/// that come.
constexpr const char* kDrivers = R"(
driver ( name "stage" provides ["map:40000"] model "walls" )
driver ( name "amcl" provides ["localize:0" "position2d:40000"]
  requires ["odometry:::position2d:0" "laser:0" "laser:::map:40000"] pf_min_samples 20 pf_max_samples 100 )
driver ( name "vfh" provides ["position2d:40001"] requires ["position2d:0" "laser:0"] )
driver ( name "wavefront" provides ["planner:0"]
  requires ["output:::position2d:40001" "input:::position2d:40000" "map:40000" "laser:0"] )
)";

class Ticked final : public run::Follower {
 public:
  explicit Ticked(std::function<void()> ticked) : ticked_(std::move(ticked)) {}
  void ticked(const world::World&) override { ticked_(); }

 private:
  const std::function<void()> ticked_;
};

config::SourceFiles sources_of(const Setting& setting) {
  config::SourceFiles sources;
  sources.path = kFile;
  std::string& text = sources.files[kFile];
  text = fmt::format(fmt::runtime(kWorld), 1000 * setting.interval);
  if (setting.has_people) text += kPerson;
  return sources;
}

std::unique_ptr<world::Engine> engine_of(const scene::SceneDesc& scene, const Setting& setting,
                                         std::uint64_t seed) {
  const app::Running running{.engine = setting.is_arena ? "arena" : "stage", .seed = seed};
  return *app::make_engine(scene, running, controllers::Libraries::LibraryUse::kLoad,
                           [](const std::string&) {});
}

}  // namespace

SimulatedProgram::SimulatedProgram(net::Network& network, ProgramOptions options)
    : network_(network),
      options_(std::move(options)),
      sources_(sources_of(options_.setting)),
      scene_(*app::scene_of(sources_, std::nullopt, nullptr)),
      site_(*this, kPlayerPort),
      server_(network_),
      disk_{options_.room} {
  PLAYHOUSE_ASSERT(server_.listen(kPlayerPort).ok());
  PLAYHOUSE_ASSERT(site_.open_world(kFile).ok());
  site_.data_flow().pass_to(server_);
  robots_ = std::make_unique<drivers::AutoDevices>(site_, kPlayerPort);
  PLAYHOUSE_ASSERT(robots_->add_all().ok());
  const Setting& setting = options_.setting;
  if (setting.has_drivers) make_drivers();
  if (setting.has_recording) begin_recording();
  open_feed();
  if (setting.has_observers) open_observers();
  if (setting.has_pages) open_page_server();
  simulation().follow(run::on_event([this](const world::World& world, const world::Event& event) {
    if (event.kind == world::Event::EventKind::kReload) options_.reloaded(world);
  }));
  simulation().follow(std::make_shared<Ticked>(options_.ticked));
  simulation().requests().record(true);
}

SimulatedProgram::~SimulatedProgram() {
  kill();
  simulation().discard();
}

Result<std::unique_ptr<drivers::SiteWorld>> SimulatedProgram::open_world(const std::string&,
                                                                         drivers::Site& site) {
  return drivers::simulated_world(site, make_simulation());
}

std::unique_ptr<run::Simulation> SimulatedProgram::make_simulation() {
  run::Simulation::SimulationOptions options{.clock = [this] { return network_.now(); },
                                             .wait = options_.wait};
  std::unique_ptr<world::Engine> engine = engine_of(scene_, options_.setting, options_.seed);
  if (options_.saved != nullptr) {
    const Result<world::SavedRun> saved = world::decode_saved_run(options_.saved->file);
    PLAYHOUSE_ASSERT(saved.ok());
    if (const Result<void> loaded = world::load_state(engine->world(), saved->state); !loaded)
      wrong("a saved run " + loaded.error().text);
    if (engine->world().hash() != options_.saved->hash) wrong("a saved run is another world when it goes on");
  }
  if (options_.nodes == nullptr)
    return std::make_unique<run::Simulation>(std::move(engine), std::move(options));
  auto head =
      options_.nodes->head(std::move(engine), sources_, [this](const std::string& why) { wrong(why); });
  cluster::Head& follower = *head;
  auto simulation = std::make_unique<run::Simulation>(std::move(head), std::move(options));
  simulation->follow(follower);
  return simulation;
}

void SimulatedProgram::make_drivers() {
  config::DiskFiles files;
  auto made = drivers::all_drivers().make(*config::load_cfg_text(kDrivers, "house.cfg", files), site_);
  PLAYHOUSE_ASSERT(made.ok());
  drivers_ = std::move(*made);
}

void SimulatedProgram::begin_recording() {
  const auto clock = [this] { return network_.now(); };
  auto sink = std::make_unique<FailingDisk>(*record::McapWriter::create(options_.recording, "ros2"), disk_);
  record_thread_ = std::make_unique<record::RecordThread>(std::move(sink), clock);
  recorder_ =
      std::make_unique<record::Recorder>(*record_thread_, record::Selection(), simulation().requests());
  recorder_link_ = std::make_shared<RecorderLink>(*recorder_, clock, options_.loses_change);
  simulation().follow(recorder_link_);
  PLAYHOUSE_ASSERT(recorder_->begin(world(), sources_).ok());
}

void SimulatedProgram::open_feed() {
  feed_ = std::make_unique<replicate::SnapshotFeed>(world(), replicate::DeviceNames(),
                                                    [this] { return network_.now(); });
  shown_.emplace(world());
  simulation().follow(run::on_show([this](const world::World& world, const world::Pace& pace) {
    if (!feed_->wants_show()) return;
    feed_->show(world, pace);
    shown_->show(world, pace);
  }));
}

void SimulatedProgram::open_observers() {
  observers::ObserverOptions served;
  served.bind = kObserverHost;
  served.port = kObserverPort;
  observers_ = std::make_unique<observers::ObserverServer>(network_, std::move(served), *feed_);
  PLAYHOUSE_ASSERT(observers_->listen().ok());
}

void SimulatedProgram::open_page_server() {
  web_server::WebOptions options{.port = kWebPort,
                                 .host_name = "house",
                                 .physics_shapes = [this] { return simulation().engine().physics_shapes(); },
                                 .place_of_body = drivers::free_place,
                                 .shares = simulation().shares()};
  web_ = std::make_unique<web_server::WebServer>(network_, std::move(options), simulation().requests(),
                                                 world(), *feed_);
  PLAYHOUSE_ASSERT(web_->listen().ok());
}

void SimulatedProgram::write_recording() {
  if (record_thread_ != nullptr) record_thread_->write_due();
}

Saved SimulatedProgram::save() {
  world::SavedRun run{sources_, world().engine, world().seed(), {}};
  if (const Result<void> saved = world::save_state(world(), run.state); !saved)
    wrong("the run is not saved: " + saved.error().text);
  return {world::encode(run), world().hash()};
}

void SimulatedProgram::look() {
  const server::ServerStatus status = server_.status();
  if (status.output_bytes > limits::kOutputBytes) wrong("the server keeps more than its limit for clients");
  if (status.devices != site_.device_count())
    wrong(fmt::format("the server has {} devices and the site {}", status.devices, site_.device_count()));
}

void SimulatedProgram::end() {
  if (server_.status().output_bytes > 0) wrong("the server keeps bytes of clients that have gone");
  if (record_thread_ == nullptr) return;
  recorder_->end(world());
  if (!record_thread_->finish() && !disk_.room) wrong("the recording was not written");
}

void SimulatedProgram::kill() {
  disk_.killed = true;
}

void SimulatedProgram::run_again() {
  if (record_thread_ == nullptr) return;
  const bool is_whole = !disk_.killed && record_thread_->finish();
  disk_failed_ = disk_.room && !record_thread_->finish();
  const double written_until = network_.now() - kRecordedAfter;
  const std::size_t changes = recorder_link_->changes_until(written_until);
  const Result<std::unique_ptr<record::ByteSource>> source = record::open_source(options_.recording);
  if (!source) return wrong(source.error().line());
  const Result<record::Recording> recording = record::read_recording(**source);
  if (!recording) {
    if (is_whole || (!disk_.room && changes > 0)) wrong("the recording " + recording.error().text);
    return;
  }
  const auto recorded = static_cast<std::size_t>(std::ranges::count_if(
      recording->items, [](const record::Recording::ChangeOrCheck& item) { return !item.change.empty(); }));
  if (!disk_.room && recorded < changes)
    return wrong(fmt::format("the recording of a killed program has {} changes of {}", recorded, changes));
  record::Rerun rerun(*recording, engine_of(scene_, options_.setting, options_.seed));
  if (const Result<void> begun = rerun.begin(); !begun) return wrong(begun.error().line());
  while (!rerun.at_end() && !rerun.differs()) rerun.step();
  checks_ = rerun.checks();
  if (rerun.differs()) return wrong("run again, " + *rerun.differs());
  if (is_whole && rerun.world().hash() != world().hash()) wrong("run again, the world is another one");
}

}  // namespace playhouse::house
