#include "playhouse/drivers/isolated/isolated_plugin.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/drivers/isolated/plugin_start.h"

namespace playhouse::drivers {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLastReads = 64;          // of what a process that has ended left behind
constexpr int kEndMilliseconds = 1000;  // from the end of its socket to its own

int milliseconds_until(Clock::time_point when) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(when - Clock::now()).count();
  return static_cast<int>(std::clamp<std::int64_t>(left, 0, std::numeric_limits<int>::max()));
}

bool becomes_readable(int descriptor, int milliseconds) {
  pollfd end{descriptor, POLLIN, 0};
  return ::poll(&end, 1, milliseconds) > 0;
}

int as_integer(double value) {
  constexpr double kLeast = std::numeric_limits<int>::min(), kMost = std::numeric_limits<int>::max();
  return std::isnan(value) ? 0 : static_cast<int>(std::clamp(value, kLeast, kMost));
}

std::string_view in_a_line(std::string_view text) {
  return text.substr(0, limits::kPluginLineBytes);
}

/// The answer of a section.
PluginFrame field_of(const PluginSection& section, const PluginFrame& frame, const FieldAsked& asked) {
  PluginFrame told{.kind = PluginFrameKind::kTold};
  const std::size_t element = frame.number;
  switch (static_cast<FieldQuestion>(frame.subtype)) {
    case FieldQuestion::kHas:
      told.time = section.has(asked.key);
      break;
    case FieldQuestion::kCount:
      told.time = static_cast<double>(section.count(asked.key));
      break;
    case FieldQuestion::kNumber:
      told.time = section.number(asked.key, frame.time, element);
      break;
    case FieldQuestion::kLength:
      told.time = section.length(asked.key, frame.time, element);
      break;
    case FieldQuestion::kAngle:
      told.time = section.angle(asked.key, frame.time, element);
      break;
    case FieldQuestion::kInteger:
      told.time = section.integer(asked.key, as_integer(frame.time), element);
      break;
    case FieldQuestion::kFlag:
      told.time = section.flag(asked.key, frame.time != 0);
      break;
    case FieldQuestion::kText:
      told.body = bytes_of_text(section.text(asked.key, asked.otherwise, element));
      break;
    case FieldQuestion::kFilename:
      told.body = bytes_of_text(section.filename(asked.key, asked.otherwise));
      break;
  }
  return told;
}

PluginFrame frame_of(PluginFrameKind kind, const Plugin::MessageKey& key, std::span<const std::byte> body) {
  return {.kind = kind,
          .subtype = key.second,
          .device = static_cast<std::uint32_t>(key.first),
          .body = {body.begin(), body.end()}};
}

/// One of those to other drivers that have no answer yet, as long as somebody may give one.
class OpenQuestion {
 public:
  explicit OpenQuestion(std::shared_ptr<std::atomic<std::size_t>> all) : all_(std::move(all)) { ++*all_; }
  ~OpenQuestion() { --*all_; }
  OpenQuestion(const OpenQuestion&) = delete;
  OpenQuestion& operator=(const OpenQuestion&) = delete;

 private:
  const std::shared_ptr<std::atomic<std::size_t>> all_;  // an answer may be dropped after the plug-in
};

}  // namespace

Result<std::unique_ptr<IsolatedPlugin>> IsolatedPlugin::start(IsolatedOptions options) {
  Result<std::unique_ptr<PluginProcess>> process = PluginProcess::start(options.program, options.name);
  if (!process) return process.error();
  return std::unique_ptr<IsolatedPlugin>(new IsolatedPlugin(std::move(options), std::move(*process)));
}

IsolatedPlugin::IsolatedPlugin(IsolatedOptions options, std::unique_ptr<PluginProcess> process)
    : options_(std::move(options)),
      process_(std::move(process)),
      out_(process_->socket()),
      questions_(std::make_shared<std::atomic<std::size_t>>(0)),
      in_(process_->socket()) {}

IsolatedPlugin::~IsolatedPlugin() {
  end(Clock::now());
}

void IsolatedPlugin::watch(ProcessEnded ended) {
  ended_ = std::move(ended);
  reader_ = std::thread([this] { read(); });
}

void IsolatedPlugin::kill(const std::string& why) {
  {
    const Lock lock(mutex_);
    if (why_.empty()) why_ = why;
  }
  process_->kill();
}

void IsolatedPlugin::end(Clock::time_point until) {
  if (!reader_.joinable()) return;
  {
    Lock lock(mutex_);
    is_ending_ = true;
    process_->hang_up();
    if (!changed_.wait_until(lock, until, [this] { return is_over_; })) {
      lock.unlock();
      log::warn("driver {} does not end; its process is killed", in_quotes(options_.name));
      kill("it does not end");
    }
  }
  reader_.join();
}

