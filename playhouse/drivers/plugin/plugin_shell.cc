#include "playhouse/drivers/plugin/plugin_shell.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/base/program_folder.h"
#include "playhouse/device/gate.h"
#include "playhouse/drivers/plugin/plugin_abi.h"
#include "playhouse/libraries/libraries.h"
#include "playhouse/libraries/thrown_by.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {
namespace {

/// How long a plug-in that was opened for nobody stays so: what another one waits for beside it may take its time.
constexpr double kUnusedSeconds = limits::kPluginSeconds + 1;

}  // namespace

class PluginDoor final : public PluginProgram {
 public:
  explicit PluginDoor(PluginShell& shell) : shell_(shell) {}

  /// From now on calls have no effect; waits for those that have begun.
  void shut() { gate_.close(); }
  void fail(const std::string& why) {
    pass([&](PluginShell& shell) { shell.failed(why); });
  }

  // Hooks.

  /// What open() throws fails this opening alone.
  void open(Plugin& plugin) {
    std::string thrown;
    is_open_ = libraries::thrown_by(thrown, [&] { plugin.open(); }) == nullptr;
    const Result<void> outcome = is_open_ ? Result<void>() : Result<void>(Error{"", thrown});
    pass([&](PluginShell& shell) {
      shell.site_.surroundings().post([&shell, outcome] { shell.opened(outcome); });
    });
  }
  void close(Plugin& plugin) {
    if (std::exchange(is_open_, false)) plugin.close();
    pass([](PluginShell& shell) { shell.site_.surroundings().post([&shell] { shell.closed(); }); });
  }

  // PluginProgram

  double time() const override {
    double time = 0;
    pass([&](PluginShell& shell) { time = shell.site_.time(); });
    return time;
  }
  void publish(std::size_t provided, std::uint8_t subtype, std::vector<std::byte> body,
               double timestamp) override {
    pass([&](PluginShell& shell) {
      const std::string fault =
          std::isfinite(timestamp)
              ? fault_of_message(shell.own_, wire::MessageType::kData, provided, subtype, body)
              : "it has no time";
      if (!fault.empty()) return shell.warn_once("data is left out: " + fault);
      if (provided < shell.ids_.size())
        shell.site_.data_flow().publish({{shell.ids_[provided], subtype, timestamp, std::move(body)}});
    });
  }
  void command(std::size_t used, std::uint8_t subtype, std::span<const std::byte> body) override {
    pass([&](PluginShell& shell) {
      const std::string fault = fault_of_message(shell.others_, wire::MessageType::kCmd, used, subtype, body);
      if (!fault.empty()) return shell.warn_once("a command is left out: " + fault);
      static_cast<void>(shell.client_.command(used, subtype, body));
    });
  }
  void ask(std::size_t used, std::uint8_t subtype, std::span<const std::byte> body,
           AnswerHeard heard) override {
    pass([&](PluginShell& shell) {
      const std::string fault =
          shell.is_connected_ ? fault_of_message(shell.others_, wire::MessageType::kReq, used, subtype, body)
                              : "the program does not run yet";
      if (!fault.empty()) {
        shell.thread_.post_anyway([heard = std::move(heard)] { heard(false, {}); });
        return shell.warn_once("a request gets NACK: " + fault);
      }
      shell.client_.ask(used, subtype, body,
                        [&shell, heard = std::move(heard)](std::optional<std::vector<std::byte>> answer) {
                          const bool posted = shell.thread_.post([heard, answer = std::move(answer)] {
                            heard(answer.has_value(), answer ? std::span<const std::byte>(*answer)
                                                             : std::span<const std::byte>());
                          });
                          // Who asked would wait for ever; it has as many of these as it asked.
                          if (!posted) shell.thread_.post_anyway([heard] { heard(false, {}); });
                        });
    });
  }
  void say(bool is_warning, std::string_view line) override {
    pass([&](PluginShell& shell) {
      const std::string text = escaped(line);
      if (is_warning)
        log::warn("driver {}: {}", in_quotes(shell.name_), text);
      else
        log::info("driver {}: {}", in_quotes(shell.name_), text);
    });
  }

 private:
  template <typename Call>
  void pass(const Call& call) const {
    gate_.pass([&] { call(shell_); });
  }
  PluginShell& shell_;
  mutable device::Gate gate_;
  bool is_open_ = false;  // the plug-in; of hooks
};

