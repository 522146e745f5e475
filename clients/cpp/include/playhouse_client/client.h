#pragma once

/// Client: a program's connection to a Player server. One thread per client and all its devices.

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

/// When the server sends data: at once, or in rounds that the client asks for.
enum class Mode : std::uint8_t { kPush = 1, kPull = 2 };

struct Options {
  Mode mode = Mode::kPull;
  Seconds timeout{5.0};  // patience of connecting, of every request and of read()
};

/// What happens to a message for this client when one like it is still waiting in the server.
enum class Rule : std::int32_t { kAccept = 0, kReplace = 1, kIgnore = 2 };

/// The messages that a rule is about; -1 stands for any.
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
  std::string model;  // that it shows, by its full name; empty where the server tells no names
  std::string robot;  // the model at the top that carries that one, or is it

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

  /// What the server said first, "Player v.3.1" for instance.
  const std::string& banner() const;
  /// "127.0.0.1:6665".
  const std::string& peer() const;
  /// False once the server is gone or this client closed.
  bool connected() const;

  /// What the server offers, in its own order, with the driver behind each device and the model it shows.
  Result<std::vector<DeviceEntry>> devices();

  /// Every model of the simulated world, parents before children. An error where the server tells no names:
  /// it simulates nothing, or is not this program.
  Result<std::vector<Model>> models();
  /// The models at the top that have a device on this port, themselves or by what they carry; their order is
  /// the world file's. An error as with models(). Needs robot.h.
  Result<std::vector<Robot>> robots();
  /// The model of this full name and what it carries, for opening its devices. Of equal names the last is
  /// meant. Needs robot.h.
  Result<Robot> robot(std::string_view name);

  Result<void> set_mode(Mode mode);
  Result<void> set_replace_rule(Rule rule, const RuleScope& scope = {});

  /// Waits for the next data and hands them to the devices; how many messages there were, 0 if none came in
  /// time, or before it was told that a device is gone (Device::gone()). In pull mode this is one round:
  /// everything the server holds for this client; a round that is not complete in time goes on in the next
  /// call. In push mode it is what has arrived. The only errors are a lost connection, a refusing server and
  /// a call from inside a callback.
  Result<std::size_t> read();
  Result<std::size_t> read(Seconds patience);

  /// Data messages that were lost because they were not read in time, here or in the server.
  std::uint64_t overflow_count() const;
  /// Asks how many data messages were lost on their way to this client, in any mode: the server's number, and
  /// those that were not read here in time. An error where the server does not tell.
  Result<std::uint64_t> lost_count();
  /// Messages that nobody waited for or that made no sense.
  std::uint64_t skipped_count() const;

  /// Ends the connection; waits up to a second until the server has read everything that was sent.
  void close();

 private:
  friend class Device;
  explicit Client(std::shared_ptr<Session> session) : session_(std::move(session)) {}
  Result<std::vector<Model>> told_models(const std::vector<DeviceAddress>& devices);

  std::shared_ptr<Session> session_;
};

/// "host:port" or "[ipv6]:port" and its parts with their defaults, or an error that says what is wrong.
struct Address {
  std::string host = "127.0.0.1";  // not localhost, which a machine without /etc/hosts cannot resolve
  std::uint16_t port = kDefaultPort;
};
Result<Address> parse_address(std::string_view text);

}  // namespace playhouse::client
