#include "playhouse/drivers/isolated/isolated_main.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/monotonic.h"
#include "playhouse/drivers/isolated/plugin_frame.h"
#include "playhouse/drivers/isolated/plugin_process.h"
#include "playhouse/drivers/isolated/plugin_start.h"
#include "playhouse/drivers/plugin/plugin.h"
#include "playhouse/drivers/plugin/plugin_abi.h"
#include "playhouse/libraries/shared_library.h"
#include "playhouse/libraries/thrown_by.h"

namespace playhouse::drivers {
namespace {

constexpr int kNoProgram = 2;  // exit code

/// The program, for a plug-in in another process than it. Its thread reads what the program says: answers wake who
/// asked, calls wait for run().
class DistantProgram final : public PluginProgram {
 public:
  DistantProgram() : reader_([this] { read(); }) {}

  /// Carries out calls until the program is gone, and ends the process.
  [[noreturn]] void run();

  /// Waits for its answer. Any thread; without a program an empty one.
  PluginFrame told(const PluginFrame& question) const;
  void send(const PluginFrame& frame) const { out_.send(frame); }

  double time() const override;
  void publish(std::size_t provided, std::uint8_t subtype, std::vector<std::byte> body,
               double timestamp) override {
    send({.kind = PluginFrameKind::kPublish,
          .subtype = subtype,
          .device = static_cast<std::uint32_t>(provided),
          .time = timestamp,
          .body = std::move(body)});
  }
  void command(std::size_t used, std::uint8_t subtype, std::span<const std::byte> body) override {
    send({.kind = PluginFrameKind::kCommandOther,
          .subtype = subtype,
          .device = static_cast<std::uint32_t>(used),
          .body = {body.begin(), body.end()}});
  }
  void ask(std::size_t used, std::uint8_t subtype, std::span<const std::byte> body,
           AnswerHeard heard) override;
  void say(bool is_warning, std::string_view line) override {
    send({.kind = PluginFrameKind::kSay, .flag = is_warning, .body = bytes_of_text(line)});
  }

 private:
  using Lock = std::unique_lock<std::mutex>;
  void read();
  void note(PluginFrame frame);
  std::optional<PluginFrame> next_call();
  void carry_out(const PluginFrame& frame);
  void configure(const PluginFrame& frame);
  void answer_heard(const PluginFrame& frame);

  mutable FrameOutput out_{kPluginSocket};
  std::atomic<bool> has_world_ = false;

  mutable std::mutex mutex_;  // guards what follows
  mutable std::condition_variable changed_;
  std::deque<PluginFrame> calls_;
  mutable bool is_asked_ = false;  // one question at a time
  mutable std::optional<PluginFrame> answer_;
  bool is_gone_ = false;  // the program
  std::map<std::uint64_t, AnswerHeard> asked_;
  std::uint64_t next_question_ = 0;

  // Of the thread of run().
  std::optional<libraries::SharedLibrary> library_;  // outlives the plug-in
  std::unique_ptr<Plugin> plugin_;
  bool is_open_ = false;

  std::thread reader_;  // last member: it uses the others
};

/// The section, which the program reads.
class DistantSection final : public PluginSection {
 public:
  explicit DistantSection(DistantProgram& program) : program_(program) {}
  bool has(std::string_view key) const override { return ask(FieldQuestion::kHas, key).time != 0; }
  std::size_t count(std::string_view key) const override {
    return static_cast<std::size_t>(ask(FieldQuestion::kCount, key).time);
  }
  double number(std::string_view key, double otherwise, std::size_t element) const override {
    return ask(FieldQuestion::kNumber, key, otherwise, element).time;
  }
  double length(std::string_view key, double otherwise, std::size_t element) const override {
    return ask(FieldQuestion::kLength, key, otherwise, element).time;
  }
  double angle(std::string_view key, double otherwise, std::size_t element) const override {
    return ask(FieldQuestion::kAngle, key, otherwise, element).time;
  }
  int integer(std::string_view key, int otherwise, std::size_t element) const override {
    return static_cast<int>(ask(FieldQuestion::kInteger, key, otherwise, element).time);
  }
  bool flag(std::string_view key, bool otherwise) const override {
    return ask(FieldQuestion::kFlag, key, otherwise).time != 0;
  }
  std::string text(std::string_view key, std::string_view otherwise, std::size_t element) const override {
    return std::string(text_of(ask(FieldQuestion::kText, key, 0, element, otherwise).body));
  }
  std::string filename(std::string_view key, std::string_view otherwise) const override {
    return std::string(text_of(ask(FieldQuestion::kFilename, key, 0, 0, otherwise).body));
  }

