#pragma once

/// One conversation with a server: whose an answer is, which data wait, when a round of data is over, and
/// which devices take the data. One thread.

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

/// Data that wait for the next read(); as many as libplayerc's ring holds. Older ones give way and are
/// counted.
inline constexpr std::size_t kWaitingMessages = 512;

/// An open device, as the session sees it.
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
  std::size_t kept_limit = 0;               // of bodies that stay until somebody takes them
  std::deque<std::vector<std::byte>> kept;  // the newest, in the order in which they came
  std::string gone;  // why nothing can be asked any more: the server retired the device; empty until then
  Device::OnData on_data;
};

class Session {
 public:
  Session(Connection connection, const Options& options)
      : connection_(std::move(connection)), timeout_(options.timeout) {}

  const Connection& connection() const { return connection_; }
  std::uint64_t overflow_count() const { return overflow_count_; }
  std::uint64_t skipped_count() const { return skipped_count_; }
  /// Of overflow_count(), those that were lost here.
  std::uint64_t unread_count() const { return unread_count_; }
  Seconds timeout() const { return timeout_; }

  Result<void> set_mode(Mode mode);

  /// Sends without waiting for anything. `sequence` goes into the header.
  Result<void> send(const wire::Header& address, std::span<const std::byte> body);

  /// Sends a request and waits for its ACK, whose body is the result. `what` names the request in errors.
  Result<std::vector<std::byte>> request(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype,
                                         std::span<const std::byte> body);
  Result<std::vector<std::byte>> request(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype,
                                         std::span<const std::byte> body, Deadline deadline);
  /// As request(), where a refusal is no error: none for NACK.
  Result<std::optional<std::vector<std::byte>>> ask(std::uint16_t interf, std::uint16_t index,
                                                    std::uint8_t subtype, std::span<const std::byte> body,
                                                    Deadline deadline);

  /// The same with the whole answer, which is ACK or NACK.
  Result<Message> exchange(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype,
                           std::span<const std::byte> body, Deadline deadline);

  Result<std::size_t> read(Seconds patience);
  /// In push mode, hands the data that have come to the devices without waiting for more.
  void deliver_pushed();

  /// `slot` must stay where it is until remove().
  void add(Slot& slot);
  void remove(Slot& slot);
  /// One that has retired is not open.
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
  std::string describe(const Key& key) const;

  Connection connection_;
  Seconds timeout_;
  Mode mode_ = Mode::kPush;  // what a server starts with
  bool round_open_ = false;
  bool round_waits_ = false;  // a round ended while a request waited: its data are in waiting_
  bool reading_ = false;
  bool told_ = false;  // in this read(), that a device has retired
  std::uint64_t overflow_count_ = 0;
  std::uint64_t skipped_count_ = 0;
  std::uint64_t unread_count_ = 0;
  std::uint32_t sequence_ = 0;
  std::vector<Key> abandoned_;  // requests whose answer did not come in time
  std::deque<Message> waiting_;
  std::vector<Slot*> slots_;
};

}  // namespace playhouse::client
