#pragma once

/// Hand-over 1: what the io thread leaves for a tick or hardware thread. A command slot keeps the newest
/// value, a request queue keeps all of them up to a limit. Any thread may call anything; no call waits for
/// another thread for longer than a move takes.

#include <cstddef>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace playhouse::device {

/// The newest value put and not yet taken: a new one overwrites an old one.
template <typename T>
class Latest {
 public:
  void put(T value) {
    const std::scoped_lock lock(mutex_);
    value_ = std::move(value);
  }
  /// Empty if nothing was put since the last take().
  std::optional<T> take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(value_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<T> value_;
};

/// First in, first out, at most `limit` values.
template <typename T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t limit) : limit_(limit) {}

  /// False when the queue is full: the value was not taken and is still the caller's.
  [[nodiscard]] bool push(T&& value) {
    const std::scoped_lock lock(mutex_);
    if (values_.size() >= limit_) return false;
    values_.push_back(std::move(value));
    return true;
  }
  /// Everything that waits, oldest first.
  std::vector<T> take_all() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(values_, {});
  }
  std::size_t size() const {
    const std::scoped_lock lock(mutex_);
    return values_.size();
  }

 private:
  const std::size_t limit_;
  mutable std::mutex mutex_;
  std::vector<T> values_;
};

}  // namespace playhouse::device
