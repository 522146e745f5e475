#pragma once

/// Subscription: what a driver has got of another device and not taken yet. It is bounded: when it is full
/// the oldest message gives way to the newest, and the loss is counted. A subscription of one message is the
/// latest value. Any thread.

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
  /// `subtype` of DATA messages, all of them if none; `limit` messages wait at most, at least 1.
  Subscription(std::optional<std::uint8_t> subtype, std::size_t limit);

  /// Everything that waits, in the order in which it was published.
  std::vector<Publication> take();
  /// The newest that waits; what is older is dropped, and counted as lost. None if nothing waits.
  std::optional<Publication> take_latest();
  /// Messages that gave way to newer ones, since the start.
  std::uint64_t lost() const;

  /// Puts a copy of the message in, if it is of the subtype wanted.
  void put(const Publication& publication);
  /// Drops what waits, which counts as no loss.
  void clear();

 private:
  const std::optional<std::uint8_t> subtype_;
  const std::size_t limit_;
  mutable std::mutex mutex_;  // guards what follows
  std::deque<Publication> waiting_;
  std::uint64_t lost_ = 0;
};

}  // namespace playhouse::device
