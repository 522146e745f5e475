#pragma once

/// Plugin: base class of a driver in a shared library, for devices that the program has no driver for. A section
/// of a configuration file names the library, `driver ( name "counter" plugin "counter" provides ["aio:0"] )`;
/// docs/plugins.md is a tutorial. Changes only together with kPluginVersion; libraries built for versions from
/// kPluginVersionLeast on still load. One object for each section. Its hooks are called one at a time, on a
/// thread of the driver's own once the server runs, so they may wait for hardware; a hook that throws, or takes
/// longer than limits::kPluginSeconds, ends the driver: its devices retire. With `isolated 1` all of it is in a
/// process of its own, and a crash does so, too. Values are those of
/// playhouse/wire/generated/INTERFACE.h; numbers of devices are their places in the file's list.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {

inline constexpr std::uint32_t kPluginVersion = 1;
inline constexpr std::uint32_t kPluginVersionLeast = 1;

/// A device of `provides` or `requires`.
struct PluginDevice {
  std::string key;     // "odometry" of "odometry:::position2d:0"
  std::string interf;  // "position2d"
  std::uint16_t code = 0, index = 0;
  std::uint32_t port = 0;
};

/// Fields of the driver's section. An absent one is `otherwise`; a malformed one ends the program with its line.
class PluginSection {
 public:
  virtual ~PluginSection() = default;
  virtual bool has(std::string_view key) const = 0;
  /// Elements of a tuple; 0 if absent, 1 for a single value.
  virtual std::size_t count(std::string_view key) const = 0;
  virtual double number(std::string_view key, double otherwise, std::size_t element = 0) const = 0;
  virtual double length(std::string_view key, double otherwise, std::size_t element = 0) const = 0;  // m
  virtual double angle(std::string_view key, double otherwise, std::size_t element = 0) const = 0;   // rad
  virtual int integer(std::string_view key, int otherwise, std::size_t element = 0) const = 0;
  virtual bool flag(std::string_view key, bool otherwise) const = 0;
  virtual std::string text(std::string_view key, std::string_view otherwise,
                           std::size_t element = 0) const = 0;
  /// A path, relative to the folder of the file.
  virtual std::string filename(std::string_view key, std::string_view otherwise) const = 0;
};

/// The one answer to a request. Destroyed unused it is NACK. Any thread.
class PluginReply {
 public:
  using SendAnswer = std::function<void(bool ack, std::vector<std::byte> body)>;
  explicit PluginReply(SendAnswer send) : send_(std::move(send)) {}
  PluginReply(PluginReply&& other) noexcept : send_(std::exchange(other.send_, nullptr)) {}
  PluginReply& operator=(PluginReply&& other) noexcept {
    std::swap(send_, other.send_);
    return *this;
  }
  ~PluginReply() { finish(false, {}); }

  void ack() { finish(true, {}); }
  template <typename T>
  void ack(const T& value) {
    finish(true, wire::encode(value));
  }
  void nack() { finish(false, {}); }

 private:
  friend class IsolatedPlugin;  // passes on answers as they are
  friend struct PassedOn;       // likewise
  void finish(bool good, std::vector<std::byte> body) {
    if (const SendAnswer send = std::exchange(send_, nullptr)) send(good, std::move(body));
  }
  SendAnswer send_;
};

/// What the program does for a plug-in. Any thread; once the driver has ended, nothing.
class PluginProgram {
 public:
  using AnswerHeard = std::function<void(bool ack, std::span<const std::byte> body)>;
  virtual ~PluginProgram() = default;
  virtual double time() const = 0;
  virtual void publish(std::size_t provided, std::uint8_t subtype, std::vector<std::byte> body,
                       double timestamp) = 0;
  virtual void command(std::size_t used, std::uint8_t subtype, std::span<const std::byte> body) = 0;
  virtual void ask(std::size_t used, std::uint8_t subtype, std::span<const std::byte> body,
                   AnswerHeard heard) = 0;
  virtual void say(bool is_warning, std::string_view line) = 0;
};

/// What Plugin::pass_on() registers. The program looks for it, so that the device of `provides` tells the
/// capabilities of the other one.
struct PassedOn {
  PluginProgram* program = nullptr;
  std::size_t used = 0;
  std::uint8_t subtype = 0;
  void operator()(std::span<const std::byte> body, PluginReply reply) const {
    const auto shared = std::make_shared<PluginReply>(std::move(reply));  // a std::function must be copyable
    program->ask(used, subtype, body, [shared](bool ack, std::span<const std::byte> answer) {
      shared->finish(ack, {answer.begin(), answer.end()});
    });
  }
};

class Plugin {
 public:
  virtual ~Plugin() = default;

  /// Reads the section and registers what it takes, once, before the server runs. A std::exception rejects the
  /// section; its text is shown to the user.
  virtual void configure(const PluginSection& section) = 0;
  /// The first of its devices was opened, and all that it requires are open.
  virtual void open() {}
  /// The last was closed. Stop what moves.
  virtual void close() {}
  /// Every step_every() seconds while a device is open.
  virtual void step() {}

  /// What was registered, for the program.
  using MessageKey = std::pair<std::size_t, std::uint8_t>;  // number of the device, subtype
  struct Registered {
    std::map<MessageKey, std::function<void(std::span<const std::byte>)>> commands;
    std::map<MessageKey, std::function<void(std::span<const std::byte>, PluginReply)>> requests;
    std::map<MessageKey, std::function<void(std::span<const std::byte>, double)>>
        data;           // of required devices
    double period = 0;  // s; 0: no steps
  };
  const Registered& registered() const { return registered_; }
  /// For the program, before configure(): `program` outlives the plug-in.
  void join(PluginProgram& program, std::vector<PluginDevice> provides, std::vector<PluginDevice> uses) {
    program_ = &program;
    provides_ = std::move(provides);
    uses_ = std::move(uses);
  }

