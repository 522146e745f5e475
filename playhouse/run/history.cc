#include "playhouse/run/history.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/world/periods.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::run {
namespace {

/// Minimum pause between two snapshots in wall time, as a multiple of the time one takes.
constexpr double kRest = 100;

}  // namespace

History::History(double interval, std::function<double()> clock, std::size_t most_bytes)
    : period_(world::ticks_of(limits::kHistoryPeriodSeconds, interval)),
      span_(world::ticks_of(limits::kHistorySeconds, interval)),
      clock_(std::move(clock)),
      most_bytes_(most_bytes) {}

void History::record(const world::World& world) {
  if (!instants_.empty() && world.tick() % period_ != 0) return;
  if (clock_() >= rest_until_) take(world);
}

void History::take(const world::World& world) {
  const auto later = std::ranges::lower_bound(instants_, world.tick(), {}, &Instant::tick);
  if (given_up_ || (later != instants_.end() && later->tick == world.tick())) return;
  const double start = clock_();
  std::vector<std::byte> state;
  if (!instants_.empty()) state.reserve(instants_.back().state->size() * 9 / 8);
  const Result<void> saved = world::save_state(world, state);
  const double end = clock_();
  rest_until_ = end + kRest * (end - start);
  std::string why_none = saved ? std::string() : saved.error().line();
  if (state.size() > most_bytes_) why_none = "a state of it is too large to be kept";
  if (std::exchange(why_none_, std::move(why_none)) != why_none_) timeline_.reset();
  if (!why_none_.empty()) return;
  state.shrink_to_fit();
  bytes_ += state.size();
  instants_.insert(later, {world.tick(), std::make_shared<const std::vector<std::byte>>(std::move(state))});
  timeline_.reset();
  make_room();
}

void History::make_room() {
  const std::uint64_t newest = instants_.back().tick;
  while (instants_.front().tick + span_ < newest) drop(0);
  while (bytes_ > most_bytes_) {
    // Drops the keyframe that leaves the smallest gap relative to its age; keeps the first and the last.
    std::size_t least_missed = 0;
    double least = INFINITY;
    for (std::size_t i = 1; i + 1 < instants_.size(); ++i) {
      const auto gap = static_cast<double>(instants_[i + 1].tick - instants_[i - 1].tick);
      const auto age = static_cast<double>(newest - instants_[i].tick);
      if (gap / age >= least) continue;
      least = gap / age;
      least_missed = i;
    }
    drop(least_missed);
  }
}

void History::drop(std::size_t place) {
  bytes_ -= instants_[place].state->size();
  instants_.erase(instants_.begin() + static_cast<std::ptrdiff_t>(place));
  timeline_.reset();
}

std::shared_ptr<const std::vector<std::byte>> History::nearest(std::uint64_t tick) const {
  PLAYHOUSE_ASSERT(!instants_.empty());
  const auto later = std::ranges::lower_bound(instants_, tick, {}, &Instant::tick);
  if (later == instants_.begin()) return later->state;
  const auto earlier = later - 1;
  const bool is_later = later != instants_.end() && later->tick - tick < tick - earlier->tick;
  return is_later ? later->state : earlier->state;
}

void History::drop_after(std::uint64_t tick) {
  while (!instants_.empty() && instants_.back().tick > tick) drop(instants_.size() - 1);
}

void History::clear() {
  instants_.clear();
  bytes_ = 0;
  timeline_.reset();
}

void History::give_up(std::string why) {
  given_up_ = true;
  why_none_ = std::move(why);
  clear();
}

std::shared_ptr<const world::Timeline> History::timeline() {
  if (timeline_) return timeline_;
  auto timeline = std::make_shared<world::Timeline>();
  for (const Instant& instant : instants_) timeline->ticks.push_back(instant.tick);
  timeline->why_none = why_none_;
  return timeline_ = std::move(timeline);
}

}  // namespace playhouse::run