void IsolatedPlugin::configure(const PluginSection& section) {
  const auto until = Clock::now() + std::chrono::seconds(limits::kPluginStartSeconds);
  section_ = &section;
  begin();
  out_.offer({.kind = PluginFrameKind::kConfigure,
              .flag = options_.has_world(),
              .body = pack(PluginStart{options_.library.string(), provides_, uses_})});
  const auto is_done = [this] {
    const Lock lock(mutex_);
    return has_returned_ || is_over_;
  };
  while (!is_done())
    if (const int left = milliseconds_until(until); left == 0 || !read_some(left)) break;
  section_ = nullptr;
  Lock lock(mutex_);
  if (!has_returned_ && !is_over_)
    throw std::runtime_error(fmt::format("it is not configured within {} s", limits::kPluginStartSeconds));
  return_from_call(lock);
}

void IsolatedPlugin::open() {
  call({.kind = PluginFrameKind::kOpen, .flag = options_.has_world()});
}

void IsolatedPlugin::call(const PluginFrame& frame) {
  begin();
  out_.send(frame);  // where nobody is left to read it, its end is told soon
  Lock lock(mutex_);
  changed_.wait(lock, [this] { return has_returned_ || is_over_; });
  return_from_call(lock);
}

/// After a call that is under way, as that of configure() while an answer has come to what it asked.
void IsolatedPlugin::begin() {
  Lock lock(mutex_);
  changed_.wait(lock, [this] { return !is_called_; });
  is_called_ = true;
}

void IsolatedPlugin::return_from_call(const Lock&) {
  is_called_ = false;
  changed_.notify_all();
  if (!std::exchange(has_returned_, false)) throw std::runtime_error(why_);
  if (const std::optional<std::string> thrown = std::exchange(thrown_, std::nullopt))
    throw std::runtime_error(*thrown);
}

void IsolatedPlugin::call_request(MessageKey key, std::span<const std::byte> body, PluginReply reply) {
  std::uint64_t number = 0;
  {
    const Lock lock(mutex_);
    number = next_reply_++;
    if (!is_over_) replies_.emplace(number, std::move(reply));
  }
  PluginFrame request = frame_of(PluginFrameKind::kRequest, key, body);
  request.number = number;
  call(request);
}

void IsolatedPlugin::read() {
  while (read_some(-1)) continue;
}

/// False: the process has ended. It waits for nothing but this, or it would not see that end.
bool IsolatedPlugin::read_some(int milliseconds) {
  const short exchange = out_.is_waiting() ? POLLIN | POLLOUT : POLLIN;
  std::array<pollfd, 3> ends{{{process_->socket(), exchange, 0},
                              {has_output_ ? process_->output() : -1, POLLIN, 0},
                              {process_->ending(), POLLIN, 0}}};
  if (::poll(ends.data(), ends.size(), milliseconds) <= 0) return true;
  if (ends[1].revents != 0) tell_lines();
  if (ends[2].revents != 0) {
    for (int reads = 0; reads < kLastReads && in_.read(false) == FrameInput::ReadOutcome::kSome; ++reads)
      if (!take_frames()) break;
    has_ended();
    return false;
  }
  if ((ends[0].revents & POLLOUT) != 0) out_.flush();
  if ((ends[0].revents & ~POLLOUT) == 0) return true;
  if (in_.read(false) != FrameInput::ReadOutcome::kEnd) return take_frames() || (has_ended(), false);
  const bool follows = becomes_readable(process_->ending(), kEndMilliseconds);
  if (!follows) kill("its process has closed its socket");
  has_ended();
  return false;
}

/// False: a rule was broken, and the process was killed.
bool IsolatedPlugin::take_frames() {
  for (;;) {
    Result<std::optional<PluginFrame>> frame = in_.take();
    if (frame && !*frame) return true;
    const TakenFrame taken = frame ? take(**frame) : TakenFrame(frame.error());
    if (taken) continue;
    kill("its process broke the rules: " + taken.error().text);
    return false;
  }
}

/// Passes on what the process has printed, line by line.
void IsolatedPlugin::tell_lines() {
  std::array<char, 4096> text;
  for (int reads = 0; has_output_ && reads < kLastReads; ++reads) {
    const ssize_t got = ::read(process_->output(), text.data(), text.size());
    if (got < 0) break;
    if (got == 0) has_output_ = false;
    for (const char each : std::string_view(text.data(), static_cast<std::size_t>(got))) {
      if (each != '\n') line_ += each;
      if (each == '\n' || line_.size() >= limits::kPluginLineBytes) tell_line();
    }
  }
}

void IsolatedPlugin::tell_line() {
  const std::string line = escaped(std::exchange(line_, {}));
  if (!line.empty()) log::info("driver {}: {}", in_quotes(options_.name), line);
}

void IsolatedPlugin::has_ended() {
  process_->kill();  // of what is left of the exchange nobody shall wait for anything
  const PluginProcess::ProcessOutcome outcome = process_->wait();
  tell_lines();
  tell_line();
  std::string why;
  bool was_killed = false, was_to_end = false;
  {
    const Lock lock(mutex_);
    was_killed = !why_.empty();
    if (!was_killed) why_ = outcome.text;
    why = why_;
    was_to_end = is_ending_;
  }
  if (!was_to_end && ended_) ended_(why);
  if (was_to_end && !was_killed && !outcome.is_good)
    log::warn("driver {}: {}", in_quotes(options_.name), why);
  std::map<std::uint64_t, PluginReply> unanswered;  // destroyed without the mutex: NACK
  {
    const Lock lock(mutex_);
    unanswered.swap(replies_);
    is_over_ = true;
  }
  changed_.notify_all();
}

