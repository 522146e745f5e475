#include "playhouse/device/subscription.h"

#include <iterator>
#include <utility>

#include "playhouse/base/assert.h"

namespace playhouse::device {

Subscription::Subscription(std::optional<std::uint8_t> subtype, std::size_t limit)
    : subtype_(subtype), limit_(limit) {
  PLAYHOUSE_ASSERT(limit >= 1);
}

std::vector<Publication> Subscription::take() {
  const std::lock_guard lock(mutex_);
  std::vector<Publication> taken(std::make_move_iterator(waiting_.begin()),
                                 std::make_move_iterator(waiting_.end()));
  waiting_.clear();
  return taken;
}

std::optional<Publication> Subscription::take_latest() {
  const std::lock_guard lock(mutex_);
  if (waiting_.empty()) return std::nullopt;
  std::optional<Publication> latest = std::move(waiting_.back());
  lost_ += waiting_.size() - 1;
  waiting_.clear();
  return latest;
}

std::uint64_t Subscription::lost() const {
  const std::lock_guard lock(mutex_);
  return lost_;
}

void Subscription::put(const Publication& publication) {
  if (subtype_ && *subtype_ != publication.subtype) return;
  const std::lock_guard lock(mutex_);
  if (waiting_.size() == limit_) {
    waiting_.pop_front();
    ++lost_;
  }
  waiting_.push_back(publication);
}

void Subscription::clear() {
  const std::lock_guard lock(mutex_);
  waiting_.clear();
}

}  // namespace playhouse::device
