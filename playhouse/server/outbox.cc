#include "playhouse/server/outbox.h"

#include <utility>

#include "playhouse/base/limits.h"

namespace playhouse::server {

bool Outbox::put(std::vector<device::Publication> batch) {
  const std::scoped_lock lock(mutex_);
  std::size_t bytes = 0;
  for (const device::Publication& publication : batch)
    bytes += limits::kHeaderBytes + publication.body.size();
  if (data_bytes_ > 0 && data_bytes_ + bytes > limits::kOutboxBytes) {
    dropped_ += std::erase_if(items_, [](const Item& item) { return item.index() == 0; });
    data_bytes_ = 0;
  }
  data_bytes_ += bytes;
  for (device::Publication& publication : batch) items_.emplace_back(std::move(publication));
  return !batch.empty() && wake();
}

bool Outbox::put(Answer answer) {
  const std::scoped_lock lock(mutex_);
  items_.emplace_back(std::move(answer));
  return wake();
}

bool Outbox::wake() {
  return !std::exchange(woken_, true);
}

std::vector<Outbox::Item> Outbox::take_all() {
  const std::scoped_lock lock(mutex_);
  data_bytes_ = 0;
  woken_ = false;
  return std::exchange(items_, {});
}

std::uint64_t Outbox::data_dropped() const {
  const std::scoped_lock lock(mutex_);
  return dropped_;
}

}  // namespace playhouse::server