namespace {

/// A section of the file, as plug-ins read it.
class FileSection final : public PluginSection {
 public:
  explicit FileSection(const config::CfgSection& section) : section_(section) {}
  bool has(std::string_view key) const override { return section_.has(key); }
  std::size_t count(std::string_view key) const override { return section_.count(key); }
  double number(std::string_view key, double otherwise, std::size_t element) const override {
    return section_.number(key, otherwise, element);
  }
  double length(std::string_view key, double otherwise, std::size_t element) const override {
    return section_.length(key, otherwise, element);
  }
  double angle(std::string_view key, double otherwise, std::size_t element) const override {
    return section_.angle(key, otherwise, element);
  }
  int integer(std::string_view key, int otherwise, std::size_t element) const override {
    return section_.integer(key, otherwise, element);
  }
  bool flag(std::string_view key, bool otherwise) const override { return section_.flag(key, otherwise); }
  std::string text(std::string_view key, std::string_view otherwise, std::size_t element) const override {
    return section_.text(key, otherwise, element);
  }
  std::string filename(std::string_view key, std::string_view otherwise) const override {
    return section_.filename(key, otherwise);
  }

 private:
  const config::CfgSection& section_;
};

/// Devices of a field, with their addresses. Fails with "file:line".
Result<std::vector<std::pair<PluginDevice, device::Address>>> devices_of(const config::CfgSection& section,
                                                                         const Site& site,
                                                                         std::string_view key) {
  std::vector<std::pair<PluginDevice, device::Address>> devices;
  for (const config::DeviceAddress& named : section.addresses(key)) {
    const Result<device::Address> address = site.resolve(named);
    if (!address) return Error{section.at(key), address.error().text};
    devices.push_back({{named.key, named.interf, address->interf, address->index, address->robot}, *address});
  }
  return devices;
}

/// Why a registration can't be served; "" if it can.
std::string fault_of(const Plugin::MessageKey& key, std::span<const PluginDevice> devices,
                     std::string_view field, wire::MessageType type) {
  if (key.first >= devices.size())
    return fmt::format("it registers device {} of {}, which names {}", key.first, field, devices.size());
  const PluginDevice& device = devices[key.first];
  if (wire::find_message(device.code, type, key.second) != nullptr) return "";
  return fmt::format("it registers subtype {}, which no message of {} has", key.second, device.interf);
}

std::string fault_of(const Plugin::Registered& registered, std::span<const PluginDevice> provides,
                     std::span<const PluginDevice> uses) {
  std::string fault;
  const auto check = [&fault](const auto& entries, std::span<const PluginDevice> devices,
                              std::string_view field, wire::MessageType type) {
    for (const auto& [key, hook] : entries)
      if (fault.empty()) fault = fault_of(key, devices, field, type);
  };
  check(registered.commands, provides, "provides", wire::MessageType::kCmd);
  check(registered.requests, provides, "provides", wire::MessageType::kReq);
  check(registered.data, uses, "requires", wire::MessageType::kData);
  const double period = registered.period;
  if (fault.empty() && period != 0 && !(period >= limits::kPluginStepSeconds))
    fault = fmt::format("invalid period of steps {} s: 0, or {} s and more is valid", period,
                        limits::kPluginStepSeconds);
  return fault;
}

/// What a hook uses; destroyed from the last to the first.
struct Kept {
  Kept(std::shared_ptr<void> code, std::shared_ptr<PluginDoor> program, std::shared_ptr<Plugin> made)
      : library(std::move(code)), door(std::move(program)), plugin(std::move(made)) {}
  std::shared_ptr<void> library;
  std::shared_ptr<PluginDoor> door;
  std::shared_ptr<Plugin> plugin;
};

std::chrono::steady_clock::time_point time_to_end() {
  return std::chrono::steady_clock::now() + std::chrono::seconds(limits::kPluginEndSeconds);
}

std::vector<std::byte> copy_of(std::span<const std::byte> body) {
  return {body.begin(), body.end()};
}

}  // namespace

