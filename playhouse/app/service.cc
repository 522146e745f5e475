#include "playhouse/app/service.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <future>
#include <iterator>
#include <set>
#include <span>
#include <system_error>
#include <thread>
#include <utility>

#include "playhouse/app/device_service.h"
#include "playhouse/app/free_ports.h"
#include "playhouse/app/guest_list.h"
#include "playhouse/app/interrupt.h"
#include "playhouse/app/kept_files.h"
#include "playhouse/app/tls_files.h"
#include "playhouse/app/whole_file.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log_at.h"
#include "playhouse/base/log_output.h"
#include "playhouse/bodies/blind_rangers.h"
#include "playhouse/bodies/blocked_starts.h"
#include "playhouse/bridge/all_drivers.h"
#include "playhouse/bridge/simulated/joining.h"
#include "playhouse/bridge/simulated/simulated_world.h"
#include "playhouse/device_server/device_server.h"
#include "playhouse/device_server/hangup.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/net/polled/system_polled.h"
#include "playhouse/record/mcap/mcap_writer.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/server/websocket_connection.h"
#include "playhouse/web_server/guests.h"
#include "playhouse/web_server/page_files.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::app {
namespace {

/// Copies of the world what viewers and observers are sent.
class FeedLink final : public run::Follower {
 public:
  explicit FeedLink(replicate::SnapshotFeed& feed) : feed_(feed) {}
  std::optional<run::Work> work(const world::World& world, const world::Pace& pace) override {
    if (!feed_.wants_show()) return {};
    pace_ = pace;
    return run::Work{.run = [this, &world](std::size_t) { feed_.show(world, pace_); }};
  }

 private:
  replicate::SnapshotFeed& feed_;
  world::Pace pace_;
};

constexpr double kProgressSeconds = 0.5;

bool is_world_file(const std::string& file) {
  return file.ends_with(".world");
}

}  // namespace

Outcome outcome_of(world::Engine& engine, double wall_time) {
  const world::World& world = engine.world();
  Outcome outcome;
  outcome.sim_time = world.time();
  outcome.wall_time = wall_time;
  outcome.real_time_factor = wall_time > 0 ? world.time() / wall_time : 0;
  outcome.ticks = world.tick();
  outcome.robots = count_robots(world);
  outcome.rays = engine.rays();
  outcome.hash = world.hash();
  outcome.sensed_hash = world.sensed_hash();
  return outcome;
}

std::string Outcome::json() const {
  return fmt::format(
      R"({{"sim_time":{},"wall_time":{:.6f},"real_time_factor":{:.3f},"ticks":{},"robots":{},"rays":{},"hash":"{:016x}","sensed_hash":"{:016x}"}})",
      sim_time, wall_time, real_time_factor, ticks, robots, rays, hash, sensed_hash);
}

Service::Service(Serving serving, Running running, QuitTime quit_time)
    : serving_(std::move(serving)),
      running_(running),
      quit_time_(quit_time),
      warn_(&warn),
      server_(std::make_unique<server::Server>(loop_, server_options(serving_))) {
  server_->set_clock([this] { return simulation().time(); });
}

Service::~Service() {
  // Pending requests are rejected while the server, which sends the replies, exists.
  if (site_ != nullptr && drivers::simulation_of(*site_) != nullptr)
    drivers::simulation_of(*site_)->discard();
  if (site_ != nullptr) end_drivers(*site_, drivers_);
}

Result<void> Service::read_world(const std::string& path, config::NamedBy by) {
  Result<scene::SceneDesc> scene = scene::load_world(path, by, &other_errors_, &sources_);
  if (!scene) return scene.error();
  scene_ = std::move(*scene);
  controllers::describe_for(scene_);
  for (const std::string& warning : scene_.warnings) warn_(warning);
  return {};
}

Result<void> Service::read_saved(const std::string& path) {
  const Result<std::string> bytes = read_file(path, config::NamedBy::kPerson, limits::kSavedRunBytes);
  if (!bytes) return bytes.error();
  Result<world::SavedRun> run = world::decode_saved_run(std::as_bytes(std::span(*bytes)));
  if (!run) return Error{escaped(path), run.error().text};
  saved_ = std::move(*run);
  files_read_.push_back(path);
  sources_ = saved_->sources;
  running_.engine = saved_->engine;
  running_.seed = saved_->seed;
  Result<scene::SceneDesc> scene = scene_of(sources_, path, &other_errors_);
  if (!scene) return Error{escaped(path), scene.error().text};
  scene_ = std::move(*scene);
  return {};
}

