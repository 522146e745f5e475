#include "playhouse/house/house.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/house/client.h"
#include "playhouse/house/robot_machine.h"
#include "playhouse/house/simulated_nodes.h"
#include "playhouse/house/simulated_program.h"
#include "playhouse/house/simulated_viewer.h"
#include "playhouse/observers/observer_client.h"
#include "playhouse/world/population/population.h"

namespace playhouse::house {
namespace {

constexpr std::uint16_t kMachinePort = 6800;
constexpr std::size_t kClients = 6, kPages = 3, kSpawned = 6, kMachines = 2;
constexpr double kSlice = 0.05;        // s of the network, while the tick sleeps
constexpr double kTickSeconds = 1e-3;  // that a tick takes
constexpr double kPatience = 5;        // s until a client has all its answers
constexpr double kSettling = 3;        // s until nothing is on its way that was before
/// A page assumes that the program hangs if it hears nothing for longer. [s]
constexpr double kSignOfLife = 1.5;
constexpr std::uint64_t kRewindTicks = 200;

/// A robot of another machine that has gone.
struct Gone {
  std::string robot;
  double until = 0;  // s; the world may have it up to then
};

class House final {
 public:
  House(const HouseOptions& options, const std::string& folder);
  Report run();

 private:
  std::uint32_t draw(std::uint32_t below) { return static_cast<std::uint32_t>(random_() % below); }
  bool one_in(std::uint32_t count) { return draw(count) == 0; }
  run::Simulation& simulation() { return program_->simulation(); }
  const world::World& world() { return program_->world(); }

  void start(const Saved* saved);
  void crash();
  void reloaded(const world::World& world);
  void change_world();
  void rewind();
  void change_clients();
  void change_pages();
  void end_page(SimulatedViewer& page);
  void change_machines();
  struct Machine;
  void end_machine(const Machine& machine);
  void change_network();
  void excuse_until(double time);
  void put_off(double seconds);
  void wait_for_nodes(double seconds);
  bool sleep(double until);
  void pass(double seconds);
  void turn();
  void begin_to_end();
  void look();
  void end_client(SimulatedClient& client);
  void end_clients();
  void expect_all_answered(const std::vector<std::unique_ptr<SimulatedClient>>& clients);
  void wrong(std::string what);

