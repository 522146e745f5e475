#pragma once

/// Session with a server: matches answers to requests, queues data, tracks
/// rounds of pull mode, and dispatches data to devices. Single-threaded.

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "connection.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

/// Capacity of the queue of data for the next read(), as in libplayerc. Overflow drops the oldest and counts
/// it.
inline constexpr std::size_t kWaitingMessages = 512;

/// State of an open device in the session.
struct Slot {
  std::uint16_t interf = 0;
  std::uint16_t index = 0;
  std::string driver;
  struct Latest {
    std::vector<std::byte> body;
    double timestamp = 0;  // s
  };
  std::map<std::uint8_t, Latest> latest;  // by subtype
  double timestamp = 0;                   // s
  bool fresh = false;
  std::size_t kept_limit = 0;               // capacity of `kept`
  std::deque<std::vector<std::byte>> kept;  // the newest bodies, in order of arrival
  std::string gone;  // the reason, once the server has retired the device; empty until then
  Device::OnData on_data;
};

class Session {
 public:
  Session(Connection connection, const Options& options)
      : connection_(std::move(connection)), timeout_(options.timeout), has_token_(!options.token.empty()) {}

  const Connection& connection() const { return connection_; }
  std::uint64_t overflow_count() const { return overflow_count_; }
  std::uint64_t skipped_count() const { return skipped_count_; }
  /// The part of overflow_count() that was dropped in this client.
  std::uint64_t unread_count() const { return unread_count_; }
  Seconds timeout() const { return timeout_; }

  Result<void> set_mode(Mode mode);

  /// Sends a message without waiting for an answer; fills in time and port.
  Result<void> send(const wire::Header& address, std::span<const std::byte> body);

  /// Sends a request and waits for its ACK; returns its body. NACK and timeout are errors.
  Result<std::vector<std::byte>> request(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype,
                                         std::span<const std::byte> body);
  Result<std::vector<std::byte>> request(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype,
                                         std::span<const std::byte> body, Deadline deadline);
  /// As request(), but a refusal is a result: none for NACK.
  Result<std::optional<std::vector<std::byte>>> ask(std::uint16_t interf, std::uint16_t index,
                                                    std::uint8_t subtype, std::span<const std::byte> body,
                                                    Deadline deadline);

  /// As request(), but returns the whole answer, ACK or NACK.
  Result<Message> exchange(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype,
                           std::span<const std::byte> body, Deadline deadline);

  Result<std::size_t> read(Seconds patience);
  /// Push mode: dispatches the data that have arrived, without waiting for more.
  void deliver_pushed();
  /// Drops all data received so far: the run that they are of is over.
  void forget_run();

  /// `slot` must keep its address until remove().
  void add(Slot& slot);
  void remove(Slot& slot);
  /// False for retired devices.
  bool has_open(std::uint16_t interf, std::uint16_t index) const;

  void close();

 private:
  struct Key {
    std::uint16_t interf;
    std::uint16_t index;
    std::uint8_t subtype;
    friend bool operator==(const Key&, const Key&) = default;
  };
  enum class Match { kOther, kOurs, kLate };

  Result<Message> answer(const Key& key, Deadline deadline);
  Match match(const wire::Header& header, const Key& key) const;
  bool is_abandoned(const Key& key) const;
  void sort(Message message);
  bool take_notice(const Message& message);
  void drop_waiting(std::uint16_t interf, std::uint16_t index);
  void end_round(const Message& message);
  Result<bool> sort_next(Deadline deadline);
  Result<std::size_t> read_round(Deadline deadline);
  Result<std::size_t> read_pushed(Deadline deadline);
  std::size_t deliver();
  bool deliver_one(const Message& message);
  bool goes_back(const wire::Header& header) const;
  void forget_later(double timestamp);
  std::string describe(const Key& key) const;
  Error refusal(const Key& key, const Message& answer) const;

  Connection connection_;
  Seconds timeout_;
  bool has_token_;
  Mode mode_ = Mode::kPush;  // the server's initial mode
  bool round_open_ = false;
  bool round_waits_ = false;  // a round ended while a request was pending: its data are in waiting_
  bool reading_ = false;
  bool told_ = false;  // this read() received notice that a device was retired
  std::uint64_t overflow_count_ = 0;
  std::uint64_t skipped_count_ = 0;
  std::uint64_t unread_count_ = 0;
  std::uint32_t sequence_ = 0;
  std::vector<Key> abandoned_;  // requests that timed out
  std::deque<Message> waiting_;
  std::vector<Slot*> slots_;
};

}  // namespace playhouse::client
