#include "playhouse/drivers/simulated/inbox.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"

namespace playhouse::drivers {

void Inbox::command(const PositionCommand& command) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  const auto [slot, is_new] = slots_.try_emplace(command.robot, entries_.size());
  if (is_new) {
    entries_.emplace_back(command);
  } else {
    entries_[slot->second] = command;
  }
}

bool Inbox::post(Change change, world::ModelId robot) {
  const std::lock_guard lock(mutex_);
  if (closed_ || changes_ >= limits::kRequestQueue) return false;
  append(std::move(change), robot);
  return true;
}

bool Inbox::post_to_all(Change change) {
  const std::lock_guard lock(mutex_);
  if (closed_ || changes_ >= limits::kRequestQueue) return false;
  append(std::move(change), {});
  slots_.clear();
  return true;
}

void Inbox::post_always(Change change, world::ModelId robot) {
  const std::lock_guard lock(mutex_);
  if (!closed_) append(std::move(change), robot);
}

void Inbox::append(Change change, world::ModelId robot) {
  entries_.emplace_back(std::move(change));
  ++changes_;
  if (robot) slots_.erase(robot);
}

void Inbox::take(std::vector<Entry>& out) {
  out.clear();
  const std::lock_guard lock(mutex_);
  slots_.clear();
  std::swap(entries_, out);
  changes_ = 0;
}

void Inbox::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
}

bool Inbox::closed() const {
  const std::lock_guard lock(mutex_);
  return closed_;
}

bool Inbox::empty() const {
  const std::lock_guard lock(mutex_);
  return entries_.empty();
}

}  // namespace playhouse::drivers
