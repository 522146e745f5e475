#include "playhouse/server/outbox.h"

#include <utility>

#include "playhouse/base/limits.h"

namespace playhouse::server {

namespace {

std::size_t bytes_of(const device::Publication& publication) {
  return limits::kHeaderBytes + publication.body.size();
}

}  // namespace

bool Outbox::put(std::vector<device::Publication> batch) {
  std::size_t bytes = 0;
  for (const device::Publication& publication : batch) bytes += bytes_of(publication);
  const std::scoped_lock lock(mutex_);
  const bool fits =
      data_bytes_ + bytes <= most_bytes_ && data_messages_ + batch.size() <= limits::kOutboxMessages;
  if (data_messages_ > 0 && !fits) drop_data();
  data_messages_ += batch.size();
  data_bytes_ += bytes;
  for (device::Publication& publication : batch) items_.emplace_back(std::move(publication));
  return !batch.empty() && wake();
}

void Outbox::drop_data() {
  dropped_ += std::erase_if(items_, [this](const OutboxItem& item) {
    const auto* publication = std::get_if<device::Publication>(&item);
    if (publication != nullptr) ++dropped_of_[publication->device];
    return publication != nullptr;
  });
  data_messages_ = data_bytes_ = 0;
}

bool Outbox::put(Answer answer) {
  const std::scoped_lock lock(mutex_);
  items_.emplace_back(std::move(answer));
  return wake();
}

bool Outbox::put(Forget forget) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(items_,
                [](const OutboxItem& item) { return std::holds_alternative<device::Publication>(item); });
  data_messages_ = data_bytes_ = 0;
  items_.emplace_back(forget);
  return wake();
}

bool Outbox::wake() {
  return !std::exchange(woken_, true);
}

bool Outbox::take(std::vector<OutboxItem>& items, std::size_t most) {
  const std::scoped_lock lock(mutex_);
  for (; !items_.empty() && most > 0; --most, items_.pop_front()) {
    items.push_back(std::move(items_.front()));
    if (const auto* publication = std::get_if<device::Publication>(&items.back())) {
      --data_messages_;
      data_bytes_ -= bytes_of(*publication);
    }
  }
  woken_ = !items_.empty();
  return woken_;
}

std::map<device::DeviceId, std::uint64_t> Outbox::take_dropped() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(dropped_of_, {});
}

std::uint64_t Outbox::data_dropped() const {
  const std::scoped_lock lock(mutex_);
  return dropped_;
}

}  // namespace playhouse::server
