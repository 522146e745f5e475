#pragma once

/// Subscription: bounded queue of another device's data, for a
/// driver. When full, the oldest message is dropped and counted.
/// With a limit of one it holds the latest value. Any thread.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "playhouse/device/driver.h"

namespace playhouse::device {

class Subscription {
 public:
  /// `subtype` of DATA messages, none: all; `limit`: capacity, at least 1.
  Subscription(std::optional<std::uint8_t> subtype, std::size_t limit);

  /// All queued messages, in order of publication.
  std::vector<Publication> take();
  /// The latest queued message; older ones are dropped and counted as lost. None if empty.
  std::optional<Publication> take_latest();
  /// Number of dropped messages.
  std::uint64_t lost() const;

  /// Appends a copy of the message if it has the subscribed subtype.
  void put(const Publication& publication);
  /// Empties the queue without counting losses.
  void clear();

 private:
  const std::optional<std::uint8_t> subtype_;
  const std::size_t limit_;
  mutable std::mutex mutex_;  // guards what follows
  std::deque<Publication> waiting_;
  std::uint64_t lost_ = 0;
};

}  // namespace playhouse::device
