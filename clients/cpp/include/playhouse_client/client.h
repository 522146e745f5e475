#pragma once

/// Client: a connection to a Player server. Single-threaded: one thread per client and all its devices.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse_client/device.h"
#include "playhouse_client/model.h"

namespace playhouse::client {

inline constexpr std::uint16_t kDefaultPort = 6665;

/// Data delivery: pushed by the server at once, or in rounds requested by the client.
enum class Mode : std::uint8_t { kPush = 1, kPull = 2 };

struct Options {
  Mode mode = Mode::kPull;
  Seconds timeout{5.0};  // timeout of connect, of every request and of read()
  std::string token{};   // of a guest, for a run with --guests; empty: none
};

/// What the server does with a message for this client while a similar one is still queued.
enum class Rule : std::int32_t { kAccept = 0, kReplace = 1, kIgnore = 2 };

/// The messages a rule applies to; -1: any.
struct RuleScope {
  std::int32_t interf = -1;
  std::int32_t index = -1;
  std::int32_t type = -1;
  std::int32_t subtype = -1;
};

/// One line of the server's device list.
struct DeviceEntry {
  DeviceAddress address;
  std::string driver;
  std::string model;  // represented by the device, by full name; empty if the server publishes no names
  std::string robot;  // the top-level ancestor of that model, or itself

  /// "position2d:0".
  std::string name() const { return address.name(); }
};

class Robot;  // robot.h

class Client {
 public:
  static Result<Client> connect(const std::string& host, std::uint16_t port, const Options& options = {});
  /// `address` is "host", "host:port", ":port" or "[::1]:port"; what is missing is 127.0.0.1 and 6665.
  static Result<Client> connect(std::string_view address, const Options& options = {});

  Client(Client&&) noexcept = default;
  Client& operator=(Client&&) noexcept;
  /// As close(). Devices may outlive the client; they are then of no use, and harmless.
  ~Client();

  /// The server's greeting, e.g. "Player v.3.1".
  const std::string& banner() const;
  /// "127.0.0.1:6665".
  const std::string& peer() const;
  /// False once the server has disconnected or this client has closed.
  bool connected() const;

  /// The server's devices in its own order, each with its driver and the model it represents.
  Result<std::vector<DeviceEntry>> devices();

  /// All models of the simulated world, parents before children. An error if the
  /// server publishes no model names: it simulates nothing, or is not Playhouse.
  Result<std::vector<Model>> models();
  /// The top-level models with a device on this port, themselves or in their subtree,
  /// in the order of the world file. An error as with models(). Needs robot.h.
  Result<std::vector<Robot>> robots();
  /// The model of this full name with its subtree, for opening its devices. If names are equal, the last one
  /// is taken. Needs robot.h.
  Result<Robot> robot(std::string_view name);

  Result<void> set_mode(Mode mode);
  Result<void> set_replace_rule(Rule rule, const RuleScope& scope = {});

  /// Waits for the next data and dispatches them to the devices. Returns the number of
  /// messages: 0 on timeout, or if a device was retired before any came (Device::gone()).
  /// Pull mode: one round, i.e. everything the server has queued for this client; a round
  /// that times out is continued by the next call. Push mode: whatever has arrived. Errors:
  /// only a lost connection, a server that refuses, and a call from inside a callback.
  Result<std::size_t> read();
  Result<std::size_t> read(Seconds patience);

  /// Data messages dropped because they were not read in time, in this client or in the server.
  std::uint64_t overflow_count() const;
  /// Requests the number of data messages lost on the way to this client, in either mode: the server's count
  /// plus those dropped here. An error if the server does not support it.
  Result<std::uint64_t> lost_count();
  /// Messages without a receiver, and malformed ones.
  std::uint64_t skipped_count() const;

  /// Closes the connection; waits up to 1 s until the server has read everything that was sent.
  void close();

 private:
  friend class Device;
  explicit Client(std::shared_ptr<Session> session) : session_(std::move(session)) {}
  Result<void> authenticate(std::string_view token);
  Result<std::vector<Model>> told_models(const std::vector<DeviceAddress>& devices);

  std::shared_ptr<Session> session_;
};

/// "host:port", "[ipv6]:port" or "/FOLDER:port", for the Unix socket FOLDER/port, split into its parts, with
/// defaults; an error says what is wrong.
struct Address {
  std::string host = "127.0.0.1";  // not localhost, which a machine without /etc/hosts cannot resolve
  std::uint16_t port = kDefaultPort;
};
Result<Address> parse_address(std::string_view text);

}  // namespace playhouse::client