PluginShell::PluginShell(const config::CfgSection& section, Site& site, std::shared_ptr<void> library,
                         std::unique_ptr<Plugin> plugin)
    : name_(section.name()),
      where_(section.at()),
      site_(site),
      library_(std::move(library)),
      plugin_(std::move(plugin)),
      isolated_(dynamic_cast<IsolatedPlugin*>(plugin_.get())),
      door_(std::make_shared<PluginDoor>(*this)),
      client_(site.surroundings(), *this, section.addresses("requires").size()),
      thread_(
          site.surroundings().has_threads() ? PluginThread::Hooks::kOnThread : PluginThread::Hooks::kOnCaller,
          [&network = site.surroundings().network()] { return network.now(); },
          [door = door_](const std::string& why) { door->fail(why); }) {
  thread_.keep(std::make_shared<Kept>(library_, door_, plugin_));
  client_.when_news([this](std::vector<device::Publication>&) { take_news(); });
}

PluginShell::~PluginShell() {
  door_->shut();  // first: what it uses may be gone
  thread_.end();
  if (isolated_ != nullptr) isolated_->end(time_to_end());
}

Result<void> PluginShell::begin(const config::CfgSection& section) {
  const auto provides = devices_of(section, site_, "provides");
  if (!provides) return provides.error();
  const auto uses = devices_of(section, site_, "requires");
  if (!uses) return uses.error();
  std::vector<device::Address> used;
  for (const auto& [device, address] : *provides) {
    own_.push_back(device);
    provides_.push_back(address);
  }
  for (const auto& [device, address] : *uses) {
    others_.push_back(device);
    used.push_back(address);
  }
  if (plugin_ != nullptr)
    if (const Result<void> good = configure(section); !good) return good;
  for (const device::Address& address : provides_) {
    const Result<device::DeviceId> id = site_.add_device(address, *this);
    if (!id) return Error{section.at("provides"), id.error().text};
    ids_.push_back(*id);
  }
  const auto connected = [this] {
    is_connected_ = true;
    return Result<void>();
  };
  site_.add_user({this, &client_, provides_, used, section.at("requires"), connected});
  return {};
}

Result<void> PluginShell::configure(const config::CfgSection& section) {
  plugin_->join(*door_, own_, others_);
  std::string thrown;
  if (const char* why = libraries::thrown_by(thrown, [&] { plugin_->configure(FileSection(section)); }))
    return Error{section.at(), fmt::format("driver {}: {}", in_quotes(name_), why)};
  const Plugin::Registered& registered = plugin_->registered();
  if (const std::string fault = fault_of(registered, own_, others_); !fault.empty())
    return Error{section.at(), fmt::format("driver {}: {}", in_quotes(name_), fault)};
  for (const auto& [key, hook] : registered.data)
    data_.emplace_back(client_.latest(key.first, key.second), hook);
  if (isolated_ != nullptr) isolated_->watch([door = door_](const std::string& why) { door->fail(why); });
  return {};
}

void PluginShell::prepare(device::DeviceId device, Prepared heard) {
  if (has_failed_) return heard(Error{"", fmt::format("driver {} has failed", in_quotes(name_))});
  if (ready(device)) return heard({});
  callers_.push_back(std::move(heard));
  if (callers_.size() > 1) return;
  client_.prepare([this](const Result<void>& outcome) { outcome ? open() : tell(outcome); });
}

/// What it requires can be opened.
void PluginShell::open() {
  if (!client_.is_open())  // it is if close() has not come back yet
    if (const Result<void> opened = client_.open(); !opened) return tell(opened);
  phase_ = Phase::kOpening;
  look();
  if (!thread_.post_anyway([plugin = plugin_.get(), door = door_] { door->open(*plugin); }))
    opened(Error{"", fmt::format("driver {} has failed", in_quotes(name_))});
}

/// The hook has come back.
void PluginShell::opened(const Result<void>& outcome) {
  if (phase_ != Phase::kOpening) return;  // what it requires has retired
  phase_ = outcome ? Phase::kOpen : Phase::kClosed;
  if (outcome) {
    unused_timer_ = site_.surroundings().network().after(kUnusedSeconds, [this] { close(); });
  } else {
    look_timer_.reset();
    client_.close();
  }
  tell(outcome);
}

void PluginShell::tell(const Result<void>& outcome) {
  for (const Prepared& heard : std::exchange(callers_, {})) heard(outcome);
}

Result<void> PluginShell::start(device::DeviceId device) {
  if (!ready(device)) return Error{"", fmt::format("driver {} is not open", in_quotes(name_))};
  if (open_++ > 0 || plugin_ == nullptr) return {};
  unused_timer_.reset();
  if (plugin_->registered().period > 0) step();
  return {};
}

