#pragma once

/// Device: one open device of any interface; the proxies (position2d.h, ranger.h, ...) wrap one. Payloads are
/// the structs of playhouse/wire/generated: SI units, radians. Single-threaded: one thread per client and all
/// its devices.

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/messages.h"

namespace playhouse::client {

class Client;
class Session;
struct Slot;

using Seconds = std::chrono::duration<double>;

/// Requested access to a device. The character codes are those of the first Player servers.
enum class Access : std::uint8_t { kAll = 1, kRead = 'r', kWrite = 'w' };

/// An empty payload.
struct Nothing {};

class Device {
 public:
  /// Data callback, invoked inside Client::read(): subtype, a body that
  /// decodes as the message of that subtype, and the server's time [s].
  using OnData = std::function<void(std::uint8_t subtype, std::span<const std::byte> body, double timestamp)>;

  /// Opens a device. An error if the server has no such device or refuses it.
  static Result<Device> open(Client& client, std::uint16_t interf, std::uint16_t index,
                             Access access = Access::kAll);

  Device(Device&&) noexcept;
  Device& operator=(Device&&) noexcept;
  /// Closes the device if it is open and the server is still connected.
  ~Device();

  /// False after close() and after a move from this object.
  bool is_open() const { return slot_ != nullptr; }
  /// True once Client::read() has received the notice that the server retired the device.
  /// From then on requests and commands are errors, the last data stay, and close() is a
  /// no-op. Before read() receives it, the server refuses requests and drops commands.
  bool gone() const;
  /// False once the server has disconnected or the client has closed.
  bool connected() const;
  std::uint16_t interf() const;
  std::uint16_t index() const;
  /// "position2d:0", also after close().
  const std::string& name() const { return name_; }
  /// Name of the driver behind the device.
  std::string driver() const;

  /// Sends a request and waits for its answer, decoded as Reply (ignored for Reply = Nothing). NACK, timeout
  /// and a lost connection are errors.
  template <typename Reply = Nothing, typename Payload = Nothing>
  Result<Reply> request(std::uint8_t subtype, const Payload& payload = {});

  /// As request(), where a refusal is an expected result: none for NACK.
  template <typename Reply, typename Payload = Nothing>
  Result<std::optional<Reply>> ask(std::uint8_t subtype, const Payload& payload = {});

  /// Sends a command; the server does not acknowledge commands.
  template <typename Payload = Nothing>
  Result<void> command(std::uint8_t subtype, const Payload& payload = {});

  /// The newest data of a subtype; none before the first, or if they do not decode as T.
  template <typename T>
  std::optional<T> latest(std::uint8_t subtype) const;

  /// The server's time [s] of the newest data; 0 before the first.
  double timestamp() const;
  /// The same for the newest data of a subtype.
  double timestamp(std::uint8_t subtype) const;

  /// Whether data have arrived since the last call; resets the flag.
  bool take_fresh();

  /// Replaces the data callback; an empty one removes it.
  void on_data(OnData callback);

  /// Properties by key; the server refuses unknown keys.
  Result<bool> get_bool(std::string_view key);
  Result<std::int32_t> get_int(std::string_view key);
  Result<double> get_double(std::string_view key);
  Result<std::string> get_string(std::string_view key);
  Result<void> set_bool(std::string_view key, bool value);
  Result<void> set_int(std::string_view key, std::int32_t value);
  Result<void> set_double(std::string_view key, double value);
  Result<void> set_string(std::string_view key, std::string_view value);

  /// Whether the driver reports support for a kind of message. Many drivers never report any.
  bool has_capability(wire::MessageType type, std::uint8_t subtype);

  /// Closes the device; a second call does nothing.
  Result<void> close();

 private:
  friend class Keeping;
  friend class Robot;
  friend class Simulation;
  static Result<Device> open(const std::shared_ptr<Session>& session, std::uint16_t interf,
                             std::uint16_t index, Access access);
  Device(std::shared_ptr<Session> session, std::unique_ptr<Slot> slot);
  using Bytes = std::vector<std::byte>;
  Result<Bytes> request_bytes(std::uint8_t subtype, std::span<const std::byte> body);
  Result<std::optional<Bytes>> ask_bytes(std::uint8_t subtype, std::span<const std::byte> body);
  Result<void> command_bytes(std::uint8_t subtype, std::span<const std::byte> body);
  const std::vector<std::byte>* latest_bytes(std::uint8_t subtype) const;
  /// Queues bodies of data for take_kept(): the newest `most`, in order of arrival.
  void keep(std::size_t most);
  std::deque<Bytes> take_kept();
  Error undecoded(std::uint8_t subtype, std::string_view what) const;
  Result<void> usable() const;

  std::shared_ptr<Session> session_;
  std::unique_ptr<Slot> slot_;  // none when closed
  std::string name_;            // "position2d:0"
};

namespace internal {

template <typename Payload>
std::vector<std::byte> bytes_of(const Payload& payload) {
  return wire::encode(payload);
}
inline std::vector<std::byte> bytes_of(const Nothing&) {
  return {};
}

}  // namespace internal

template <typename Reply, typename Payload>
Result<Reply> Device::request(std::uint8_t subtype, const Payload& payload) {
  const Result<std::vector<std::byte>> answer = request_bytes(subtype, internal::bytes_of(payload));
  if (!answer) return answer.error();
  if constexpr (std::is_same_v<Reply, Nothing>) {
    return Nothing{};
  } else {
    Result<Reply> reply = wire::decode<Reply>(*answer);
    return reply ? reply : undecoded(subtype, reply.error().text);
  }
}

template <typename Reply, typename Payload>
Result<std::optional<Reply>> Device::ask(std::uint8_t subtype, const Payload& payload) {
  const Result<std::optional<Bytes>> answer = ask_bytes(subtype, internal::bytes_of(payload));
  if (!answer) return answer.error();
  if (!*answer) return std::optional<Reply>();
  Result<Reply> reply = wire::decode<Reply>(**answer);
  if (!reply) return undecoded(subtype, reply.error().text);
  return std::optional<Reply>(std::move(*reply));
}

template <typename Payload>
Result<void> Device::command(std::uint8_t subtype, const Payload& payload) {
  return command_bytes(subtype, internal::bytes_of(payload));
}

template <typename T>
std::optional<T> Device::latest(std::uint8_t subtype) const {
  const std::vector<std::byte>* body = latest_bytes(subtype);
  if (body == nullptr) return std::nullopt;
  Result<T> value = wire::decode<T>(*body);
  if (!value) return std::nullopt;
  return std::move(*value);
}

}  // namespace playhouse::client
