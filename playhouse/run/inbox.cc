#include "playhouse/run/inbox.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"
#include "playhouse/world/changes/packed_change.h"

namespace playhouse::run {

void Inbox::command(world::Change command) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  const auto [place, is_new] = slots_.try_emplace(world::model_of(command), entries_.size());
  if (is_new) {
    entries_.push_back(std::move(command));
  } else {
    entries_[place->second] = std::move(command);
  }
}

bool Inbox::post(Request request, world::ModelId model) {
  const std::lock_guard lock(mutex_);
  if (closed_ || changes_ >= limits::kRequestQueue) return false;
  append(std::move(request), model);
  return true;
}

bool Inbox::post_to_all(Request request) {
  const std::lock_guard lock(mutex_);
  if (closed_ || changes_ >= limits::kRequestQueue) return false;
  append(std::move(request), {});
  slots_.clear();
  return true;
}

void Inbox::post_always(Request request, world::ModelId model) {
  const std::lock_guard lock(mutex_);
  if (!closed_) append(std::move(request), model);
}

void Inbox::append(Request request, world::ModelId model) {
  entries_.push_back(std::move(request));
  ++changes_;
  slots_.erase(model);
}

void Inbox::take(std::vector<InboxEntry>& out) {
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

}  // namespace playhouse::run