 private:
  PluginFrame ask(FieldQuestion question, std::string_view key, double otherwise = 0, std::size_t element = 0,
                  std::string_view text = "") const {
    return program_.told({.kind = PluginFrameKind::kAskField,
                          .subtype = static_cast<std::uint8_t>(question),
                          .number = element,
                          .time = otherwise,
                          .body = pack(FieldAsked{std::string(key), std::string(text)})});
  }
  DistantProgram& program_;
};

RegisteredKeys keys_of(const Plugin::Registered& registered) {
  RegisteredKeys keys;
  keys.period = registered.period;
  for (const auto& [key, hook] : registered.commands) keys.commands.push_back(key);
  for (const auto& [key, hook] : registered.requests) {
    if (const auto* const passed_on = hook.target<PassedOn>())
      keys.passed_on.emplace_back(key, passed_on->used);
    else
      keys.requests.push_back(key);
  }
  for (const auto& [key, hook] : registered.data) keys.data.push_back(key);
  return keys;
}

double DistantProgram::time() const {
  if (!has_world_) return unix_seconds();
  return told({.kind = PluginFrameKind::kAskTime}).time;
}

void DistantProgram::ask(std::size_t used, std::uint8_t subtype, std::span<const std::byte> body,
                         AnswerHeard heard) {
  std::uint64_t number = 0;
  {
    const Lock lock(mutex_);
    number = next_question_++;
    asked_[number] = std::move(heard);
  }
  send({.kind = PluginFrameKind::kAskOther,
        .subtype = subtype,
        .device = static_cast<std::uint32_t>(used),
        .number = number,
        .body = {body.begin(), body.end()}});
}

PluginFrame DistantProgram::told(const PluginFrame& question) const {
  Lock lock(mutex_);
  changed_.wait(lock, [this] { return !is_asked_ || is_gone_; });
  if (is_gone_) return {};
  is_asked_ = true;
  answer_.reset();
  lock.unlock();
  send(question);
  lock.lock();
  changed_.wait(lock, [this] { return answer_ || is_gone_; });
  is_asked_ = false;
  changed_.notify_all();
  return answer_.value_or(PluginFrame{});
}

/// Once the program is gone the plug-in has its time to end, whatever its hooks do.
void DistantProgram::read() {
  FrameInput in(kPluginSocket);
  while (in.read(true) == FrameInput::ReadOutcome::kSome) {
    for (;;) {
      Result<std::optional<PluginFrame>> frame = in.take();
      if (!frame) std::_Exit(kNoProgram);
      if (!*frame) break;
      note(std::move(**frame));
    }
  }
  Lock lock(mutex_);
  is_gone_ = true;
  changed_.notify_all();
  changed_.wait_for(lock, std::chrono::seconds(limits::kPluginEndSeconds), [] { return false; });
  std::_Exit(kNoProgram);
}

void DistantProgram::note(PluginFrame frame) {
  {
    const Lock lock(mutex_);
    if (frame.kind == PluginFrameKind::kTold)
      answer_ = std::move(frame);
    else
      calls_.push_back(std::move(frame));
  }
  changed_.notify_all();
}

/// None once the program is gone.
std::optional<PluginFrame> DistantProgram::next_call() {
  Lock lock(mutex_);
  changed_.wait(lock, [this] { return is_gone_ || !calls_.empty(); });
  if (is_gone_) return std::nullopt;
  std::optional<PluginFrame> call = std::move(calls_.front());
  calls_.pop_front();
  return call;
}

void DistantProgram::run() {
  std::string thrown;
  while (const std::optional<PluginFrame> call = next_call()) {
    const char* const why = libraries::thrown_by(thrown, [&] { carry_out(*call); });
    send({.kind = PluginFrameKind::kReturned, .flag = why != nullptr, .body = bytes_of_text(why ? why : "")});
  }
  if (is_open_) libraries::thrown_by(thrown, [this] { plugin_->close(); });
  plugin_.reset();
  std::fflush(nullptr);
  std::_Exit(0);
}

void DistantProgram::carry_out(const PluginFrame& frame) {
  if (frame.kind == PluginFrameKind::kConfigure) return configure(frame);
  const Plugin::Registered& registered = plugin_->registered();
  const Plugin::MessageKey key{frame.device, frame.subtype};
  switch (frame.kind) {
    case PluginFrameKind::kOpen:
      has_world_ = frame.flag;
      plugin_->open();
      is_open_ = true;
      return;
    case PluginFrameKind::kClose:
      is_open_ = false;
      return plugin_->close();
    case PluginFrameKind::kStep:
      return plugin_->step();
    case PluginFrameKind::kCommand:
      return registered.commands.at(key)(frame.body);
    case PluginFrameKind::kRequest:
      return registered.requests.at(key)(
          frame.body, PluginReply([this, number = frame.number](bool ack, std::vector<std::byte> body) {
            send({.kind = PluginFrameKind::kReply, .flag = ack, .number = number, .body = std::move(body)});
          }));
    case PluginFrameKind::kDatum:
      return registered.data.at(key)(frame.body, frame.time);
    case PluginFrameKind::kHeard:
      return answer_heard(frame);
    default:
      throw std::runtime_error("the program is of another version");
  }
}

void DistantProgram::configure(const PluginFrame& frame) {
  std::optional<PluginStart> start = unpack_start(frame.body);
  if (!start || plugin_ != nullptr) throw std::runtime_error("the program is of another version");
  has_world_ = frame.flag;
  Result<libraries::SharedLibrary> library = libraries::SharedLibrary::open(start->library, kPluginAbi);
  if (!library) throw std::runtime_error(library.error().line());
  library_ = std::move(*library);
  Result<std::unique_ptr<Plugin>> made = library_->make<Plugin>();
  if (!made) throw std::runtime_error(made.error().line());
  plugin_ = std::move(*made);
  plugin_->join(*this, std::move(start->provides), std::move(start->uses));
  plugin_->configure(DistantSection(*this));
  send({.kind = PluginFrameKind::kRegistered, .body = pack(keys_of(plugin_->registered()))});
}

void DistantProgram::answer_heard(const PluginFrame& frame) {
  AnswerHeard heard;
  {
    const Lock lock(mutex_);
    const auto found = asked_.find(frame.number);
    if (found == asked_.end()) return;
    heard = std::move(found->second);
    asked_.erase(found);
  }
  heard(frame.flag, frame.body);
}

volatile std::sig_atomic_t process_of_program = 0;  // global, for the signal handler

/// The thread that reads sees that the program has gone. This is for a process whose threads do nothing any more. The
/// signal tells the end of a thread of the program as well, which is none of ours.
void end_after_program() {
  process_of_program = ::getppid();
  std::signal(SIGHUP, [](int) {
    if (::getppid() != process_of_program) ::alarm(limits::kPluginEndSeconds + 1);
  });
  ::prctl(PR_SET_PDEATHSIG, SIGHUP);
}

}  // namespace

bool is_isolated_plugin(int argc, const char* const* argv) {
  return argc == 3 && std::string_view(argv[1]) == kPluginProcessWord;
}

int run_isolated_plugin() {
  int type = 0;
  socklen_t size = sizeof type;
  if (::getsockopt(kPluginSocket, SOL_SOCKET, SO_TYPE, &type, &size) != 0) {
    std::fprintf(stderr, "error: %s is started by the program itself, for a driver with isolated 1\n",
                 kPluginProcessWord);
    return kNoProgram;
  }
  // The program ends it in order, where whoever ends a service tells all its processes to. No SIG_IGN, which programs
  // that the plug-in starts would inherit.
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) {});
  ::prctl(PR_SET_NAME, kPluginProcessWord);     // who lists processes would read "exe"
  ::fcntl(kPluginSocket, F_SETFD, FD_CLOEXEC);  // programs that the plug-in starts must not keep it
  end_after_program();
  // As in the program.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  DistantProgram().run();
}

}  // namespace playhouse::drivers
