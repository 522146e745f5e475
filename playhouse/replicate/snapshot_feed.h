#pragma once

/// SnapshotFeed: the world's newest state on its way from the tick to a thread that serves viewers, without
/// either waiting for the other: one snapshot is written, one is ready, one is read. Threads: wants_show()
/// and show() are for the tick thread or one that works for it, all else for the one that serves.

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>

#include "playhouse/replicate/snapshot.h"

namespace playhouse::replicate {

/// The least time between two frames of one viewer, and between two captures.
inline constexpr std::chrono::milliseconds kFramePeriod{33};

class SnapshotFeed {
 public:
  /// The first layout is made at once; `devices` is asked then, and by show() for models that come.
  SnapshotFeed(const world::World& world, const Prototypes& prototypes, DeviceNames devices)
      : prototypes_(prototypes),
        devices_(std::move(devices)),
        layout_(std::make_shared<const Layout>(world, prototypes, devices_)),
        first_(layout_) {}

  /// Somebody watches, and the last capture was kFramePeriod ago.
  bool wants_show() const {
    return watched_.load(std::memory_order_relaxed) &&
           std::chrono::steady_clock::now() - capture_time_ >= kFramePeriod;
  }

  /// Captures the world, which stands still meanwhile. True: the one who serves is to be told.
  bool show(const world::World& world, const world::Pace& pace) {
    capture_time_ = std::chrono::steady_clock::now();
    {
      const std::lock_guard lock(mutex_);
      tick_interest_ = interest_;
    }
    if (layout_->population != world.population())
      layout_ = std::make_shared<const Layout>(world, prototypes_, devices_, layout_.get());
    capture(world, pace, layout_, tick_interest_, back_);
    {
      const std::lock_guard lock(mutex_);
      std::swap(back_, ready_);
      fresh_ = true;
    }
    return !told_.exchange(true);
  }

  /// Whether there is anybody to show to.
  void watch(bool anybody) { watched_ = anybody; }
  /// What all look at, from the next capture on.
  void set_interest(Interest interest) {
    const std::lock_guard lock(mutex_);
    interest_ = std::move(interest);
  }
  /// Brings `front` up to the newest snapshot, once the one who serves was told.
  void take(Snapshot& front) {
    told_ = false;
    const std::lock_guard lock(mutex_);
    if (std::exchange(fresh_, false)) std::swap(ready_, front);
  }
  /// Of the population when the feed was made.
  const std::shared_ptr<const Layout>& first_layout() const { return first_; }

 private:
  const Prototypes& prototypes_;
  const DeviceNames devices_;
  std::shared_ptr<const Layout> layout_;  // of the newest capture
  const std::shared_ptr<const Layout> first_;
  std::chrono::steady_clock::time_point capture_time_;
  Interest tick_interest_;
  Snapshot back_;

  std::atomic<bool> watched_ = false, told_ = false;
  std::mutex mutex_;  // guards the next three; held for copies of a few words
  Interest interest_;
  Snapshot ready_;
  bool fresh_ = false;
};

}  // namespace playhouse::replicate
