#include "playhouse/drivers/simulated/inbox.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"

namespace playhouse::drivers {

void Inbox::command(const PositionCommand& command) {
  const std::lock_guard lock(mutex_);
  PLAYHOUSE_ASSERT(command.robot.index < slots_.size());
  if (closed_) return;
  std::size_t& slot = slots_[command.robot.index];
  if (slot != kNoEntry) {
    entries_[slot] = command;
    return;
  }
  slot = entries_.size();
  entries_.emplace_back(command);
}

bool Inbox::post(Change change, world::PositionRow robot) {
  const std::lock_guard lock(mutex_);
  if (closed_ || changes_ >= limits::kRequestQueue) return false;
  append(std::move(change), robot);
  return true;
}

bool Inbox::post_to_all(Change change) {
  const std::lock_guard lock(mutex_);
  if (closed_ || changes_ >= limits::kRequestQueue) return false;
  append(std::move(change), {});
  std::ranges::fill(slots_, kNoEntry);
  return true;
}

void Inbox::post_always(Change change, world::PositionRow robot) {
  const std::lock_guard lock(mutex_);
  if (!closed_) append(std::move(change), robot);
}

void Inbox::append(Change change, world::PositionRow robot) {
  entries_.emplace_back(std::move(change));
  ++changes_;
  if (robot) slots_[robot.index] = kNoEntry;
}

void Inbox::take(std::vector<Entry>& out) {
  out.clear();
  const std::lock_guard lock(mutex_);
  for (const Entry& entry : entries_) {
    if (const auto* command = std::get_if<PositionCommand>(&entry)) slots_[command->robot.index] = kNoEntry;
  }
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
