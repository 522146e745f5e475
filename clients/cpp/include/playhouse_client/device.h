#pragma once

/// Device: one open device of any interface. The proxies (position2d.h, ranger.h, ...) are made of it.
/// Values are those of playhouse/wire/generated: SI units, radians. One thread per client and all its
/// devices.

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

/// What a program wants to do with a device. The character codes are those of Player's first servers.
enum class Access : std::uint8_t { kAll = 1, kRead = 'r', kWrite = 'w' };

/// A payload for messages that have none.
struct Nothing {};

class Device {
 public:
  /// Data as they come, from inside Client::read(): the subtype, a body that decodes as the message of that
  /// subtype, and the server's time (s).
  using OnData = std::function<void(std::uint8_t subtype, std::span<const std::byte> body, double timestamp)>;

  /// Opens a device. An error if the server has no such device or refuses it.
  static Result<Device> open(Client& client, std::uint16_t interf, std::uint16_t index,
                             Access access = Access::kAll);

  Device(Device&&) noexcept;
  Device& operator=(Device&&) noexcept;
  /// Closes the device, if it is open and the server still there.
  ~Device();

  /// False after close() and in what was moved from.
  bool is_open() const { return slot_ != nullptr; }
  /// Client::read() was told that the server has retired the device. Requests and commands are errors from
  /// then on, the last data stay, and close() has nothing to do. Until read() comes to it the server refuses
  /// requests and drops commands.
  bool gone() const;
  /// False once the server is gone or the client closed.
  bool connected() const;
  std::uint16_t interf() const;
  std::uint16_t index() const;
  /// "position2d:0", also after close().
  const std::string& name() const { return name_; }
  /// Name of the driver behind the device.
  std::string driver() const;

  /// Asks and waits for the answer: Reply as it decodes, or nothing for Reply = Nothing. NACK, silence and a
  /// lost connection are errors.
  template <typename Reply = Nothing, typename Payload = Nothing>
  Result<Reply> request(std::uint8_t subtype, const Payload& payload = {});

  /// As request(), for questions that a server may well refuse: none for NACK.
  template <typename Reply, typename Payload = Nothing>
  Result<std::optional<Reply>> ask(std::uint8_t subtype, const Payload& payload = {});

  /// Sends a command; the server carries it out without an answer.
  template <typename Payload = Nothing>
  Result<void> command(std::uint8_t subtype, const Payload& payload = {});

  /// The last data of a subtype: none before the first, or if they are no T.
  template <typename T>
  std::optional<T> latest(std::uint8_t subtype) const;

  /// The server's time (s) at the last data; 0 before the first.
  double timestamp() const;
  /// The same at the last data of a subtype.
  double timestamp(std::uint8_t subtype) const;

  /// Whether data have come since the last call of this function.
  bool take_fresh();

  /// Replaces the callback; an empty one ends it.
  void on_data(OnData callback);

  /// Properties, by key. The server refuses keys it does not have.
  Result<bool> get_bool(std::string_view key);
  Result<std::int32_t> get_int(std::string_view key);
  Result<double> get_double(std::string_view key);
  Result<std::string> get_string(std::string_view key);
  Result<void> set_bool(std::string_view key, bool value);
  Result<void> set_int(std::string_view key, std::int32_t value);
  Result<void> set_double(std::string_view key, double value);
  Result<void> set_string(std::string_view key, std::string_view value);

  /// Whether the driver says that it understands a kind of message. Many drivers never say so.
  bool has_capability(wire::MessageType type, std::uint8_t subtype);

  /// Closes the device; a second call does nothing.
  Result<void> close();

 private:
  friend class Opaque;
  friend class Robot;
  friend class Simulation;
  friend class SpeechRecognition;
  static Result<Device> open(const std::shared_ptr<Session>& session, std::uint16_t interf,
                             std::uint16_t index, Access access);
  Device(std::shared_ptr<Session> session, std::unique_ptr<Slot> slot);
  using Bytes = std::vector<std::byte>;
  Result<Bytes> request_bytes(std::uint8_t subtype, std::span<const std::byte> body);
  Result<std::optional<Bytes>> ask_bytes(std::uint8_t subtype, std::span<const std::byte> body);
  Result<void> command_bytes(std::uint8_t subtype, std::span<const std::byte> body);
  const std::vector<std::byte>* latest_bytes(std::uint8_t subtype) const;
  /// Bodies of data stay until take_kept(), the newest so many, in the order in which they came.
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