libraries::Libraries Service::libraries() const {
  return {.folders = {},
          .allowed = {running_.allowed_libraries.begin(), running_.allowed_libraries.end()},
          .use = libraries_};
}

std::vector<std::string> Service::files_read() const {
  std::vector<std::string> files = names_of(sources_);
  files.insert(files.end(), files_read_.begin(), files_read_.end());
  files.insert(files.end(), running_.allowed_libraries.begin(), running_.allowed_libraries.end());
  if (!serving_.guests.empty()) files.push_back(serving_.guests);
  return files;
}

Result<void> Service::save(const world::World& world, const std::string& file) const {
  world::SavedRun run{sources_, world.engine, world.seed(), {}};
  if (const Result<void> saved = world::save_state(world, run.state); !saved) return saved;
  return write_file(file, world::encode(run));
}

Result<void> Service::let_clients_save(const std::string& file) {
  if (access(config::containing_folder(file).c_str(), W_OK | X_OK) != 0)
    return Error{escaped(file), "cannot be written: " + std::generic_category().message(errno)};
  drivers::model_devices_of(*site_)->save_by(
      [this, file](const world::World& world) { world_saver_.save(world, file); });
  return {};
}

Result<void> Service::save_at(const SaveAt& save) {
  // Reports controllers that cannot be saved now, rather than at the time of the save.
  std::vector<std::byte> ignored;
  const Result<void> saved =
      is_world_file(save.file) ? Result<void>() : world::save_state(simulation().world(), ignored);
  if (!saved) return saved;
  if (saves_.empty())
    simulation().follow(
        run::on_show([this](const world::World& world, const world::Pace&) { save_due(world); }));
  saves_.push_back(save);
  save_due(simulation().world());
  return {};
}

void Service::save_due(const world::World& world) {
  std::erase_if(saves_, [&](const SaveAt& due) {
    if (world.time() < due.seconds) return false;
    if (is_world_file(due.file)) {
      world_saver_.save(world, due.file);
      return true;
    }
    const Result<void> saved = save(world, due.file);
    if (saved) {
      log::info("saved {:.1f} s to {}", world.time(), escaped(due.file));
    } else {
      log::tell(log::Level::kError, saved.error());
      saving_works_ = false;
    }
    return true;
  });
}

Result<void> Service::record(const std::string& file, const std::string& only) {
  Result<record::Selection> selection = only.empty() ? record::Selection() : record::Selection::parse(only);
  if (!selection) return Error{"--record-only", selection.error().text};
  Result<std::unique_ptr<record::McapWriter>> writer = record::McapWriter::create(file, "ros2");
  if (!writer) return writer.error();
  record_file_ = std::make_unique<record::RecordThread>(std::move(*writer));
  recorder_ =
      std::make_unique<record::Recorder>(*record_file_, std::move(*selection), simulation().requests());
  simulation().follow(*recorder_);
  return recorder_->begin(simulation().world(), sources_);
}

Result<void> Service::read_cfg(const std::string& path) {
  Result<config::CfgFile> file = config::load_cfg(path, serving_.port, &other_errors_, scene::is_model_type);
  if (!file) return file.error();
  cfg_ = std::move(*file);
  files_read_.insert(files_read_.end(), cfg_->files.begin(), cfg_->files.end());
  for (const std::string& warning : cfg_->warnings) warn_(warning);
  return {};
}

const config::CfgFile* Service::file_without_world() const {
  return cfg_ && !has_world(*cfg_) ? &*cfg_ : nullptr;
}

/// Without a number (--port 0): a free port before as many free ones as the scene can need, as no interface
/// has more devices than there are models; 0 if there is none. A saved run has what clients brought, too.
/// They are held, so that no other program takes one until it is opened.
std::uint16_t Service::first_of_free_ports() {
  const std::size_t models = scene_.models.size() + (saved_ ? limits::kBroughtModels : 0);
  const std::size_t count = cfg_ || recording_ ? 1 : (models + indices_ - 1) / indices_;
  if (count < 2) return 0;
  held_ports_ = hold_free_ports(loop_, serving_.bind, count);
  return held_ports_.empty() ? 0 : held_ports_.front()->port();
}

Result<std::uint16_t> Service::listen(std::uint16_t port) {
  std::erase_if(held_ports_, [port](const auto& held) { return held->port() == port; });
  return server_->listen(port);
}

Result<void> Service::read_tls() {
  Result<std::shared_ptr<net::TlsIdentity>> identity = read_tls_files(serving_);
  if (!identity) return identity.error();
  tls_ = std::move(*identity);
  loop_.use_tls(tls_);
  web_loop_.use_tls(tls_);
  return {};
}