  const HouseOptions options_;
  const Setting setting_;
  const std::string folder_;
  std::mt19937_64 random_;
  Report report_;
  net::SimulatedNetwork network_;
  std::optional<SimulatedNodes> nodes_;  // of a cluster
  std::unique_ptr<SimulatedProgram> program_;
  std::optional<Saved> saved_;
  std::unique_ptr<observers::ObserverClient> observer_;
  std::vector<std::unique_ptr<SimulatedViewer>> pages_;
  std::vector<std::unique_ptr<SimulatedClient>> clients_, leaving_;
  struct Machine {
    std::unique_ptr<RobotMachine> program;
    std::string robot;
    double ends = 0;    // s; 0: it goes on
    bool lost = false;  // the world does not know any more whose robot it is
  };
  std::vector<Machine> machines_;
  std::vector<Gone> gone_;
  std::uint64_t turns_ = 0;
  double next_turn_, leaving_until_ = 0, whole_at_ = 0;  // s; the network carries all
  std::optional<double> ends_;                           // s; all clients leave
  std::vector<world::ModelId> spawned_;
  std::optional<std::uint64_t> rewound_to_;
  bool paused_ = false, crashes_ = false;
  Hash digest_;
};

House::House(const HouseOptions& options, const std::string& folder)
    : options_(options),
      setting_(options.setting.value_or(setting_of(options.seed))),
      folder_(folder),
      random_(options.seed),
      network_(options.seed),
      next_turn_(setting_.turn) {
  network_.datagrams = {
      .loss = draw(50) / 100.0, .duplication = 0.1, .delay = 0.01, .jitter = draw(20) / 100.0};
  network_.connections.delay = draw(20) / 1000.0;
  network_.connections.jitter = draw(50) / 1000.0;
  if (setting_.is_cluster) nodes_.emplace(options_.seed);
  start(nullptr);
}

/// The program begins, at the beginning or where a run was saved.
void House::start(const Saved* saved) {
  SimulatedProgram::ProgramOptions options{.setting = setting_, .seed = options_.seed};
  options.recording = fmt::format("{}/house-{}-{}.mcap", folder_, options_.seed, report_.crashes);
  if (setting_.disk_fails) options.room = 100000 + draw(1 << 20);
  options.loses_change = options_.sabotage == Sabotage::kLosesChange;
  if (nodes_) options.nodes = &*nodes_;
  options.saved = saved;
  options.wait = [this](double until) { return sleep(until); };
  options.ticked = [this] { pass(kTickSeconds); };
  options.reloaded = [this](const world::World& world) { reloaded(world); };
  options.wrong = [this](std::string what) { wrong(std::move(what)); };
  program_ = std::make_unique<SimulatedProgram>(network_, std::move(options));
  paused_ = crashes_ = false;
  rewound_to_.reset();
  reloaded(world());
}

/// The program is killed, and started again. Who was connected has to connect again.
void House::crash() {
  program_->kill();
  program_->run_again();
  report_.checks += program_->checks();
  ++report_.crashes;
  for (auto* clients : {&clients_, &leaving_}) {
    for (const auto& client : *clients) end_client(*client);
    clients->clear();
  }
  for (const auto& page : pages_) end_page(*page);
  pages_.clear();
  observer_.reset();
  for (Machine& machine : machines_) machine.lost = true;
  program_.reset();
  start(saved_ && one_in(2) ? &*saved_ : nullptr);
}

/// The world is another one. A rewind arrives at the tick that was asked for.
void House::reloaded(const world::World& world) {
  excuse_until(network_.now() + kSettling);
  gone_.clear();
  for (Machine& machine : machines_) machine.lost |= machine.program->is_over();
  std::erase_if(spawned_, [&](world::ModelId model) { return !world.row(model); });
  if (!rewound_to_) return;
  if (world.tick() != *rewound_to_)
    wrong(fmt::format("the run went to tick {} instead of {}", world.tick(), *rewound_to_));
  rewound_to_.reset();
}

void House::wrong(std::string what) {
  if (!report_.fault)
    report_.fault =
        fmt::format("at {:.1f} s, tick {}: {}", network_.now(), program_ ? world().tick() : 0, what);
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
    clients_.push_back(
        std::make_unique<SimulatedClient>(network_, kPlayerPort, manner, setting_.period(), random_()));
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
  if (one_in(200)) observer_.reset();
  if (setting_.has_observers && observer_ == nullptr && one_in(50))
    observer_ = *observers::ObserverClient::open(
        network_, *net::parse_endpoint(kObserverHost, kObserverPort), {0, 30}, "", [] {}, "10.0.0.2");
}

void House::change_pages() {
  if (setting_.has_pages && pages_.size() < kPages && one_in(20)) {
    const std::string address = fmt::format("10.1.{}.{}", report_.pages / 200, 1 + report_.pages % 200);
    const auto manner = static_cast<PageManner>(draw(kPageManners));
    pages_.push_back(
        std::make_unique<SimulatedViewer>(network_, kWebPort, address, program_->shown(), manner, random_()));
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

/// Robots come from other machines, and leave with them.
void House::change_machines() {
  if (setting_.has_robots && machines_.size() < kMachines && one_in(60)) {
    const std::string robot = fmt::format("guest{}", ++report_.machines);
    const auto port = static_cast<std::uint16_t>(kMachinePort + report_.machines % 1000);
    machines_.push_back(
        {std::make_unique<RobotMachine>(network_, kPlayerPort, port, robot, setting_.period(), random_()),
         robot});
    machines_.back().program->excuse_until(whole_at_ + kSettling);
  }
  for (Machine& machine : machines_) {
    if (machine.ends > 0 || !one_in(200)) continue;
    machine.program->finish();
    machine.ends = std::max(network_.now(), whole_at_) + 2 * kPatience;
  }
  std::erase_if(machines_, [this](Machine& machine) {
    const bool ends = machine.ends > 0 && network_.now() >= machine.ends;
    if (!ends && !machine.program->is_over()) return false;
    end_machine(machine);
    return true;
  });
}

void House::end_machine(const Machine& machine) {
  const bool had_time = machine.ends > 0 && network_.now() >= machine.ends;
  if (had_time && !machine.program->is_over() && machine.program->waits_for() > 0)
    wrong(fmt::format("{} requests to a robot of another machine are not answered",
                      machine.program->waits_for()));
  report_.answers += machine.program->answered();
  digest_.add(machine.program->digest());
  if (!machine.lost) gone_.push_back({machine.robot, std::max(network_.now(), whole_at_) + kPatience});
}

/// Now and then nothing arrives for some seconds.
void House::change_network() {
  if (!one_in(600) || network_.is_cut()) return;
  const double seconds = draw(50) / 10.0;
  network_.cut(seconds);
  ++report_.cuts;
  whole_at_ = network_.now() + seconds;
  put_off(seconds);
  excuse_until(whole_at_ + kSettling);
}

/// What somebody has to have done by a time.
void House::put_off(double seconds) {
  leaving_until_ += seconds;
  for (Machine& machine : machines_) machine.ends += machine.ends > 0 ? seconds : 0;
  for (Gone& gone : gone_) gone.until += seconds;
}

/// Of data that are missing, and of silence.
void House::excuse_until(double time) {
  for (auto* clients : {&clients_, &leaving_})
    for (const auto& client : *clients) client->excuse_until(time);
  for (const auto& page : pages_) page->excuse_until(time);
  for (const Machine& machine : machines_) machine.program->excuse_until(time);
}

void House::end_client(SimulatedClient& client) {
  report_.answers += client.answered();
  digest_.add(client.digest());
  client.leave();
}

/// Those that have had the time for all answers.
void House::end_clients() {
  expect_all_answered(leaving_);
  for (const auto& client : leaving_) end_client(*client);
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
  if (nodes_ && nodes_->now() > network_.now() + seconds)
    wait_for_nodes(nodes_->now() - network_.now() - seconds);
  network_.run_for(seconds);
  if (nodes_ && nodes_->now() < network_.now()) nodes_->pass(network_.now() - nodes_->now());
  program_->write_recording();
  for (; next_turn_ <= network_.now(); next_turn_ += setting_.turn) turn();
}

/// A tick has waited for nodes for so long, and everybody for the tick.
void House::wait_for_nodes(double seconds) {
  network_.run_for(seconds);
  put_off(seconds);
  if (ends_) *ends_ += seconds;
  excuse_until(network_.now() + kSettling);
}

/// Everybody does something.
void House::turn() {
  ++turns_;
  for (auto* clients : {&clients_, &leaving_})
    for (const auto& client : *clients) client->hear(network_.now());
  for (const Machine& machine : machines_) machine.program->hear();
  for (const auto& page : pages_)
    page->hear(kSignOfLife + 4 * (network_.connections.delay + network_.connections.jitter));
  look();
  if (report_.fault || (ends_ && network_.now() >= *ends_ + kPatience)) return simulation().requests().stop();
  if (network_.now() >= options_.seconds) return begin_to_end();
  change_world();
  change_clients();
  change_pages();
  change_machines();
  change_network();
  if (nodes_) nodes_->act();
  if (one_in(300)) saved_ = program_->save();
  if (setting_.crashes && one_in(500)) {
    crashes_ = true;
    return simulation().requests().stop();
  }
  for (const auto& page : pages_) page->act();
  for (auto* clients : {&clients_, &leaving_})
    for (const auto& client : *clients) client->act();
  for (const Machine& machine : machines_) machine.program->act();
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
    for (const Machine& machine : machines_) end_machine(machine);
    machines_.clear();
    ends_ = std::max(network_.now(), whole_at_) + kPatience;
  }
  if (network_.now() >= *ends_) end_clients();
  for (const auto& client : leaving_) client->act();
}

/// Invariants of every tick.
void House::look() {
  program_->look();
  for (auto* clients : {&clients_, &leaving_})
    for (const auto& client : *clients)
      if (client->fault()) wrong(*client->fault());
  for (const auto& page : pages_)
    if (page->fault()) wrong(*page->fault());
  for (const Machine& machine : machines_)
    if (machine.program->fault()) wrong("of a robot of another machine, " + *machine.program->fault());
  std::erase_if(gone_, [this](const Gone& gone) {
    if (network_.now() < gone.until) return false;
    if (world().find(gone.robot)) wrong(gone.robot + " is in the world after its machine has gone");
    return true;
  });
  if (turns_ % 10 == 0) digest_.add(world().hash());
}

Report House::run() {
  for (simulation().run(); crashes_; simulation().run()) crash();
  network_.run_for(kPatience);
  program_->end();
  if (!report_.fault) program_->run_again();
  report_.checks += program_->checks();
  report_.disk_failed = program_->disk_failed();
  report_.simulated = network_.now();
  if (nodes_) report_.nodes = nodes_->joined();
  digest_.add(world().hash());
  report_.digest = digest_.value();
  clients_.clear();
  pages_.clear();
  return report_;
}

}  // namespace

Report run_house(const HouseOptions& options, const std::string& folder) {
  return House(options, folder).run();
}

}  // namespace playhouse::house