 protected:
  /// The devices of the section.
  std::span<const PluginDevice> provides() const { return provides_; }
  std::span<const PluginDevice> uses() const { return uses_; }

  // In configure(). A command or request that is not registered is refused, and so is a body that is no T.

  template <typename T>
  void on_command(std::size_t provided, std::uint8_t subtype, std::function<void(const T&)> take) {
    registered_.commands[{provided, subtype}] = [take = std::move(take)](std::span<const std::byte> body) {
      if (const Result<T> value = wire::decode<T>(body)) take(*value);
    };
  }
  /// Of a request with a body.
  template <typename T>
  void on_request(std::size_t provided, std::uint8_t subtype,
                  std::function<void(const T&, PluginReply)> answer) {
    registered_.requests[{provided, subtype}] = [answer = std::move(answer)](std::span<const std::byte> body,
                                                                             PluginReply reply) {
      if (const Result<T> value = wire::decode<T>(body)) answer(*value, std::move(reply));
    };
  }
  /// Of one without, as a question for a value.
  void on_request(std::size_t provided, std::uint8_t subtype, std::function<void(PluginReply)> answer) {
    registered_.requests[{provided, subtype}] = [answer = std::move(answer)](std::span<const std::byte>,
                                                                             PluginReply reply) {
      answer(std::move(reply));
    };
  }
  /// All requests to a device of `provides` that are not registered go to one of `requires`, of the same
  /// interface, whose answer becomes theirs.
  void pass_on(std::size_t provided, std::size_t used) {
    if (provided >= provides_.size() || used >= uses_.size())
      throw std::invalid_argument("requests of a device are passed on which the section does not name");
    if (provides_[provided].code != uses_[used].code)
      throw std::invalid_argument("requests to " + provides_[provided].interf + " are not those to " +
                                  uses_[used].interf);
    for (unsigned subtype = 0; subtype <= 0xFF; ++subtype) {
      const auto key = static_cast<std::uint8_t>(subtype);
      if (wire::find_message(uses_[used].code, wire::MessageType::kReq, key) != nullptr)
        registered_.requests.try_emplace({provided, key}, PassedOn{program_, used, key});
    }
  }
  /// Data of a required device, with their time [s]. If they come faster than they are taken, the latest.
  template <typename T>
  void on_data(std::size_t used, std::uint8_t subtype, std::function<void(const T&, double time)> take) {
    registered_.data[{used, subtype}] = [take = std::move(take)](std::span<const std::byte> body,
                                                                 double time) {
      if (const Result<T> value = wire::decode<T>(body)) take(*value, time);
    };
  }
  /// At least limits::kPluginStepSeconds.
  void step_every(double seconds) { registered_.period = seconds; }

  // Any thread.

  /// Of the simulated world, if the file has one; else since 1970. [s]
  double time() const { return program_->time(); }
  /// Sends DATA to all clients of a device of `provides`, stamped with `timestamp`, or the time of now.
  template <typename T>
  void publish(std::size_t provided, std::uint8_t subtype, const T& value,
               std::optional<double> timestamp = {}) {
    program_->publish(provided, subtype, wire::encode(value), timestamp.value_or(time()));
  }
  /// To a device of `requires`.
  template <typename T>
  void command(std::size_t used, std::uint8_t subtype, const T& value) {
    program_->command(used, subtype, wire::encode(value));
  }
  /// What takes the answer to a request: a T, or none for NACK; without a T whether it was ACK.
  template <typename T>
  using AnswerTo = std::conditional_t<std::is_void_v<T>, std::function<void(bool ack)>,
                                      std::function<void(std::optional<T>)>>;
  /// Asks a device of `requires`; the answer comes as a hook does.
  template <typename T = void>
  void ask(std::size_t used, std::uint8_t subtype, AnswerTo<T> heard) {
    program_->ask(used, subtype, {}, taken_by<T>(std::move(heard)));
  }
  /// By a request with a body.
  template <typename T = void, typename Body>
  void ask(std::size_t used, std::uint8_t subtype, const Body& body, AnswerTo<T> heard) {
    program_->ask(used, subtype, wire::encode(body), taken_by<T>(std::move(heard)));
  }
  /// Lines of the log.
  void inform(std::string_view line) { program_->say(false, line); }
  void warn(std::string_view line) { program_->say(true, line); }

 private:
  friend class IsolatedPlugin;  // stands for one in a process of its own
  template <typename T>
  static PluginProgram::AnswerHeard taken_by(AnswerTo<T> heard) {
    return [heard = std::move(heard)](bool ack, std::span<const std::byte> body) {
      if constexpr (std::is_void_v<T>) {
        heard(ack);
      } else {
        const Result<T> value = ack ? wire::decode<T>(body) : Result<T>(Error{});
        heard(value ? std::optional<T>(*value) : std::nullopt);
      }
    };
  }
  Registered registered_;
  PluginProgram* program_ = nullptr;
  std::vector<PluginDevice> provides_, uses_;
};

}  // namespace playhouse::drivers

/// Exports the class that a library provides; use it once, outside any namespace.
#define PLAYHOUSE_DRIVER(Type)                                                                              \
  extern "C" __attribute__((visibility("default"))) std::uint32_t playhouse_driver_version() {              \
    return ::playhouse::drivers::kPluginVersion;                                                            \
  }                                                                                                         \
  extern "C" __attribute__((visibility("default"))) ::playhouse::drivers::Plugin* playhouse_driver_make() { \
    return new Type;                                                                                        \
  }