Result<void> Service::open_ports() {
  if (serving_.port == 0) serving_.port = first_of_free_ports();
  const std::set<std::uint16_t> wanted =
      cfg_ ? device_server::ports_of(*cfg_, serving_.port) : std::set<std::uint16_t>{0};
  const Result<std::uint16_t> opened =
      device_server::open_ports(wanted, serving_.port, serving_.port_option, [this](std::uint16_t port) {
        Result<std::uint16_t> listening = listen(port);
        if (listening) player_ports_.push_back(*listening);
        return listening;
      });
  if (!opened) return opened.error();
  serving_.port = *opened;
  return {};
}

Result<void> Service::open_following_ports() {
  const std::size_t count = robots_ ? robots_->ports() : 1;
  for (std::uint32_t port = serving_.port + 1u; port < serving_.port + count; ++port) {
    const Result<void> opened = open_port(port);
    if (!opened)
      return Error{opened.error().where,
                   fmt::format("{}; the devices of {} robots need {} ports, from {} on; {} takes others",
                               opened.error().text, count_robots(simulation().world()), count, serving_.port,
                               serving_.port_option)};
    player_ports_.push_back(static_cast<std::uint16_t>(port));
  }
  held_ports_.clear();
  return {};
}

/// The io thread never waits for the tick thread, so the tick thread may wait for it.
Result<void> Service::open_port(std::uint32_t port) {
  if (port > kLastPort) return Error{fmt::format("port {}", port), "the last port is 65535"};
  const auto number = static_cast<std::uint16_t>(port);
  const auto opened = std::make_shared<std::promise<Result<std::uint16_t>>>();  // outlives set_value()
  const auto open = [this, opened, number] { opened->set_value(listen(number)); };
  io_runs_ ? loop_.post(open) : open();
  const Result<std::uint16_t> listening = opened->get_future().get();
  if (!listening) return listening.error();
  if (io_runs_) log::say(client_place(shown_host(serving_.bind), number, serving_));
  return {};
}

Result<void> Service::make_devices() {
  drivers::Host& surroundings = *this;  // private base, not accessible to make_unique
  site_ = std::make_unique<drivers::Site>(surroundings, serving_.port);
  site_->data_flow().pass_to(*server_);
  const Result<void> made = recording_ ? open_playback() : cfg_ ? make_drivers() : add_robots();
  if (made && drivers::simulation_of(*site_) != nullptr)
    if (run::LockStep* lock_step = simulation().lock_step()) server_->take_turns(turns_.emplace(*lock_step));
  // Before ports are announced: a reader of those may send a signal at once.
  if (made) catch_signals();
  return made;
}

Result<void> Service::make_drivers() {
  Result<std::vector<std::unique_ptr<device::Driver>>> made = drivers::all_drivers().make(*cfg_, *site_);
  for (const std::string& warning : site_->warnings()) warn_(warning);
  if (!made) return made.error();
  drivers_ = std::move(*made);
  return {};
}

Result<void> Service::open_playback() {
  record::Rerun& rerun = *recording_->rerun;
  if (const Result<void> opened = site_->open_world(recording_->scene.path); !opened) return opened;
  playback_ = std::make_unique<Playback>(simulation(), rerun);
  simulation().follow(
      run::on_show([this](const world::World&, const world::Pace&) { playback_->look_for_end(); }));
  return {};
}

Result<void> Service::add_robots() {
  if (const Result<void> opened = site_->open_world(scene_.path); !opened) return opened.error();
  robots_ = std::make_unique<drivers::AutoDevices>(*site_, serving_.port, indices_);
  if (const Result<void> added = robots_->add_all(); !added) return added;
  Result<std::vector<std::unique_ptr<device::Driver>>> of_program = drivers::make_drivers_of_program(*site_);
  if (!of_program) return of_program.error();
  drivers_ = std::move(*of_program);
  if (robots_->left_out() > 0)
    warn_(fmt::format("{} devices are left out: an interface has {} indices on each of {} ports",
                      robots_->left_out(), indices_, robots_->ports()));
  if (site_->device_count() > limits::kDevices) {
    warn_(fmt::format("{} devices: a client's list shows the first {} of its port, and all can be opened",
                      site_->device_count(), limits::kDevices));
  }
  return {};
}

Result<std::unique_ptr<drivers::SiteWorld>> Service::open_world(const std::string& path,
                                                                drivers::Site& site) {
  return drivers::simulated_world(site, open_simulation(path));
}