void PluginShell::stop(device::DeviceId) {
  if (--open_ == 0 && is_in_use()) close();
}

/// What it uses stays open until the plug-in has stopped what it moves.
void PluginShell::close() {
  step_timer_.reset();
  unused_timer_.reset();
  phase_ = Phase::kClosing;
  if (!thread_.post_anyway([plugin = plugin_.get(), door = door_] { door->close(*plugin); })) closed();
}

void PluginShell::closed() {
  if (phase_ != Phase::kClosing) return;  // it was opened again
  phase_ = Phase::kClosed;
  look_timer_.reset();
  client_.close();
}

/// Its own devices retire as well.
void PluginShell::retired(device::DeviceId) {
  if (is_in_use()) close();
  client_.close();
  tell(Error{"", "what it requires has retired"});
}

std::size_t PluginShell::number_of(device::DeviceId device) const {
  return static_cast<std::size_t>(std::ranges::find(ids_, device) - ids_.begin());
}

device::Taken PluginShell::command(const device::Message& message) {
  if (phase_ != Phase::kOpen) return device::Taken::kNo;  // it must not wait for the next client
  const auto& commands = plugin_->registered().commands;
  const auto found = commands.find({number_of(message.device), message.subtype});
  if (found == commands.end()) return device::Taken::kNo;
  const bool queued = thread_.post([take = &found->second, body = copy_of(message.body)] { (*take)(body); });
  return queued ? device::Taken::kQueued : device::Taken::kNo;
}

void PluginShell::request(const device::Message& message, device::Replier replier) {
  if (phase_ != Phase::kOpen) return;
  const auto& requests = plugin_->registered().requests;
  const auto found = requests.find({number_of(message.device), message.subtype});
  if (found == requests.end()) return;
  // A std::function must be copyable.
  const auto reply = std::make_shared<PluginReply>(
      [shared = std::make_shared<device::Replier>(std::move(replier))](
          bool ack, std::vector<std::byte> body) { ack ? shared->ack(std::move(body)) : shared->nack(); });
  thread_.post(
      [answer = &found->second, body = copy_of(message.body), reply] { (*answer)(body, std::move(*reply)); });
}

bool PluginShell::capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const {
  if (plugin_ == nullptr) return false;
  const Plugin::Registered& registered = plugin_->registered();
  const Plugin::MessageKey key{number_of(device), subtype};
  if (type == static_cast<std::uint8_t>(wire::MessageType::kCmd)) return registered.commands.contains(key);
  if (type != static_cast<std::uint8_t>(wire::MessageType::kReq)) return false;
  const auto found = registered.requests.find(key);
  if (found == registered.requests.end()) return false;
  const auto* const passed_on = found->second.target<PassedOn>();
  return passed_on == nullptr || client_.capable(passed_on->used, type, subtype);
}

void PluginShell::barrier(device::Replier replier) {
  const auto shared = std::make_shared<device::Replier>(std::move(replier));
  if (!thread_.post([shared] { shared->ack(); })) shared->ack();
}

/// A hook for each of its data at a time: what comes meanwhile replaces what waits.
void PluginShell::take_news() {
  for (Datum& datum : data_) {
    if (datum.is_posted.exchange(true)) continue;
    const bool posted = thread_.post([&datum] {
      datum.is_posted = false;
      if (const auto latest = datum.latest.take_latest()) datum.take(latest->body, latest->timestamp);
    });
    if (!posted) datum.is_posted = false;
  }
}

/// Whether a hook has come back, while there may be one.
void PluginShell::look() {
  if (has_failed_) return;
  if (const double busy = thread_.busy(); busy > limits::kPluginSeconds)
    return failed(fmt::format("it has not come back for {:.0f} s", busy));
  look_timer_ = site_.surroundings().network().after(1, [this] { look(); });
}

void PluginShell::step() {
  if (!step_waits_.exchange(true)) {
    const bool posted = thread_.post([this, plugin = plugin_.get()] {
      step_waits_ = false;
      plugin->step();
    });
    if (!posted) step_waits_ = false;
  }
  step_timer_ = site_.surroundings().network().after(plugin_->registered().period, [this] { step(); });
}