IsolatedPlugin::TakenFrame IsolatedPlugin::take(PluginFrame& frame) {
  switch (frame.kind) {
    case PluginFrameKind::kRegistered:
      return take_registered(frame);
    case PluginFrameKind::kReturned:
      return take_returned(frame);
    case PluginFrameKind::kAskTime:
      return tell({.kind = PluginFrameKind::kTold, .time = program_->time()});
    case PluginFrameKind::kAskField:
      return tell_field(frame);
    case PluginFrameKind::kPublish:
      program_->publish(frame.device, frame.subtype, std::move(frame.body), frame.time);
      return {};
    case PluginFrameKind::kCommandOther:
      program_->command(frame.device, frame.subtype, frame.body);
      return {};
    case PluginFrameKind::kAskOther:
      return take_question(frame);
    case PluginFrameKind::kReply:
      return take_reply(frame);
    case PluginFrameKind::kSay:
      program_->say(frame.flag, in_a_line(text_of(frame.body)));
      return {};
    default:
      return Error{"", fmt::format("it sent a frame of kind {}", static_cast<int>(frame.kind))};
  }
}

/// Who asks one question at a time has read the last answer.
IsolatedPlugin::TakenFrame IsolatedPlugin::tell(const PluginFrame& answer) {
  if (out_.is_waiting(last_told_)) return Error{"", "it asks again and has not read the answer"};
  last_told_ = out_.offer(answer);
  return {};
}

IsolatedPlugin::TakenFrame IsolatedPlugin::take_registered(const PluginFrame& frame) {
  std::optional<RegisteredKeys> keys = unpack_keys(frame.body, provides_.size() + uses_.size());
  const auto is_there = [this](const auto& passed_on) { return passed_on.second < uses_.size(); };
  if (section_ == nullptr || std::exchange(is_registered_, true) || !keys ||
      !std::ranges::all_of(keys->passed_on, is_there))
    return Error{"", "it registered what cannot be"};
  for (const MessageKey& key : keys->commands)
    registered_.commands[key] = [this, key](std::span<const std::byte> body) {
      call(frame_of(PluginFrameKind::kCommand, key, body));
    };
  for (const MessageKey& key : keys->requests)
    registered_.requests[key] = [this, key](std::span<const std::byte> body, PluginReply reply) {
      call_request(key, body, std::move(reply));
    };
  for (const auto& [key, used] : keys->passed_on)  // need not go to the process and back
    registered_.requests[key] = PassedOn{program_, used, key.second};
  for (const MessageKey& key : keys->data)
    registered_.data[key] = [this, key](std::span<const std::byte> body, double time) {
      PluginFrame datum = frame_of(PluginFrameKind::kDatum, key, body);
      datum.time = time;
      call(datum);
    };
  registered_.period = keys->period;
  return {};
}

IsolatedPlugin::TakenFrame IsolatedPlugin::take_returned(const PluginFrame& frame) {
  {
    const Lock lock(mutex_);
    if (!is_called_ || has_returned_) return Error{"", "it returned from a call that there was not"};
    has_returned_ = true;
    if (frame.flag) thrown_ = in_a_line(text_of(frame.body));
  }
  changed_.notify_all();
  return {};
}

IsolatedPlugin::TakenFrame IsolatedPlugin::tell_field(const PluginFrame& frame) {
  const std::optional<FieldAsked> asked = unpack_asked(frame.body);
  asked_of_section_ += frame.body.size();
  if (section_ == nullptr || !asked || frame.subtype > static_cast<std::uint8_t>(FieldQuestion::kFilename) ||
      asked_of_section_ > limits::kFileBytes)
    return Error{"", "it asked for fields of its section out of place"};
  return tell(field_of(*section_, frame, *asked));
}

IsolatedPlugin::TakenFrame IsolatedPlugin::take_question(const PluginFrame& frame) {
  if (*questions_ >= limits::kRequestQueue)
    return Error{"", fmt::format("more than {} requests wait for an answer", limits::kRequestQueue)};
  program_->ask(frame.device, frame.subtype, frame.body,
                [this, number = frame.number, open = std::make_shared<OpenQuestion>(questions_)](
                    bool ack, std::span<const std::byte> body) {
                  call({.kind = PluginFrameKind::kHeard,
                        .flag = ack,
                        .number = number,
                        .body = {body.begin(), body.end()}});
                });
  return {};
}

IsolatedPlugin::TakenFrame IsolatedPlugin::take_reply(PluginFrame& frame) {
  std::optional<PluginReply> reply;
  {
    const Lock lock(mutex_);
    const auto found = replies_.find(frame.number);
    if (found == replies_.end()) return Error{"", "it answered what nobody asked"};
    reply = std::move(found->second);
    replies_.erase(found);
  }
  reply->finish(frame.flag, std::move(frame.body));
  return {};
}

}  // namespace playhouse::drivers