Result<std::unique_ptr<run::Simulation>> Service::open_simulation(const std::string& path) {
  if (recording_)
    return std::make_unique<run::Simulation>(std::move(recording_->rerun),
                                             pace_of(recording_->scene, serving_, running_, quit_time_));
  if (cfg_) {
    if (const Result<void> read = read_world(path, config::NamedBy::kFile); !read) return read.error();
  }
  Result<std::unique_ptr<world::Engine>> engine =
      make_engine(scene_, running_, libraries_, warn_, engine_maker_, &other_errors_);
  if (!engine) return engine.error();
  if (saved_) {
    const Result<void> loaded = world::load_state((*engine)->world(), saved_->state);
    if (!loaded) return Error{{}, "the saved run " + loaded.error().text};
  } else {
    for (const std::string& warning : bodies::blocked_starts((*engine)->world())) warn_(warning);
    for (const std::string& warning : bodies::blind_rangers((*engine)->world())) warn_(warning);
  }
  const run::Simulation::SimulationOptions pace = pace_of(scene_, serving_, running_, quit_time_);
  if (!running_.cluster) return std::make_unique<run::Simulation>(std::move(*engine), pace);
  const bool is_open = !net::is_local(serving_.bind + ":0");
  if (is_open && running_.cluster_token.empty()) running_.cluster_token = web_server::random_token();
  auto head = std::make_unique<cluster::Head>(net::system_polled(), std::move(*engine), sources_,
                                              cluster::Head::HeadOptions{.bind = serving_.bind,
                                                                         .port = *running_.cluster,
                                                                         .nodes = running_.nodes,
                                                                         .token = running_.cluster_token},
                                              [this](const Error& why) { fail_run(why); });
  head_ = head.get();
  const Result<std::uint16_t> port = head_->listen();
  if (!port) return port.error();
  cluster_port_ = *port;
  auto simulation = std::make_unique<run::Simulation>(std::move(head), pace);
  simulation->follow(*head_);
  return simulation;
}

void Service::fail_run(const Error& why) {
  log::tell(log::Level::kError, why);
  run_works_ = false;
  stop();
}

void Service::stop() {
  if (head_ != nullptr) head_->stop();
  simulation().requests().stop();
}

Result<void> Service::read_guests() {
  Result<server::GuestBook> guests = app::read_guests(serving_);
  if (!guests) return guests.error();
  guests_ = std::move(*guests);
  server::admit_guests(*server_, guests_);
  return {};
}

/// On the web thread. Without guests nobody is asked on the Player port, until somebody was sent out.
void Service::close_clients_sent_out() {
  if (observers_) observers_->end_sent_out();
  if (guests_.guests().empty()) {
    loop_.post([this] {
      server_->admit_by([book = guests_](const std::string& token, const std::string& peer) {
        const bool is_admitted = token == "*" && !book.is_sent_out(token, peer);
        return is_admitted ? std::optional<device::Rights>(device::Rights{}) : std::nullopt;
      });
    });
  }
  server_->close_clients([book = guests_](const std::string& token, const std::string& peer) {
    return book.is_sent_out(token, peer);
  });
}

/// Made for the first server that shows the world.
replicate::SnapshotFeed& Service::feed() {
  if (feed_) return *feed_;
  const auto device_names = [this](world::ModelId model) {
    if (playback_) return std::vector<std::string>();
    return drivers::device_names(drivers::model_devices_of(*site_)->directory(), model,
                                 player_ports_.front());
  };
  feed_ = std::make_unique<replicate::SnapshotFeed>(simulation().world(), device_names,
                                                    [this] { return web_loop_.now(); });
  simulation().follow(std::make_shared<FeedLink>(*feed_));
  return *feed_;
}

std::optional<web_server::WebOptions::PlayerClients> Service::clients_of_pages() {
  if (playback_) return std::nullopt;
  return web_server::WebOptions::PlayerClients{
      .loop = &loop_,
      .port = player_ports_.front(),
      .came = [this](std::uint16_t port, std::unique_ptr<net::WebSocket> socket) {
        server::accept_websocket(*server_, port, std::move(socket));
      }};
}

Result<void> Service::open_page() {
  if (!serving_.web) return {};
  std::function<world::PhysicsShapes()> physics_shapes;
  if (!playback_) physics_shapes = [this] { return simulation().engine().physics_shapes(); };
  const web_server::WebOptions options{.bind = serving_.bind,
                                       .port = *serving_.web,
                                       .page = web_server::page_files(),
                                       .host_name = {},
                                       .further_names = serving_.web_hosts,
                                       .guests = guests_,
                                       .proxies = serving_.proxies,
                                       .sent_out = [this] { close_clients_sent_out(); },
                                       .viewers = serving_.viewers,
                                       .bytes_per_second = serving_.page_bytes,
                                       .physics_shapes = std::move(physics_shapes),
                                       .place_of_body = drivers::free_place,
                                       .player_clients = clients_of_pages(),
                                       .shares = simulation().shares()};
  world::Control& control = playback_ ? static_cast<world::Control&>(*playback_) : simulation().requests();
  web_ = std::make_unique<web_server::WebServer>(web_loop_, options, control, simulation().world(), feed());
  const Result<std::uint16_t> port = web_->listen();
  if (!port) return Error{port.error().where, port.error().text + "; --web takes another port, or off"};
  web_port_ = *port;
  return {};
}