void PluginShell::failed(const std::string& why) {
  if (has_failed_.exchange(true)) return;
  log::error("{}: driver {} has failed, and its devices retire: {}", where_, in_quotes(name_), why);
  thread_.end();
  if (isolated_ != nullptr) isolated_->kill(why);
  site_.surroundings().post([this, why] {
    phase_ = Phase::kClosed;
    unused_timer_.reset();
    client_.close();
    tell(Error{"", why});
    site_.retire_later(provides_);
  });
}

void PluginShell::warn_once(const std::string& line) {
  if (told_.add(line)) log::warn("driver {}: {}", in_quotes(name_), line);
}

/// All hooks and the end of a process share one time.
void PluginShell::finish() {
  if (is_in_use()) close();  // nobody has begun to use it yet
  if (isolated_ == nullptr) return thread_.finish();
  const auto until = time_to_end();
  thread_.finish([this] { isolated_->kill("it does not end"); });
  isolated_->end(until);
}

namespace {

/// The plug-in of a section; null where no code is to be loaded.
struct MadePlugin {
  std::shared_ptr<libraries::SharedLibrary>
      library;  // outlives the plug-in; null: it is in a process of its own
  std::unique_ptr<Plugin> plugin;
};

Result<MadePlugin> make_in_this_process(const libraries::WantedLibrary& wanted,
                                        const libraries::Libraries& libraries,
                                        std::vector<std::string>& warnings) {
  MadePlugin made;
  auto library = libraries::load(wanted, libraries, warnings);
  if (!library) return library.error();
  made.library = std::move(*library);
  if (made.library == nullptr) return made;
  auto plugin = made.library->make<Plugin>();
  if (!plugin) return Error{wanted.where, plugin.error().line()};
  made.plugin = std::move(*plugin);
  return made;
}

/// The library is loaded there: its code may crash whenever it runs.
Result<MadePlugin> make_isolated(const config::CfgSection& section, Site& site,
                                 const libraries::WantedLibrary& wanted,
                                 const libraries::Libraries& libraries, std::vector<std::string>& warnings) {
  const Result<std::filesystem::path> file = libraries::locate(wanted, libraries, warnings);
  if (!file) return file.error();
  if (file->empty()) return MadePlugin();
  const std::filesystem::path program = site.surroundings().plugin_program();
  if (program.empty()) return Error{section.at("isolated"), "this program starts no other processes"};
  Result<std::unique_ptr<IsolatedPlugin>> plugin =
      IsolatedPlugin::start({.program = program,
                             .library = std::filesystem::absolute(*file),
                             .name = section.name(),
                             .has_world = [&site] { return site.world() != nullptr; }});
  if (!plugin)
    return Error{section.at("isolated"),
                 fmt::format("driver {}: {}", in_quotes(section.name()), plugin.error().line())};
  return MadePlugin{nullptr, std::move(*plugin)};
}

/// Where the library of a plug-in may be.
libraries::Libraries libraries_for(const config::PluginField& plugin, Site& site) {
  libraries::Libraries libraries = site.surroundings().libraries();
  const std::string beside = std::filesystem::path(plugin.folder).parent_path().string();
  libraries.folders =
      libraries::library_folders(beside.empty() ? "." : beside, "PLAYERPATH", program_folder());
  return libraries;
}

libraries::WantedLibrary wanted_for(const config::PluginField& plugin) {
  return {kPluginAbi, plugin.name, plugin.where, {}};
}

}  // namespace

bool plugin_is_there(const config::PluginField& plugin, Site& site) {
  return libraries::is_there(wanted_for(plugin), libraries_for(plugin, site));
}

Result<std::unique_ptr<device::Driver>> make_plugin(const config::CfgSection& section,
                                                    const config::PluginField& plugin, Site& site) {
  std::vector<std::string> warnings;
  const libraries::Libraries libraries = libraries_for(plugin, site);
  const libraries::WantedLibrary wanted = wanted_for(plugin);
  Result<MadePlugin> made = section.flag("isolated", false)
                                ? make_isolated(section, site, wanted, libraries, warnings)
                                : make_in_this_process(wanted, libraries, warnings);
  if (!made) return made.error();
  for (const std::string& line : warnings) site.warn(line);
  auto shell =
      std::make_unique<PluginShell>(section, site, std::move(made->library), std::move(made->plugin));
  if (const Result<void> begun = shell->begin(section); !begun) return begun.error();
  return std::unique_ptr<device::Driver>(std::move(shell));
}

}  // namespace playhouse::drivers
