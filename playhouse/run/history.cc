#include "playhouse/run/history.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/world/changes/packed_change.h"
#include "playhouse/world/periods.h"
#include "playhouse/world/saving/whole_state.h"

namespace playhouse::run {
namespace {

/// Nothing but what viewers see depends on drawings, and clients that draw anew in every frame would fill the
/// room: keyframes have them, and between two keyframes they stay as they are.
bool is_repeated(const world::Change& change) {
  return !std::holds_alternative<world::changes::Draw>(change) &&
         !std::holds_alternative<world::changes::ClearDrawing>(change);
}

/// Minimum pause between two snapshots in wall time, as a multiple of the time one takes.
constexpr double kRest = 100;

}  // namespace

History::History(double interval, std::function<double()> clock, std::size_t most_bytes)
    : period_(world::ticks_of(limits::kHistoryPeriodSeconds, interval)),
      span_(world::ticks_of(limits::kHistorySeconds, interval)),
      clock_(std::move(clock)),
      most_bytes_(most_bytes) {}

void History::record(const world::World& world) {
  if (!keyframes_.empty() && world.tick() % period_ != 0) return;
  if (clock_() < rest_until_) return;
  std::optional<Keyframe> keyframe = save(world);
  if (!keyframe) return;
  bytes_ += keyframe->whole->size();
  keyframes_.push_back(*std::move(keyframe));
  timeline_.reset();
  make_room();
}

/// None: `why_none_` is set.
std::optional<History::Keyframe> History::save(const world::World& world) {
  const double start = clock_();
  std::vector<std::byte> whole;
  if (!keyframes_.empty()) whole.reserve(keyframes_.back().whole->size() * 9 / 8);
  const Result<void> saved = world::save_whole(world, whole);
  const double end = clock_();
  rest_until_ = end + kRest * (end - start);
  std::string why_none = saved ? std::string() : saved.error().line();
  if (whole.size() > most_bytes_) why_none = "a state of it is too large to be kept";
  if (std::exchange(why_none_, std::move(why_none)) != why_none_) timeline_.reset();
  if (!why_none_.empty()) return std::nullopt;
  whole.shrink_to_fit();
  return Keyframe{world.tick(), std::make_shared<const std::vector<std::byte>>(std::move(whole))};
}

void History::changed(std::span<const world::Change> changes) {
  for (const world::Change& change : changes) {
    if (std::holds_alternative<world::changes::Load>(change)) {
      new_changes_.clear();
    } else if (!keyframes_.empty() && is_repeated(change)) {
      world::pack(change, new_changes_);
    }
  }
  if (changed_ + new_changes_.size() > most_bytes_ / 2) make_room();
}

void History::continue_from(std::uint64_t tick) {
  if (present_) bytes_ -= present_->whole->size();
  if (std::exchange(present_, std::nullopt)) timeline_.reset();
  while (!keyframes_.empty() && keyframes_.back().tick > tick) drop(keyframes_.size() - 1);
  for (; !changes_.empty() && changes_.back().tick >= tick; changes_.pop_back())
    changed_ -= changes_.back().packed.size();
  if (arrived_) {
    if (!keyframes_.empty() && keyframes_.back().tick == tick) drop(keyframes_.size() - 1);
    bytes_ += arrived_->whole->size();
    keyframes_.push_back(*std::exchange(arrived_, std::nullopt));
    timeline_.reset();
    make_room();
  }
  if (new_changes_.empty()) return;
  changed_ += new_changes_.size();
  changes_.push_back({tick, std::exchange(new_changes_, {})});
}

void History::leave(const world::World& world) {
  if (present_ || keyframes_.empty()) return;
  present_ = save(world);
  if (!present_) return;
  bytes_ += present_->whole->size();
  timeline_.reset();
}

/// Subscriptions are those of now, whatever the tick: what follows cannot be repeated from an earlier state.
void History::arrive(const world::World& world) {
  new_changes_.clear();
  if (keyframes_.empty()) return;
  arrived_ = save(world);
  if (!arrived_) return clear();
  arrived_->is_branch = true;
}

std::uint64_t History::nearest(std::uint64_t tick) const {
  const std::uint64_t last = present_ ? present_->tick : keyframes_.back().tick;
  return std::clamp(tick, keyframes_.front().tick, last);
}

const History::Keyframe& History::before(std::uint64_t tick) const {
  if (present_ && tick >= present_->tick) return *present_;
  const auto later = std::ranges::upper_bound(keyframes_, tick, {}, &Keyframe::tick);
  return later == keyframes_.begin() ? keyframes_.front() : *std::prev(later);
}

std::span<const std::byte> History::changes_at(std::uint64_t tick) const {
  const auto found = std::ranges::lower_bound(changes_, tick, {}, &Changes::tick);
  if (found == changes_.end() || found->tick != tick) return {};
  return found->packed;
}

void History::make_room() {
  const std::uint64_t newest = keyframes_.back().tick;
  while (keyframes_.front().tick + span_ < newest) drop_first();
  // Changes have half of the room at most: keyframes between them do not make them fewer.
  while (changed_ + new_changes_.size() > most_bytes_ / 2) {
    if (keyframes_.size() == 1) return clear();
    drop_first();
  }
  while (bytes_ + changed_ > most_bytes_ && keyframes_.size() > 1) {
    // Drops the keyframe that leaves the smallest gap relative to its age; keeps the first and the last,
    // and those that nothing before them leads to.
    std::size_t least_missed = 0;
    double least = INFINITY;
    for (std::size_t i = 1; i + 1 < keyframes_.size(); ++i) {
      if (keyframes_[i].is_branch) continue;
      const auto gap = static_cast<double>(keyframes_[i + 1].tick - keyframes_[i - 1].tick);
      const auto age = static_cast<double>(newest - keyframes_[i].tick);
      if (gap / age >= least) continue;
      least = gap / age;
      least_missed = i;
    }
    least_missed == 0 ? drop_first() : drop(least_missed);
  }
}

void History::drop(std::size_t place) {
  bytes_ -= keyframes_[place].whole->size();
  keyframes_.erase(keyframes_.begin() + static_cast<std::ptrdiff_t>(place));
  timeline_.reset();
}

/// With the changes up to the next one.
void History::drop_first() {
  drop(0);
  while (!changes_.empty() && (keyframes_.empty() || changes_.front().tick < keyframes_.front().tick)) {
    changed_ -= changes_.front().packed.size();
    changes_.pop_front();
  }
}

void History::clear() {
  keyframes_.clear();
  changes_.clear();
  present_.reset();
  arrived_.reset();
  new_changes_.clear();
  bytes_ = changed_ = 0;
  timeline_.reset();
}

std::shared_ptr<const world::Timeline> History::timeline() {
  if (timeline_) return timeline_;
  auto timeline = std::make_shared<world::Timeline>();
  for (const Keyframe& keyframe : keyframes_) timeline->ticks.push_back(keyframe.tick);
  if (present_ && present_->tick > timeline->ticks.back()) timeline->ticks.push_back(present_->tick);
  timeline->why_none = why_none_;
  return timeline_ = std::move(timeline);
}

}  // namespace playhouse::run