Result<void> Service::open_observers() {
  if (!serving_.observers) return {};
  observers::ObserverOptions options{.bind = serving_.bind,
                                     .port = *serving_.observers,
                                     .guests = guests_,
                                     .observers = serving_.viewers,
                                     .bytes_per_second = serving_.observer_bytes};
  observers_ = std::make_unique<observers::ObserverServer>(web_loop_, std::move(options), feed());
  const Result<std::uint16_t> port = observers_->listen();
  if (!port) return Error{port.error().where, port.error().text + "; --observers takes another port"};
  observer_port_ = *port;
  return {};
}

std::vector<std::string> Service::places() const {
  std::vector<std::string> lines;
  const std::string host = shown_host(serving_.bind);
  for (const std::uint16_t port : player_ports_) lines.push_back(client_place(host, port, serving_));
  std::ranges::move(
      guest_places(guests_, host, web_ ? std::optional(web_port_) : std::nullopt, tls_ != nullptr),
      std::back_inserter(lines));
  if (observers_) lines.push_back(fmt::format("observers: {}:{}", host, observer_port_));
  const std::string& token = running_.cluster_token;
  if (head_ != nullptr)
    lines.push_back(
        fmt::format("cluster nodes: {}:{}{}", host, cluster_port_, token.empty() ? "" : " --token " + token));
  return lines;
}

std::vector<std::string> Service::robot_names() {
  std::vector<std::string> names;
  if (playback_) return names;
  const world::World& world = simulation().world();
  for (const world::ModelRow model : world.positions.model)
    if (world.models.root[model] == model) names.push_back(world.name(model));
  return names;
}

void Service::catch_signals() {
  const auto end = [this](int signal) {
    int none = 0;
    if (signal_.compare_exchange_strong(none, signal)) return stop();
    if (signal != SIGHUP)
      std::_Exit(128 + signal);  // second signal: at once; a closed terminal may send it twice
  };
  device_server::on_ending_signals(signal_loop_, end);
}

void Service::show_progress() {
  const world::Pace pace = simulation().requests().pace();
  // The factor is measured over a second: unavailable at first.
  const bool measured = pace.paused || pace.real_time_factor > 0;
  const std::string factor = measured ? fmt::format("{:.2f}x real time, ", pace.real_time_factor) : "";
  log::show_progress(fmt::format("{:.1f} s simulated, {}{} clients ", simulation().time(), factor,
                                 server_->status().sessions));
  progress_ = loop_.after(kProgressSeconds, [this] { show_progress(); });
}

Outcome Service::run(const std::function<void(int signal)>& ended) {
  const bool shows_progress = isatty(STDERR_FILENO) == 1;
  if (shows_progress) progress_ = loop_.after(kProgressSeconds, [this] { show_progress(); });
  io_runs_ = true;
  std::thread io([this] { loop_.run(); });
  std::thread web([this] { web_loop_.run(); });
  std::thread signals([this] { signal_loop_.run(); });
  const auto start = std::chrono::steady_clock::now();
  simulation().run();
  const double wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (ended) ended(signal_.load());
  loop_.post([this] {
    server_->finish([this] { loop_.finish(); });
    simulation().discard();  // only now: the server takes what is dropped before finish() for a refusal
  });
  if (observers_) web_loop_.post([this] { observers_->say_goodbye("the run has ended"); });
  web_loop_.stop();
  io.join();
  web.join();
  signal_loop_.stop();
  signals.join();
  end_at_once_on_signals();  // no longer handled by the loop
  if (shows_progress) log::show_progress("");
  saving_works_ = world_saver_.finish() && saving_works_;
  if (recorder_) {
    recorder_->end(simulation().world());
    saving_works_ = record_file_->finish() && saving_works_;
  }
  for (const SaveAt& save : saves_)
    log::error_at(escaped(save.file), "not saved: the run ended at {} s, before {} s",
                  simulation().world().time(), save.seconds);
  Outcome outcome = outcome_of(simulation().engine(), wall_time);
  outcome.signal = signal_.load();
  return outcome;
}

}  // namespace playhouse::app
