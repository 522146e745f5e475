#pragma once

/// Outbox: queue of data and replies from drivers on any thread to the io thread, in order, in batches.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <variant>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/device/driver.h"

namespace playhouse::server {

struct Answer {
  std::uint64_t ticket = 0;
  bool ack = false;
  std::vector<std::byte> body;
};

/// Data queued for clients are void.
struct Forget {};

class Outbox {
 public:
  /// `data_bytes`: of data the io thread has not taken yet.
  explicit Outbox(std::size_t data_bytes = limits::kOutboxBytes) : most_bytes_(data_bytes) {}

  using OutboxItem = std::variant<device::Publication, Answer, Forget>;

  /// True if the io thread has to be woken: the outbox was empty. If the io thread lags by more
  /// bytes of data than that, or by limits::kOutboxMessages, queued data is dropped in favour of
  /// the new; replies never are.
  [[nodiscard]] bool put(std::vector<device::Publication> batch);
  [[nodiscard]] bool put(Answer answer);
  /// Removes the queued data.
  [[nodiscard]] bool put(Forget forget);
  /// Moves the oldest items, at most this many, to `items`. True
  /// if there are more: call again, no wake-up will follow.
  bool take(std::vector<OutboxItem>& items, std::size_t most);
  std::uint64_t data_dropped() const;
  /// Messages dropped since the last call, by device.
  std::map<device::DeviceId, std::uint64_t> take_dropped();

 private:
  void drop_data();  // holding the mutex
  bool wake();       // holding the mutex

  const std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::deque<OutboxItem> items_;
  std::size_t data_messages_ = 0, data_bytes_ = 0;
  std::uint64_t dropped_ = 0;
  std::map<device::DeviceId, std::uint64_t> dropped_of_;  // since take_dropped()
  bool woken_ = false;
};

}  // namespace playhouse::server
